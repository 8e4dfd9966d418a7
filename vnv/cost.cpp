#include "vnv/cost.hpp"

#include <malloc.h>
#include <sys/resource.h>

#include <fstream>
#include <string>

namespace touchstone::vnv {
namespace {

double seconds(const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); }

rusage usage() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return used;
}

double cpu_time() {
  const rusage used = usage();
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

/// Linux: forget the largest resident set so far, once freed memory has gone back to the system.
void forget_peak_memory() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";
}

/// Bytes.
double peak_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (double kibibytes = 0; word == "VmHWM:" && status >> kibibytes) return 1024 * kibibytes;
  return 1024 * static_cast<double>(usage().ru_maxrss);
}

}  // namespace

CostMeter::CostMeter() {
  forget_peak_memory();
  cpu_start_ = cpu_time();
  wall_start_ = std::chrono::steady_clock::now();
}

Cost CostMeter::read() const {
  Cost cost;
  cost.cpu = cpu_time() - cpu_start_;
  cost.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start_).count();
  cost.peak_memory = peak_memory();
  return cost;
}

}  // namespace touchstone::vnv

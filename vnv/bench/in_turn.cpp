#include "vnv/bench/in_turn.hpp"

#include "vnv/record/median.hpp"

#include <time.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace touchstone::bench {
namespace {

double seconds_per_call(const Work& work, long calls, Clock clock) {
  const double start = clock();
  for (long k = 0; k < calls; ++k) work();
  return (clock() - start) / static_cast<double>(calls);
}

}  // namespace

/// By the clock that counts nanoseconds; the split into user and system time is counted in ticks on some machines. The
/// works make no system calls.
double cpu_time() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double wall_time() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

using vnv::median;

double Times::of(std::size_t work) const { return median(of_works_.at(work)); }

std::vector<double> Times::ratios(std::size_t work, std::size_t to) const {
  std::vector<double> found;
  for (std::size_t round = 0; round < of_works_.at(work).size(); ++round)
    found.push_back(of_works_[work][round] / of_works_.at(to)[round]);
  return found;
}

double Times::ratio(std::size_t work, std::size_t to) const { return median(ratios(work, to)); }

double Times::spread(std::size_t work, std::size_t to) const {
  std::vector<double> found = ratios(work, to);
  std::ranges::sort(found);
  const std::size_t last = found.size() - 1;
  return (found[last - last / 4] - found[last / 4]) / 2 / median(found);
}

Times time_in_turn(const std::vector<Work>& works, const Effort& effort) {
  std::vector<long> calls;
  for (const Work& work : works) {
    work();
    const double once = seconds_per_call(work, 1, effort.clock);
    calls.push_back(std::max(1L, std::lround(effort.seconds / std::max(once, 1e-9))));
  }
  std::vector<std::vector<double>> of_works(works.size());
  for (int round = 0; round < effort.rounds; ++round)
    for (std::size_t k = 0; k < works.size(); ++k)
      of_works[k].push_back(seconds_per_call(works[k], calls[k], effort.clock));
  return Times(std::move(of_works));
}

}  // namespace touchstone::bench

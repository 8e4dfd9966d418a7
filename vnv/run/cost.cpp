#include "vnv/run/cost.hpp"

#include "vnv/record/median.hpp"

#include <sys/resource.h>

#include <algorithm>

namespace touchstone::vnv {
namespace {

/// Seconds. System time is left out: it is mostly other people's.
double user_time() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return static_cast<double>(used.ru_utime.tv_sec) + 1e-6 * static_cast<double>(used.ru_utime.tv_usec);
}

double median_of(const std::vector<Cost>& repeats, double Cost::*value) {
  std::vector<double> values;
  for (const Cost& cost : repeats) values.push_back(cost.*value);
  return median(values);
}

}  // namespace

CostMeter::CostMeter() : user_start_(user_time()) {}

Cost CostMeter::read() const {
  Cost cost;
  cost.cpu = cost.cpu_lowest = cost.cpu_highest = user_time() - user_start_;
  cost.wall = watch_.seconds();
  return cost;
}

Cost cost_of_repeats(const std::vector<Cost>& repeats) {
  Cost cost = repeats.front();
  cost.repeats = static_cast<long>(repeats.size());
  for (double Cost::*value : {&Cost::cpu, &Cost::wall, &Cost::stepping, &Cost::harness, &Cost::peak_memory})
    cost.*value = median_of(repeats, value);
  const auto [lowest, highest] = std::ranges::minmax(repeats, {}, &Cost::cpu);
  cost.cpu_lowest = lowest.cpu;
  cost.cpu_highest = highest.cpu;
  return cost;
}

}  // namespace touchstone::vnv

#include "vnv/command/tasks.hpp"

#include "vnv/command/inputs.hpp"
#include "vnv/record/record.hpp"

#include <algorithm>
#include <cmath>

namespace touchstone::vnv::command {
std::map<std::string, double> costs_of_levels(const std::filesystem::path& record) {
  std::map<std::string, double> costs;
  if (!std::filesystem::exists(record)) return costs;
  for (const RunSummary& run : read_record(record).runs)
    if (std::isfinite(run.cost.cpu)) costs[run.level] += run.cost.cpu * static_cast<double>(run.cost.repeats);
  return costs;
}

std::vector<Task> tasks_of(const std::vector<Chosen>& methods, const std::string& suite,
                           const std::filesystem::path& records) {
  std::vector<Task> tasks;
  for (const Chosen& one : methods) {
    const std::map<std::string, double> costs = costs_of_levels(record_file(records, one.name()));
    for (const LevelDescription& level : one.method->levels) {
      const auto until = level.until.find(suite);
      if (until == level.until.end()) continue;
      const auto cost = costs.find(level.name);
      tasks.push_back({one.name(), level.name, level.spacing, until->second,
                       cost == costs.end() ? std::nullopt : std::optional(cost->second), one.of->timed});
    }
  }
  return tasks;
}

std::optional<LastCost> last_cost(const std::filesystem::path& record) try {
  LastCost last;
  for (const RunSummary& run : read_record(record).runs) {
    last.wall += (run.cost.wall + run.cost.harness) * static_cast<double>(run.cost.repeats);
    last.peak_memory = std::max(last.peak_memory, run.cost.peak_memory);
  }
  return last;
} catch (const std::runtime_error&) {
  return std::nullopt;
}

std::map<std::string, double> last_times(const std::filesystem::path& record) try {
  std::map<std::string, double> times;
  for (const RunSummary& run : read_record(record).runs)
    if (std::isfinite(run.cost.wall)) times[run.level] = run.cost.wall * static_cast<double>(run.cost.repeats);
  return times;
} catch (const std::runtime_error&) {
  return {};
}

Estimate estimate(const std::vector<Task>& tasks, int at_once) {
  Estimate all;
  std::map<std::string, double> together;  // s  by method, of those that may run side by side
  double alone = 0;                        // s
  for (const Task& task : tasks) {
    const double cpu = task.cpu.value_or(0);
    all.cpu += cpu;
    all.unknown += !task.cpu;
    (task.timed ? alone : together[task.name]) += cpu;
  }
  for (const auto& [name, cpu] : together) all.longest = std::max(all.longest, cpu);
  all.shortest_wall = alone + std::max(all.longest, (all.cpu - alone) / at_once);
  return all;
}

}  // namespace touchstone::vnv::command

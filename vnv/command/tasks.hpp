#pragma once
/// What a suite has to do, level by level, and what it cost last time.

#include "vnv/command/catalogue.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace touchstone::vnv::command {

/// One method on one level.
struct Task {
  std::string name;           // "poiseuille.mpm"
  std::string level;          // "M2"
  double spacing = 0;         // m
  double until = 0;           // s  of flow
  std::optional<double> cpu;  // s  of all its repeats, if there is a record
  bool timed = false;         // nothing else runs beside it
};

/// The levels of methods that a suite runs, with their cost by the records of the folder, where there are any. Throws
/// std::runtime_error for a record that cannot be read.
std::vector<Task> tasks_of(const std::vector<Chosen>& methods, const std::string& suite,
                           const std::filesystem::path& records);

/// What a method took when it last ran, all its runs together.
struct LastCost {
  double wall = 0;         // s
  double peak_memory = 0;  // bytes
};
/// Nothing where there is no record, or none that can be read.
std::optional<LastCost> last_cost(const std::filesystem::path& record);
/// The CPU time [s] of each of its levels with all repeats, by name; none where there is no record. Throws
/// std::runtime_error for one that cannot be read.
std::map<std::string, double> costs_of_levels(const std::filesystem::path& record);
/// The wall time [s] of each of its levels, by name; none where there is no such record.
std::map<std::string, double> last_times(const std::filesystem::path& record);

struct Estimate {
  double cpu = 0;            // s  of the tasks whose cost is known
  long unknown = 0;          // tasks
  double longest = 0;        // s  of one method, whose levels run one after the other
  double shortest_wall = 0;  // s  with so many methods at once, each on a processor of its own
};
Estimate estimate(const std::vector<Task>& tasks, int at_once);

}  // namespace touchstone::vnv::command

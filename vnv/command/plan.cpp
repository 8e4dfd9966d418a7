/// vnv plan: the tasks of a suite with what they cost last time.

#include "vnv/command/solvers.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>

namespace touchstone::vnv::command {
namespace {

void print_json(const std::vector<Task>& tasks, const std::string& suite) {
  for (const Task& task : tasks) {
    nlohmann::ordered_json line = {{"name", task.name},       {"suite", suite},      {"level", task.level},
                                   {"spacing", task.spacing}, {"until", task.until}, {"timed", task.timed}};
    line["cpu"] = task.cpu ? nlohmann::ordered_json(*task.cpu) : nlohmann::ordered_json(nullptr);
    fmt::print("{}\n", line.dump());
  }
}

void print_for_people(const std::vector<Task>& tasks, int at_once) {
  std::size_t wide = 0, levels_wide = 0;
  for (const Task& task : tasks) {
    wide = std::max(wide, task.name.size());
    levels_wide = std::max(levels_wide, task.level.size());
  }
  fmt::print("{:<{}}  {:<{}}  {:>11}  {:>9}  {:>8}\n", "method", wide, "level", levels_wide, "spacing [m]", "until [s]",
             "CPU [s]");
  for (const Task& task : tasks)
    fmt::print("{:<{}}  {:<{}}  {:>11.4g}  {:>9.4g}  {:>8}\n", task.name, wide, task.level, levels_wide, task.spacing,
               task.until, task.cpu ? fmt::format("{:.3g}", *task.cpu) : "unknown");
  const Estimate all = estimate(tasks, at_once);
  fmt::print("{} tasks, {:.3g} CPU s", tasks.size(), all.cpu);
  if (all.unknown > 0) fmt::print(" and {} of unknown cost", all.unknown);
  fmt::print("; at least {:.3g} s with {} at once\n", all.shortest_wall, at_once);
}

}  // namespace

int plan(const Build& build, PlanOptions options) {
  const std::filesystem::path records = build.records(options.suite);
  std::vector<Task> tasks;
  const std::vector<doors::Solver> solvers = take_solvers(options.patterns);
  for (const doors::Solver& solver : solvers) std::ranges::move(tasks_of(solver, records), std::back_inserter(tasks));
  const bool are_solvers_all = !solvers.empty() && options.patterns.empty();
  if (!are_solvers_all && build.is_installed() && options.patterns.empty()) {
    if (!options.as_json)
      fmt::print(
          "No cases of our methods are installed, so no suite has tasks here; --build names a build folder that has "
          "them.\n\n  vnv plan mine.toml      the runs of your code, with their last recorded cost\n"
          "  vnv list                the flows by which any code can be judged\n");
    return all_holds;
  }
  if (!are_solvers_all) {
    const Catalogue catalogue = read_catalogue(build, options.patterns);
    const std::vector<Chosen> methods = choose_all(catalogue, options.patterns, options.suite);
    std::ranges::move(tasks_of(methods, options.suite, records), std::back_inserter(tasks));
  }
  if (options.as_json)
    print_json(tasks, options.suite);
  else
    print_for_people(tasks, options.at_once);
  return all_holds;
}

}  // namespace touchstone::vnv::command

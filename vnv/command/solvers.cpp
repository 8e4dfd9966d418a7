#include "vnv/command/solvers.hpp"

#include "vnv/command/inputs.hpp"
#include "vnv/command/outcome.hpp"
#include "vnv/command/patterns.hpp"
#include "vnv/command/terminal.hpp"
#include "vnv/flows/formulas/flow_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace touchstone::vnv::command {

namespace fs = std::filesystem;

std::vector<doors::Solver> take_solvers(Patterns& patterns) {
  std::vector<doors::Solver> solvers;
  for (const std::string& pattern : patterns)
    if (pattern.ends_with(".toml")) solvers.push_back(doors::read_solver(pattern));
  std::erase_if(patterns, [](const std::string& pattern) { return pattern.ends_with(".toml"); });
  return solvers;
}

std::vector<std::string> chosen_flows(const Patterns& patterns) {
  const std::vector<std::string> all = known_flows();
  if (patterns.empty()) return all;
  std::vector<std::string> chosen;
  for (const std::string& pattern : patterns) {
    const std::vector<std::string> found = matches(pattern, all);
    if (found.empty())
      throw std::invalid_argument(fmt::format("no flow fits '{}', and no cases are installed; expected one of: {}",
                                              pattern, fmt::join(all, ", ")));
    chosen.insert(chosen.end(), found.begin(), found.end());
  }
  return chosen;
}

std::vector<Task> tasks_of(const doors::Solver& solver, const fs::path& records) {
  const std::map<std::string, double> costs = costs_of_levels(record_file(records, solver.case_and_method()));
  std::vector<Task> tasks;
  for (const double spacing : solver.spacings) {
    const std::string level = doors::level_name(solver.flow, spacing);
    const auto cost = costs.find(level);
    tasks.push_back({.name = solver.case_and_method(),
                     .level = level,
                     .spacing = spacing,
                     .until = solver.times.back(),
                     .cpu = cost == costs.end() ? std::nullopt : std::optional(cost->second)});
  }
  return tasks;
}

void print_solvers(const std::vector<doors::Solver>& solvers) {
  for (const doors::Solver& solver : solvers) {
    std::vector<std::string> levels;
    for (const double spacing : solver.spacings)
      levels.push_back(fmt::format("{:.4g} across", solver.flow.across / spacing));
    fmt::print("{}  {}\n  {}  {}\n    {}, at {} s\n", coloured(Colour::bold, solver.flow.case_name()),
               solver.flow.judged.title, solver.name, solver.description, fmt::join(levels, ", "),
               fmt::join(solver.times, ", "));
  }
}

Suite suite_named(const std::string& name) {
  return *std::ranges::find_if(vnv::suites, [&](Suite suite) { return name_of(suite) == name; });
}

doors::Judgement run_and_record(const doors::Solver& solver, const std::string& suite, const fs::path& records,
                                const fs::path& last_records) {
  const std::string name = solver.case_and_method();
  const std::map<std::string, double> expected =
      last_times(record_file(last_records.empty() ? records : last_records, name));
  forget(records, name);
  doors::Judgement judgement = doors::run_solver(solver, records / "runs" / name, suite_named(suite), expected);
  fs::create_directories(records);
  write(judgement.record, record_file(records, name));
  return judgement;
}

}  // namespace touchstone::vnv::command

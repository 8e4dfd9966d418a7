/// vnv plan: the tasks of a suite with what they cost last time.

#include "vnv/command/commands.hpp"
#include "vnv/command/tasks.hpp"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

namespace touchstone::vnv::command {
namespace {

struct Options {
  std::vector<std::string> patterns{};
  std::string suite = "acceptance";
  int at_once = 1;
  bool as_json = false;
};

std::string seconds(const std::optional<double>& cpu) { return cpu ? fmt::format("{:.3g}", *cpu) : "unknown"; }

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
               task.until, seconds(task.cpu));
  const Estimate all = estimate(tasks, at_once);
  fmt::print("{} tasks, {:.3g} CPU s", tasks.size(), all.cpu);
  if (all.unknown > 0) fmt::print(" and {} of unknown cost", all.unknown);
  fmt::print("; with {} at once no less than {:.3g} s\n", at_once, all.shortest_wall);
}

int plan(const Build& build, const Options& options) {
  const Catalogue catalogue = read_catalogue(build, options.patterns);
  const std::vector<Chosen> methods = choose_all(catalogue, options.patterns, options.suite);
  const std::vector<Task> tasks = tasks_of(methods, options.suite, build.records(options.suite));
  if (options.as_json)
    print_json(tasks, options.suite);
  else
    print_for_people(tasks, options.at_once);
  return all_holds;
}

}  // namespace

void add_plan(CLI::App& app, Session& session) {
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("plan", "Tells each method and level of a suite, and what it cost by the last records.");
  command->footer("Examples:\n  vnv plan --suite nightly -j 8\n  vnv plan 'invariance_*' --json");
  add_patterns(*command, options->patterns);
  add_suite(*command, options->suite)->capture_default_str();
  add_at_once(*command, options->at_once);
  command->add_flag("--json", options->as_json, "a line of JSON for each task; \"cpu\" is null where it is unknown");
  set_todo(*command, session, plan, options);
}

}  // namespace touchstone::vnv::command

/// vnv list: cases, methods, levels, and which suite runs what.

#include "vnv/command/solvers.hpp"
#include "vnv/command/terminal.hpp"
#include "vnv/flows/formulas/flow_file.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace touchstone::vnv::command {
namespace {

std::vector<std::string> levels_of(const MethodDescription& method, const std::string& suite) {
  std::vector<std::string> names;
  for (const LevelDescription& level : method.levels)
    if (level.until.contains(suite)) names.push_back(level.name);
  return names;
}

void print_json(const std::vector<Chosen>& methods) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const Chosen& one : methods) {
    nlohmann::ordered_json levels = nlohmann::ordered_json::object();
    for (const std::string& suite : suites)
      if (one.method->is_run_in(suite)) levels[suite] = levels_of(*one.method, suite);
    all.push_back({{"case", one.of->name},
                   {"title", one.of->title},
                   {"method", one.method->name},
                   {"timed", one.of->timed},
                   {"levels", levels}});
  }
  fmt::print("{}\n", all.dump(2));
}

/// Of a suite that was not asked for, many levels are a number.
std::string words_of(const std::vector<std::string>& levels, const std::string& suite, const std::string& only) {
  constexpr std::size_t few = 24;
  return levels.size() <= few || suite == only ? fmt::format("{}", fmt::join(levels, ", "))
                                               : fmt::format("{} levels; --suite {} names them", levels.size(), suite);
}

void print_for_people(const std::vector<Chosen>& methods, const std::string& only) {
  const Description* last = nullptr;
  for (const Chosen& one : methods) {
    if (one.of != last) fmt::print("{}  {}\n", coloured(Colour::bold, one.of->name), one.of->title);
    last = one.of;
    fmt::print("  {}\n", one.method->name);
    for (const std::string& suite : suites)
      if (one.method->is_run_in(suite) && (only.empty() || suite == only))
        fmt::print("    {:<10}  {}\n", suite, words_of(levels_of(*one.method, suite), suite, only));
  }
}

/// "exact velocity, pressure; over time: half-axes"
std::string judged_by(const Flow& flow) {
  std::vector<std::string> exact, over_time;
  for (const Exact& one : flow.exact) exact.push_back(one.field);
  for (const Measured& one : flow.measured)
    if (one.over) over_time.push_back(one.name);
  return fmt::format("{}{}{}{}{}", exact.empty() ? "" : "exact ", fmt::join(exact, ", "),
                     exact.empty() || over_time.empty() ? "" : "; ",
                     over_time.empty() ? "" : "over time: ", fmt::join(over_time, ", "));
}

/// What can be done without cases, and by which flows.
void print_what_is_installed(const std::vector<std::string>& flows) {
  fmt::print(
      "No cases of our methods are installed; --build names a build folder that has them. Any code can be judged by\n\n");
  for (const std::string& name : flows) {
    const Flow flow = flow_of(name);
    fmt::print("{:24} {:36} {}\n", name, flow.judged.title, judged_by(flow));
  }
  fmt::print(
      "\n  vnv scene FLOW          what to compute\n  vnv explain FLOW        what is claimed, and by which oracle\n"
      "  vnv judge FLOW FILES    judges what a code wrote\n"
      "  vnv run mine.toml       runs a code, judges it and keeps a record, which vnv report turns into a page\n");
}

}  // namespace

int list(const Build& build, ListOptions options) {
  const std::vector<doors::Solver> solvers = take_solvers(options.patterns);
  print_solvers(solvers);
  if (!solvers.empty() && options.patterns.empty()) return all_holds;
  if (build.is_installed()) {
    const std::vector<std::string> flows = chosen_flows(options.patterns);
    if (options.as_json)
      print_json({});
    else if (!options.names_only)
      print_what_is_installed(flows);
    return all_holds;
  }
  const Catalogue catalogue = read_catalogue(build, options.patterns);
  if (!options.names_only && !catalogue.not_built.empty())
    fmt::print(stderr, "vnv: {} cases are not built and not listed: cmake --build BUILD\n", catalogue.not_built.size());
  const std::vector<Chosen> methods = choose(catalogue, options.patterns, options.suite);
  if (options.names_only)
    for (const Chosen& one : methods) fmt::print("{}\n", one.name());
  else if (options.as_json)
    print_json(methods);
  else
    print_for_people(methods, options.suite);
  return all_holds;
}

}  // namespace touchstone::vnv::command

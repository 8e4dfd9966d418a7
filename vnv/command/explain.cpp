/// vnv explain: what a case solves or a flow is, what is claimed of it on whose word, and where its data come from.

#include "vnv/command/solvers.hpp"
#include "vnv/command/terminal.hpp"
#include "vnv/doors/scene.hpp"
#include "vnv/files/tables.hpp"
#include "vnv/flows/formulas/flow_file.hpp"
#include "vnv/record/prices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

namespace touchstone::vnv::command {
namespace {

void print_wrapped(const std::string& text, int indent) { fmt::print("{}", wrapped(text, width(), indent)); }

void print_heading(std::string_view text) { fmt::print("\n{}\n", coloured(Colour::bold, text)); }

std::string limits(const ClaimDescription& claim) {
  if (claim.lower && claim.upper) return fmt::format("{:g} to {:g}", *claim.lower, *claim.upper);
  if (claim.upper) return fmt::format("at most {:g}", *claim.upper);
  return claim.lower ? fmt::format("at least {:g}", *claim.lower) : "any";
}

/// "order of L2 [%] over grid, M2, 0.1 s: at least 1.9, surely above 1.5 (theory: second order)"
std::string sentence(const ClaimDescription& claim) {
  std::string text =
      claim.ladder.empty() ? claim.quantity : fmt::format("order of {} over {}", claim.quantity, claim.ladder);
  if (!claim.level.empty()) text += ", " + claim.level;
  if (claim.time) text += fmt::format(", {:g} s", *claim.time);
  text += ": " + limits(claim);
  if (claim.surely_above) text += fmt::format(", surely above {:g}", *claim.surely_above);
  return fmt::format("{} ({})", text, claim.author);
}

/// "2 by theory, 1 by literature, 14 accepted values"
std::string authors(const std::vector<ClaimDescription>& claims, long accepted) {
  std::map<std::string, long> counts;
  for (const ClaimDescription& claim : claims) ++counts[claim.author.substr(0, claim.author.find(':'))];
  std::string text;
  for (const std::string author : {"theory", "literature", "baseline"})
    if (counts[author] > 0) text += fmt::format("{}{} by {}", text.empty() ? "" : ", ", counts[author], author);
  if (accepted > 0) text += fmt::format("{}{} accepted values", text.empty() ? "" : ", ", accepted);
  return text.empty() ? "none of its own" : text;
}

void print_levels(const MethodDescription& method) {
  long only_of_work = 0;  // hundreds
  for (const LevelDescription& level : method.levels) {
    if (level.until.size() == 1 && level.until.contains("work")) {
      ++only_of_work;
      continue;
    }
    std::string text = fmt::format("{}: spacing {:g} m", level.name, level.spacing);
    if (level.cell) text += fmt::format(", cell {:g} m", *level.cell);
    if (level.smoothing_length) text += fmt::format(", smoothing length {:g} m", *level.smoothing_length);
    if (level.time_step) text += fmt::format(", time step {:g} s", *level.time_step);
    for (const auto& [suite, until] : level.until) text += fmt::format("; {} to {:g} s", suite, until);
    print_wrapped(text, 6);
  }
  if (only_of_work > 0)
    print_wrapped(fmt::format("and {} of the suite work alone, which vnv list --suite work names", only_of_work), 6);
}

void print_method(const MethodDescription& method, bool whole) {
  fmt::print("  {}\n", coloured(Colour::bold, method.name));
  print_wrapped(method.description, 4);
  print_wrapped("Claims: " + authors(method.claims, method.baselines), 4);
  if (!whole) return;
  for (const ClaimDescription& claim : method.claims) print_wrapped(sentence(claim), 6);
  fmt::print("    Levels:\n");
  print_levels(method);
  for (const LadderDescription& ladder : method.ladders)
    print_wrapped(fmt::format("Ladder {}: {}", ladder.name, fmt::join(ladder.levels, ", ")), 4);
  print_wrapped(fmt::format("New baselines allow a change by {:g} %, or by {:g}: {}", 100 * method.tolerance.relative,
                            method.tolerance.absolute, method.tolerance.basis),
                4);
}

/// Where the numbers of a file come from, what they hold for and how far.
void print_table(const std::string& file) {
  print_wrapped(file, 2);
  for (const Sheet::Key& key : read_sheet(file).keys)
    if (key.name != "scaling") print_wrapped(key.name + ": " + key.value, 4);
}

void print_data(const Description& one) {
  if (!one.tables.empty()) print_heading("Data that the case declares");
  for (const std::string& file : one.tables) print_table(file);
  print_heading("Baselines");
  if (one.acceptance.revision.empty()) return fmt::print("  none accepted yet\n");
  print_wrapped(one.baseline_file, 2);
  print_wrapped(fmt::format("accepted {} at revision {}: {}", one.acceptance.date, one.acceptance.revision,
                            one.acceptance.reason),
                4);
}

/// "the front: 20 times or more, to 0.5 s"
std::string over_time(const Measured& one) {
  const auto [first, last, least, is_steady] = *one.over;
  if (!std::isfinite(first)) return one.name + ": at whatever times there are";
  const std::string span =
      first < last ? fmt::format(", from {:g} to {:g} s{}", first, last, is_steady ? " or as long, later" : "")
      : last > 0   ? fmt::format(", to {:g} s{}", last, is_steady ? " or later" : "")
                   : "";
  return fmt::format("{}: {} or more{}", one.name, least == 1 ? "a time" : fmt::format("{} times", least), span);
}

/// A flow, by which any code is judged, at its published parameters.
void explain_flow(const std::string& name) {
  const Flow flow = flow_of(name);
  const Description one = doors::describe(flow);
  fmt::print("{}\n\n", coloured(Colour::bold, fmt::format("{}: {}", flow.name, one.title)));
  print_wrapped(one.description, 0);
  print_heading("Parameters, as published; --set gives them other values");
  for (const Parameter& p : flow.parameters)
    print_wrapped(fmt::format("{} = {:.10g}{}: {}", p.name, p.value, p.unit == "-" ? "" : " " + p.unit, p.words), 2);
  print_heading("Judged");
  for (const Exact& exact : flow.exact)
    print_wrapped(fmt::format("exact {}: {}", exact.field, fmt::join(exact.norms, "; ")), 2);
  print_wrapped(fmt::format("at {} s, or at the times of your files", fmt::join(one.times, ", ")), 2);
  for (const Measured& measured : flow.measured)
    if (measured.over) print_wrapped("over time, " + over_time(measured), 2);
  print_heading("Claimed of any code");
  for (std::size_t k = 0; k < one.claims.size(); ++k)
    print_wrapped(sentence(one.claims[k]) +
                      (k < flow.judged.claims.size() ? "" : fmt::format(", with {:g} across or more", flow.resolved)),
                  2);
  if (!one.tables.empty()) print_heading("Data");
  for (const std::string& file : one.tables) print_table(file);
  fmt::print("\nvnv scene {0} says what to compute; vnv judge {0} FILES judges what a code wrote.\n", name);
}

/// The default among the methods of a case, by what errors cost in it or in the flow that stands for it.
void print_default(const Description& one) {
  const std::filesystem::path file = std::filesystem::path(one.data_folder) / "work.csv";
  if (!std::filesystem::exists(file)) return;
  std::vector<Price> prices = read_prices(file);
  std::erase_if(prices, [&](const Price& p) {
    return p.case_name != one.priced_as ||
           std::ranges::find(one.methods, p.method, &MethodDescription::name) == one.methods.end();
  });
  const auto chosen = default_method(prices);
  if (!chosen) return;
  print_heading("Default method");
  print_wrapped(fmt::format("{}: {} in {} ({})", chosen->method, chosen->reason, one.priced_as, file.string()), 2);
}

void explain_case(const Description& one, const std::vector<Chosen>& methods, bool whole) {
  fmt::print("{}\n\n", coloured(Colour::bold, fmt::format("{}: {}", one.name, one.title)));
  print_wrapped(one.description, 0);
  if (!one.claims.empty()) print_heading("Claimed of any method");
  for (const ClaimDescription& claim : one.claims) print_wrapped(sentence(claim), 2);
  print_default(one);
  print_heading("Methods");
  for (const Chosen& chosen : methods)
    if (chosen.of == &one) print_method(*chosen.method, whole);
  print_data(one);
}

}  // namespace

int explain(const Build& build, const ExplainOptions& options) {
  if (options.pattern.ends_with(".toml")) {
    explain_flow(options.pattern);
    return all_holds;
  }
  if (build.is_installed()) {
    for (const std::string& flow : chosen_flows({options.pattern})) explain_flow(flow);
    return all_holds;
  }
  const Catalogue catalogue = read_catalogue(build, {options.pattern});
  const std::vector<std::string> flows = known_flows();
  if (std::ranges::find(flows, options.pattern) != flows.end() &&
      std::ranges::find(catalogue.cases, options.pattern, &Description::name) == catalogue.cases.end()) {
    fmt::print(stderr, "vnv: the case {} is not built; this is the flow by which any code is judged\n",
               options.pattern);
    explain_flow(options.pattern);
    return all_holds;
  }
  const std::vector<Chosen> methods = choose_all(catalogue, {options.pattern}, "");
  const bool whole = methods.size() == 1;
  const Description* last = nullptr;
  for (const Chosen& chosen : methods) {
    if (chosen.of == last) continue;
    if (last) fmt::print("\n");
    last = chosen.of;
    explain_case(*chosen.of, methods, whole);
  }
  return all_holds;
}

}  // namespace touchstone::vnv::command

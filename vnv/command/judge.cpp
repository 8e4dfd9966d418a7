/// vnv judge, prepare and collect: the output of any code, judged by a flow.

#include "vnv/command/inputs.hpp"
#include "vnv/command/junit.hpp"
#include "vnv/command/settings.hpp"
#include "vnv/command/solvers.hpp"
#include "vnv/files/whole_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

namespace touchstone::vnv::command {
namespace {

doors::Mapping mapping_of(const JudgeOptions& options) {
  doors::Mapping mapping{.arrays = pairs_of("--field", options.fields),
                         .units = pairs_of("--unit", options.units),
                         .axes = options.axes,
                         .only = options.only,
                         .inside = options.inside};
  if (!options.origin.empty()) mapping.origin = {options.origin.at(0), options.origin.at(1)};
  if (options.time >= 0) mapping.time = options.time;
  if (options.time_step > 0) mapping.time_step = options.time_step;
  return mapping;
}

std::optional<double> where_positive(double value) { return value > 0 ? std::optional(value) : std::nullopt; }

void print_values(const Record& record) {
  fmt::print("\n{:24} {:>12} {:32} {:>12}\n", "level", "time [s]", "quantity", "value");
  for (const Value& v : record.values)
    fmt::print("{:24} {:12.6g} {:32} {:12.6g}\n", v.level, v.time, v.quantity.heading(), v.value);
  for (const ObservedOrder& order : record.orders)
    if (order.levels.size() > 2)
      fmt::print("observed order of {} at {:g} s: {:.3f} +- {:.2g} over {} resolutions\n", order.quantity, order.time,
                 order.order, order.half_width, order.levels.size());
}

/// What was read, measured and claimed; keeps the record where a folder is named.
int conclude(const doors::Flow& flow, const doors::Judgement& judgement, const std::string& records,
             const std::string& junit) {
  const Record& record = judgement.record;
  fmt::print("{}\n", flow.title());
  for (const std::string& line : judgement.files) fmt::print("  {}\n", line);
  for (const std::string& line : judgement.words) fmt::print("  {}\n", line);
  print_values(record);
  fmt::print("\n");
  for (const std::string& line : judgement.not_judged) fmt::print("not judged: {}\n", line);
  for (const Verdict& v : record.verdicts) fmt::print("{}\n", v.sentence);
  if (!records.empty()) write(record, record_file(records, record.case_name + "." + record.method));
  if (!junit.empty()) files::write_whole(junit, junit_of(record));
  const auto held = std::ranges::count(record.verdicts, Outcome::holds, &Verdict::outcome);
  fmt::print("{} of {} claims hold\n", held, record.verdicts.size());
  return held == std::ssize(record.verdicts) ? all_holds : something_fails;
}

}  // namespace

int judge(const Build&, const JudgeOptions& options) {
  const doors::Flow flow = doors::flow_named(options.flow, settings_of(options.set));
  return conclude(flow,
                  doors::judge_files(flow, {options.files.begin(), options.files.end()}, mapping_of(options),
                                     where_positive(options.spacing),
                                     {.name = options.name, .at_most = where_positive(options.at_most)}),
                  options.records, options.junit);
}

int prepare(const Build&, const PrepareOptions& options) {
  const doors::Solver solver = doors::read_solver(options.solver);
  doors::prepare(solver, options.folder);
  fmt::print("{}: {} folders, each with run.sh\n", options.folder, solver.spacings.size());
  return all_holds;
}

int collect(const Build&, const CollectOptions& options) {
  const doors::Solver solver = doors::read_solver(options.solver);
  return conclude(solver.flow, doors::collect(solver, options.folder, suite_named(options.suite)), options.records,
                  options.junit);
}

}  // namespace touchstone::vnv::command

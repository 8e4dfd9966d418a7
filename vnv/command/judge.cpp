/// vnv judge, prepare and collect: the output of any code, judged by a flow.

#include "vnv/command/inputs.hpp"
#include "vnv/command/junit.hpp"
#include "vnv/command/settings.hpp"
#include "vnv/command/solvers.hpp"
#include "vnv/command/values.hpp"
#include "vnv/files/whole_file.hpp"
#include "vnv/flows/formulas/flow_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>

namespace touchstone::vnv::command {
namespace {

doors::Mapping mapping_of(const JudgeOptions& options) {
  doors::Mapping mapping{.arrays = pairs_of("--field", options.fields),
                         .units = pairs_of("--unit", options.units),
                         .axes = options.axes,
                         .only = options.only,
                         .inside = options.inside,
                         .probes = options.probes,
                         .at = options.at,
                         .symmetric = options.symmetric,
                         .time = options.time,
                         .time_step = options.time_step};
  if (!options.origin.empty()) mapping.origin = {options.origin.at(0), options.origin.at(1)};
  doors::require_known_names(mapping, "--at, --axes, --field, --unit, --symmetric");
  return mapping;
}

/// Each cause that was fitted, by itself or with another, with its 95 % interval.
void print(const Diagnosis& diagnosis) {
  fmt::print("\n{}, {}, {:.3g} % wrong: {}\n", diagnosis.level, diagnosis.field, diagnosis.error, diagnosis.sentence);
  for (const Explanation& one : diagnosis.explanations) {
    std::vector<std::string> causes;
    for (const FittedCause& c : one.causes)
      causes.push_back(c.unit.empty() ? c.cause : fmt::format("{} {} {}", c.cause, in_digits(c), c.unit));
    fmt::print("  {:5.1f} % of the squared error: {}{}\n", 100 * one.share, fmt::join(causes, ", "),
               one.named ? " *" : "");
  }
}

/// What `--json` prints: of the record what a judgement is, with what was read and what was not judged.
void print_as_json(const Flow& flow, const doors::Judgement& judgement, bool holds) {
  const auto record = nlohmann::ordered_json::parse(as_json(judgement.record));
  nlohmann::ordered_json all{{"schema", "touchstone judgement 1"},
                             {"flow", flow.name},
                             {"title", flow.title()},
                             {"holds", holds},
                             {"files", judgement.files},
                             {"read as", judgement.words},
                             {"not judged", judgement.not_judged}};
  for (const char* part : {"runs", "values", "orders", "verdicts", "diagnoses"}) all[part] = record.at(part);
  fmt::print("{}\n", all.dump(2));
}

/// Before anything is read: what cannot be kept need not be judged.
void make_folder_of(const std::string& records) {
  if (!records.empty()) files::make_folder(records);
}

/// What was read, measured and claimed, for a person.
void print_for_people(const Flow& flow, const doors::Judgement& judgement, bool diagnose) {
  const Record& record = judgement.record;
  fmt::print("{}\n", flow.title());
  constexpr std::size_t few = 6;
  const std::size_t files = judgement.files.size();
  for (std::size_t k = 0; k < files; ++k)
    if (files <= few || k == 0 || k + 1 == files)
      fmt::print("  {}\n", judgement.files[k]);
    else if (k == 1)
      fmt::print("  ... and {} between\n", files - 2);
  for (const std::string& line : judgement.words) fmt::print("  {}\n", line);
  print_values(record);
  fmt::print("\n");
  for (const std::string& line : judgement.not_judged) fmt::print("not judged: {}\n", line);
  for (const Verdict& v : record.verdicts) fmt::print("{}\n", v.sentence);
  if (diagnose)
    for (const Diagnosis& one : record.diagnoses) print(one);
  const auto held = std::ranges::count(record.verdicts, Outcome::holds, &Verdict::outcome);
  fmt::print("{} of {} claims hold\n", held, record.verdicts.size());
}

/// Shows what was found, and keeps the record and the verdicts where a folder or a file is named.
int conclude(const Flow& flow, const doors::Judgement& judgement, const ResultOptions& results) {
  const Record& record = judgement.record;
  const bool holds = !record.verdicts.empty() &&
                     std::ranges::all_of(record.verdicts, [](const Verdict& v) { return v.outcome == Outcome::holds; });
  if (results.as_json)
    print_as_json(flow, judgement, holds);
  else
    print_for_people(flow, judgement, results.diagnose);
  if (!results.records.empty()) write(record, record_file(results.records, record.case_name + "." + record.method));
  if (!results.junit.empty()) files::write_whole(results.junit, junit_of(record));
  return holds ? all_holds : something_fails;
}

}  // namespace

int judge(const Build&, const JudgeOptions& options) {
  make_folder_of(options.results.records);
  const Flow flow = flow_of(options.flow, settings_of(options.set));
  return conclude(
      flow,
      doors::judge_files(flow, {options.files.begin(), options.files.end()}, mapping_of(options), options.spacing,
                         {.name = options.name, .at_most = options.at_most, .diagnose = options.results.diagnose}),
      options.results);
}

int prepare(const Build&, const PrepareOptions& options) {
  const doors::Solver solver = doors::read_solver(options.solver);
  doors::prepare(solver, options.folder);
  fmt::print("{}: {} folders, each with run.sh\n", options.folder, solver.spacings.size());
  return all_holds;
}

int collect(const Build&, const CollectOptions& options) {
  make_folder_of(options.results.records);
  const doors::Solver solver = doors::read_solver(options.solver);
  return conclude(solver.flow, doors::collect(solver, options.folder, suite_named(options.suite)), options.results);
}

}  // namespace touchstone::vnv::command

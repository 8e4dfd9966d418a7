#include "vnv/gate/gate.hpp"

#include "vnv/files/whole_file.hpp"
#include "vnv/gate/findings.hpp"
#include "vnv/gate/error_against_time.hpp"
#include "vnv/gate/turns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace touchstone::gate {
namespace {

RunExcerpt excerpts_of(const Program& program, const std::string& method, const std::string& suite) {
  return [=](const Excerpt& excerpt) { return run_of(program, method, suite, excerpt); };
}

/// What both builds can run, and in `found` what is only in one of them or need not be run.
std::vector<Contest> contests_of(const Build& before, const Build& after, const GateRequest& request, Findings& found) {
  std::vector<Contest> contests;
  const auto add = [&](const Program& program, const Program* other) {
    if (other && !request.all && are_same_programs(before, after, program, *other)) {
      found.skipped.push_back(program.case_name);
      return;
    }
    for (const std::string& method : program.methods) {
      if (other && std::ranges::count(other->methods, method) > 0)
        contests.push_back({.case_name = program.case_name,
                            .method = method,
                            .is_timed = program.is_timed,
                            .before = run_of(program, method, request.suite),
                            .after = run_of(*other, method, request.suite),
                            .excerpt_before = excerpts_of(program, method, request.suite),
                            .excerpt_after = excerpts_of(*other, method, request.suite)});
      else
        found.differences.push_back(of_whole_method(program.case_name, method, Change::worse));
    }
  };
  const auto program_in = [](const Build& build, const std::string& case_name) -> const Program* {
    const auto at = std::ranges::find(build.programs, case_name, &Program::case_name);
    return at == build.programs.end() ? nullptr : &*at;
  };
  for (const Program& program : before.programs) add(program, program_in(after, program.case_name));
  for (const Program& program : after.programs) {
    const Program* other = program_in(before, program.case_name);
    for (const std::string& method : program.methods)
      if (!other || std::ranges::count(other->methods, method) == 0)
        found.differences.push_back(of_whole_method(program.case_name, method, Change::unjudged));
  }
  return contests;
}

/// What a program finds that judges time is its machine's, unless it is the same.
void set_aside_times(const std::vector<Contest>& contests, std::vector<Difference>& differences) {
  for (Difference& d : differences) {
    const bool is_timed =
        std::ranges::any_of(contests, [&](const Contest& c) { return c.case_name == d.case_name && c.is_timed; });
    if (!is_timed || d.kind == Kind::run || d.change == Change::same) continue;
    d.change = Change::unjudged;
    d.why = "judges the time of its machine";
  }
}

std::vector<Difference> compare_costs(const std::vector<Contest>& contests, const Turns& turns,
                                      const GateRequest& request, std::ostream& progress) {
  std::vector<Timing> first;
  for (const Contest& contest : contests)
    if (!contest.is_timed) first.push_back(timing_of(contest, turns));
  return compare_costs(first, [&](const std::vector<Timing>& doubtful) {
    progress << fmt::format("gate: {} methods whose cost is in doubt are run again\n", doubtful.size());
    std::vector<Contest> again;
    for (const Contest& contest : contests)
      if (std::ranges::any_of(doubtful, [&](const Timing& timing) { return are_of_one_method(timing, contest); }))
        again.push_back(contest);
    const Turns longer = take_turns(again, request.repeats * times_the_pairs, progress);
    std::vector<Timing> second;
    for (const Contest& contest : again) second.push_back(timing_of(contest, longer));
    return second;
  });
}

void append(std::vector<Difference> more, Findings& found) {
  std::ranges::move(more, std::back_inserter(found.differences));
}

Turns compare_in_turn(std::vector<Contest> contests, const GateRequest& request, std::ostream& progress,
                      Findings& found) {
  found.suite = request.suite;
  if (contests.empty()) return {};
  Turns turns = take_turns(contests, std::max(1L, request.repeats), progress);
  std::vector<Difference> differences = compare_repeated(turns.before, turns.after);
  set_aside_times(contests, differences);
  append(std::move(differences), found);
  if (request.repeats > 0) append(compare_costs(contests, turns, request, progress), found);
  return turns;
}

Turns compare_records(Source& before, Source& after, Findings& found) try {
  found.suite = before.records.front().suite;
  if (after.records.front().suite != found.suite)
    throw BadInput(fmt::format("{}: suite '{}', {}: suite '{}', expected records of one suite", before.name,
                               found.suite, after.name, after.records.front().suite));
  found.differences = compare(before.records, after.records);
  return {{std::move(before.records)}, {std::move(after.records)}};
} catch (const std::invalid_argument& error) {
  throw BadInput(error.what());
}

/// Writes what was found wherever it is wanted, and concludes.
Status conclude(const GateRequest& request, const Findings& found, const Turns& turns, std::ostream& output) {
  output << text_of(found) << std::flush;
  if (!request.markdown.empty()) files::write_whole(request.markdown, markdown_of(found));
  if (!request.json.empty()) files::write_whole(request.json, json_of(found));
  if (!request.figure.empty()) {
    vnv::Record page = error_against_time(turns.before, turns.after);
    page.verdicts = verdicts_of(found);
    page.tables = {page_table_of(found)};
    vnv::write(page, request.figure);
  }
  const Change conclusion = conclusion_of(found);
  return conclusion == Change::worse ? worse : conclusion == Change::inconclusive ? inconclusive : same_or_better;
}

}  // namespace

Status gate(const GateRequest& request, const Contest& contest, std::ostream& output, std::ostream& progress) {
  Findings found{request.before, request.after, {}, {}, {}};
  const Turns turns = compare_in_turn({contest}, request, progress, found);
  return conclude(request, found, turns, output);
}

Status gate(const GateRequest& request, std::ostream& output, std::ostream& progress) {
  Revisions revisions(std::filesystem::current_path());
  Source before = open_source(request.before, request, revisions, progress);
  Source after = open_source(request.after, request, revisions, progress);
  if (before.build.has_value() != after.build.has_value())
    throw BadInput(fmt::format("{} is a build and {} is none, expected two of a kind",
                               before.build ? before.name : after.name, before.build ? after.name : before.name));
  Findings found{request.before, request.after, {}, {}, {}};
  const Turns turns =
      before.build ? compare_in_turn(contests_of(*before.build, *after.build, request, found), request, progress, found)
                   : compare_records(before, after, found);
  return conclude(request, found, turns, output);
}

}  // namespace touchstone::gate

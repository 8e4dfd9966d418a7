#include "vnv/harness/assess.hpp"

#include "vnv/files/tables.hpp"
#include "vnv/harness/environment.hpp"
#include "vnv/harness/run_levels.hpp"
#include "vnv/judge/order.hpp"
#include "vnv/measures/coverage.hpp"
#include "vnv/record/same_time.hpp"
#include "vnv/studies/ensemble.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace touchstone::vnv {
namespace {

/// What a run monitored, as a CSV file. Throws std::invalid_argument unless each number is a quantity with a name.
HistoryFile history_of(const Case& declared, const std::string& name, const Run& run) {
  std::vector<std::string> headings{"time [s]"};
  for (const Quantity& quantity : declared.monitor.quantities) headings.push_back(quantity.heading());
  std::string text =
      fmt::format("# title: {} {}, monitored quantities\n{}", name, run.summary.level, csv_line(headings));
  for (std::size_t k = 0; k < run.history.time.size(); ++k) {
    if (run.history.values[k].size() + 1 != headings.size())
      throw std::invalid_argument(fmt::format("{}: {} numbers are monitored, expected as many as quantities, {}", name,
                                              run.history.values[k].size(), headings.size() - 1));
    text += fmt::format("{}{}{}\n", run.history.time[k], headings.size() > 1 ? "," : "",
                        fmt::join(run.history.values[k], ","));
  }
  return {run.summary.level, fmt::format("histories/{}.csv", stem_of_files(name, run.summary.level)), std::move(text)};
}

/// Measures each run and keeps account in the record.
void measure_runs(const Case& declared, const Method& method, const std::vector<Run>& runs, Record& record) {
  for (const Run& run : runs) {
    const StopWatch measuring;
    record.values.insert(record.values.end(), run.found.begin(), run.found.end());
    record.curves.insert(record.curves.end(), run.curves.begin(), run.curves.end());
    const auto level = std::ranges::find(method.levels, run.summary.level, &Level::name);
    for (const Measurement& measure : declared.measurements) {
      const std::vector<Value> errors = measure(*level, run);
      record.values.insert(record.values.end(), errors.begin(), errors.end());
    }
    if (declared.monitor.evaluate && !run.history.time.empty())
      record.histories.push_back(history_of(declared, record.case_name + "." + record.method, run));
    std::ranges::move(coverage_of(*level, run), std::back_inserter(record.values));
    record.runs.push_back(run.summary);
    record.runs.back().cost.harness += measuring.seconds();
  }
}

/// The errors of one quantity and time along a ladder, as far as this suite ran it.
ObservedOrder order_along(const Ladder& ladder, const Record& record, const Quantity& quantity, double time) {
  std::vector<std::string> levels;
  std::vector<double> spacings, errors;
  for (const std::string& level : ladder.levels)
    for (const Value& e : record.values)
      if (e.level == level && e.quantity == quantity && std::abs(e.time - time) <= 1e-9 * time) {
        levels.push_back(level);
        spacings.push_back(e.spacing);
        errors.push_back(e.value);
      }
  ObservedOrder order = observe_order(spacings, errors);
  order.ladder = ladder.name;
  order.quantity = quantity.heading();
  order.time = time;
  order.levels = levels;
  return order;
}

/// Orders of the norms, at each time that at least two levels of a ladder reached.
void observe_orders(const Method& method, Record& record) {
  for (const Ladder& ladder : method.ladders)
    for (const Value& e : record.values) {
      if (e.level != ladder.levels.front() || !(e.time > 0) || e.quantity.kind != Kind::norm) continue;
      ObservedOrder order = order_along(ladder, record, e.quantity, e.time);
      if (order.levels.size() >= 2) record.orders.push_back(std::move(order));
    }
}

/// Throws std::invalid_argument for a ladder that the method has not got.
const Ladder& find_ladder(const Method& method, const std::string& name) {
  for (const Ladder& ladder : method.ladders)
    if (ladder.name == name) return ladder;
  throw std::invalid_argument(fmt::format("{}: no ladder '{}'", method.name, name));
}

/// Throws std::invalid_argument for a claim or a ladder that names a level or ladder that the method has not got.
void require_known_names(const Method& method) {
  const auto require_level = [&](const std::string& name) {
    if (!name.empty() && std::ranges::find(method.levels, name, &Level::name) == method.levels.end())
      throw std::invalid_argument(fmt::format("{}: no level '{}'", method.name, name));
  };
  for (const Ladder& ladder : method.ladders) std::ranges::for_each(ladder.levels, require_level);
  for (const Claim& claim : method.claims) {
    require_level(claim.level);
    if (!claim.ladder.empty()) find_ladder(method, claim.ladder);
  }
}

/// Whether the suite runs a level for as long as a claim speaks of.
bool is_run(const Claim& claim, const Method& method, Suite suite) {
  const auto is_on = [&](const Level& level) {
    if (claim.ladder.empty()) return claim.covers(level.name, claim.time);
    const std::vector<std::string>& levels = find_ladder(method, claim.ladder).levels;
    return std::ranges::find(levels, level.name) != levels.end();
  };
  const auto runs = std::ranges::count_if(method.levels, [&](const Level& level) {
    return is_on(level) && level.until(suite) > 0 &&
           (std::isnan(claim.time) || level.until(suite) >= claim.time * (1 - 1e-9));
  });
  return runs >= (claim.ladder.empty() ? 1 : claim.least_levels);
}

void judge_claim(const Claim& claim, const Method& method, Suite suite, const std::vector<Value>& values,
                 Record& record) {
  const std::size_t before = record.verdicts.size();
  Place place{record.case_name, method.name, claim.level, not_a_number, claim.time};
  if (!claim.ladder.empty()) {
    for (const ObservedOrder& order : record.orders)
      if (order.ladder == claim.ladder && order.quantity == claim.quantity.heading() && claim.covers("", order.time) &&
          std::ssize(order.levels) >= claim.least_levels) {
        place.time = order.time;
        record.verdicts.push_back(judge(claim, place, order));
      }
  } else {
    for (const Value& e : values)
      if (e.quantity == claim.quantity && claim.covers(e.level, e.time))
        record.verdicts.push_back(judge(claim, {record.case_name, method.name, e.level, e.spacing, e.time}, e.value));
  }
  if (record.verdicts.size() == before && is_run(claim, method, suite))
    record.verdicts.push_back(judge(claim, place, not_a_number));  // the run ended before, or nothing measures this
}

/// What claims may speak of: the errors of the runs, and what was found over all of them.
std::vector<Value> all_values(const Case& declared, const Results& results, const Record& record) {
  std::vector<Value> values = record.values;
  for (const Finding& find : declared.findings) {
    const std::vector<Value> found = find(results, record);
    values.insert(values.end(), found.begin(), found.end());
  }
  return values;
}

/// The last few of values: of several levels the finest at its end.
std::string last_of(const std::vector<Value>& values) {
  const Value& last = values.back();
  std::vector<std::string> words;
  for (const Value& e : values)
    if (e.level == last.level && e.time == last.time && words.size() < 3)
      words.push_back(fmt::format("{} = {:.3g}", e.quantity.heading(), e.value));
  const std::string where = last.level.empty() ? "" : last.level + ", ";
  return fmt::format(" ({}{:.3g} s: {})", where, last.time, fmt::join(words, ", "));
}

/// One verdict on all values of a method that were never accepted, which shows some and says how they would be.
void ask_for_acceptance(long count, const std::string& shown, Suite suite, Record& record) {
  if (count == 0 || suite != Suite::acceptance) return;
  const Claim accepted{
      {std::string(never_accepted), "", Kind::count}, std::nullopt, std::nullopt, baseline("none yet")};
  Verdict v = judge(accepted, {record.case_name, record.method, ""}, static_cast<double>(count));
  v.sentence = fmt::format(
      "{0}.{1}: {2} no accepted baseline yet{4}; accept {3} with: build/vnv/vnv accept {0}.{1} --reason \"...\"",
      record.case_name, record.method, count == 1 ? "1 value has" : fmt::format("{} values have", count),
      count == 1 ? "it" : "them", shown);
  record.verdicts.push_back(std::move(v));
}

/// Each value keeps within the limits that were accepted with the last one.
void judge_baselines(const Baselines& baselines, Suite suite, Record& record) {
  std::vector<Value> not_accepted;
  for (const Value& e : record.values) {
    if (is_of_coverage(e.quantity.name)) continue;
    const Baseline* last = baselines.find(record.method, e.level, e.time, e.quantity.heading());
    const Place place{record.case_name, record.method, e.level, e.spacing, e.time};
    if (last)
      record.verdicts.push_back(
          judge(between(e.quantity, last->lower, last->upper, baseline(last->basis)), place, e.value));
    else
      not_accepted.push_back(e);
  }
  ask_for_acceptance(std::ssize(not_accepted), not_accepted.empty() ? "" : last_of(not_accepted), suite, record);
}

/// What the members of an ensemble are together is of the distribution that was accepted; each alone is chance.
void judge_ensemble(const Baselines& baselines, Suite suite, Record& record) {
  long not_accepted = 0;
  for (const EnsembleComparison& one : compare_with_accepted(record, baselines)) {
    if (is_of_coverage(one.quantity.name)) continue;
    const Claim alike =
        at_least({one.quantity.name + ", p-value against the accepted ensemble", "", Kind::probability}, least_p_value,
                 baseline(fmt::format("{} accepted members; Anderson-Darling permutation test", one.accepted.size())));
    if (!one.accepted.empty())
      record.verdicts.push_back(
          judge(alike, {record.case_name, record.method, "", not_a_number, one.time}, one.p_value));
    else
      ++not_accepted;
  }
  ask_for_acceptance(not_accepted, "", suite, record);
}

/// What a baseline holds of a run must still be measured, unless it is reported at the end of a run and this run went
/// on.
void miss_lost_values(const Baselines& baselines, Record& record) {
  for (const Baseline& last : baselines.rows) {
    const auto run = std::ranges::find(record.runs, last.level, &RunSummary::level);
    if (last.method != record.method || run == record.runs.end() || last.time > run->end_time * (1 + 1e-9)) continue;
    const bool measured = std::ranges::any_of(record.values, [&](const Value& e) {
      return baselines.find(record.method, e.level, e.time, e.quantity.heading()) == &last;
    });
    const bool measured_later = std::ranges::any_of(record.values, [&](const Value& e) {
      return e.level == last.level && e.quantity.heading() == last.quantity && e.time > last.time;
    });
    if (!measured && !measured_later)
      record.verdicts.push_back(
          judge(between(with_heading(last.quantity), last.lower, last.upper, baseline(last.basis)),
                {record.case_name, record.method, last.level, run->spacing, last.time}, not_a_number));
  }
}

const Quantity end_of_run{std::string(end_time_reached), "", Kind::value, Better::larger};

/// Every run is claimed to end where it was meant to, unless that is the question.
void judge_ends(const Method& method, Record& record) {
  for (const RunSummary& run : record.runs) {
    if (std::ranges::find(method.levels, run.level, &Level::name)->may_diverge) continue;
    const Claim ends = at_least(end_of_run, 1, theory("a stable method reaches the end time"));
    Verdict v =
        judge(ends, {record.case_name, record.method, run.level, run.spacing, run.end_time}, run.finished ? 1 : 0);
    if (!run.finished)
      v.sentence = fmt::format("{}.{} {}: {}: FAILS", record.case_name, record.method, run.level, run.outcome);
    record.verdicts.push_back(std::move(v));
  }
}

/// The fluid of every simulation is claimed to stay together, unless it is made to see whether it diverges; what a method
/// claims itself goes before.
void judge_coverage(const Method& method, const std::vector<Run>& runs, Record& record) {
  for (const Run& run : runs) {
    const RunSummary& of = run.summary;
    const auto level = std::ranges::find(method.levels, of.level, &Level::name);
    if (!run.room || !of.finished || level->may_diverge) continue;
    for (const Quantity& quantity : {largest_hole, rows_in_one_place, rows_crowded}) {
      if (quantity == largest_hole && !fills_its_domain(*level, run)) continue;
      if (std::ranges::find(method.claims, quantity, &Claim::quantity) != method.claims.end()) continue;
      const auto measured = std::ranges::find_if(record.values, [&](const Value& e) {
        return e.level == of.level && e.quantity == quantity && same_time(e.time, of.end_time);
      });
      record.verdicts.push_back(judge(claim_of_coverage(quantity, static_cast<double>(of.cost.particles)),
                                      {record.case_name, record.method, of.level, of.spacing, of.end_time},
                                      measured == record.values.end() ? not_a_number : measured->value));
    }
  }
}

}  // namespace

std::string stem_of_files(const std::string& name, const std::string& level) {
  std::string stem = fmt::format("{}.{}", name, level);
  std::ranges::replace_if(
      stem, [](unsigned char c) { return !std::isalnum(c) && c != '.' && c != '-'; }, '_');
  return stem;
}

Record record_of(const std::string& case_name, const Case& declared, const Method& method, Suite suite) {
  Record record;
  record.case_name = case_name;
  record.title = declared.title;
  record.description = declared.description;
  record.method = method.name;
  record.method_description = method.description;
  record.as_printed = method.as_printed;
  record.suite = name_of(suite);
  return record;
}

Record assess(const std::string& case_name, const Case& declared, const Method& method, Suite suite,
              const std::optional<Baselines>& baselines) {
  require_known_names(method);
  return assess(case_name, declared, {method, suite, run_levels(case_name, declared, method, suite)}, baselines);
}

Record assess(const std::string& case_name, const Case& declared, const Results& results,
              const std::optional<Baselines>& baselines) {
  const auto& [method, suite, runs] = results;
  require_known_names(method);
  Record record = record_of(case_name, declared, method, suite);
  measure_runs(declared, method, runs, record);
  observe_orders(method, record);
  judge_ends(method, record);
  const std::vector<Value> values = all_values(declared, results, record);
  const auto judge_all = [&](const std::vector<Claim>& claims) {
    for (const Claim& claim : claims) judge_claim(claim, results.method, results.suite, values, record);
  };
  if (suite == Suite::work) {
    judge_all(method.claims_of_work);
  } else {
    judge_all(declared.claims);
    judge_all(method.claims);
    judge_coverage(method, runs, record);
  }
  if (baselines) {
    (declared.ensemble ? judge_ensemble : judge_baselines)(*baselines, suite, record);
    miss_lost_values(*baselines, record);
  }
  for (const Plot& plot : declared.plots) plot(results, record);
  describe_environment(record);
  return record;
}

bool claims_more_than_ends(const Record& record) {
  return !std::ranges::all_of(
      record.verdicts, [](const Verdict& v) { return v.quantity == end_of_run.name || is_of_coverage(v.quantity); });
}

std::vector<std::string> complaints(const Record& record, const AcceptedClaims& accepted) {
  std::vector<std::string> lines;
  const std::string name = record.case_name + "." + record.method;
  if (!claims_more_than_ends(record)) lines.push_back(name + ": nothing was judged, expected at least one claim");
  for (const Verdict& verdict : record.verdicts)
    if (verdict.outcome != Outcome::holds)
      lines.push_back(verdict.sentence);
    else if (const std::string what = contradiction(verdict, record); !what.empty())
      lines.push_back(fmt::format("{}: {}", verdict.sentence, what));
  const ClaimCount* last = accepted.find(record.case_name, record.method, record.suite);
  const ClaimCount found = claims_in(record);
  if (const long missing = last ? missing_of(*last, found) : 0; lines.empty() && missing > 0)
    lines.push_back(fmt::format("{}: {} fewer than accepted: {}", name,
                                missing == 1 ? "1 claim" : fmt::format("{} claims", missing),
                                missing_in_words(*last, found)));
  return lines;
}

std::vector<Baseline> baselines_from(const Record& record, const Tolerance& tolerance) {
  std::vector<Baseline> rows;
  for (const Value& e : record.values) {
    if (is_of_coverage(e.quantity.name)) continue;
    const std::string heading = e.quantity.heading();
    const auto wider = std::ranges::find_if(tolerance.exceptions, [&](const Tolerance::Exception& exception) {
      return heading.find(exception.words) != heading.npos;
    });
    const bool is_exception = wider != tolerance.exceptions.end();
    const double relative = is_exception ? wider->relative : tolerance.relative;
    const double allowed = std::max(relative * std::abs(e.value), tolerance.absolute);
    rows.push_back({record.method, e.level, e.time, heading, e.value, e.value - allowed, e.value + allowed,
                    is_exception ? wider->basis : tolerance.basis});
  }
  return rows;
}

}  // namespace touchstone::vnv

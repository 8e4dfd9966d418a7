#include "vnv/doors/judge.hpp"

#include "vnv/doors/diagnosis/diagnosis.hpp"
#include "vnv/doors/filling.hpp"
#include "vnv/harness/assess.hpp"
#include "vnv/judge/baselines.hpp"
#include "vnv/measures/coverage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>

namespace touchstone::vnv::doors {
namespace {

/// A run of what was given, whose samples it takes, as if it had been computed here.
Run run_of(GivenLevel& given, const std::string& level, const Monitor& monitor) {
  Run run{.summary = {.level = level,
                      .spacing = given.spacing,
                      .finished = given.outcome == "finished",
                      .outcome = given.outcome,
                      .cost = given.cost}};
  for (auto& [time, samples] : given.at) {
    run.samples.push_back(std::move(samples));
    if (!monitor.evaluate) continue;
    run.history.time.push_back(time);
    run.history.values.push_back(monitor.evaluate(run.samples.back()));
  }
  if (run.samples.empty()) return run;
  run.summary.end_time = run.samples.back().time;
  run.summary.cost.particles = run.samples.back().size();
  return run;
}

/// The time that was asked for, of a sample that is the nearest to it and within 1 %; of any other sample its own.
double asked(double time, const std::vector<double>& times, const std::vector<Samples>& all) {
  const auto to = [](double one) { return [one](double other) { return std::abs(one - other); }; };
  const auto one = std::ranges::min_element(times, {}, to(time));
  if (one == times.end() || to(*one)(time) > time_tolerance * *one) return time;
  const bool another_is_nearer = std::ranges::any_of(
      all, [&](double other) { return to(*one)(other) < to(*one)(time); }, &Samples::time);
  return another_is_nearer ? time : *one;
}

/// Whether fields hold nothing that is not a finite number.
bool are_numbers(const std::vector<std::string>& fields, const std::vector<Samples>& all) {
  return std::ranges::all_of(all, [&](const Samples& s) {
    return (!has(fields, velocity_along_x) || s.v.row(0).allFinite()) &&
           (!has(fields, "velocity") || s.v.allFinite()) && (!has(fields, "pressure") || s.pressure.allFinite());
  });
}

/// A span, of a steady flow as long before a later end [s].
Span span_of(Span span, double end) {
  const double later = span.is_steady ? std::max(0.0, end - span.last) : 0;
  return {span.first + later, span.last + later, span.least};
}

/// Those times at which a measurement can be made: at others, as at rest, there is nothing to compare with.
Measurement where_defined(const Measured& measured, const std::vector<double>& times,
                          std::vector<std::string>& not_judged) {
  const auto add = [=, &times, &not_judged](std::vector<Value>& all, const Level& level, const Run& run,
                                            const std::vector<Samples>& given) {
    try {
      for (Value value : measured.measurement(level, run)) {
        value.time = asked(value.time, times, given);
        if (std::isnan(value.value) && are_numbers(measured.fields, run.samples))  // as where no row is
          not_judged.push_back(fmt::format("{}, {:g} s: {}: cannot be measured of these rows", level.name, value.time,
                                           value.quantity.name));
        else
          all.push_back(std::move(value));
      }
    } catch (const std::logic_error& error) {
      not_judged.push_back(fmt::format("{}, {:g} s: {}", level.name, run.samples.back().time, error.what()));
    }
  };
  return [=, &not_judged](const Level& level, const Run& run) {
    std::vector<Value> all;
    if (run.samples.empty()) return all;  // it did not answer, as its verdict says
    if (!measured.over && run.samples.size() > 1) {
      for (const Samples& samples : run.samples)
        add(all, level, {.summary = run.summary, .samples = {samples}}, run.samples);
    } else if (!measured.over) {
      add(all, level, run, run.samples);  // without a copy
    } else if (const Span at = span_of(*measured.over, run.samples.back().time);
               run.samples.size() < at.least || run.samples.front().time > at.first * (1 + time_tolerance) ||
               run.samples.back().time < at.last * (1 - time_tolerance)) {
      const std::string first = std::isfinite(at.first) ? fmt::format(", the first at {:g} s or before", at.first) : "",
                        last = at.last > 0 ? fmt::format(", the last at {:g} s or after", at.last) : "";
      not_judged.push_back(fmt::format("{}: {} over time: {} {} from {:g} to {:g} s, expected {} or more{}{}",
                                       level.name, measured.name, run.samples.size(),
                                       run.samples.size() == 1 ? "time" : "times", run.samples.front().time,
                                       run.samples.back().time, at.least, first, last));
    } else {
      add(all, level, run, run.samples);
    }
    return all;
  };
}

/// The flow's case with what is measured of the fields that there are.
Case case_of(const Flow& flow, const Given& given, const std::vector<double>& times,
             std::vector<std::string>& not_judged) {
  Case judged = flow.judged;
  std::ranges::copy(flow.aside, std::back_inserter(judged.claims));
  judged.title = flow.title();
  for (const Measured& one : flow.measured) {
    const auto missing = std::ranges::find_if(
        one.fields, [&](const std::string& name) { return given.fields && !has(*given.fields, name); });
    if (missing == one.fields.end())
      judged.measurements.push_back(where_defined(one, times, not_judged));
    else if (const std::string line = fmt::format(
                 "no {} in the files: what is measured of it is not judged",
                 *missing == "velocity" && has(*given.fields, velocity_along_x) ? "velocity along y" : *missing);
             !has(not_judged, line))
      not_judged.push_back(line);
  }
  return judged;
}

/// A user's own limits of orders, of the norms of which the flow claims one.
std::vector<Claim> own_claims(const Flow& flow, const Judged& what) {
  std::vector<Claim> claims;
  for (const Claim& claim : flow.judged.claims)
    if (what.order_at_least && !claim.ladder.empty())
      claims.push_back(order_at_least(ladder_of_files, claim.quantity, *what.order_at_least, *what.order_at_least - 0.5,
                                      baseline("order that the user expects"))
                           .with_at_least_levels(3));
  return claims;
}

/// A user's limit [%] of each error at the finest resolution: its size, of one with a sign too, and a hundredth of it
/// of one that is a pure number. Fails where there is none.
void limit_errors(double percent, const std::string& finest, Record& record) {
  const auto is_error = [](const Quantity& q) {
    return (q.kind == Kind::norm || q.kind == Kind::error || q.kind == Kind::deviation) &&
           (q.unit == "%" || q.unit.empty());
  };
  const Author user = baseline("limit of the user");
  bool is_any = false;
  for (const Value& v : record.values) {
    if (v.level != finest || !is_error(v.quantity)) continue;
    const double limit = v.quantity.unit.empty() ? percent / 100 : percent;
    record.verdicts.push_back(judge(v.quantity.kind == Kind::deviation ? between(v.quantity, -limit, limit, user)
                                                                       : at_most(v.quantity, limit, user),
                                    {record.case_name, record.method, v.level, v.spacing, v.time}, v.value));
    is_any = true;
  }
  if (is_any) return;
  Verdict none =
      judge(at_least({std::string(anything_limited)}, 1, user), {record.case_name, record.method, finest}, 0);
  none.sentence = fmt::format("{}.{} {}: the limit of {:g} % applies to nothing: no error was measured: FAILS",
                              record.case_name, record.method, finest, percent);
  record.verdicts.push_back(std::move(none));
}

/// What is measured of fields that are there is a number, whether or not it is limited.
void refuse_what_is_no_number(Record& record) {
  for (const Value& v : record.values) {
    const auto fails = [&](const Verdict& other) {
      return other.level == v.level && other.quantity == v.quantity.name && std::isnan(other.value);
    };
    if (!std::isnan(v.value) || std::ranges::any_of(record.verdicts, fails)) continue;
    const Place place{record.case_name, record.method, v.level, v.spacing, v.time};
    Verdict is_none = judge(at_least(v.quantity, 0, theory("what is measured is a number")), place, v.value);
    is_none.sentence = fmt::format("{}.{} {}: {} = nan at {:.4g} s, expected a number: FAILS", record.case_name,
                                   record.method, v.level, v.quantity.name, v.time);
    record.verdicts.push_back(std::move(is_none));
  }
}

/// A velocity that is farther off than none, or at one row than twice the largest, as a reversed one is, is none of the
/// flow: also where it falls with the spacing, as that of one wild row does.
void refuse_what_is_worse_than_nothing(const Flow& flow, Record& record) {
  for (const Exact& exact : flow.exact)
    for (const Value& v : record.values) {
      const double most = v.quantity.name.starts_with("Linf") ? 200 : 100;
      if (exact.field != "velocity" || !has(exact.norms, v.quantity.name) || !(v.value > most)) continue;
      record.verdicts.push_back(
          judge(at_most(v.quantity, most, theory("a fluid at rest is 100 % off, a reversed one 200 %")),
                {record.case_name, record.method, v.level, v.spacing, v.time}, v.value));
    }
}

/// Errors that are rounding, of numbers in single precision or with eight digits, have no order, and need none.
void take_rounding_for_converged(const std::vector<Claim>& claims, Record& record) {
  constexpr double rounding = 1e-4;  // %  of files with six digits
  const auto is_rounding = [](const ObservedOrder& order) {
    return order.quantity.ends_with("[%]") && std::abs(order.errors.back()) <= rounding;
  };
  for (const Claim& claim : claims)
    for (const ObservedOrder& order : record.orders) {
      if (claim.ladder.empty() || order.quantity != claim.quantity.heading() || !is_rounding(order)) continue;
      for (Verdict& v : record.verdicts)
        if (v.quantity == judged_quantity(claim).name && v.time == order.time)
          v = judge(at_most(claim.quantity, rounding, theory("an error at rounding is converged")),
                    {record.case_name, record.method, order.levels.back(), order.spacings.back(), order.time},
                    order.errors.back());
    }
  std::erase_if(record.orders, is_rounding);
}

/// For want of a field, or of times of one level, as has been said.
void leave_out_what_is_not_measured(const std::vector<Claim>& claims, Record& record) {
  for (const Claim& claim : claims) {
    const auto is_claimed = [&](const Value& value) { return value.quantity.name == claim.quantity.name; };
    if (std::ranges::any_of(record.values, is_claimed)) continue;
    std::erase_if(record.verdicts, [&](const Verdict& v) { return v.quantity == judged_quantity(claim).name; });
  }
  std::erase_if(record.verdicts, [&](const Verdict& v) {
    const auto is_it = [&](const Value& value) { return value.level == v.level && value.quantity.name == v.quantity; };
    return std::isnan(v.value) && !v.level.empty() && std::ranges::none_of(record.values, is_it);
  });
}

/// An order is that of one time, which three resolutions have to have.
void leave_out_orders_of_no_time(const std::vector<Claim>& claims, Record& record,
                                 std::vector<std::string>& not_judged) {
  for (const Claim& claim : claims) {
    std::map<double, int> levels;  // by time
    for (const Value& value : record.values)
      if (!claim.ladder.empty() && value.quantity.name == claim.quantity.name) ++levels[value.time];
    if (levels.empty() || std::ranges::any_of(levels, [](const auto& at) { return at.second >= 3; })) continue;
    if (std::erase_if(record.verdicts, [&](const Verdict& v) { return v.quantity == judged_quantity(claim).name; }))
      not_judged.push_back(
          fmt::format("order of {}: no time at which there are three resolutions", claim.quantity.name));
  }
}

/// Says with each verdict on a filling that fails where it does.
void say_where(const Filling& filling, Record& record) {
  for (Verdict& v : record.verdicts)
    for (const auto& [quantity, where] : filling.where)
      if (v.level == filling.level && v.quantity == quantity && v.outcome != Outcome::holds && !where.empty())
        v.sentence += "; " + where;
}

/// Where all claims on a filling hold, one of them speaks for the others: that of the hole, or else the first.
void say_briefly(const Filling& filling, Record& record) {
  const auto is_of_it = [&](const Verdict& v) { return v.level == filling.level && is_of_filling(v.quantity); };
  const auto fails = [&](const Verdict& v) { return is_of_it(v) && v.outcome != Outcome::holds; };
  auto spokesman = std::ranges::find_if(
      record.verdicts, [&](const Verdict& v) { return is_of_it(v) && v.quantity == largest_hole.name; });
  if (spokesman == record.verdicts.end()) spokesman = std::ranges::find_if(record.verdicts, is_of_it);
  if (spokesman == record.verdicts.end() || std::ranges::any_of(record.verdicts, fails)) return;
  std::string others;
  for (const Verdict& v : record.verdicts)
    if (is_of_it(v) && v.quantity != spokesman->quantity)
      others += fmt::format("{}{} = {:.4g}{}", others.empty() ? "" : ", ", v.quantity, v.value,
                            v.unit.empty() ? "" : " " + v.unit);
  if (!others.empty())
    spokesman->sentence +=
        fmt::format("; {}, as {} hold, too", filling.is_counted ? "all the fluid is there" : "it has no hole", others);
  const std::string kept = spokesman->quantity;
  std::erase_if(record.verdicts, [&](const Verdict& v) { return is_of_it(v) && v.quantity != kept; });
}

/// That its runs end, that all the fluid is there and what it does not do says nothing of how it flows: who claims no
/// more does not pass.
void refuse_to_claim_nothing(const Flow& flow, Record& record) {
  const auto is_of_flow = [&](const Verdict& v) {
    const auto is_it = [&](const Claim& claim) { return claim.quantity.name == v.quantity; };
    return v.quantity != end_time_reached && !is_of_filling(v.quantity) && std::ranges::none_of(flow.aside, is_it);
  };
  if (std::ranges::any_of(record.verdicts, is_of_flow)) return;
  Verdict v = judge(at_least({std::string(anything_claimed)}, 1, theory("a verdict needs a claim")),
                    Place{.case_name = record.case_name, .method = record.method, .level = ""}, 0);
  v.sentence = fmt::format(
      "{}.{}: nothing was claimed of its errors: three resolutions show the order, --at-most PERCENT or at_most in "
      "[claims] sets a limit: FAILS",
      record.case_name, record.method);
  record.verdicts.push_back(std::move(v));
}

/// Whether a verdict is of a norm of the field, or of the order of one.
bool is_of(const Exact& exact, const Verdict& verdict, const std::vector<Claim>& claims) {
  return has(exact.norms, verdict.quantity) || std::ranges::any_of(claims, [&](const Claim& claim) {
           return has(exact.norms, claim.quantity.name) && judged_quantity(claim).name == verdict.quantity;
         });
}

/// What diagnose() finds of each level; of all of them that it cannot be made, should it throw: a judgement does not
/// end by it.
std::vector<Diagnosis> diagnosed(const Flow& flow, const Exact& exact, const Results& results, const Record& record) {
  std::vector<Diagnosed> levels;
  std::vector<const Exact*> others;
  for (const Exact& other : flow.exact)
    if (&other != &exact &&
        std::ranges::any_of(record.values, [&](const Value& v) { return has(other.norms, v.quantity.name); }))
      others.push_back(&other);
  for (std::size_t k = 0; k < results.runs.size(); ++k) {
    levels.push_back({.samples = {}, .spacing = results.method.levels[k].spacing});
    for (const Samples& at : results.runs[k].samples) levels.back().samples.push_back(&at);
  }
  try {
    return diagnose(exact, levels, flow.domain, 0.3, others);
  } catch (const std::exception& error) {
    return std::vector<Diagnosis>(levels.size(), {.field = exact.field,
                                                  .sentence = fmt::format("no diagnosis of the {} could be made: {}",
                                                                          exact.field, error.what())});
  }
}

/// Diagnoses each field and level of which a verdict does not hold, an order as its finest level, and adds what is
/// found to the sentences of these verdicts. If asked, all others too.
void diagnose_failures(const Flow& flow, const Results& results, const std::vector<Claim>& claims, bool diagnose_all,
                       Record& record) {
  const std::vector<Level>& levels = results.method.levels;
  for (const Exact& exact : flow.exact) {
    std::vector<Diagnosis> of_levels;
    for (std::size_t k = 0; k < levels.size(); ++k) {
      const auto has_value = [&](const Value& v) {
        return v.level == levels[k].name && has(exact.norms, v.quantity.name);
      };
      if (std::ranges::none_of(record.values, has_value)) continue;
      std::vector<Verdict*> of_it;
      for (Verdict& v : record.verdicts)
        if (is_of(exact, v, claims) && (v.level == levels[k].name || (v.level.empty() && k + 1 == levels.size())))
          of_it.push_back(&v);
      const auto fails = [](const Verdict* v) { return v->outcome != Outcome::holds; };
      if (std::ranges::none_of(of_it, fails) && !diagnose_all) continue;
      if (of_levels.empty()) of_levels = diagnosed(flow, exact, results, record);
      Diagnosis& found = of_levels[k];
      found.level = levels[k].name;
      for (Verdict* v : of_it) {
        if (!has(found.quantities, v->quantity)) found.quantities.push_back(v->quantity);
        if (fails(v)) v->sentence += "; " + found.sentence;
      }
      record.diagnoses.push_back(std::move(found));
    }
  }
}

}  // namespace

bool is_limited(const Value& value, const Record& record) {
  if (is_of_filling(value.quantity.name)) return true;  // its verdict may speak for several
  return std::ranges::any_of(record.verdicts, [&](const Verdict& v) {
    return (v.quantity == value.quantity.name && v.level == value.level) ||
           v.quantity.starts_with("order of " + value.quantity.name + " over ");
  });
}

Judgement judge_given(const Flow& flow, Given given, const Judged& what) {
  Judgement judgement{.files = given.files, .words = given.words};
  std::ranges::sort(given.levels, std::greater{}, &GivenLevel::spacing);
  const std::vector<double>& times = what.times.empty() ? flow.judged.times : what.times;
  Case judged = case_of(flow, given, times, judgement.not_judged);
  Method method{.name = what.name, .description = what.description, .ladders = {{ladder_of_files, {}}}};
  std::vector<Run> runs;
  std::vector<Filling> fillings;
  for (GivenLevel& level : given.levels) {
    const std::string name = level_name(flow, level.spacing);
    fillings.push_back(filling_of(flow, name, level, given.fields.value_or(std::vector<std::string>{})));
    runs.push_back(run_of(level, name, flow.judged.monitor));
    if (flow.across / level.spacing > flow.resolved * (1 - 1e-6))
      for (const Claim& claim : flow.of_resolved) judged.claims.push_back(claim.on(name));
    else if (flow.of_coarse)
      for (const Claim& claim : flow.of_coarse(flow.across / level.spacing)) judged.claims.push_back(claim.on(name));
    const double end = level.at.empty() ? times.back() : asked(level.at.rbegin()->first, times, runs.back().samples);
    method.levels.push_back({.name = name, .spacing = level.spacing, .acceptance = end, .report = end, .nightly = end});
    method.ladders[0].levels.push_back(name);
  }
  for (const Filling& filling : fillings) {
    std::ranges::copy(filling.claims, std::back_inserter(judged.claims));
    std::ranges::copy(filling.told, std::back_inserter(judgement.words));
  }
  judged.measurements.push_back([&](const Level& level, const Run& run) {
    std::vector<Value> values = std::ranges::find(fillings, level.name, &Filling::level)->values;
    for (Value& value : values) value.time = asked(value.time, times, run.samples);
    return values;
  });
  method.claims = own_claims(flow, what);
  const Results results{method, what.suite, std::move(runs)};
  judgement.record =
      assess(flow.case_name(), judged, results, what.baselines ? std::optional(*what.baselines) : std::nullopt);
  judgement.record.another_code = true;
  for (const Filling& filling : fillings) {
    say_where(filling, judgement.record);
    say_briefly(filling, judgement.record);
  }
  std::vector<Claim> claims = judged.claims;
  std::ranges::copy(method.claims, std::back_inserter(claims));
  const bool all_finished =
      std::ranges::all_of(given.levels, [](const GivenLevel& level) { return level.outcome == "finished"; });
  take_rounding_for_converged(claims, judgement.record);
  if (const GivenLevel& finest = given.levels.back(); what.at_most && finest.outcome == "finished")
    limit_errors(*what.at_most, method.levels.back().name, judgement.record);
  refuse_what_is_no_number(judgement.record);
  refuse_what_is_worse_than_nothing(flow, judgement.record);
  for (const std::string field : {"velocity", "pressure"})
    if (given.fields && has(*given.fields, field) &&
        std::ranges::none_of(flow.measured, [&](const Measured& one) { return has(one.fields, field); }))
      judgement.not_judged.push_back(fmt::format("{}: nothing of it is measured in this flow", field));
  if (!std::ranges::all_of(fillings, &Filling::is_counted))
    judgement.not_judged.emplace_back(
        "how many rows there should be: --spacing, volumes, or masses and densities say it; without them a fluid that is "
        "thinned out evenly is not seen");
  if (!what.at_most && given.levels.size() < 3)
    judgement.not_judged.emplace_back(
        "how small the errors are, and how they fall: --at-most PERCENT or at_most in [claims] limits them, three "
        "resolutions show the order");
  diagnose_failures(flow, results, claims, what.diagnose, judgement.record);
  if (all_finished) {
    leave_out_what_is_not_measured(judged.claims, judgement.record);
    leave_out_orders_of_no_time(judged.claims, judgement.record, judgement.not_judged);
    refuse_to_claim_nothing(flow, judgement.record);
  }
  return judgement;
}

Judgement judge_files(const Flow& flow, const std::vector<std::filesystem::path>& files, const Mapping& mapping,
                      std::optional<double> spacing, const Judged& what) {
  const auto judge_in = [&](const Flow& read_by, const std::string& words) {
    Given given = read_files(read_by, files, mapping, spacing);
    if (!words.empty()) given.say(words);
    Judgement judgement = judge_given(read_by, std::move(given), what);
    std::erase_if(judgement.record.verdicts, [](const Verdict& v) { return v.quantity == end_time_reached; });
    return judgement;
  };
  try {
    return judge_in(flow, "");
  } catch (const LongerThanPeriod& longer) {
    if (!flow.is_uniform_along_x || longer.axis != 0) throw;
    Flow lengthened = flow;  // which changes nothing in its field
    lengthened.domain.box.high.x() = lengthened.filled.high.x() = flow.domain.box.low.x() + longer.length;
    return judge_in(lengthened, fmt::format("{} Judged so.", longer.what()));
  }
}

}  // namespace touchstone::vnv::doors

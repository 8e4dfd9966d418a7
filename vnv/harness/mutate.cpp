#include "vnv/harness/mutate.hpp"

#include "vnv/harness/run_levels.hpp"
#include "vnv/measures/coverage.hpp"
#include "vnv/record/same_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>

namespace touchstone::vnv {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What verdicts are made of.
struct RecordParts {
  std::vector<RunSummary> runs;
  std::vector<Value> values;                     // measured of the runs
  std::vector<Value> found;                      // over all runs
  std::map<std::string, bool> of_simulations{};  // levels, and whether their fluid fills its domain
};

bool is_read_by(const Verdict& v, const Value& value) {
  return value.level == v.level && value.quantity.name == v.quantity && same_time(value.time, v.time);
}

bool is_end(const Verdict& v) { return v.quantity == end_time_reached; }

/// Of values that were found over all runs a record keeps only what was claimed of them.
RecordParts parts_of(const Case& declared, const Method& method, const Record& record) {
  RecordParts parts{record.runs, record.values, {}};
  for (const Verdict& v : record.verdicts) {
    if (v.quantity == rows_in_one_place.name) parts.of_simulations.try_emplace(v.level, false);
    if (v.quantity == largest_hole.name) parts.of_simulations[v.level] = true;
  }
  for (const std::vector<Claim>& claims : {declared.claims, method.claims})
    for (const Claim& claim : claims)
      for (const Verdict& v : record.verdicts) {
        const auto is_its = [&](const Value& value) { return is_read_by(v, value); };
        if (claim.ladder.empty() && claim.quantity.name == v.quantity && !std::isnan(v.value) &&
            std::ranges::none_of(parts.values, is_its) && std::ranges::none_of(parts.found, is_its))
          parts.found.push_back({v.level, v.spacing, v.time, claim.quantity, v.value});
      }
  return parts;
}

/// Judges parts as a run of the method that left them.
class Replay {
 public:
  Replay(const Case& declared, const Method& method, const std::string& case_name, Suite suite,
         const Baselines& baselines)
      : played_(declared), case_name_(case_name), results_{method, suite, {}}, baselines_(baselines) {
    played_.monitor = {};
    played_.plots.clear();
    played_.measurements = {[this](const Level& level, const Run&) {
      std::vector<Value> values;
      std::ranges::copy_if(parts_->values, std::back_inserter(values),
                           [&](const Value& value) { return value.level == level.name; });
      return values;
    }};
    played_.findings = {[this](const Results&, const Record&) { return parts_->found; }};
  }
  Replay(const Replay&) = delete;

  Record operator()(const RecordParts& parts) {
    parts_ = &parts;
    results_.runs.clear();
    for (const RunSummary& run : parts.runs) {
      results_.runs.push_back({.summary = run});
      const auto of = parts.of_simulations.find(run.level);
      if (of == parts.of_simulations.end()) continue;
      const Box domain{.high = Vec2::Zero()}, another{.high = Vec2::Ones()};
      results_.runs.back().room = Room{{domain}, of->second ? domain : another};
    }
    return assess(case_name_, played_, results_, baselines_);
  }

 private:
  Case played_;
  std::string case_name_;
  Results results_;
  std::optional<Baselines> baselines_;
  const RecordParts* parts_ = nullptr;
};

bool is_same_claim(const Verdict& a, const Verdict& b) {
  return a.level == b.level && a.quantity == b.quantity && same_time(a.time, b.time) && a.author == b.author &&
         a.lower == b.lower && a.upper == b.upper;
}

/// Whether a claim that held does not hold any more; one that is gone is another matter.
bool fails_in(const Record& record, const Verdict& claim) {
  return std::ranges::any_of(record.verdicts,
                             [&](const Verdict& v) { return is_same_claim(v, claim) && v.outcome != Outcome::holds; });
}

void require_judged_alike(const Record& again, const Record& record) {
  const auto differs = [](const Verdict& a, const Verdict& b) {
    return !is_same_claim(a, b) || a.outcome != b.outcome;
  };
  const auto [now, then] = std::ranges::mismatch(again.verdicts, record.verdicts, std::not_fn(differs));
  if (now == again.verdicts.end() && then == record.verdicts.end()) return;
  throw std::invalid_argument(
      fmt::format("{}.{}: judged again by its values, it says '{}', expected '{}' as in its record: is that of this "
                  "program and these baselines?",
                  record.case_name, record.method, now == again.verdicts.end() ? "" : now->sentence,
                  then == record.verdicts.end() ? "" : then->sentence));
}

/// The nearest value beyond a limit.
double just_beyond(const Verdict& v) {
  if (!v.lower || (v.upper && *v.upper - v.value <= v.value - *v.lower)) return std::nextafter(*v.upper, infinity);
  return std::nextafter(*v.lower, -infinity);
}

/// The values that a claim reads, where it reads several.
std::vector<Value*> read_together(RecordParts& parts, const Verdict& v, const Record& judged) {
  std::vector<Value*> read;
  const auto add = [&](const std::string& level, const std::string& quantity, double time) {
    for (Value& value : parts.values)
      if ((level.empty() || value.level == level) && value.quantity.name == quantity && same_time(value.time, time))
        read.push_back(&value);
  };
  for (const ObservedOrder& order : judged.orders)
    if (const std::string name = with_heading(order.quantity).name;
        v.half_width && v.quantity == fmt::format("order of {} over {}", name, order.ladder) &&
        same_time(v.time, order.time))
      for (const std::string& level : order.levels) add(level, name, order.time);
  if (read.empty()) add("", v.quantity.substr(0, v.quantity.rfind(", p-value")), v.time);  // of an ensemble
  return read;
}

/// The values that a claim reads: one, those of a ladder, or those of an ensemble.
std::vector<Value*> read_by(const Verdict& v, RecordParts& parts, const Record& judged) {
  for (std::vector<Value>* values : {&parts.values, &parts.found})
    for (Value& value : *values)
      if (is_read_by(v, value)) return {&value};
  return read_together(parts, v, judged);
}

/// Whether some factor makes the claim fail, up or down, each farther from 1 than the one before: twice for an order;
/// four times for an ensemble, whose p-values take long and do not feel a per cent.
bool fails_by_a_factor(const Verdict& v, const RecordParts& parts, const Record& judged, Replay& replay) {
  RecordParts mutated = parts;
  const std::vector<Value*> read = read_by(v, mutated, judged);
  const std::size_t together = v.half_width ? 1 : read.size();
  const bool is_ensemble = !v.half_width;
  for (double s = is_ensemble ? 0.01 : 1e-6; s < 1e6; s *= is_ensemble ? 4 : 2)
    for (const double factor : {1 + s, 1 / (1 + s)})
      for (std::size_t first = 0; first < read.size(); first += together) {
        std::vector<double> before;
        for (std::size_t k = first; k < first + together; ++k) {
          before.push_back(read[k]->value);
          read[k]->value *= factor;
        }
        const bool fails = fails_in(replay(mutated), v);
        for (std::size_t k = first; k < first + together; ++k) read[k]->value = before[k - first];
        if (fails) return true;
      }
  return false;
}

/// Whether a method does not pass that is judged by these parts; what cannot be assessed does not.
bool is_red(const RecordParts& parts, const AcceptedClaims& accepted, Replay& replay) try {
  return !complaints(replay(parts), accepted).empty();
} catch (const std::exception&) {
  return true;
}

bool fails_beyond(const Verdict& v, RecordParts parts, const Record& judged, Replay& replay) {
  if (is_end(v)) {
    std::ranges::find(parts.runs, v.level, &RunSummary::level)->finished = false;
    return fails_in(replay(parts), v);
  }
  const std::vector<Value*> read = read_by(v, parts, judged);
  if (read.size() != 1) return fails_by_a_factor(v, parts, judged, replay);
  read.front()->value = just_beyond(v);
  return fails_in(replay(parts), v);
}

/// The parts with one mutation that leaves no value to judge; nothing where it makes no sense.
std::optional<RecordParts> spoilt(Mutation mutation, const Verdict& v, RecordParts parts, const Record& judged) {
  if (is_end(v)) {  // its only other mutation is a run that is not there
    if (mutation != Mutation::missing) return std::nullopt;
    std::erase_if(parts.runs, [&](const RunSummary& run) { return run.level == v.level; });
    std::erase_if(parts.values, [&](const Value& value) { return value.level == v.level; });
    return parts;
  }
  const std::vector<Value*> read = read_by(v, parts, judged);
  if (read.empty()) return std::nullopt;
  Value& value = *read.front();
  const Value original = value;
  if (mutation == Mutation::no_number) value.value = not_a_number;
  if (mutation == Mutation::elsewhere) {
    if (value.level.empty()) return std::nullopt;  // of all levels together
    const auto other =
        std::ranges::find_if(parts.runs, [&](const RunSummary& run) { return run.level != value.level; });
    value.level = other == parts.runs.end() ? "nowhere" : other->level;
  }
  const auto erase = [&](const auto& is_gone) {
    std::erase_if(parts.values, is_gone);
    std::erase_if(parts.found, is_gone);
  };
  if (mutation == Mutation::missing)
    erase([&](const Value& one) {
      return one.level == original.level && one.quantity == original.quantity && same_time(one.time, original.time);
    });
  if (mutation == Mutation::unmeasured) erase([&](const Value& one) { return one.quantity == original.quantity; });
  return parts;
}

}  // namespace

std::string Mutations::sentence() const {
  std::string text = fmt::format("{} claims hold:", claims);
  for (std::size_t k = 0; k < tried.size(); ++k)
    text += fmt::format("{} {} {}/{}", k ? "," : "", words(Mutation{})[k], seen[k], tried[k]);
  return text;
}

Mutations mutate_record(const Case& declared, const Method& method, const Record& record, const Baselines& baselines,
                        const AcceptedClaims& accepted) {
  const Suite suite = record.suite == name_of(Suite::acceptance) ? Suite::acceptance
                      : record.suite == name_of(Suite::report)   ? Suite::report
                                                                 : Suite::nightly;
  Replay replay(declared, method, record.case_name, suite, baselines);
  const RecordParts parts = parts_of(declared, method, record);
  const Record judged = replay(parts);
  require_judged_alike(judged, record);
  Mutations all;
  const auto note = [&](Mutation mutation, bool is_seen, const Verdict& v) {
    ++all.tried[static_cast<std::size_t>(mutation)];
    all.seen[static_cast<std::size_t>(mutation)] += is_seen;
    if (!is_seen)
      all.survivors.push_back(fmt::format("{}: {}", words(mutation)[static_cast<std::size_t>(mutation)], v.sentence));
  };
  for (const Verdict& v : judged.verdicts) {
    if (v.outcome != Outcome::holds) continue;
    ++all.claims;
    note(Mutation::beyond, fails_beyond(v, parts, judged, replay), v);
    for (const Mutation mutation : {Mutation::no_number, Mutation::missing, Mutation::elsewhere, Mutation::unmeasured})
      if (const std::optional<RecordParts> mutated = spoilt(mutation, v, parts, judged))
        note(mutation, is_red(*mutated, accepted, replay), v);
  }
  return all;
}

namespace {

using Field = std::pair<const char*, void (*)(Run&, double)>;

template <auto field>
void scale(Run& run, double factor) {
  for (Samples& s : run.samples) s.*field *= factor;
}

void scale_position(Run& run, double factor) {
  for (Samples& s : run.samples) {
    const Vec2 centre = s.x.rowwise().mean();
    s.x = (factor * (s.x.colwise() - centre)).colwise() + centre;
  }
}

void scale_monitored(Run& run, double factor) {
  for (std::vector<double>& row : run.history.values)
    for (double& number : row) number *= factor;
}

void tilt_monitored(Run& run, double factor) {
  const std::vector<double>& time = run.history.time;
  for (std::size_t k = 0; k < time.size(); ++k)
    for (double& number : run.history.values[k]) number *= std::pow(factor, time[k] / time.back());
}

/// Each quantity by another amount, also one that is zero or whose scale no claim feels.
void shift_monitored(Run& run, double factor) {
  const std::vector<double>& time = run.history.time;
  for (std::size_t k = 0; k < time.size(); ++k)
    for (double by = factor - 1; double& number : run.history.values[k]) number += by * time[k] / time.back(), by *= 2;
}

void stretch_time(Run& run, double factor) {
  for (double& time : run.history.time) time *= factor;
}

/// Without the particles near the bottom and the top, as long as half of the height is left.
void lose_edges(Run& run, double factor) {
  if (factor > 0.99 || factor < 0.5) return;
  for (Samples& s : run.samples) {
    const double low = s.x.row(1).minCoeff(), high = s.x.row(1).maxCoeff();
    std::vector<Eigen::Index> kept;
    for (Eigen::Index p = 0; p < s.size(); ++p)
      if (std::abs(s.x(1, p) - (low + high) / 2) <= factor * (high - low) / 2) kept.push_back(p);
    s = {s.time, s.x(Eigen::all, kept), s.v(Eigen::all, kept), s.mass(kept), s.density(kept), s.pressure(kept)};
  }
}

/// So large a part of the particles stands where their neighbours do.
void pair_up(Run& run, double factor) {
  for (Samples& s : run.samples) {
    const auto pairs =
        static_cast<Eigen::Index>(std::min(1.0, std::abs(factor - 1)) * static_cast<double>(s.size() / 2));
    for (Eigen::Index p = 0; p < pairs; ++p) s.x.col(2 * p) = s.x.col(2 * p + 1);
  }
}

/// Also what is zero.
void move_found(Run& run, double factor) {
  for (Value& value : run.found) value.value = factor * value.value + factor - 1;
}

constexpr std::array<Field, 12> fields{{
    {"velocity", scale<&Samples::v>},
    {"density", scale<&Samples::density>},
    {"pressure", scale<&Samples::pressure>},
    {"position", scale_position},
    {"monitored", scale_monitored},
    {"monitored, growing with time,", tilt_monitored},
    {"time of what was monitored", stretch_time},
    {"what was found", move_found},
    {"monitored, shifted with time,", shift_monitored},
    {"height that particles fill", lose_edges},
    {"place of pairs", pair_up},
    {"steps",
     [](Run& run, double factor) {
       run.summary.cost.steps = std::lround(factor * static_cast<double>(run.summary.cost.steps));
     }},
}};

/// The judged runs; nothing where something cannot be measured of them, such as a particle beyond a wall.
std::optional<Record> assess_if_possible(const std::string& case_name, const Case& declared, const Results& results,
                                         const Baselines& baselines) try {
  return assess(case_name, declared, results, baselines);
} catch (const std::exception&) {
  return std::nullopt;
}

/// What is no number fails anyway: it would say nothing of the claim's limit.
bool fails_by_a_number(const Record& record, const Verdict& claim) {
  const auto found = std::ranges::find_if(record.verdicts, [&](const Verdict& v) { return is_same_claim(v, claim); });
  return found != record.verdicts.end() && std::isfinite(found->value) && fails_in(record, claim);
}

bool is_of_ensemble(const Verdict& v) { return v.level.empty() && !v.half_width; }

/// Whether no claim has yet to be made to fail by all levels together, or, where one is named, by this one.
bool are_settled(const std::vector<std::string>& fails_by, const Record& judged, const std::string& level) {
  for (std::size_t k = 0; k < fails_by.size(); ++k) {
    const Verdict& v = judged.verdicts[k];
    const bool reads_it = level.empty() || v.level == level || (v.level.empty() && !is_of_ensemble(v));
    if (reads_it && v.outcome == Outcome::holds && !is_end(v) && fails_by[k].empty()) return false;
  }
  return true;
}

}  // namespace

Mutations mutate_samples(const std::string& case_name, const Case& declared, const Method& method, Suite suite,
                         const Baselines& baselines, std::vector<std::string>& least) {
  Case unplotted = declared;
  unplotted.plots.clear();
  Results results{method, suite, run_levels(case_name, declared, method, suite)};
  const auto began = std::chrono::steady_clock::now();
  const Record judged = assess(case_name, unplotted, results, baselines);
  const std::vector<Run> original = results.runs;
  std::vector<std::string> fails_by(judged.verdicts.size());  // the smallest change that does it
  Mutations all;
  const auto judge = [&](const std::string& change, const auto& may_fail) {
    const std::optional<Record> mutated = assess_if_possible(case_name, unplotted, results, baselines);
    for (std::size_t k = 0; mutated && k < fails_by.size(); ++k) {
      const Verdict& v = judged.verdicts[k];
      if (!fails_by[k].empty() || !may_fail(v) || !fails_by_a_number(*mutated, v)) continue;
      fails_by[k] = change;
      if (v.outcome == Outcome::holds) all.failing = mutated;
    }
  };
  const auto scale = [&](const Field& field, double factor, const std::string& level) {
    results.runs = original;
    for (Run& run : results.runs)
      if (level.empty() || run.summary.level == level) field.second(run, factor);
    judge(fmt::format("{} of {} times {:.7g}", field.first, level.empty() ? "all levels" : level, factor),
          [](const Verdict& v) { return !is_end(v); });
  };
  std::vector<std::string> levels{""};  // all together first: what a solver gets wrong it gets wrong on each
  for (const Run& run : original) levels.push_back(run.summary.level);
  const double least_change = std::ranges::any_of(judged.verdicts, is_of_ensemble) ? 0.01 : 1e-6;
  for (const std::string& level : levels)
    for (double s = least_change; s < 1e4; s *= 4)
      for (const Field& field : fields)
        for (const double factor : {1 + s, 1 / (1 + s)})
          if (!are_settled(fails_by, judged, level)) scale(field, factor, level);
  results.runs = original;
  for (Run& run : results.runs) run.summary.finished = false;
  judge("no level that ends", [](const Verdict& v) { return is_end(v) || is_of_ensemble(v); });
  for (std::size_t k = 0; k < fails_by.size(); ++k) {
    const Verdict& v = judged.verdicts[k];
    if (v.outcome != Outcome::holds) continue;
    ++all.claims;
    ++all.tried[0];
    const bool is_seen = !fails_by[k].empty();
    all.seen[0] += is_seen;
    (is_seen ? least : all.survivors).push_back(is_seen ? fails_by[k] + " fails: " + v.sentence : v.sentence);
  }
  all.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return all;
}

}  // namespace touchstone::vnv

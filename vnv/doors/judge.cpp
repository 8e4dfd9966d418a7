#include "vnv/doors/judge.hpp"

#include "vnv/harness/assess.hpp"
#include "vnv/judge/baselines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace touchstone::vnv::doors {
namespace {

GivenLevel& level_of(std::vector<GivenLevel>& levels, double spacing) {
  const auto is_equal = [&](const GivenLevel& level) { return std::abs(level.spacing / spacing - 1) < 0.01; };
  const auto found = std::ranges::find_if(levels, is_equal);
  return found == levels.end() ? levels.emplace_back(spacing) : *found;
}

bool has(const std::vector<std::string>& fields, const std::string& name) {
  return std::ranges::find(fields, name) != fields.end();
}

/// Of a mesh its cells: what stands at its corners is interpolated from them.
std::vector<Dataset> rows_to_judge(std::vector<Dataset> all) {
  const auto is_of_cells = [](const Dataset& data) { return data.rows_are == Rows::cells; };
  if (std::ranges::any_of(all, is_of_cells)) std::erase_if(all, std::not_fn(is_of_cells));
  return all;
}

/// Rows of a flow that fills its domain reach over most of it; those in another unit do not.
void require_filled(const Flow& flow, const std::string& source, const Samples& samples) {
  const Vec2 spread = samples.x.rowwise().maxCoeff() - samples.x.rowwise().minCoeff(), size = flow.filled.size();
  if (samples.size() < 4 || (spread.array() >= size.array() / 2).all()) return;
  throw Unreadable(
      fmt::format("{}: rows spread over {:.4g} m by {:.4g} m, expected most of the {:.4g} m by {:.4g} m that the flow "
                  "fills: --unit length=..., or --set its size",
                  source, spread.x(), spread.y(), size.x(), size.y()));
}

/// A run of what was given, as if it had been computed here.
Run run_of(const GivenLevel& given, const std::string& level) {
  Run run{.summary = {.level = level,
                      .spacing = given.spacing,
                      .finished = given.outcome == "finished",
                      .outcome = given.outcome,
                      .cost = given.cost}};
  for (const auto& [time, samples] : given.at) run.samples.push_back(samples);
  if (run.samples.empty()) return run;
  run.summary.end_time = run.samples.back().time;
  run.summary.cost.particles = run.samples.back().size();
  return run;
}

/// The time that was asked for, of one within 1 % of it.
double asked(double time, const std::vector<double>& times) {
  const auto near = std::ranges::find_if(times, [&](double one) { return std::abs(time - one) <= 0.01 * one; });
  return near == times.end() ? time : *near;
}

/// Those times at which a measurement can be made: at others, as at rest, there is nothing to compare with.
Measurement where_defined(const Measurement& measurement, const std::vector<double>& times,
                          std::vector<std::string>& not_judged) {
  return [&, measurement](const Level& level, const Run& run) {
    std::vector<Value> all;
    for (const Samples& samples : run.samples) {
      const Run one{.summary = run.summary, .samples = {samples}};
      try {
        for (Value value : measurement(level, one)) {
          value.time = asked(value.time, times);
          all.push_back(std::move(value));
        }
      } catch (const std::invalid_argument& error) {
        not_judged.push_back(fmt::format("{}, {:g} s: {}", level.name, samples.time, error.what()));
      }
    }
    return all;
  };
}

/// The flow's case with what is measured of the fields that there are.
Case case_of(const Flow& flow, const Given& given, const std::vector<double>& times,
             std::vector<std::string>& not_judged) {
  Case judged = flow.judged;
  judged.title = flow.title();
  for (const Measured& one : flow.measured) {
    const auto missing = std::ranges::find_if(
        one.fields, [&](const std::string& name) { return given.fields && !has(*given.fields, name); });
    if (missing == one.fields.end())
      judged.measurements.push_back(where_defined(one.measurement, times, not_judged));
    else
      not_judged.push_back(fmt::format("no {} in the files: what is measured of it is not judged", *missing));
  }
  return judged;
}

/// A user's own limits, on the quantities of which the flow claims an order.
std::vector<Claim> own_claims(const Flow& flow, const Judged& what, const std::string& finest) {
  std::vector<Claim> claims;
  for (const Claim& claim : flow.judged.claims) {
    if (what.at_most)
      claims.push_back(at_most(claim.quantity, *what.at_most, baseline("limit of the user")).on(finest));
    if (what.order_at_least)
      claims.push_back(order_at_least(ladder_of_files, claim.quantity, *what.order_at_least, *what.order_at_least - 0.5,
                                      baseline("order that the user expects"))
                           .over(3));
  }
  return claims;
}

}  // namespace

void Given::say(const std::string& line) {
  if (std::ranges::find(words, line) == words.end()) words.push_back(line);
}

void read_into(Given& given, const Flow& flow, const Mapping& mapping, const std::filesystem::path& file,
               std::optional<double> said) {
  for (const Dataset& data : rows_to_judge(read_datasets(file))) {
    Reading reading = reading_of(data, mapping, flow.domain, flow.fluid.density);
    given.files.push_back(reading.file);
    for (const std::string& line : reading.words) given.say(line);
    require_filled(flow, data.source, reading.samples);
    if (given.fields)
      std::erase_if(*given.fields, [&](const std::string& name) { return !has(reading.fields, name); });
    else
      given.fields = reading.fields;
    const double area = flow.filled.size().prod(),
                 spacing = said.value_or(std::sqrt(area / static_cast<double>(reading.samples.size())));
    given.say(fmt::format("spacing: {:.4g} m, {}", spacing,
                          said ? "as said" : "the root of the filled area over the number of rows"));
    const double time = reading.samples.time;
    if (!level_of(given.levels, spacing).at.emplace(time, std::move(reading.samples)).second)
      throw std::invalid_argument(
          fmt::format("{}: spacing {:.4g} m and time {:g} s again, expected each once", data.source, spacing, time));
  }
}

Judgement judge_given(const Flow& flow, Given given, const Judged& what) {
  Judgement judgement{.files = given.files, .words = given.words};
  std::ranges::sort(given.levels, std::greater{}, &GivenLevel::spacing);
  const std::vector<double>& times = what.times.empty() ? flow.judged.times : what.times;
  Case judged = case_of(flow, given, times, judgement.not_judged);
  Method method{.name = what.name, .description = what.description, .ladders = {{ladder_of_files, {}}}};
  std::vector<Run> runs;
  for (const GivenLevel& level : given.levels) {
    const std::string name = fmt::format("{:.4g} across", flow.across / level.spacing);
    runs.push_back(run_of(level, name));
    const double end = level.at.empty() ? times.back() : asked(level.at.rbegin()->first, times);
    method.levels.push_back({.name = name, .spacing = level.spacing, .acceptance = end, .report = end, .nightly = end});
    method.ladders[0].levels.push_back(name);
  }
  method.claims = own_claims(flow, what, method.levels.back().name);
  judgement.record = assess(flow.case_name(), judged, {method, what.suite, std::move(runs)},
                            what.baselines ? std::optional(*what.baselines) : std::nullopt);
  judgement.record.another_code = true;
  return judgement;
}

Judgement judge_files(const Flow& flow, const std::vector<std::filesystem::path>& files, const Mapping& mapping,
                      std::optional<double> spacing, const Judged& what) {
  Given given;
  for (const std::filesystem::path& file : files) read_into(given, flow, mapping, file, spacing);
  Judgement judgement = judge_given(flow, std::move(given), what);
  std::erase_if(judgement.record.verdicts, [](const Verdict& v) { return v.quantity == end_time_reached; });
  return judgement;
}

}  // namespace touchstone::vnv::doors

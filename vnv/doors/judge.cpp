#include "vnv/doors/judge.hpp"

#include "vnv/harness/assess.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>

namespace touchstone::vnv::doors {
namespace {

/// One resolution: the samples of its files, by their times.
struct Given {
  double spacing;  // m
  std::map<double, Samples> at{};
};

Given& level_of(std::vector<Given>& levels, double spacing) {
  const auto is_equal = [&](const Given& level) { return std::abs(level.spacing / spacing - 1) < 0.01; };
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

void say_once(Judgement& judgement, const std::string& line) {
  if (std::ranges::find(judgement.words, line) == judgement.words.end()) judgement.words.push_back(line);
}

/// A run of what was given, as if it had been computed here.
Run run_of(const Given& given, const std::string& level) {
  Run run{.summary = {.level = level, .spacing = given.spacing, .finished = true, .outcome = "finished"}};
  for (const auto& [time, samples] : given.at) run.samples.push_back(samples);
  run.summary.end_time = run.samples.back().time;
  run.summary.cost.particles = run.samples.back().size();
  return run;
}

/// Those times at which a measurement can be made: at others, as at rest, there is nothing to compare with.
Measurement where_defined(const Measurement& measurement, std::vector<std::string>& not_judged) {
  return [&not_judged, measurement](const Level& level, const Run& run) {
    std::vector<Value> all;
    for (const Samples& samples : run.samples) {
      const Run one{.summary = run.summary, .samples = {samples}};
      try {
        const std::vector<Value> values = measurement(level, one);
        all.insert(all.end(), values.begin(), values.end());
      } catch (const std::invalid_argument& error) {
        not_judged.push_back(fmt::format("{}, {:g} s: {}", level.name, samples.time, error.what()));
      }
    }
    return all;
  };
}

}  // namespace

Judgement judge_files(const Flow& flow, const JudgeRequest& request) {
  Judgement judgement;
  std::vector<Given> levels;
  std::optional<std::vector<std::string>> fields;  // that all files have
  for (const std::filesystem::path& file : request.files)
    for (const Dataset& data : rows_to_judge(read_datasets(file))) {
      Reading reading = reading_of(data, request.mapping, flow.domain);
      for (const std::string& line : reading.words) say_once(judgement, line);
      require_filled(flow, data.source, reading.samples);
      if (fields)
        std::erase_if(*fields, [&](const std::string& name) { return !has(reading.fields, name); });
      else
        fields = reading.fields;
      const double area = flow.filled.size().prod(),
                   spacing = request.spacing.value_or(std::sqrt(area / static_cast<double>(reading.samples.size())));
      say_once(judgement,
               fmt::format("spacing: {:.4g} m, {}", spacing,
                           request.spacing ? "as said" : "the root of the filled area over the number of rows"));
      const double time = reading.samples.time;
      if (!level_of(levels, spacing).at.emplace(time, std::move(reading.samples)).second)
        throw std::invalid_argument(
            fmt::format("{}: spacing {:.4g} m and time {:g} s again, expected each once", data.source, spacing, time));
    }
  std::ranges::sort(levels, std::greater{}, &Given::spacing);

  Case judged = flow.judged;
  for (const Measured& one : flow.measured) {
    const auto missing = std::ranges::find_if(one.fields, [&](const std::string& name) { return !has(*fields, name); });
    if (missing == one.fields.end())
      judged.measurements.push_back(where_defined(one.measurement, judgement.not_judged));
    else
      judgement.not_judged.push_back(fmt::format("no {} in the files: what is measured of it is not judged", *missing));
  }
  Method method{.name = request.name, .description = "Files of another code.", .ladders = {{ladder_of_files, {}}}};
  Results results{method, Suite::report, {}};
  for (const Given& given : levels) {
    const std::string name = fmt::format("{:.4g} across", flow.across / given.spacing);
    method.levels.push_back({.name = name, .spacing = given.spacing, .report = given.at.rbegin()->first});
    method.ladders[0].levels.push_back(name);
    results.runs.push_back(run_of(given, name));
  }
  if (request.at_most)
    for (const Claim& claim : flow.judged.claims)
      judged.claims.push_back(at_most(claim.quantity, *request.at_most, baseline("limit of the user")));
  judgement.record = assess(flow.name, judged, results, std::nullopt);
  std::erase_if(judgement.record.verdicts,  // files have no other end than their last time
                [](const Verdict& v) { return v.quantity == end_time_reached; });
  return judgement;
}

}  // namespace touchstone::vnv::doors

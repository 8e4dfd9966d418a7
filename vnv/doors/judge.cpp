#include "vnv/doors/judge.hpp"

#include "solvers/lattice.hpp"
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

Vec2 spread_of(const Vectors& places) { return places.rowwise().maxCoeff() - places.rowwise().minCoeff(); }

/// Rows of a flow that fills its domain reach over most of it, those of one with a free surface at the start over what
/// it fills; those in another unit or of a flow of another size do not.
void require_filled(const Flow& flow, const std::string& source, const Samples& samples, double spacing) {
  const Vec2 spread = spread_of(samples.x), size = flow.filled.size();
  const auto refuse = [&](const std::string& expected) {
    throw Unreadable(
        fmt::format("{}: rows spread over {:.4g} m by {:.4g} m, expected {}: --unit length=..., or --set its size",
                    source, spread.x(), spread.y(), expected));
  };
  if (samples.size() < 4) return;
  if (!flow.has_free_surface()) {
    if ((spread.array() < size.array() / 2).any())
      refuse(fmt::format("most of the {:.4g} m by {:.4g} m that the flow fills", size.x(), size.y()));
  } else if (samples.time == 0) {
    const Vec2 exact = spread_of(places_in(flow.domain.box, flow.start, lattice(flow.filled, spacing)));
    if (((spread - exact).array().abs() > 2 * spacing + 0.05 * exact.array()).any())
      refuse(fmt::format("about {:.4g} m by {:.4g} m at the start", exact.x(), exact.y()));
  } else if (const double area = flow.filled_area(); spread.prod() < area / 2) {
    refuse(fmt::format("room for the {:.4g} m² of fluid", area));
  }
}

/// Masses, densities and volumes of a plane flow; of rows that have none, equal ones.
void require_volumes(const Flow& flow, const std::string& source, Reading& reading) {
  Samples& samples = reading.samples;
  const double area = flow.filled_area();
  if (!reading.has_volumes) {
    samples.density.setConstant(flow.fluid.density);
    samples.mass.setConstant(flow.fluid.density * area / static_cast<double>(samples.size()));
    return;
  }
  if (!has(reading.fields, "density")) {
    samples.density *= flow.fluid.density;
    samples.mass *= flow.fluid.density;
  }
  if (const double found = samples.volumes().sum(); flow.has_free_surface() && std::abs(found / area - 1) > 0.2) {
    throw Unreadable(fmt::format(
        "{}: volumes of {:.4g} m² in all, per metre of depth, expected {:.4g} m²: --set the size of the flow", source,
        found, area));
  }
}

void say_once(Judgement& judgement, const std::string& line) {
  if (std::ranges::find(judgement.words, line) == judgement.words.end()) judgement.words.push_back(line);
}

/// A run of what was given, as if it had been computed here.
Run run_of(const Given& given, const std::string& level, const Watch& watch) {
  Run run{.summary = {.level = level, .spacing = given.spacing, .finished = true, .outcome = "finished"}};
  for (const auto& [time, samples] : given.at) {
    run.samples.push_back(samples);
    if (!watch.see) continue;
    run.history.time.push_back(time);
    run.history.seen.push_back(watch.see(samples));
  }
  run.summary.end_time = run.samples.back().time;
  run.summary.cost.particles = run.samples.back().size();
  return run;
}

/// Those times at which a measurement can be made: at others, as at rest, there is nothing to compare with.
Measurement where_defined(const Measured& measured, std::vector<std::string>& not_judged) {
  const auto add = [=, &not_judged](std::vector<Value>& all, const Level& level, const Run& run) {
    try {
      const std::vector<Value> values = measured.measurement(level, run);
      all.insert(all.end(), values.begin(), values.end());
    } catch (const std::logic_error& error) {
      not_judged.push_back(fmt::format("{}, {:g} s: {}", level.name, run.samples.back().time, error.what()));
    }
  };
  return [=, &not_judged](const Level& level, const Run& run) {
    std::vector<Value> all;
    if (!measured.over) {
      for (const Samples& samples : run.samples) add(all, level, {.summary = run.summary, .samples = {samples}});
    } else if (const auto [first, last, least] = *measured.over; run.samples.size() < least ||
                                                                 run.samples.front().time > first * (1 + 1e-9) ||
                                                                 run.samples.back().time < last * (1 - 1e-9)) {
      not_judged.push_back(fmt::format(
          "{}: {} over time: {} times from {:g} to {:g} s, expected {} or more from {:g} to {:g} s", level.name,
          measured.name, run.samples.size(), run.samples.front().time, run.samples.back().time, least, first, last));
    } else {
      add(all, level, run);
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
      if (fields)
        std::erase_if(*fields, [&](const std::string& name) { return !has(reading.fields, name); });
      else
        fields = reading.fields;
      const double spacing =
          request.spacing.value_or(std::sqrt(flow.filled_area() / static_cast<double>(reading.samples.size())));
      require_filled(flow, data.source, reading.samples, spacing);
      require_volumes(flow, data.source, reading);
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
      judged.measurements.push_back(where_defined(one, judgement.not_judged));
    else
      judgement.not_judged.push_back(fmt::format("no {} in the files: what is measured of it is not judged", *missing));
  }
  Method method{.name = request.name, .description = "Files of another code.", .ladders = {{ladder_of_files, {}}}};
  Results results{method, Suite::report, {}};
  for (const Given& given : levels) {
    const std::string name = fmt::format("{:.4g} across", flow.across / given.spacing);
    method.levels.push_back({.name = name, .spacing = given.spacing, .report = given.at.rbegin()->first});
    method.ladders[0].levels.push_back(name);
    results.runs.push_back(run_of(given, name, flow.judged.watch));
    if (flow.across / given.spacing > flow.resolved * (1 - 1e-6))
      for (const Claim& claim : flow.of_resolved) judged.claims.push_back(claim.on(name));
  }
  if (request.at_most)
    for (const Claim& claim : flow.judged.claims)
      if (claim.quantity.kind == Kind::norm)
        judged.claims.push_back(at_most(claim.quantity, *request.at_most, baseline("limit of the user")));
  judgement.record = assess(flow.name, judged, results, std::nullopt);
  const auto is_measured = [&](const Verdict& v) {
    return std::ranges::any_of(judgement.record.values, [&](const Value& value) {
      return v.quantity.find(value.quantity.name) != v.quantity.npos;
    });
  };
  std::erase_if(judgement.record.verdicts, [&](const Verdict& v) {  // files have no other end than their last time
    return v.quantity == end_time_reached || !is_measured(v);
  });
  return judgement;
}

}  // namespace touchstone::vnv::doors

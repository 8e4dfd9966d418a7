#include "vnv/studies/run_time.hpp"

#include "vnv/judge/norms.hpp"
#include "vnv/measures/plots/along_ladders.hpp"
#include "vnv/record/work_precision.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace touchstone::vnv {
namespace {

std::string family_of(const Method& method) {
  if (method.family == Family::undeclared)
    throw std::invalid_argument(fmt::format("{}: no family is declared, expected one of mpm, sph", method.name));
  return method.family == Family::mpm ? "MPM" : "SPH";
}

/// Not a number where a run has not got the quantity at one of the times.
double largest_error(const Quantity& quantity, const std::vector<double>& times, const Record& record, const Run& run) {
  if (!run.summary.finished) return not_a_number;
  double largest = 0;
  for (const double time : times)
    largest = norms::larger_magnitude(largest, error_of(quantity, time)(record, run).value_or(not_a_number));
  return largest;
}

/// Spacings with points per cell, or with smoothing lengths.
std::vector<Level> resolutions(const WorkStudy& study, Family family) {
  std::vector<Level> all;
  if (family == Family::mpm)
    for (const int n : study.cells)
      for (const int side : study.points)
        all.push_back({.name = fmt::format("{} cells, {} per cell", n, side * side),
                       .spacing = study.length / (n * side),
                       .cell = study.length / n,
                       .combination = fmt::format("{} per cell", side * side)});
  else
    for (const int n : study.particles)
      for (const double h : study.kernels)
        all.push_back({.name = fmt::format("{} across, h {:g}", n, h),
                       .spacing = study.length / n,
                       .smoothing_length = h * study.length / n,
                       .combination = fmt::format("h {:g}", h)});
  return all;
}

/// How long a strip has to be [m]: for MPM eight cells, which fill a vector register; for SPH as many spacings as the
/// kernel reaches over and lists beyond it, and an even number of them: three columns of particles cannot go to and
/// fro, and bear steps that a channel does not.
double strip_at(const Level& level, const Method& method) {
  if (method.family == Family::mpm) return 8 * level.cell;
  constexpr double listed_beyond = 0.3;  // spacings  as `sph::reach_of` has it at most
  const double columns = method.kernel_support * level.smoothing_length / level.spacing + listed_beyond;
  return 2 * std::ceil(columns / 2) * level.spacing;
}

std::vector<Level> levels_of(const WorkStudy& study, const Method& method) {
  std::vector<Level> levels;
  std::set<std::string> known;
  for (const Level& resolution : resolutions(study, method.family))
    for (const double stiffness : study.stiffness)
      for (const double step : study.steps) {
        Level level = resolution;
        level.sound_speed = stiffness * study.largest_speed;
        if (!std::isnan(study.period)) level.period = std::min(study.period, strip_at(level, method));
        const double longest = step * method.time_step(level), first = study.times.front();
        level.time_step = first / std::ceil(first / longest * (1 - 1e-9));
        level.work = study.times.back();
        level.may_diverge = true;
        level.name += fmt::format(", {:.4g} s", level.time_step);
        level.combination += fmt::format(", step {:g}, c/U {:g}", step, stiffness);
        if (!std::isnan(stiffness)) level.name += fmt::format(", c {:g} m/s", level.sound_speed);
        if (known.insert(level.name).second) levels.push_back(level);
      }
  return levels;
}

/// What other suites do not draw.
Plot in_work(const Plot& plot) {
  return [=](const Results& results, Record& record) {
    if (results.suite == Suite::work) plot(results, record);
  };
}

const Quantity worth_making{"runs that no cheaper run of the method beats", "", Kind::count, Better::larger};

/// The points of a method's runs with one sound speed [m/s].
std::vector<WorkPoint> at_sound_speed(double c, const std::vector<WorkPoint>& points, const Method& method) {
  std::vector<WorkPoint> found;
  std::ranges::copy_if(points, std::back_inserter(found), [&](const WorkPoint& p) {
    return std::ranges::find(method.levels, p.run, &Level::name)->sound_speed == c;
  });
  return found;
}

/// How stiff the fluid has to be for an error, and what it costs: a row a method.
Plot error_against_stiffness(const WorkStudy& study) {
  return [=](const Results& results, Record& record) {
    const WorkDiagram diagram = study.diagram();
    const std::vector<WorkPoint> all = work_points(diagram, study.times, results, record);
    const Axis stiffness{.label = "sound speed over largest speed", .logarithmic = true};
    record.figures.push_back({"floor",
                              "Smallest error against sound speed",
                              "Of all runs of a method within its budget of CPU time.",
                              stiffness,
                              {.label = study.error.heading(), .logarithmic = true}});
    record.figures.push_back({"price",
                              fmt::format("CPU time to {:g} {} against sound speed", study.ranked_by, study.error.unit),
                              "Where the line of a method ends, softer fluids do not reach that error.",
                              stiffness,
                              {.label = "CPU time [s]", .logarithmic = true}});
    Curve floor{"floor", results.method.name, Role::ours, {}, {}, false}, price = floor;
    price.figure = "price";
    for (const double ratio : study.stiffness) {
      const std::vector<WorkPoint> points = at_sound_speed(ratio * study.largest_speed, all, results.method);
      if (const auto front = pareto_front(points); !front.empty()) {
        floor.x.push_back(ratio);
        floor.y.push_back(front.back().error);
      }
      if (const TimeToError time = time_to_error(points, study.ranked_by); time.is_reached()) {
        price.x.push_back(ratio);
        price.y.push_back(time.cpu);
      }
    }
    record.curves.insert(record.curves.end(), {floor, price});
    Table table{"stiffness",
                "How stiff a fluid has to be for an error",
                fmt::format("Sound speed over the largest speed of the flow, c/U. For each error: the softest fluid in "
                            "which a method reaches it, and the least CPU time, with its c/U and how many times as "
                            "much is needed at c/U = {:g}.",
                            study.stiffness.front()),
                {"method"},
                {}};
    std::vector<Cell> row{results.method.name};
    for (const double target : study.targets) {
      if (target > study.ranked_by || std::fmod(std::log10(study.ranked_by / target) + 1e-9, 1) > 1e-6) continue;
      const std::string error = fmt::format("{:g} {}", target, study.error.unit);
      table.columns.insert(table.columns.end(), {"softest c/U to " + error, "least CPU to " + error + " [s]"});
      double softest = not_a_number, at = not_a_number, least = not_a_number, stiffest = not_a_number;
      for (const double ratio : study.stiffness) {
        const TimeToError time =
            time_to_error(at_sound_speed(ratio * study.largest_speed, all, results.method), target);
        if (!time.is_reached()) continue;
        softest = std::min(ratio, std::isnan(softest) ? ratio : softest);
        if (!(time.cpu >= least)) least = time.cpu, at = ratio;
        if (ratio == study.stiffness.front()) stiffest = time.cpu;
      }
      const bool is_reached = least > 0;
      row.push_back(is_reached ? fmt::format("{:g}", softest) : "not reached");
      row.push_back(
          !is_reached ? ""
                      : fmt::format("{:.2g} at {:g}, {}", least, at,
                                    stiffest > 0 ? fmt::format("× {:.2g}", stiffest / least) : "stiffest not reached"));
    }
    table.rows.push_back(std::move(row));
    record.tables.push_back(std::move(table));
  };
}

/// The next finer run of the same combination, or null.
const Run* refined(const Run& run, const Results& results) {
  const auto level_of = [&](const Run& one) {
    return *std::ranges::find(results.method.levels, one.summary.level, &Level::name);
  };
  const Run* found = nullptr;
  const std::string combination = level_of(run).combination;
  for (const Run& other : results.runs)
    if (!combination.empty() && level_of(other).combination == combination &&
        other.summary.spacing < run.summary.spacing && !(found && other.summary.spacing < found->summary.spacing))
      found = &other;
  return found;
}

}  // namespace

std::vector<WorkPoint> work_points(const WorkDiagram& diagram, const std::vector<double>& times, const Results& results,
                                   const Record& record) {
  std::vector<WorkPoint> points;
  for (const Run& run : results.runs) {
    if (!run.summary.finished) continue;
    const Cost& cost = run.summary.cost;
    double error = largest_error(diagram.quantity, times, record, run);
    if (const Run* finer = refined(run, results); finer && finer->summary.finished)
      error = norms::larger_magnitude(error, largest_error(diagram.quantity, times, record, *finer));
    const double fraction =
        std::isnan(error) ? error : times.back() / run.summary.end_time;  // a shorter run tells the cost of a step
    points.push_back({.diagram = diagram.id,
                      .series = results.method.name,
                      .family = family_of(results.method),
                      .run = run.summary.level,
                      .particles = static_cast<double>(cost.particles),
                      .per_step = cost.per_step(),
                      .error = error,
                      .cpu = fraction * cost.cpu,
                      .cpu_lowest = fraction * cost.cpu_lowest,
                      .cpu_highest = fraction * cost.cpu_highest});
  }
  return points;
}

Plot error_against_run_time(WorkDiagram diagram, std::vector<double> times, std::vector<WorkPoint> elsewhere) {
  return [=](const Results& results, Record& record) {
    record.diagrams.push_back(diagram);
    const std::vector<WorkPoint> ours = work_points(diagram, times, results, record);
    record.work.insert(record.work.end(), ours.begin(), ours.end());
    for (WorkPoint point : elsewhere) {
      point.diagram = diagram.id;
      point.elsewhere = true;
      record.work.push_back(point);
    }
  };
}

Quantity price_of(const WorkDiagram& diagram, double target) {
  const std::string& unit = diagram.quantity.unit;
  return {fmt::format("CPU time to {:g}{}", target, unit.empty() ? "" : " " + unit), "s", Kind::cost};
}

Finding prices(WorkDiagram diagram, std::vector<double> times) {
  return [=](const Results& results, const Record& record) {
    const std::vector<WorkPoint> points = work_points(diagram, times, results, record);
    std::vector<Value> found;
    for (const double target : diagram.targets)
      found.push_back({"", not_a_number, times.back(), price_of(diagram, target), time_to_error(points, target).cpu});
    return found;
  };
}

WorkDiagram WorkStudy::diagram() const {
  const std::string when = times.size() == 1 ? fmt::format("t = {:g} s", times[0])
                                             : fmt::format("t = {} s (the larger one)", fmt::join(times, " and "));
  return {
      .id = "work",
      .title = "Work-precision diagram",
      .caption = fmt::format("{} at {}, against CPU time, each method over resolutions, points per cell or smoothing "
                             "lengths, and time steps{}; lower left is better.",
                             error.name, when, stiffness.size() > 1 ? ", and sound speeds" : ""),
      .quantity = error,
      .targets = targets,
      .ranked_by = ranked_by};
}

Case with_work(Case declared, const WorkStudy& study, std::vector<WorkPoint> elsewhere) {
  for (Method& method : declared.methods)
    if (method.time_step) {
      const std::vector<Level> levels = levels_of(study, method);
      method.levels.insert(method.levels.end(), levels.begin(), levels.end());
      method.claims_of_work.push_back(at_least(worth_making, 1, theory("a method that is stable has an error")));
    }
  const WorkDiagram diagram = study.diagram();
  declared.work_budget = study.budget;
  declared.error_of_work = [=, measurements = declared.measurements](const Level& level, const Run& run) {
    Record measured;
    for (const Measurement& measure : measurements)
      for (const Value& value : measure(level, run)) measured.values.push_back(value);
    return largest_error(study.error, study.times, measured, run);
  };
  declared.plots.push_back(in_work(error_against_run_time(diagram, study.times, std::move(elsewhere))));
  if (study.stiffness.size() > 1) declared.plots.push_back(in_work(error_against_stiffness(study)));
  declared.findings.push_back(prices(diagram, study.times));
  declared.findings.push_back([=](const Results& results, const Record& record) -> std::vector<Value> {
    const auto front = pareto_front(work_points(diagram, study.times, results, record), worthwhile);
    return {{"", not_a_number, study.times.back(), worth_making, static_cast<double>(front.size())}};
  });
  return declared;
}

}  // namespace touchstone::vnv

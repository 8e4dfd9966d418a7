#include "reports/compare/work_precision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

namespace touchstone::reports {
namespace {

using vnv::Role;
using vnv::TimeToError;
using vnv::WorkDiagram;
using vnv::WorkPoint;
using Points = std::vector<WorkPoint>;

template <class Fits>
Points those(const Points& points, const Fits& fits) {
  Points chosen;
  std::ranges::copy_if(points, std::back_inserter(chosen), fits);
  return chosen;
}

bool is_measured_here(const WorkPoint& p) { return !p.elsewhere; }

/// The machine that ran most of these methods, of equal ones the first; empty if `is_meant` is none.
std::string usual_machine(const CaseRecords& records, const auto& is_meant) {
  std::vector<std::string> machines;
  for (const auto& record : records.records)
    if (is_meant(record)) machines.push_back(vnv::one_machine(record));
  const auto most = std::ranges::max_element(
      machines, {}, [&](const std::string& machine) { return std::ranges::count(machines, machine); });
  return most == machines.end() ? "" : *most;
}

/// All points of a diagram; those that several records bring stand once. What another machine ran is elsewhere, and of
/// no published pair.
Points points_of(const CaseRecords& records, const WorkDiagram& diagram, const std::string& machine) {
  Points points;
  for_each(records, &vnv::Record::work, [&](const vnv::Record& record, WorkPoint point) {
    const bool is_known = point.elsewhere && std::ranges::any_of(points, [&](const WorkPoint& p) {
                            return p.elsewhere && p.series == point.series && p.run == point.run;
                          });
    if (point.diagram != diagram.id || is_known) return;
    if (!point.elsewhere && vnv::one_machine(record) != machine) {
      point.elsewhere = true;
      point.series += " on " + (record.host.empty() ? record.machine : record.host);
      point.per_step = vnv::not_a_number;
    }
    points.push_back(std::move(point));
  });
  return points;
}

vnv::Curve curve(const WorkDiagram& diagram, std::string label, Role role, const Points& points) {
  vnv::Curve drawn{diagram.id, std::move(label), role, {}, {}, role == Role::guide || role == Role::best};
  for (const WorkPoint& point : points) {
    drawn.x.push_back(point.cpu);
    drawn.y.push_back(point.error);
  }
  return drawn;
}

/// The points that are not on the front of their own series.
Points beaten(const Points& points) {
  Points left;
  for (const std::string& series : vnv::ranking(points, 1)) {
    const Points own = vnv::of_series(points, series), front = vnv::pareto_front(own, vnv::worthwhile);
    std::ranges::copy_if(own, std::back_inserter(left),
                         [&](const WorkPoint& p) { return p.error > 0 && std::ranges::find(front, p) == front.end(); });
  }
  return left;
}

vnv::Figure figure(const WorkDiagram& diagram, const std::string& machine) {
  return {
      .id = diagram.id,
      .title = diagram.title,
      .caption =
          diagram.caption +
          " A line joins the runs of a method that are worth making: no cheaper one comes within 5 % of their "
          "error. Rings mark the same among all methods here, the Pareto front. Dashed: measured elsewhere, on other machines." +
          (machine.empty() ? "" : " All else was run on one: " + machine + "."),
      .x = {.label = "CPU time [s]", .logarithmic = true},
      .y = {.label = diagram.quantity.heading(), .logarithmic = true}};
}

/// Each method's own front goes into its own record, and with it gets the colour that it has in other figures.
void add_curves(CaseRecords& records, const WorkDiagram& diagram, const Points& points) {
  for (auto& record : records.records)
    if (const auto own = vnv::of_series(points, record.method); !own.empty())
      record.curves.push_back(curve(diagram, record.method, Role::ours, vnv::pareto_front(own, vnv::worthwhile)));
  auto& curves = records.records.front().curves;
  const Points others = those(points, &WorkPoint::elsewhere), ours = those(points, is_measured_here);
  for (const std::string& series : vnv::ranking(others, diagram.ranked_by))
    curves.push_back(curve(diagram, series, Role::published, vnv::pareto_front(vnv::of_series(others, series))));
  if (const auto left = beaten(ours); !left.empty())
    curves.push_back(curve(diagram, "beaten by another run of its method", Role::guide, left));
  curves.push_back(
      curve(diagram, "Pareto front of all methods here", Role::best, vnv::pareto_front(ours, vnv::worthwhile)));
}

std::string interval(const TimeToError& time) {
  if (!time.is_reached()) return "not reached";
  if (time.at_most) return fmt::format("≤ {:.3g}", time.cpu);
  return fmt::format("{:.3g} ({:.3g} to {:.3g})", time.cpu, time.lowest, time.highest);
}

/// "3 %" where the quantity ends with [%].
std::string with_unit_of(const WorkDiagram& diagram, double target) {
  return fmt::format("{:g}{}", target, diagram.quantity.unit == "%" ? " %" : "");
}

vnv::Table costs(const WorkDiagram& diagram, const Points& points) {
  vnv::Table table{diagram.id + "_prices",
                   "CPU time to a given error",
                   fmt::format("Interpolated on logarithmic axes along each method's own front; in brackets from the "
                               "fastest repeat of the neighbouring run that is not good enough to the slowest of the "
                               "one that is. ≤: the cheapest run is better already. Ranked by the time to {}.",
                               with_unit_of(diagram, diagram.ranked_by)),
                   {"rank", "method"},
                   {}};
  for (const double target : diagram.targets)
    table.columns.push_back("CPU to " + with_unit_of(diagram, target) + " [s]");
  table.columns.push_back("smallest error");
  double rank = 0;
  for (const std::string& series : vnv::ranking(points, diagram.ranked_by)) {
    const Points own = vnv::of_series(points, series), front = vnv::pareto_front(own);
    table.rows.push_back({++rank, series + (own.front().elsewhere ? ", measured elsewhere" : "")});
    for (const double target : diagram.targets) table.rows.back().push_back(interval(vnv::time_to_error(own, target)));
    table.rows.back().push_back(front.empty() ? vnv::not_a_number : front.back().error);
  }
  return table;
}

/// Runs of SPH and of MPM whose costs are compared, and what their ratio is called.
struct Comparison {
  std::string name;
  Points sph, mpm;
};

/// The published pair, if it says how long a step took; then all SPH of ours with all MPM of ours, and each SPH alone.
std::vector<Comparison> comparisons(const Points& points) {
  const auto is_mpm = [](const WorkPoint& p) { return p.family == "MPM"; };
  const Points published = those(points, [](const WorkPoint& p) { return p.elsewhere && p.per_step > 0; });
  const Points ours = those(points, is_measured_here);
  const Points mpm = those(ours, is_mpm);
  std::vector<Comparison> all;
  if (!published.empty())
    all.push_back({"Sun et al.", those(published, std::not_fn(is_mpm)), those(published, is_mpm)});
  all.push_back({"cheapest SPH here", those(ours, std::not_fn(is_mpm)), mpm});
  std::set<std::string> known;
  for (const WorkPoint& p : ours)
    if (!is_mpm(p) && known.insert(p.series).second) all.push_back({p.series, vnv::of_series(ours, p.series), mpm});
  std::erase_if(all, [](const Comparison& c) { return c.sph.empty() || c.mpm.empty(); });
  return all;
}

std::set<double> numbers_in(const Points& points) {
  std::set<double> numbers;
  for (const WorkPoint& p : points)
    if (p.per_step > 0) numbers.insert(p.particles);
  return numbers;
}

/// The particle numbers that every pair has on both sides.
std::set<double> common_numbers(const std::vector<Comparison>& pairs) {
  std::set<double> common = numbers_in(pairs.front().sph);
  for (const Comparison& pair : pairs)
    for (const Points& side : {pair.sph, pair.mpm}) {
      const std::set<double> there = numbers_in(side);
      std::erase_if(common, [&](double number) { return !there.contains(number); });
    }
  return common;
}

double step_ratio(const Comparison& pair, double particles) {
  return vnv::time_per_step(pair.sph, particles) / vnv::time_per_step(pair.mpm, particles);
}

/// "12.3", with a sign of inequality if one side is only known to be at most so much; "SPH does not reach it".
std::string cost_ratio(const Comparison& pair, double target) {
  const TimeToError sph = vnv::time_to_error(pair.sph, target), mpm = vnv::time_to_error(pair.mpm, target);
  if (!sph.is_reached() && !mpm.is_reached()) return "neither reaches it";
  if (!sph.is_reached()) return "SPH does not reach it";
  if (!mpm.is_reached()) return "MPM does not reach it";
  const char* sign = sph.at_most && mpm.at_most ? "about " : sph.at_most ? "≤ " : mpm.at_most ? "≥ " : "";
  return fmt::format("{}{:.3g}", sign, sph.cpu / mpm.cpu);
}

/// Every run that was measured, for as long as it took until then.
Points points_of(const vnv::Record& record, const Subject& subject) {
  Points points;
  for (const auto& error : record.values) {
    const auto run = std::ranges::find(record.runs, error.level, &vnv::RunSummary::level);
    if (!subject.is(error.quantity.heading(), error.time) || run == record.runs.end() || !run->finished) continue;
    if (std::isnan(run->cost.cpu)) continue;  // unknown, or of another resource, which is compared with none
    const double fraction = error.time / run->end_time;
    points.push_back({.series = record.method,
                      .run = run->level,
                      .error = error.value,
                      .cpu = fraction * run->cost.cpu,
                      .cpu_lowest = fraction * run->cost.cpu_lowest,
                      .cpu_highest = fraction * run->cost.cpu_highest});
  }
  return points;
}

}  // namespace

void add_work_precision(CaseRecords& records) {
  for (const WorkDiagram& diagram : each_once(records, &vnv::Record::diagrams)) {
    const std::string machine = usual_machine(records, [&](const vnv::Record& record) {
      return std::ranges::any_of(record.work,
                                 [&](const WorkPoint& p) { return p.diagram == diagram.id && is_measured_here(p); });
    });
    const Points points = points_of(records, diagram, machine);
    auto& first = records.records.front();
    first.figures.push_back(figure(diagram, machine));
    add_curves(records, diagram, points);
    first.tables.push_back(costs(diagram, points));
    if (auto ratios = cost_ratios(diagram, points); !ratios.rows.empty()) first.tables.push_back(std::move(ratios));
  }
}

vnv::Table cost_ratios(const vnv::WorkDiagram& diagram, const Points& points) {
  const std::vector<Comparison> pairs = comparisons(points);
  vnv::Table table{
      diagram.id + "_ratios",
      "Equal particle number and equal error, side by side",
      "CPU time of SPH over that of the cheapest MPM beside it. Sun et al. compare at equal particle number and call MPM "
      "ten times cheaper; what a user pays for is the error.",
      {"at equal", "of"},
      {}};
  if (pairs.empty()) return table;
  for (const Comparison& pair : pairs) table.columns.push_back("SPH over MPM, " + pair.name);
  for (const double particles : common_numbers(pairs)) {
    table.rows.push_back({"particle number, a step", fmt::format("{:g} particles", particles)});
    for (const Comparison& pair : pairs) table.rows.back().push_back(step_ratio(pair, particles));
  }
  for (const double target : diagram.targets) {
    table.rows.push_back({"error, the whole run", with_unit_of(diagram, target)});
    for (const Comparison& pair : pairs) table.rows.back().push_back(cost_ratio(pair, target));
  }
  return table;
}

std::optional<Cheapest> cheapest(const CaseRecords& records, const Subject& subject) {
  const std::string machine =
      usual_machine(records, [&](const vnv::Record& record) { return !points_of(record, subject).empty(); });
  Points points;
  for (const auto& record : records.records)
    if (vnv::one_machine(record) == machine)
      for (WorkPoint& point : points_of(record, subject)) points.push_back(std::move(point));
  std::vector<double> least;  // error of each method
  for (const std::string& method : vnv::ranking(points, 1))
    if (const auto front = vnv::pareto_front(vnv::of_series(points, method), vnv::worthwhile); !front.empty())
      least.push_back(front.back().error);
  if (least.size() < 2) return std::nullopt;
  std::ranges::nth_element(least, least.begin() + 1);
  const double error = least[1];
  const std::vector<std::string> methods = vnv::ranking(points, error);
  const auto cost = [&](const std::string& method) {
    return Cheapest::Cost{method, vnv::time_to_error(vnv::of_series(points, method), error)};
  };
  return Cheapest{error, cost(methods[0]), cost(methods[1]), machine};
}

}  // namespace touchstone::reports

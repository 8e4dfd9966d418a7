#include "reports/compare/work_precision.hpp"

#include "reports/text/notation.hpp"
#include "vnv/record/same_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <tuple>

namespace touchstone::reports {
namespace {

using vnv::heading_of;
using vnv::Resource;
using vnv::Role;
using vnv::same_time;
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

/// Every run of a record whose value of what is asked for was measured, for as long as it took of a resource until
/// then; what it took is unknown of files that were judged.
Points runs_of(const vnv::Record& record, Resource resource, const auto& is_asked) {
  Points points;
  for (const vnv::Value& error : record.values) {
    const auto run = std::ranges::find(record.runs, error.level, &vnv::RunSummary::level);
    if (run == record.runs.end() || !run->finished || !is_asked(error)) continue;
    const vnv::Cost& cost = run->cost;
    if (cost.resource != resource || std::isnan(cost.spent())) continue;
    const double fraction = error.time / run->end_time;
    const bool is_cpu = resource == Resource::cpu;
    points.push_back({.series = record.method,
                      .run = run->level,
                      .particles = static_cast<double>(cost.particles),
                      .error = error.value,
                      .cpu = fraction * cost.spent(),
                      .cpu_lowest = fraction * (is_cpu ? cost.cpu_lowest : cost.spent()),
                      .cpu_highest = fraction * (is_cpu ? cost.cpu_highest : cost.spent())});
  }
  return points;
}

bool brings_its_own(const vnv::Record& record, const WorkDiagram& diagram) {
  return std::ranges::any_of(record.work,
                             [&](const WorkPoint& p) { return p.diagram == diagram.id && is_measured_here(p); });
}

/// The time of a quantity at which most methods have three runs or more, then at which most have any; the latest of
/// equal ones. Not a number if it was never measured.
double telling_time(const CaseRecords& records, const vnv::Quantity& quantity) {
  std::vector<double> times;
  for_each(records, &vnv::Record::values, [&](const auto&, const vnv::Value& value) {
    if (value.quantity == quantity && std::ranges::none_of(times, [&](double t) { return same_time(t, value.time); }))
      times.push_back(value.time);
  });
  const auto merit = [&](double time) {
    long ladders = 0, methods = 0;
    for (const vnv::Record& record : records.records) {
      const auto runs = std::ranges::count_if(record.values, [&](const vnv::Value& value) {
        return value.quantity == quantity && same_time(value.time, time);
      });
      ladders += runs >= 3;
      methods += runs > 0;
    }
    return std::tuple(ladders, methods, time);
  };
  return times.empty() ? vnv::not_a_number : *std::ranges::max_element(times, {}, merit);
}

/// The points of a diagram that a record brings, in one resource: its own, or those of its runs.
Points points_of(const vnv::Record& record, const WorkDiagram& diagram, double time, Resource resource) {
  Points points =
      those(record.work, [&](const WorkPoint& p) { return p.diagram == diagram.id && resource == Resource::cpu; });
  const auto is_asked = [&](const vnv::Value& v) { return v.quantity == diagram.quantity && same_time(v.time, time); };
  if (!brings_its_own(record, diagram))
    std::ranges::copy(runs_of(record, resource, is_asked), std::back_inserter(points));
  return points;
}

/// The machine that ran most of the methods of a diagram.
std::string usual_machine(const CaseRecords& records, const WorkDiagram& diagram, double time, Resource resource) {
  return usual_machine(records, [&](const vnv::Record& record) {
    return std::ranges::any_of(points_of(record, diagram, time, resource), is_measured_here);
  });
}

/// All points of a diagram in one resource; those that several records bring stand once. What another machine ran is
/// elsewhere, and of no published pair.
Points points_of(const CaseRecords& records, const WorkDiagram& diagram, double time, Resource resource,
                 const std::string& machine) {
  Points points;
  for (const vnv::Record& record : records.records)
    for (WorkPoint& point : points_of(record, diagram, time, resource)) {
      const bool is_known = point.elsewhere && std::ranges::any_of(points, [&](const WorkPoint& p) {
                              return p.elsewhere && p.series == point.series && p.run == point.run;
                            });
      if (is_known) continue;
      if (!point.elsewhere && vnv::one_machine(record) != machine) {
        point.elsewhere = true;
        point.series += " on " + (record.host.empty() ? record.machine : record.host);
        point.per_step = vnv::not_a_number;
      }
      points.push_back(std::move(point));
    }
  return points;
}

/// The errors of each method's runs worth making: the smallest of each, rising, and the largest of all.
struct Reach {
  std::vector<double> least{};
  double largest = 0;

  explicit Reach(const Points& points) {
    for (const std::string& method : vnv::ranking(points, 1))
      if (const auto front = vnv::pareto_front(vnv::of_series(points, method), vnv::worthwhile); !front.empty()) {
        least.push_back(front.back().error);
        largest = std::max(largest, front.front().error);
      }
    std::ranges::sort(least);
  }
};

/// Targets where none are declared: powers of ten, or more between these where they are few, that two methods reach
/// and some cheapest run does not; ranked by the smallest that half of the methods reach.
void choose_targets(WorkDiagram& diagram, const Points& points) {
  const Reach reach(points);
  if (!diagram.targets.empty() || reach.least.empty()) return;
  const double smallest = reach.least[reach.least.size() > 1 ? 1 : 0],
               of_half = reach.least[(reach.least.size() - 1) / 2];
  for (const auto& steps : {std::vector{1.0}, std::vector{3.0, 1.0}, std::vector{5.0, 2.0, 1.0}}) {
    diagram.targets.clear();
    for (double power = std::pow(10, std::ceil(std::log10(reach.largest))); 5 * power >= smallest; power /= 10)
      for (const double step : steps)
        if (const double target = std::strtod(fmt::format("{:.1g}", step * power).c_str(), nullptr);
            target >= smallest && target <= reach.largest)
          diagram.targets.push_back(target);
    if (diagram.targets.size() >= 3) break;
  }
  constexpr std::size_t most = 4;
  if (diagram.targets.size() > most) diagram.targets.erase(diagram.targets.begin(), diagram.targets.end() - most);
  for (const double target : diagram.targets)
    if (target >= of_half) diagram.ranked_by = target;
}

/// The diagram of a resource, with all that its declaration leaves to the page.
WorkDiagram told(WorkDiagram diagram, double time, Resource resource, const Points& points) {
  const std::string name(word_of(resource));
  if (diagram.caption.empty())
    diagram.caption = fmt::format(
        "{}, at t = {:g} s, against {} time up to then (longer runs are charged pro rata); lower left is "
        "better.",
        diagram.quantity.name, time, name);
  if (resource != Resource::cpu) {
    diagram.id += "_" + name;
    diagram.title += fmt::format(", {} time", name);
    diagram.caption += " That is the wall time of a run times the number of units that it occupied.";
  }
  choose_targets(diagram, points);
  return diagram;
}

Work work_in(const CaseRecords& records, const WorkDiagram& declared, Resource resource) {
  const double time = telling_time(records, declared.quantity);
  const std::string machine = usual_machine(records, declared, time, resource);
  const Points points = points_of(records, declared, time, resource, machine);
  return {told(declared, time, resource, points), time, points, machine};
}

/// What most methods have measured of a kind, of equal ones the first. What was measured twice at one spacing is of
/// runs that differ in something else, and at no time of none to compare.
std::optional<vnv::Quantity> usual_quantity(const CaseRecords& records, vnv::Kind kind) {
  std::vector<std::pair<vnv::Quantity, std::set<std::string>>> measured;  // by which methods
  std::set<std::tuple<std::string, std::string, double, double>> places;
  std::set<std::string> unfit;
  for_each(records, &vnv::Record::values, [&](const vnv::Record& record, const vnv::Value& value) {
    if (value.quantity.kind != kind) return;
    const std::string heading = value.quantity.heading();
    if (!std::isfinite(value.time) || !places.emplace(record.method, heading, value.time, value.spacing).second)
      unfit.insert(heading);
    auto known = std::ranges::find(measured, value.quantity, [](const auto& one) { return one.first; });
    if (known == measured.end()) known = measured.insert(measured.end(), {value.quantity, {}});
    known->second.insert(record.method);
  });
  std::erase_if(measured, [&](const auto& one) { return unfit.contains(one.first.heading()); });
  if (measured.empty()) return std::nullopt;
  return std::ranges::max_element(measured, {}, [](const auto& one) { return one.second.size(); })->first;
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
    std::ranges::copy_if(own, std::back_inserter(left), [&](const WorkPoint& p) {
      const auto is_it = [&](const WorkPoint& f) { return f.cpu == p.cpu && f.error == p.error; };
      return p.error > 0 && std::ranges::none_of(front, is_it);
    });
  }
  return left;
}

/// What a reader must know of where and how the times of a diagram were measured.
std::string about_times(const CaseRecords& records, const Points& points, const std::string& machine) {
  std::string words;
  if (std::ranges::any_of(records.records, [&](const vnv::Record& record) {
        return record.another_code && !vnv::of_series(points, record.method).empty();
      }))
    words += " For other codes, the time is that of the whole program, including its start and its output.";
  const bool some_elsewhere = std::ranges::any_of(points, &WorkPoint::elsewhere);
  if (some_elsewhere) words += " Dashed: measured elsewhere, on other machines.";
  if (!machine.empty())
    words += fmt::format(" {}: {}.", some_elsewhere ? "All else was run on one" : "Run on one machine", machine);
  return words;
}

vnv::Figure figure(const CaseRecords& records, const WorkDiagram& diagram, Resource resource, const Points& points,
                   const std::string& machine) {
  return {
      .id = diagram.id,
      .title = diagram.title,
      .caption = diagram.caption +
                 " A line joins the efficient runs of a method: no cheaper one comes within 5 % of their error. Rings "
                 "mark the efficient runs of all methods here, the Pareto front." +
                 about_times(records, points, machine),
      .x = {.label = heading_of(resource), .logarithmic = true},
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
  if (points.empty()) return;
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

vnv::Table costs(const WorkDiagram& diagram, Resource resource, const Points& points) {
  const std::string name(word_of(resource));
  vnv::Table table{
      diagram.id + "_prices",
      name + " time to a given error",
      fmt::format("Interpolated on logarithmic axes along each method's own front; in brackets the range from the "
                  "fastest repeat of the neighbouring run whose error is too large to the slowest repeat of the one "
                  "whose error is small enough. ≤: the cheapest run already does better. Ranked by {}.",
                  std::isnan(diagram.ranked_by) ? "the smallest error"
                                                : "the time to " + with_unit_of(diagram, diagram.ranked_by)),
      {"rank", "method"},
      {}};
  for (const double target : diagram.targets)
    table.columns.push_back(name + " to " + with_unit_of(diagram, target) + " [s]");
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
  const auto is_sph = [](const WorkPoint& p) { return p.family == "SPH"; };
  const Points published = those(points, [](const WorkPoint& p) { return p.elsewhere && p.per_step > 0; });
  const Points ours = those(points, is_measured_here);
  const Points mpm = those(ours, is_mpm);
  std::vector<Comparison> all;
  if (!published.empty()) all.push_back({"Sun et al.", those(published, is_sph), those(published, is_mpm)});
  all.push_back({"cheapest SPH here", those(ours, is_sph), mpm});
  std::set<std::string> known;
  for (const WorkPoint& p : ours)
    if (is_sph(p) && known.insert(p.series).second) all.push_back({p.series, vnv::of_series(ours, p.series), mpm});
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

}  // namespace

void add_work_precision(CaseRecords& records) {
  for (const WorkDiagram& declared : each_once(records, &vnv::Record::diagrams)) {
    bool has_points = false;
    for (const Resource resource : {Resource::gpu, Resource::core, Resource::cpu}) {
      const auto [diagram, time, points, machine] = work_in(records, declared, resource);
      if (points.empty() && (has_points || resource != Resource::cpu)) continue;
      has_points = true;
      auto& first = records.records.front();
      first.figures.push_back(figure(records, diagram, resource, points, machine));
      add_curves(records, diagram, points);
      if (points.empty()) continue;
      first.tables.push_back(costs(diagram, resource, points));
      if (auto ratios = cost_ratios(diagram, points); !ratios.rows.empty()) first.tables.push_back(std::move(ratios));
    }
  }
}

std::optional<Work> work_of(const CaseRecords& records) {
  for (const WorkDiagram& declared : each_once(records, &vnv::Record::diagrams))
    if (Work work = work_in(records, declared, Resource::cpu); std::isfinite(work.time) || !work.points.empty())
      return work;
  for (const vnv::Kind kind : {vnv::Kind::norm, vnv::Kind::error})
    if (auto quantity = usual_quantity(records, kind))
      return work_in(records, {{}, {}, {}, std::move(*quantity), {}}, Resource::cpu);
  return std::nullopt;
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

std::string rounded(const TimeToError& time) { return (time.at_most ? "≤\u202f" : "") + rounded(time.cpu, "s"); }

std::optional<Cheapest> cheapest(const CaseRecords& records, const Subject& subject) {
  const auto own = [&](const vnv::Record& record) {
    return runs_of(record, Resource::cpu,
                   [&](const vnv::Value& v) { return subject.is(v.quantity.heading(), v.time); });
  };
  const std::string machine = usual_machine(records, [&](const vnv::Record& record) { return !own(record).empty(); });
  Points points;
  for (const auto& record : records.records)
    if (vnv::one_machine(record) == machine) std::ranges::move(own(record), std::back_inserter(points));
  const std::vector<double> least = Reach(points).least;
  if (least.size() < 2) return std::nullopt;
  const double error = least[1];
  const std::vector<std::string> methods = vnv::ranking(points, error);
  const auto cost = [&](const std::string& method) {
    return Cheapest::Cost{method, vnv::time_to_error(vnv::of_series(points, method), error)};
  };
  return Cheapest{error, cost(methods[0]), cost(methods[1]), machine};
}

}  // namespace touchstone::reports

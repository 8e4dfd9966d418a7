#include "reports/compare/work.hpp"

#include "reports/compare/price_ratios.hpp"
#include "reports/text/numbers.hpp"
#include "vnv/record/work_precision.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace touchstone::reports {
namespace {

using vnv::Role;
using vnv::WorkDiagram;
using vnv::WorkPoint;

/// All points of a diagram; those that several records bring stand once.
std::vector<WorkPoint> points_of(const CaseRecords& records, const WorkDiagram& diagram) {
  std::vector<WorkPoint> points;
  for (const auto& record : records.records)
    for (const WorkPoint& point : record.work) {
      const bool is_known = std::ranges::any_of(
          points, [&](const WorkPoint& p) { return p.elsewhere && p.series == point.series && p.run == point.run; });
      if (point.diagram == diagram.id && !is_known) points.push_back(point);
    }
  return points;
}

std::vector<WorkPoint> measured(bool elsewhere, const std::vector<WorkPoint>& points) {
  std::vector<WorkPoint> chosen;
  std::ranges::copy_if(points, std::back_inserter(chosen),
                       [&](const WorkPoint& p) { return p.elsewhere == elsewhere; });
  return chosen;
}

vnv::Curve curve(const WorkDiagram& diagram, std::string label, Role role, const std::vector<WorkPoint>& points) {
  vnv::Curve drawn{diagram.id, std::move(label), role, {}, {}, role == Role::guide || role == Role::best};
  for (const WorkPoint& point : points) {
    drawn.x.push_back(point.cpu);
    drawn.y.push_back(point.error);
  }
  return drawn;
}

/// The points that are not on the front of their own series.
std::vector<WorkPoint> beaten(const std::vector<WorkPoint>& points) {
  std::vector<WorkPoint> left;
  for (const std::string& series : vnv::ranking(points, 1)) {
    const std::vector<WorkPoint> own = vnv::of_series(points, series), front = vnv::pareto_front(own, vnv::worthwhile);
    std::ranges::copy_if(own, std::back_inserter(left),
                         [&](const WorkPoint& p) { return p.error > 0 && std::ranges::find(front, p) == front.end(); });
  }
  return left;
}

vnv::Figure figure(const WorkDiagram& diagram) {
  return {
      .id = diagram.id,
      .title = diagram.title,
      .caption =
          diagram.caption +
          " A line joins the runs of a method that are worth making: no cheaper one comes within 5 % of their "
          "error. Rings mark the same among all methods here, the Pareto front. Dashed: measured elsewhere, on other machines.",
      .x = {.label = "CPU time [s]", .logarithmic = true},
      .y = {.label = diagram.quantity.heading(), .logarithmic = true}};
}

/// Each method's own front goes into its own record, and with it gets the colour that it has in other figures.
void add_curves(CaseRecords& records, const WorkDiagram& diagram, const std::vector<WorkPoint>& points) {
  for (auto& record : records.records)
    if (const auto own = vnv::of_series(points, record.method); !own.empty())
      record.curves.push_back(curve(diagram, record.method, Role::ours, vnv::pareto_front(own, vnv::worthwhile)));
  auto& curves = records.records.front().curves;
  const std::vector<WorkPoint> others = measured(true, points), ours = measured(false, points);
  for (const std::string& series : vnv::ranking(others, diagram.ranked_by))
    curves.push_back(curve(diagram, series, Role::published, vnv::pareto_front(vnv::of_series(others, series))));
  if (const auto left = beaten(ours); !left.empty())
    curves.push_back(curve(diagram, "beaten by another run of its method", Role::guide, left));
  curves.push_back(
      curve(diagram, "Pareto front of all methods here", Role::best, vnv::pareto_front(ours, vnv::worthwhile)));
}

std::string interval(const vnv::TimeToError& time) {
  if (!time.is_reached()) return "not reached";
  if (time.at_most) return fmt::format("≤ {:.3g}", time.cpu);
  return fmt::format("{:.3g} ({:.3g} to {:.3g})", time.cpu, time.lowest, time.highest);
}

/// "3 %" where the quantity ends with [%].
std::string with_unit_of(const WorkDiagram& diagram, double target) {
  return fmt::format("{:g}{}", target, diagram.quantity.unit == "%" ? " %" : "");
}

vnv::Table prices(const WorkDiagram& diagram, const std::vector<WorkPoint>& points) {
  vnv::Table table{diagram.id + "_prices",
                   "CPU seconds to an error",
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
    const std::vector<WorkPoint> own = vnv::of_series(points, series), front = vnv::pareto_front(own);
    table.rows.push_back({++rank, series + (own.front().elsewhere ? ", measured elsewhere" : "")});
    for (const double target : diagram.targets) table.rows.back().push_back(interval(vnv::time_to_error(own, target)));
    table.rows.back().push_back(front.empty() ? vnv::not_a_number : front.back().error);
  }
  return table;
}

std::vector<WorkDiagram> diagrams_of(const CaseRecords& records) {
  std::vector<WorkDiagram> diagrams;
  for (const auto& record : records.records)
    for (const auto& diagram : record.diagrams)
      if (std::ranges::find(diagrams, diagram.id, &WorkDiagram::id) == diagrams.end()) diagrams.push_back(diagram);
  return diagrams;
}

}  // namespace

void add_work(CaseRecords& records) {
  for (const WorkDiagram& diagram : diagrams_of(records)) {
    const std::vector<WorkPoint> points = points_of(records, diagram);
    auto& first = records.records.front();
    first.figures.push_back(figure(diagram));
    add_curves(records, diagram, points);
    first.tables.push_back(prices(diagram, points));
    if (auto ratios = price_ratios(diagram, points); !ratios.rows.empty()) first.tables.push_back(std::move(ratios));
  }
}

}  // namespace touchstone::reports

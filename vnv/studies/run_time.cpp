#include "vnv/studies/run_time.hpp"

#include "vnv/plots/along_ladders.hpp"
#include "vnv/record/work_precision.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace touchstone::vnv {
namespace {

std::string family_of(const Method& method) {
  if (method.family == Family::undeclared)
    throw std::invalid_argument(fmt::format("{}: no family is declared, expected one of mpm, sph", method.name));
  return method.family == Family::mpm ? "MPM" : "SPH";
}

}  // namespace

std::vector<WorkPoint> work_points(const WorkDiagram& diagram, double time, const Results& results,
                                   const Record& record) {
  std::vector<WorkPoint> points;
  for (const Run& run : results.runs) {
    if (!run.summary.finished) continue;
    const Cost& cost = run.summary.cost;
    const std::optional<double> error = error_of(diagram.quantity, time)(record, run);
    const double fraction =
        error ? time / run.summary.end_time : not_a_number;  // a shorter run tells the cost of a step
    points.push_back({.diagram = diagram.id,
                      .series = results.method.name,
                      .family = family_of(results.method),
                      .run = run.summary.level,
                      .particles = static_cast<double>(cost.particles),
                      .per_step = cost.per_step(),
                      .error = error.value_or(not_a_number),
                      .cpu = fraction * cost.cpu,
                      .cpu_lowest = fraction * cost.cpu_lowest,
                      .cpu_highest = fraction * cost.cpu_highest});
  }
  return points;
}

Plot error_against_run_time(WorkDiagram diagram, double time, std::vector<WorkPoint> elsewhere) {
  return [=](const Results& results, Record& record) {
    record.diagrams.push_back(diagram);
    const std::vector<WorkPoint> ours = work_points(diagram, time, results, record);
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

Finding prices(WorkDiagram diagram, double time) {
  return [=](const Results& results, const Record& record) {
    const std::vector<WorkPoint> points = work_points(diagram, time, results, record);
    std::vector<Value> found;
    for (const double target : diagram.targets)
      found.push_back({"", not_a_number, time, price_of(diagram, target), time_to_error(points, target).cpu});
    return found;
  };
}

}  // namespace touchstone::vnv

#include "vnv/record/work_precision.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace touchstone::vnv {
namespace {

bool is_drawable(double value) { return value > 0 && std::isfinite(value); }

double best_error(const std::vector<WorkPoint>& points) {
  double best = std::numeric_limits<double>::infinity();
  for (const WorkPoint& p : points)
    if (is_drawable(p.error)) best = std::min(best, p.error);
  return best;
}

/// The time on the straight line between two points of logarithmic axes.
double between(const WorkPoint& coarse, const WorkPoint& fine, double target) {
  const double fraction = std::log(coarse.error / target) / std::log(coarse.error / fine.error);
  return coarse.cpu * std::pow(fine.cpu / coarse.cpu, fraction);
}

}  // namespace

std::vector<WorkPoint> pareto_front(std::vector<WorkPoint> points, double gain) {
  std::erase_if(points, [](const WorkPoint& p) { return !is_drawable(p.error) || !is_drawable(p.cpu); });
  std::ranges::stable_sort(points, {}, [](const WorkPoint& p) { return std::tuple(p.cpu, p.error); });
  double best = std::numeric_limits<double>::infinity();
  std::erase_if(points, [&](const WorkPoint& p) {
    const bool is_beaten = p.error >= best * (1 - gain);
    if (!is_beaten) best = p.error;
    return is_beaten;
  });
  return points;
}

TimeToError time_to_error(const std::vector<WorkPoint>& points, double target) {
  const std::vector<WorkPoint> front = pareto_front(points, worthwhile);
  const auto fine = std::ranges::find_if(front, [&](const WorkPoint& p) { return p.error <= target; });
  if (fine == front.end()) return {};
  if (fine == front.begin()) return {fine->cpu, 0, fine->cpu_highest, true};
  return {between(fine[-1], *fine, target), fine[-1].cpu_lowest, fine->cpu_highest, false};
}

std::vector<WorkPoint> of_series(const std::vector<WorkPoint>& points, const std::string& series) {
  std::vector<WorkPoint> found;
  std::ranges::copy_if(points, std::back_inserter(found), [&](const WorkPoint& p) { return p.series == series; });
  return found;
}

std::vector<std::string> ranking(const std::vector<WorkPoint>& points, double target) {
  std::vector<std::string> names;
  for (const WorkPoint& p : points)
    if (std::ranges::find(names, p.series) == names.end()) names.push_back(p.series);
  const auto price = [&](const std::string& name) {
    const std::vector<WorkPoint> own = of_series(points, name);
    const TimeToError time = time_to_error(own, target);
    return std::tuple(!time.is_reached(), time.is_reached() ? time.cpu : best_error(own));
  };
  std::ranges::stable_sort(names, {}, price);
  return names;
}

double time_per_step(const std::vector<WorkPoint>& points, double particles) {
  double least = not_a_number;
  for (const WorkPoint& p : points)
    if (p.particles == particles && !(p.per_step >= least)) least = p.per_step;
  return least;
}

}  // namespace touchstone::vnv

#include "reports/compare/cheapest.hpp"

#include <algorithm>
#include <set>

namespace touchstone::reports {
namespace {

using vnv::WorkPoint;

/// Every run that was measured, for as long as it took until then.
std::vector<WorkPoint> points_of(const vnv::Record& record, const Subject& subject) {
  std::vector<WorkPoint> points;
  for (const auto& error : record.values) {
    const auto run = std::ranges::find(record.runs, error.level, &vnv::RunSummary::level);
    if (!subject.is(error.quantity.heading(), error.time) || run == record.runs.end() || !run->finished) continue;
    const double share = error.time / run->end_time;
    points.push_back({.series = record.method,
                      .run = run->level,
                      .error = error.value,
                      .cpu = share * run->cost.cpu,
                      .cpu_lowest = share * run->cost.cpu_lowest,
                      .cpu_highest = share * run->cost.cpu_highest});
  }
  return points;
}

}  // namespace

std::optional<Cheapest> cheapest(const CaseRecords& records, const Subject& subject) {
  std::vector<WorkPoint> points;
  std::set<std::string> machines;
  for (const auto& record : records.records) {
    const std::vector<WorkPoint> own = points_of(record, subject);
    points.insert(points.end(), own.begin(), own.end());
    if (!own.empty()) machines.insert(record.machine);
  }
  std::vector<double> least;  // error of each method
  for (const std::string& method : vnv::ranking(points, 1))
    if (const auto front = vnv::pareto_front(vnv::of_series(points, method), vnv::worthwhile); !front.empty())
      least.push_back(front.back().error);
  if (least.size() < 2 || machines.size() > 1) return std::nullopt;
  std::ranges::nth_element(least, least.begin() + 1);
  const double error = least[1];
  const std::vector<std::string> methods = vnv::ranking(points, error);
  const auto price = [&](const std::string& method) {
    return Cheapest::Price{method, vnv::time_to_error(vnv::of_series(points, method), error)};
  };
  return Cheapest{error, price(methods[0]), price(methods[1])};
}

}  // namespace touchstone::reports

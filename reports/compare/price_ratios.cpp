#include "reports/compare/price_ratios.hpp"

#include "vnv/record/work_precision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

namespace touchstone::reports {
namespace {

using vnv::TimeToError;
using vnv::WorkPoint;
using Points = std::vector<WorkPoint>;

const std::string cheapest_here = "cheapest SPH here";

template <class Fits>
Points those(const Points& points, const Fits& fits) {
  Points chosen;
  std::ranges::copy_if(points, std::back_inserter(chosen), fits);
  return chosen;
}

/// Two sets of runs that are compared, and what their ratio is called.
struct Comparison {
  std::string name;
  Points dear, cheap;
};

/// The published pair, if it says how long a step took; then all SPH of ours with all MPM of ours, and each SPH alone.
std::vector<Comparison> comparisons(const Points& points) {
  const auto mpm = [](const WorkPoint& p) { return p.family == "MPM"; };
  const Points published = those(points, [](const WorkPoint& p) { return p.elsewhere && p.per_step > 0; });
  const Points ours = those(points, [](const WorkPoint& p) { return !p.elsewhere; });
  const Points cheap = those(ours, mpm);
  std::vector<Comparison> all;
  if (!published.empty()) all.push_back({"Sun et al.", those(published, std::not_fn(mpm)), those(published, mpm)});
  all.push_back({cheapest_here, those(ours, std::not_fn(mpm)), cheap});
  std::set<std::string> known;
  for (const WorkPoint& p : ours)
    if (!mpm(p) && known.insert(p.series).second) all.push_back({p.series, vnv::of_series(ours, p.series), cheap});
  std::erase_if(all, [](const Comparison& c) { return c.dear.empty() || c.cheap.empty(); });
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
  std::set<double> common = numbers_in(pairs.front().dear);
  for (const Comparison& pair : pairs)
    for (const Points& side : {pair.dear, pair.cheap}) {
      const std::set<double> there = numbers_in(side);
      std::erase_if(common, [&](double number) { return !there.contains(number); });
    }
  return common;
}

double step_ratio(const Comparison& pair, double particles) {
  return vnv::time_per_step(pair.dear, particles) / vnv::time_per_step(pair.cheap, particles);
}

/// "12.3", with a sign of inequality if one side is only known to be at most so much; "SPH does not reach it".
std::string price_ratio(const Comparison& pair, double target) {
  const TimeToError dear = vnv::time_to_error(pair.dear, target), cheap = vnv::time_to_error(pair.cheap, target);
  if (!dear.is_reached() && !cheap.is_reached()) return "neither reaches it";
  if (!dear.is_reached()) return "SPH does not reach it";
  if (!cheap.is_reached()) return "MPM does not reach it";
  const char* sign = dear.at_most && cheap.at_most ? "about " : dear.at_most ? "≤ " : cheap.at_most ? "≥ " : "";
  return fmt::format("{}{:.3g}", sign, dear.cpu / cheap.cpu);
}

std::string text_of(const vnv::Cell& cell) {
  const double* number = std::get_if<double>(&cell);
  return number ? fmt::format("{:.3g}", *number) : std::get<std::string>(cell);
}

/// "Sun et al.: 10.9; cheapest SPH here: 12": the pairs that are representative.
std::string listed(const std::vector<Comparison>& pairs, const std::vector<vnv::Cell>& row) {
  std::string list;
  for (std::size_t k = 0; k < pairs.size(); ++k)
    if (pairs[k].dear.front().elsewhere || pairs[k].name == cheapest_here)
      list += (list.empty() ? "" : "; ") + pairs[k].name + ": " + text_of(row[k + 2]);
  return list;
}

using Rows = std::vector<std::vector<vnv::Cell>>;

std::string sentence(const std::vector<Comparison>& pairs, const Rows& by_number, const Rows& by_error) {
  std::string words;
  if (!by_number.empty())
    words += fmt::format(" At equal particle number ({}) a step of SPH costs so many times one of MPM: {}.",
                         std::get<std::string>(by_number.front()[1]), listed(pairs, by_number.front()));
  for (const auto& row : by_error)
    words += fmt::format(" {} an error of {}: {}.",
                         &row == &by_error.front() ? "A run of SPH costs so many times one of MPM to" : "To",
                         std::get<std::string>(row[1]), listed(pairs, row));
  return words;
}

}  // namespace

vnv::Table price_ratios(const vnv::WorkDiagram& diagram, const Points& points) {
  const std::vector<Comparison> pairs = comparisons(points);
  vnv::Table table{
      diagram.id + "_ratios", "Equal particle number and equal error, side by side", "", {"at equal", "of"}, {}};
  if (pairs.empty()) return table;
  for (const Comparison& pair : pairs) table.columns.push_back("SPH over MPM, " + pair.name);
  Rows by_number, by_error;
  for (const double particles : common_numbers(pairs)) {
    by_number.push_back({"particle number, a step", fmt::format("{:g} particles", particles)});
    for (const Comparison& pair : pairs) by_number.back().push_back(step_ratio(pair, particles));
  }
  const char* unit = diagram.quantity.unit == "%" ? " %" : "";
  for (const double target : diagram.targets) {
    by_error.push_back({"error, the whole run", fmt::format("{:g}{}", target, unit)});
    for (const Comparison& pair : pairs) by_error.back().push_back(price_ratio(pair, target));
  }
  table.caption =
      "CPU time of SPH over that of the cheapest MPM. Sun et al. compare at equal particle number and "
      "call MPM ten times cheaper; what a user pays for is the error." +
      sentence(pairs, by_number, by_error);
  table.rows = by_number;
  table.rows.insert(table.rows.end(), by_error.begin(), by_error.end());
  return table;
}

}  // namespace touchstone::reports

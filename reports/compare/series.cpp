#include "reports/compare/series.hpp"

#include "vnv/record/median.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

namespace touchstone::reports {
namespace {

using Kind = Series::Kind;

/// Where a number stands in every night; times agree to nine digits.
using Key = std::tuple<std::string, std::string, bool, std::string, std::string, std::string>;

class Collector {
 public:
  explicit Collector(std::size_t nights) : nights_(nights) {}

  Series& at(Kind kind, const std::string& case_name, const std::string& method, const std::string& level, double time,
             const std::string& quantity) {
    const Key key{case_name, method, kind == Kind::cost, quantity, level, fmt::format("{:.9g}", time)};
    return by_key_
        .try_emplace(key, Series{.kind = kind,
                                 .case_name = case_name,
                                 .method = method,
                                 .level = level,
                                 .time = time,
                                 .quantity = quantity,
                                 .points = std::vector<SeriesPoint>(nights_)})
        .first->second;
  }

  std::vector<Series> sorted() && {
    std::vector<Series> sorted;
    for (auto& [key, series] : by_key_) sorted.push_back(std::move(series));
    return sorted;
  }

 private:
  std::size_t nights_;
  std::map<Key, Series> by_key_;
};

void put(Series& series, std::size_t night, double value) {
  SeriesPoint& point = series.points[night];
  if (!point.is_there) point.value = value;
  point.is_there = true;
}

/// That ran each method.
using Machines = std::map<std::pair<std::string, std::string>, std::string>;

Machines machines_in(const Night& night) {
  Machines machines;
  for (const NightRun& run : night.runs) machines.try_emplace({run.case_name, run.method}, run.machine);
  return machines;
}

void add_run(Collector& all, const NightRun& run, std::size_t night) {
  if (!run.finished) return;
  for (const auto& [quantity, value] :
       {std::pair{"CPU time [s]", run.cpu}, std::pair{"peak memory [MB]", run.peak_memory / 1e6}}) {
    if (std::isnan(value)) continue;  // files that were judged, or another resource
    Series& series = all.at(Kind::cost, run.case_name, run.method, run.level, vnv::not_a_number, quantity);
    series.spacing = run.spacing;
    put(series, night, value);
  }
}

void add_value(Collector& all, Kind kind, const NightValue& v, std::size_t night) {
  Series& series = all.at(kind, v.case_name, v.method, v.level, v.time, v.quantity);
  series.spacing = v.spacing;
  put(series, night, v.value);
}

/// Named as the claim on it is.
void add_order(Collector& all, const NightOrder& o, std::size_t night) {
  const std::string name = o.quantity.substr(0, o.quantity.rfind(" ["));
  Series& series =
      all.at(Kind::order, o.case_name, o.method, "", o.time, fmt::format("order of {} over {}", name, o.ladder));
  series.levels = o.levels;
  put(series, night, o.order);
}

bool is_of_baseline(const NightVerdict& v) { return v.author.starts_with("baseline"); }

void add_verdict(Collector& all, const NightVerdict& v, std::size_t night) {
  Series& series = all.at(v.quantity.starts_with("order of ") ? Kind::order : Kind::error, v.case_name, v.method,
                          v.level, v.time, v.quantity);
  if (std::isnan(series.spacing)) series.spacing = v.spacing;
  put(series, night, v.value);
  series.points[night].fails |= v.outcome == vnv::Outcome::fails;
  if (is_of_baseline(v)) {
    if (v.lower && v.upper && std::isfinite(*v.upper - *v.lower)) series.tolerance = (*v.upper - *v.lower) / 2;
    return;
  }
  series.author = v.author;
  series.lower = v.lower;
  series.upper = v.upper;
  series.has_margin |= v.outcome != vnv::Outcome::holds || v.margin != 0;
}

void add(Collector& all, const Night& night, std::size_t n) {
  for (const auto& run : night.runs) add_run(all, run, n);
  for (const auto& error : night.errors) add_value(all, Kind::error, error, n);
  for (const auto& limit : night.limits) add_value(all, Kind::limit, limit, n);
  for (const auto& order : night.orders) add_order(all, order, n);
  for (const auto& verdict : night.verdicts) add_verdict(all, verdict, n);
}

/// What a series keeps to between two steps.
class Level {
 public:
  explicit Level(const Series& series) : series_(series) {}

  /// The first nights make the level, so that it does not follow a slow drift.
  void add(double value) {
    if (values_.size() < most) values_.push_back(value);
  }
  void restart() { values_.clear(); }
  bool is_known() const { return !values_.empty(); }
  double middle() const { return vnv::median(values_); }

  bool holds(double value) const {
    const double level = middle();
    if (std::isnan(value) || std::isnan(level)) return std::isnan(value) == std::isnan(level);
    if (std::isinf(value) || std::isinf(level)) return value == level;
    return std::abs(value - level) <= std::max(tolerance(level), 4 * spread());
  }

 private:
  static constexpr std::size_t most = 15, enough = 5;  // nights
  static constexpr double rounding = 1e-12;            // in any unit: what another order of a sum leaves of zero

  double tolerance(double level) const {
    if (series_.tolerance) return *series_.tolerance;
    return std::max(rounding, (series_.kind == Kind::cost ? 0.1 : 0.01) * std::abs(level));
  }
  /// From night to night, so that a drift is not taken for noise; the standard deviation, if that is normal.
  double spread() const {
    if (values_.size() < enough) return 0;
    std::vector<double> differences;
    for (std::size_t i = 1; i < values_.size(); ++i) differences.push_back(std::abs(values_[i] - values_[i - 1]));
    return 1.4826 / std::numbers::sqrt2 * vnv::median(differences);
  }

  const Series& series_;
  std::vector<double> values_;
};

/// The points that are there, by night.
std::vector<std::size_t> nights_there(const Series& series) {
  std::vector<std::size_t> nights;
  for (std::size_t n = 0; n < series.points.size(); ++n)
    if (series.points[n].is_there) nights.push_back(n);
  return nights;
}

/// Whether the night after a cost that left its level stands on the same side.
bool stays_away(const Level& level, double value, double next) {
  return !level.holds(next) && (next > level.middle()) == (value > level.middle());
}

std::vector<bool> places_changed(const std::vector<Night>& nights) {
  std::vector<bool> changed(nights.size());
  const auto place = [](const Night& n) { return std::tie(n.compiler, n.flags); };
  for (std::size_t n = 1; n < nights.size(); ++n) changed[n] = place(nights[n]) != place(nights[n - 1]);
  return changed;
}

/// Runs of the largest CPU time of each method, in the last night that has them.
std::map<std::pair<std::string, std::string>, const Series*> most_expensive_runs(const std::vector<Series>& all) {
  std::map<std::pair<std::string, std::string>, const Series*> most_expensive;
  for (const Series& s : all) {
    if (s.quantity != "CPU time [s]" || s.kind != Kind::cost || !s.points.back().is_there) continue;
    const Series*& best = most_expensive[{s.case_name, s.method}];
    if (!best || s.points.back().value > best->points.back().value) best = &s;
  }
  return most_expensive;
}

bool is_judged(const Series& s) { return s.has_margin && !s.author.empty(); }

bool is_candidate(const Series& s) {
  if (s.kind == Kind::order) return is_judged(s) || (s.quantity.starts_with("order of L2") && s.levels > 2);
  return s.kind == Kind::limit || is_judged(s);
}

double or_lowest(double value) { return std::isnan(value) ? -INFINITY : value; }

/// Whether one says more of its quantity: a later time, then a finer spacing.
bool is_more_telling(const Series& a, const Series& b) {
  return std::pair(or_lowest(a.time), -a.spacing) > std::pair(or_lowest(b.time), -b.spacing);
}

}  // namespace

std::pair<double, double> Series::range() const {
  double low = INFINITY, high = -INFINITY;
  for (const auto& point : points)
    if (point.is_finite()) {
      low = std::min(low, point.value);
      high = std::max(high, point.value);
    }
  return {low, high};
}

void mark_steps(Series& series, const std::vector<bool>& starts_anew) {
  Level level(series);
  const auto there = nights_there(series);
  std::size_t last = 0;
  for (std::size_t i = 0; i < there.size(); ++i) {
    const std::size_t n = there[i];
    const SeriesPoint& point = series.points[n];
    const bool is_cost = series.kind == Kind::cost;
    if (is_cost && i > 0 &&
        (point.machine != series.points[last].machine ||
         std::any_of(starts_anew.begin() + last + 1, starts_anew.begin() + n + 1, std::identity{})))
      level.restart();
    const bool flips = level.is_known() && point.fails != series.points[last].fails;
    last = n;
    if (level.is_known() && (flips || !level.holds(point.value))) {
      const bool is_loud =
          is_cost && !(i + 1 < there.size() && stays_away(level, point.value, series.points[there[i + 1]].value));
      if (is_loud) continue;
      series.steps.push_back({n, level.middle(), point.value});
      level.restart();
    }
    level.add(point.value);
  }
}

std::optional<std::size_t> night_on_another_machine(const Series& series, const Step& step) {
  for (std::size_t n = step.night; n-- > 0;)
    if (const SeriesPoint& point = series.points[n]; point.is_there)
      return point.machine == series.points[step.night].machine ? std::nullopt : std::optional(n);
  return std::nullopt;
}

std::vector<Series> series_of(const std::vector<Night>& nights) {
  Collector collector(nights.size());
  for (std::size_t n = 0; n < nights.size(); ++n) add(collector, nights[n], n);
  std::vector<Series> all = std::move(collector).sorted();
  for (std::size_t n = 0; n < nights.size(); ++n) {
    const Machines machines = machines_in(nights[n]);
    for (Series& series : all)
      if (const auto found = machines.find({series.case_name, series.method}); found != machines.end())
        series.points[n].machine = found->second;
  }
  const auto starts_anew = places_changed(nights);
  for (Series& series : all) mark_steps(series, starts_anew);
  return all;
}

std::vector<const Series*> worth_drawing(const std::vector<Series>& all) {
  std::map<std::tuple<std::string, std::string, std::string, std::string>, const Series*> best;
  for (const Series& s : all) {
    if (s.kind == Kind::cost || !is_candidate(s)) continue;
    // The limits of all lattices and flows are drawn.
    const Series*& so_far = best[{s.case_name, s.method, s.quantity, s.kind == Kind::limit ? s.level : ""}];
    if (!so_far || is_more_telling(s, *so_far)) so_far = &s;
  }
  std::set<const Series*> chosen;
  for (const auto& [subject, series] : best) chosen.insert(series);
  const auto most_expensive = most_expensive_runs(all);
  for (const Series& s : all)
    if (const auto run = most_expensive.find({s.case_name, s.method});
        s.kind == Kind::cost && run != most_expensive.end() && run->second->level == s.level)
      chosen.insert(&s);
  return {chosen.begin(), chosen.end()};  // in the order of `all`
}

}  // namespace touchstone::reports

#include "vnv/judge/series.hpp"

#include "vnv/judge/distribution.hpp"
#include "vnv/record/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace touchstone::vnv {
namespace {

void require_rising(std::string_view who, double from, double to) {
  if (!(from < to))
    throw std::invalid_argument(fmt::format("{}: from {} to {}, expected increasing times", who, from, to));
}

/// Both times, and those of the series between them.
void add_times(std::vector<double>& times, const Series& series, double from, double to) {
  for (const double time : series.time)
    if (time > from && time < to) times.push_back(time);
}

std::vector<double> in_order(std::vector<double> times) {
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

/// Where a number that goes from `first` to `last` is not negative, in parts of the way; not at all if it is none.
struct Part {
  double begin = 0, end = 0;
};
Part not_negative(double first, double last) {
  if (first >= 0 && last >= 0) return {0, 1};
  if (first >= 0 && last < 0) return {0, first / (first - last)};
  if (first < 0 && last >= 0) return {first / (first - last), 1};
  return {};
}

}  // namespace

Series series_of(const DataTable& table, std::string_view time, std::string_view value) {
  const std::vector<double>&times = table.numbers(time), &values = table.numbers(value);
  std::vector<std::size_t> order(times.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return times[k]; });
  Series series;
  std::size_t alike = 0;
  for (const std::size_t k : order) {
    if (series.time.empty() || times[k] != series.time.back()) {
      series.time.push_back(times[k]);
      series.value.push_back(values[k]);
      alike = 1;
    } else {
      series.value.back() += (values[k] - series.value.back()) / static_cast<double>(++alike);
    }
  }
  return series;
}

Series shifted(Series series, double shift) {
  for (double& time : series.time) time += shift;
  return series;
}

Series scaled(Series series, double time, double offset, double value) {
  for (double& t : series.time) t /= time;
  for (double& v : series.value) v = (v - offset) / value;
  return series;
}

void require_series(std::string_view who, const Series& series) {
  if (series.time.size() != series.value.size() || series.time.size() < 2)
    throw std::invalid_argument(fmt::format("{}: {} times and {} values, expected two or more of each", who,
                                            series.time.size(), series.value.size()));
  for (std::size_t k = 1; k < series.time.size(); ++k)
    if (const double rise = series.time[k] - series.time[k - 1]; !(rise > 0 && std::isfinite(rise)))
      throw std::invalid_argument(fmt::format("{}: time {} after {}, expected strictly increasing finite times", who,
                                              series.time[k], series.time[k - 1]));
}

double value_at(const Series& series, double time) {
  if (series.time.empty() || !(time >= series.time.front() && time <= series.time.back())) return not_a_number;
  const auto above = std::ranges::upper_bound(series.time, time) - series.time.begin();
  const auto k = static_cast<std::size_t>(above);
  if (series.time[k - 1] == time) return series.value[k - 1];
  const double part = (time - series.time[k - 1]) / (series.time[k] - series.time[k - 1]);
  return series.value[k - 1] + part * (series.value[k] - series.value[k - 1]);
}

std::vector<double> differences(const Series& ours, const Series& measured, double from, double to) {
  std::vector<double> found;
  for (std::size_t k = 0; k < measured.time.size(); ++k)
    if (measured.time[k] >= from && measured.time[k] <= to)
      found.push_back(value_at(ours, measured.time[k]) - measured.value[k]);
  return found;
}

double root_mean_square(const std::vector<double>& differences) {
  double sum = 0;
  for (const double d : differences) sum += d * d;
  return std::sqrt(sum / static_cast<double>(differences.size()));
}

double time_integral(const Series& series, double from, double to) {
  require_series("integral", series);
  require_rising("integral", from, to);
  std::vector<double> times{from};
  add_times(times, series, from, to);
  times.push_back(to);
  double sum = 0;
  for (std::size_t k = 1; k < times.size(); ++k)
    sum += (times[k] - times[k - 1]) * (value_at(series, times[k - 1]) + value_at(series, times[k])) / 2;
  return sum;
}

double time_mean(const Series& series, double from, double to) { return time_integral(series, from, to) / (to - from); }

double fraction_inside(const Series& series, const Series& low, const Series& high, double from, double to) {
  require_rising("fraction inside", from, to);
  std::vector<double> times{from, to};
  for (const Series* one : {&series, &low, &high}) {
    require_series("fraction inside", *one);
    add_times(times, *one, from, to);
  }
  times = in_order(std::move(times));
  std::vector<double> above_low, below_high;
  for (const double time : times) {
    const double value = value_at(series, time);
    above_low.push_back(value - value_at(low, time));
    below_high.push_back(value_at(high, time) - value);
  }
  double inside = 0;
  for (std::size_t k = 1; k < times.size(); ++k) {
    const Part one = not_negative(above_low[k - 1], above_low[k]),
               other = not_negative(below_high[k - 1], below_high[k]);
    inside +=
        (times[k] - times[k - 1]) * std::max(0.0, std::min(one.end, other.end) - std::max(one.begin, other.begin));
  }
  return inside / (to - from);
}

Series quantile_of(const std::vector<Series>& members, const std::vector<double>& times, double fraction) {
  Series found{times, {}};
  for (const double time : times) {
    std::vector<double> values;
    for (const Series& member : members) values.push_back(value_at(member, time));
    const bool known = std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
    found.value.push_back(known ? quantile(std::move(values), fraction) : not_a_number);
  }
  return found;
}

}  // namespace touchstone::vnv

#pragma once
/// A number over time, linear between its samples: what was monitored, or measured by a sensor.

#include "vnv/files/tables.hpp"

#include <string_view>
#include <vector>

namespace touchstone::vnv {

struct Series {
  std::vector<double> time;   // s, or any one unit; rising
  std::vector<double> value;  // in any one unit, equally many
};

/// Two columns of a table, in the order of time; of rows of one time the mean, as read-outs have them.
Series series_of(const DataTable& table, std::string_view time, std::string_view value);

/// With its clock set later by `shift`.
Series shifted(Series series, double shift);

/// Times over `time`, values less `offset` over `value`.
Series scaled(Series series, double time, double offset, double value);

/// Throws std::invalid_argument with one line that begins with `who`, unless there are two samples or more, equally
/// many times and values, and finite rising times.
void require_series(std::string_view who, const Series& series);

/// The value at a time; not a number outside of the series.
double value_at(const Series& series, double time);

/// Ours less measured at the times of the measured one, from one time to another, both included.
std::vector<double> differences(const Series& ours, const Series& measured, double from, double to);
/// Not a number of none.
double root_mean_square(const std::vector<double>& differences);

/// The integral over time from one time to a later one, and the mean: exact for what is linear between the samples. Not
/// a number where the series does not reach, or holds what is no number there. Throw as `require_series`.
double time_integral(const Series& series, double from, double to);
double time_mean(const Series& series, double from, double to);

/// The fraction of the time from `from` to `to` in which a series lies within a band, its edges included; 0 to 1. What
/// a series does not reach, or is not a number, is outside. Throws as `require_series`, and for times that do not rise.
double fraction_inside(const Series& series, const Series& low, const Series& high, double from, double to);

/// A quantile of several series at each of these times, such as the median of an ensemble; not a number where one of
/// them is none or does not reach. Throws std::invalid_argument without any series, or for a fraction outside [0, 1].
Series quantile_of(const std::vector<Series>& members, const std::vector<double>& times, double fraction);

}  // namespace touchstone::vnv

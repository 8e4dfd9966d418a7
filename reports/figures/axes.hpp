#pragma once
/// Axes as gnuplot draws them: ranges, and ticks at decades or at 1, 2 and 5.

#include "vnv/record/record.hpp"

#include <string>
#include <utility>
#include <vector>

namespace touchstone::reports {

/// A value that the axis can show, in the unit of its label.
bool is_drawable(double value, const vnv::Axis& axis);

/// Smallest and largest drawable value, in the unit of the label; {1, 0} if there is none.
class AxisRange {
 public:
  explicit AxisRange(const vnv::Axis& axis) : axis_(axis) {}
  void add(const std::vector<double>& si_values);

  bool is_empty() const { return high_ < low_; }
  /// With the limits that the axis states, and never of zero width; limits from the data move outwards by a fraction of
  /// that width.
  std::pair<double, double> range(double air = 0) const;

 private:
  const vnv::Axis& axis_;
  double low_ = std::numeric_limits<double>::infinity(), high_ = -low_;
};

/// The distance of ticks, 1, 2 or 5 times a power of ten, that makes at most so many steps of a span.
double tick_step(double span, double at_most);

/// "set xrange [0:1]" for the axis "x".
std::string range_command(const char* name, double low, double high);

/// The commands for one axis, named "x" or "y".
std::string axis_commands(const char* name, const vnv::Axis& axis, const AxisRange& extent);

}  // namespace touchstone::reports

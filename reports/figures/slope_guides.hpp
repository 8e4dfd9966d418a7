#pragma once
/// Slopes 1 and 2 on logarithmic axes, drawn where nothing else is.

#include <string>
#include <utility>
#include <vector>

namespace touchstone::reports {

/// Points joined by a line, in the units of the axes.
using DrawnLine = std::vector<std::pair<double, double>>;

/// The commands of two short grey lines from one corner, and of their names. The ranges [lowest, highest] are those of
/// the axes; coordinates that no logarithmic axis shows are passed over.
std::string slope_guides(std::pair<double, double> x, std::pair<double, double> y, const std::vector<DrawnLine>& lines);

}  // namespace touchstone::reports

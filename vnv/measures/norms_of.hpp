#pragma once
#include "vnv/case.hpp"
#include "vnv/measures/profile.hpp"

#include <functional>
#include <string>

namespace touchstone::vnv {

/// The truth across a channel: value at y [m] and time [s].
using Truth = std::function<double(double y, double t)>;

/// L2 (34) and Linf (35) of a measured profile against the truth, in per cent, at every time of a run. `what` names
/// field and measure: "v_x, row means" gives "L2 v_x, row means [%]". The measure may depend on the level.
Measurement norms_of(std::string what, std::function<Measure(const Level&)> measure, Truth truth);

}  // namespace touchstone::vnv

#pragma once
#include "vnv/measures/norms_of.hpp"
#include "vnv/record/record.hpp"

#include <functional>
#include <string>
#include <vector>

namespace touchstone::vnv {

/// Adds a profile to a curve, of points less than a 2000th of the height and of the largest value apart but the first:
/// in a flow along a channel all particles of a row are one point.
void add_points(Curve& curve, const Profile& profile, double height);

/// A measured profile at each time of the levels named, as points over the exact lines.
Plot profiles(Figure frame, std::function<Measure(const Level&)> measure, Truth truth, double height,
              std::vector<std::string> levels);

}  // namespace touchstone::vnv

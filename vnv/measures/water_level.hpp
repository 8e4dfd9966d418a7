#pragma once
/// How high water stands above a floor at y = 0, as a gauge sees it. A gauge of an experiment sees one of these, and
/// which is seldom said; where water is in one piece they agree.

#include "vnv/measures/wet_extents.hpp"
#include "vnv/record/quantity.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace touchstone::vnv {

struct WaterLevel {
  double lowest = not_a_number;  // m  top of the lowest water, up to its first gap; 0 where it does not reach the floor
  double highest = not_a_number;  // m  top of the highest, spray too
  double volume = not_a_number;   // m  volume over width: the level if all of it stood on the floor
};

/// Of the water within `half_width` [m] of a gauge at x [m], which should be half a spacing at least. A gap is wider
/// than `gap` spacings [m]; what is narrower is between particles, as below the lowest of them. All are 0 where it is
/// dry, and not a number for samples without particles, or with a place or volume that is no finite number. Throws
/// std::invalid_argument for a half width or spacing that is not positive.
inline WaterLevel water_level(const Samples& samples, double x, double half_width, double spacing, double gap = 2) {
  if (!(half_width > 0 && spacing > 0))
    throw std::invalid_argument(
        fmt::format("water level: half width {} m, spacing {} m, expected positive lengths", half_width, spacing));
  if (!fronts::known(samples)) return {};
  const Range strip{x - half_width, x + half_width};
  const std::vector<Range> wet = wet_extents(samples, strip, gap * spacing);
  if (wet.empty()) return {0, 0, 0};
  double volume = 0;
  each_inside(samples, strip, [&](Eigen::Index, const Range& across, const Range& upright) {
    volume += across.length() * upright.length();
  });
  return {wet.front().low > gap * spacing ? 0 : wet.front().high, wet.back().high, volume / strip.length()};
}

}  // namespace touchstone::vnv

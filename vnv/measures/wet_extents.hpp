#pragma once
/// Where an upright strip is wet. A particle of volume V is an upright square of side sqrt(V), as for `half_full_slab`.

#include "vnv/measures/front.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace touchstone::vnv {

/// From `low` to `high` along x or y.
struct Extent {
  double low, high;  // m

  double length() const { return std::max(0.0, high - low); }
};

inline Extent common(const Extent& a, const Extent& b) { return {std::max(a.low, b.low), std::min(a.high, b.high)}; }

/// Calls visit(p, along x, along y) with the part of each particle's square that lies in a strip along x and is more
/// than a rounding error wide. There are particles, of finite places and volumes.
template <class Visit>
void each_inside(const Samples& samples, const Extent& strip, const Visit& visit) {
  const double largest_side = std::sqrt(samples.mass.maxCoeff() / samples.density.minCoeff());
  const Extent near{strip.low - largest_side, strip.high + largest_side};
  for (Eigen::Index p = 0; p < samples.size(); ++p) {
    const double x = samples.x(0, p), y = samples.x(1, p);
    if (x < near.low || x > near.high) continue;
    const double half = std::sqrt(samples.mass(p) / samples.density(p)) / 2;
    const Extent across = common({x - half, x + half}, strip);
    if (across.length() > 1e-9 * half) visit(p, across, Extent{y - half, y + half});
  }
}

/// The heights [m] at which there is water in a strip along x, from below; gaps of up to `bridged` [m] are water too.
inline std::vector<Extent> wet_extents(const Samples& samples, const Extent& strip, double bridged) {
  std::vector<Extent> all, wet;
  each_inside(samples, strip, [&](Eigen::Index, const Extent&, const Extent& upright) { all.push_back(upright); });
  std::ranges::sort(all, {}, &Extent::low);
  for (const Extent& one : all)
    if (wet.empty() || one.low > wet.back().high + bridged)
      wet.push_back(one);
    else
      wet.back().high = std::max(wet.back().high, one.high);
  return wet;
}

}  // namespace touchstone::vnv

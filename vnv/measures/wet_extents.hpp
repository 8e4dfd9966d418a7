#pragma once
/// Where an upright strip is wet. A particle of volume V is an upright square of side sqrt(V), as for `half_full_slab`.

#include "solvers/walls/wall.hpp"
#include "vnv/measures/front.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace touchstone::vnv {

inline Range common(const Range& a, const Range& b) { return {std::max(a.low, b.low), std::min(a.high, b.high)}; }

/// Calls visit(p, along x, along y) with the part of each particle's square that lies in a strip along x and is more
/// than a rounding error wide. There are particles, of finite places and volumes.
template <class Visit>
void each_inside(const Samples& samples, const Range& strip, const Visit& visit) {
  const double largest_side = std::sqrt(samples.mass.maxCoeff() / samples.density.minCoeff());
  const Range near{strip.low - largest_side, strip.high + largest_side};
  for (Eigen::Index p = 0; p < samples.size(); ++p) {
    const double x = samples.x(0, p), y = samples.x(1, p);
    if (x < near.low || x > near.high) continue;
    const double half = std::sqrt(samples.mass(p) / samples.density(p)) / 2;
    const Range across = common({x - half, x + half}, strip);
    if (across.length() > 1e-9 * half) visit(p, across, Range{y - half, y + half});
  }
}

/// The heights [m] at which there is water in a strip along x, from below; gaps of up to `bridged` [m] are water too.
inline std::vector<Range> wet_extents(const Samples& samples, const Range& strip, double bridged) {
  std::vector<Range> all, wet;
  each_inside(samples, strip, [&](Eigen::Index, const Range&, const Range& upright) { all.push_back(upright); });
  std::ranges::sort(all, {}, &Range::low);
  for (const Range& one : all)
    if (wet.empty() || one.low > wet.back().high + bridged)
      wet.push_back(one);
    else
      wet.back().high = std::max(wet.back().high, one.high);
  return wet;
}

}  // namespace touchstone::vnv

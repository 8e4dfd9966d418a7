#pragma once
/// Where the front of a dam break is that runs along a floor in +x. The answer depends on the operator, so there are
/// three: log all, judge `half_full_slab`. Each gives x [m]; without a front, or with a place or volume that is not a
/// finite number, it gives not a number.

#include "solvers/samples.hpp"
#include "vnv/record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace touchstone::vnv {

namespace fronts {

/// The volume in a slab that is moved backwards grows at another rate from where its rear comes to `rear`.
struct Change {
  double rear;  // m
  double rate;  // m  more volume [m²] per length [m]
};

/// All changes, farthest first, for slabs one cell long below `top` and particles that are squares.
inline std::vector<Change> changes(const Samples& samples, double cell, double top) {
  const Scalars sides = samples.volumes().sqrt();
  std::vector<Change> all;
  for (Eigen::Index p = 0; p < samples.size(); ++p) {
    const double side = sides(p), nose = samples.x(0, p) + side / 2, tail = nose - side;
    const double height = std::clamp(top - (samples.x(1, p) - side / 2), 0.0, side);
    if (height > 0)
      all.insert(all.end(), {{nose, height}, {tail, -height}, {nose - cell, -height}, {tail - cell, height}});
  }
  std::ranges::sort(all, std::ranges::greater{}, &Change::rear);
  return all;
}

/// False where a place or a volume is not a number, or a volume not positive.
inline bool known(const Samples& samples) {
  return samples.size() > 0 && samples.x.allFinite() && samples.volumes().allFinite() && (samples.volumes() > 0).all();
}

}  // namespace fronts

/// The particle that is farthest along x: one drop of spray moves it.
inline double farthest_particle(const Samples& samples) {
  return fronts::known(samples) ? samples.x.row(0).maxCoeff() : not_a_number;
}

/// The rearmost particle for which it and those behind it hold at least `share` of the volume.
/// Throws std::invalid_argument unless 0 < share <= 1.
inline double percentile_front(const Samples& samples, double share = 0.995) {
  if (!(share > 0 && share <= 1))
    throw std::invalid_argument(fmt::format("percentile_front: share = {}, wanted above 0 and at most 1", share));
  if (!fronts::known(samples)) return not_a_number;
  const Scalars volumes = samples.volumes();
  std::vector<Eigen::Index> order(static_cast<std::size_t>(samples.size()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::ranges::stable_sort(order, {}, [&](Eigen::Index p) { return samples.x(0, p); });
  const double wanted = share * volumes.sum();
  double behind = 0;
  for (const auto p : order)
    if ((behind += volumes(p)) >= wanted) return samples.x(0, p);
  return samples.x(0, order.back());  // the two sums differ by rounding
}

/// The middle of the farthest slab that is half full: one cell long, one cell high, standing on the floor, anywhere
/// along x, and full when the fluid in it has the volume cell².
///
/// A particle of volume V is an upright square of side sqrt(V), of which the part below the top of the slab counts, so
/// the slab that is exactly half full is found by moving one backwards from the farthest fluid. An upright face at
/// least a cell high is found where it stands, whatever the spacing. A sheet thinner than half a cell, or drops that
/// together fill no half slab, are no front; with one particle a cell, a lone particle on the floor is one.
/// `cell` and the height `floor` in m. Throws std::invalid_argument for a cell that is not positive.
inline double half_full_slab(const Samples& samples, double cell, double floor = 0) {
  if (!(cell > 0))
    throw std::invalid_argument(fmt::format("half_full_slab: cell = {} m, wanted a positive length", cell));
  if (!fronts::known(samples)) return not_a_number;
  const double half = cell * cell / 2;
  double volume = 0, rate = 0, rear = 0;  // while the slab is ahead of all fluid, its rear may be anywhere
  for (const auto& change : fronts::changes(samples, cell, floor + cell)) {
    const double more = rate * (rear - change.rear);
    if (volume + more >= half) return rear - (half - volume) / rate + cell / 2;
    volume += more;
    rear = change.rear;
    rate += change.rate;
  }
  return not_a_number;
}

}  // namespace touchstone::vnv

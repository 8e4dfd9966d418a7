#pragma once
/// Where the front of a dam break is that runs along a floor in +x, and how high water stands. The answer depends on
/// the operator, so there are four: log all, judge `half_full_slab`. Each gives x [m]; without a front, or with a place
/// or volume that is not a finite number, it gives not a number.

#include "solvers/samples.hpp"
#include "vnv/record/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <queue>
#include <stdexcept>
#include <utility>
#include <vector>

namespace touchstone::vnv {

namespace fronts {

/// The volume in a slab that is moved backwards grows at another rate from where its rear comes to `rear`.
struct Change {
  double rear;  // m
  double rate;  // m  more volume [m²] per length [m]

  bool operator<(const Change& other) const { return rear < other.rear; }
};

/// All changes, for slabs one cell long and high, and particles that are squares, as a heap: the farthest first.
inline std::priority_queue<Change> changes(const Samples& samples, double cell) {
  std::vector<Change> all;
  const double largest_side = std::sqrt(samples.mass.maxCoeff() / samples.density.minCoeff());
  for (Eigen::Index p = 0; p < samples.size(); ++p) {
    if (!(samples.x(1, p) < cell + largest_side / 2)) continue;
    const double side = std::sqrt(samples.mass(p) / samples.density(p)), height = cell - (samples.x(1, p) - side / 2);
    if (!(height > 0)) continue;
    const double nose = samples.x(0, p) + side / 2, tail = nose - side, inside = std::min(height, side);
    all.insert(all.end(), {{nose, inside}, {tail, -inside}, {nose - cell, -inside}, {tail - cell, inside}});
  }
  return std::priority_queue<Change>({}, std::move(all));
}

/// False where a place or a volume is not a number, or a volume not positive.
inline bool known(const Samples& samples) {
  if (samples.size() == 0) return false;
  const double nothing = (0 * samples.x.array()).sum() + (0 * samples.mass).sum() + (0 * samples.density).sum();
  return nothing == 0 && samples.mass.minCoeff() > 0 && samples.density.minCoeff() > 0;
}

}  // namespace fronts

/// The particle that is farthest along x: one drop of spray moves it.
inline double farthest_particle(const Samples& samples) {
  return fronts::known(samples) ? samples.x.row(0).maxCoeff() : not_a_number;
}

/// The rearmost particle for which it and those behind it hold at least 99.5 % of the volume.
inline double percentile_front(const Samples& samples) {
  constexpr double fraction = 0.995;
  if (!fronts::known(samples)) return not_a_number;
  const Scalars x = samples.x.row(0), volumes = samples.volumes();
  const double expected = (1 - 1e-12) * fraction * volumes.sum();  // less what the rounding of sums may do

  // Only in the slice where that fraction is reached do the particles have to be put in order.
  constexpr int slices = 256;
  const double rear = x.minCoeff(), per_length = (slices - 1) / std::max(x.maxCoeff() - rear, 1e-300);
  const auto slice = [&](Eigen::Index p) { return std::min(static_cast<int>((x(p) - rear) * per_length), slices - 1); };
  std::array<double, slices> volume_in{};
  for (Eigen::Index p = 0; p < x.size(); ++p) volume_in[slice(p)] += volumes(p);
  int here = 0;
  double behind = 0;
  while (here < slices - 1 && behind + volume_in[here] < expected) behind += volume_in[here++];
  std::vector<std::pair<double, double>> in_order;
  for (Eigen::Index p = 0; p < x.size(); ++p)
    if (slice(p) == here) in_order.emplace_back(x(p), volumes(p));
  std::ranges::sort(in_order);
  for (const auto& [place, volume] : in_order)
    if ((behind += volume) >= expected) return place;
  return x.maxCoeff();  // the sums differ by rounding
}

/// The farthest particle of the body of most particles: those closer than `reach` [m] to one of a body belong to it.
inline double farthest_of_body(const Samples& samples, double reach) {
  if (!fronts::known(samples)) return not_a_number;
  std::multimap<std::array<long, 2>, Eigen::Index> left;  // by squares of that side
  const auto square_of = [&](Eigen::Index p, long columns, long rows) -> std::array<long, 2> {
    return {std::lround(std::floor(samples.x(0, p) / reach)) + columns,
            std::lround(std::floor(samples.x(1, p) / reach)) + rows};
  };
  for (Eigen::Index p = 0; p < samples.size(); ++p) left.emplace(square_of(p, 0, 0), p);
  std::vector<Eigen::Index> largest;
  while (left.size() > largest.size()) {
    std::vector<Eigen::Index> body{left.extract(left.begin()).mapped()};
    for (std::size_t k = 0; k < body.size(); ++k)
      for (const long columns : {-1, 0, 1})
        for (const long rows : {-1, 0, 1}) {
          const Eigen::Index p = body[k];
          auto [near, end] = left.equal_range(square_of(p, columns, rows));
          while (near != end)
            if ((samples.x.col(near->second) - samples.x.col(p)).norm() < reach)
              body.push_back(near->second), near = left.erase(near);
            else
              ++near;
        }
    if (body.size() > largest.size()) largest = std::move(body);
  }
  return samples.x(0, largest).maxCoeff();
}

/// The mean height [m] of the water that stands over a part of the floor.
inline double level_between(const Samples& samples, double low, double high) {
  const Scalars x = samples.x.row(0).transpose();
  return (x >= low && x < high).select(samples.volumes(), 0).sum() / (high - low);
}

/// The middle of the farthest slab that is half full: one cell [m] long, one cell high, standing on the floor, anywhere
/// along x, and full when the fluid in it has the volume cell².
///
/// A particle of volume V is an upright square of side sqrt(V), of which the part below the top of the slab counts, so
/// the slab that is exactly half full is found by moving one backwards from the farthest fluid. An upright face at
/// least a cell high is found where it stands, whatever the spacing. A sheet thinner than half a cell, or drops that
/// together fill no half slab, are no front; with one particle a cell, a lone particle on the floor is one.
/// Throws std::invalid_argument for a cell that is not positive.
inline double half_full_slab(const Samples& samples, double cell) {
  if (!(cell > 0))
    throw std::invalid_argument(fmt::format("half_full_slab: cell = {} m, expected a positive length", cell));
  if (!fronts::known(samples)) return not_a_number;
  const double half = cell * cell / 2;
  double volume = 0, rate = 0, rear = 0;  // while the slab is ahead of all fluid, its rear may be anywhere
  for (auto changes = fronts::changes(samples, cell); !changes.empty(); changes.pop()) {
    const fronts::Change change = changes.top();
    const double more = rate * (rear - change.rear);
    if (volume + more >= half) return rear - (half - volume) / rate + cell / 2;
    volume += more;
    rear = change.rear;
    rate += change.rate;
  }
  return not_a_number;
}

}  // namespace touchstone::vnv

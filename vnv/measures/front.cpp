#include "vnv/measures/front.hpp"

#include "vnv/record/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <map>
#include <queue>
#include <stdexcept>
#include <utility>
#include <vector>

namespace touchstone::vnv {
namespace {

/// The volume in a slab that is moved backwards grows at another rate from where its rear comes to `rear`.
struct Change {
  double rear;  // m
  double rate;  // m  more volume [m²] per length [m]

  bool operator<(const Change& other) const { return rear < other.rear; }
};

/// All changes, for slabs one cell long and high, and particles that are squares, as a heap: the farthest first.
std::priority_queue<Change> changes_in(const Samples& samples, double cell) {
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

}  // namespace

bool fronts::known(const Samples& samples) {
  if (samples.size() == 0) return false;
  const double nothing = (0 * samples.x.array()).sum() + (0 * samples.mass).sum() + (0 * samples.density).sum();
  return nothing == 0 && samples.mass.minCoeff() > 0 && samples.density.minCoeff() > 0;
}

double farthest_particle(const Samples& samples) {
  return fronts::known(samples) ? samples.x.row(0).maxCoeff() : not_a_number;
}

double percentile_front(const Samples& samples) {
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
  struct PlacedVolume {
    double x, volume;
    auto operator<=>(const PlacedVolume&) const = default;
  };
  std::vector<PlacedVolume> in_order;
  for (Eigen::Index p = 0; p < x.size(); ++p)
    if (slice(p) == here) in_order.push_back({x(p), volumes(p)});
  std::ranges::sort(in_order);
  for (const auto& [place, volume] : in_order)
    if ((behind += volume) >= expected) return place;
  return x.maxCoeff();  // the sums differ by rounding
}

double farthest_of_body(const Samples& samples, double reach) {
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

double volume_behind(const Samples& samples, double x) {
  const Scalars volumes = samples.volumes(), sides = volumes.sqrt();
  const Scalars behind = (x - samples.x.row(0).transpose().array() + sides / 2).max(0).min(sides);
  return (sides * behind).sum();
}

double half_full_slab(const Samples& samples, double cell) {
  if (!(cell > 0))
    throw std::invalid_argument(fmt::format("half_full_slab: cell = {} m, expected a positive length", cell));
  if (!fronts::known(samples)) return not_a_number;
  const double half = cell * cell / 2;
  double volume = 0, rate = 0, rear = 0;  // while the slab is ahead of all fluid, its rear may be anywhere
  for (auto changes = changes_in(samples, cell); !changes.empty(); changes.pop()) {
    const Change change = changes.top();
    const double more = rate * (rear - change.rear);
    if (volume + more >= half) return rear - (half - volume) / rate + cell / 2;
    volume += more;
    rear = change.rear;
    rate += change.rate;
  }
  return not_a_number;
}

}  // namespace touchstone::vnv

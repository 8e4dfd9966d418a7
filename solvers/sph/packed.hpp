#pragma once
/// What a sum over pairs reads of a particle, side by side in memory, in the precision of the sums.

#include "solvers/sph/pair_lanes.hpp"

#include <Eigen/Core>

namespace touchstone::sph {

/// Where a particle stands.
template <class Number>
struct PackedPlace {
  Number x = 0, y = 0;  // m

  void stand_at(double at_x, double at_y) {
    x = at_x;
    y = at_y;
  }
};

/// Single precision keeps its digits for the distance between neighbours: what rounding takes off a place is kept
/// beside it.
template <>
struct PackedPlace<float> {
  float x = 0, y = 0;            // m
  float rest_x = 0, rest_y = 0;  // m

  void stand_at(double at_x, double at_y) {
    x = static_cast<float>(at_x);
    y = static_cast<float>(at_y);
    rest_x = static_cast<float>(at_x - double{x});
    rest_y = static_cast<float>(at_y - double{y});
  }
};

/// Fields stand in twos that are loaded together: what the printed terms need of a state in one, what those of pressure
/// differences need in another. Sixteen bytes are loaded at once, two doubles or four floats. What a pair would divide
/// by is divided by here, once per particle. No field is ever undefined: lanes without a neighbour read the particle
/// that is nowhere, and no weight of 0 removes what is not a number.
template <class Number_>
struct alignas(16) Packed : PackedPlace<Number_> {
  using Number = Number_;
  Number vx = 0, vy = 0;              // m/s
  Number rho = 0, p_over_rho2 = 0;    // kg/m³; Pa m⁶/kg²  p / rho²
  Number specific_volume = 0, p = 0;  // m³/kg  1 / rho; Pa

  void set_state(double density, double pressure) {
    const double per = 1 / density;
    rho = static_cast<Number>(density);
    p = static_cast<Number>(pressure);
    specific_volume = static_cast<Number>(per);
    p_over_rho2 = static_cast<Number>(pressure * per * per);
  }
  void move(double at_vx, double at_vy) {
    vx = static_cast<Number>(at_vx);
    vy = static_cast<Number>(at_vy);
  }
};

/// One particle per lane.
template <class Packed, int width = lanes_of<typename Packed::Number>>
struct ParticleLanes {
  using Real = LanesOf<typename Packed::Number, width>;
  const Packed* all;
  const int* which;

  /// A field and the one beside it.
  template <class Owner>
  std::array<Real, 2> two(typename Packed::Number Owner::*first) const {
    if constexpr (std::is_same_v<typename Packed::Number, double>) {
      return gather_two<width>([&](int lane) { return &(all[which[lane]].*first); });
    } else {  // the four floats that hold both; whose other half is asked for too, the compiler loads once
      const auto start = reinterpret_cast<const char*>(&(all->*first)) - reinterpret_cast<const char*>(all);
      const auto four = gather_four<width>(
          [&](int lane) { return reinterpret_cast<const char*>(all + which[lane]) + start / 16 * 16; });
      return start % 16 == 0 ? std::array{four[0], four[1]} : std::array{four[2], four[3]};
    }
  }
};

/// The same for a single particle, for plain loops.
template <class Packed>
struct One {
  using Real = typename Packed::Number;
  const Packed* all;
  Eigen::Index which;

  template <class Owner>
  std::array<Real, 2> two(Real Owner::*first) const {
    const Real* both = &(all[which].*first);
    return {both[0], both[1]};
  }
};

/// r_i - r_j [m].
template <class I, class J>
auto apart(const I& i, const J& j) {
  using Packed = std::remove_cvref_t<decltype(*j.all)>;
  auto r = i.two(&Packed::x);
  const auto from = j.two(&Packed::x);
  r[0] -= from[0];
  r[1] -= from[1];
  if constexpr (std::is_same_v<typename Packed::Number, float>) {
    const auto rest = i.two(&Packed::rest_x), less = j.two(&Packed::rest_x);
    r[0] += rest[0] - less[0];
    r[1] += rest[1] - less[1];
  }
  return r;
}

/// |r_i - r_j| [m].
template <class I, class J>
auto distance(const I& i, const J& j) {
  const auto r = apart(i, j);
  using Real = typename J::Real;
  return square_root(Real(r[0] * r[0] + r[1] * r[1]));
}

}  // namespace touchstone::sph

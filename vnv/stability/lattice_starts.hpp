#pragma once
/// How fluid on a lattice may start: with noise, with a shear wave.

#include "vnv/stability/resting_lattice.hpp"

#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>

namespace touchstone::vnv {

/// The same number between -1 and 1 for the same three integers, on any machine (the finaliser of MurmurHash3).
inline double noise(std::uint64_t column, std::uint64_t row, std::uint64_t what) {
  std::uint64_t h = (column * 0x9e3779b97f4a7c15u) ^ (row * 0xc2b2ae3d27d4eb4fu) ^ (what * 0x165667b19e3779f9u);
  h = (h ^ (h >> 33)) * 0xff51afd7ed558ccdu;
  h = (h ^ (h >> 33)) * 0xc4ceb9fe1a85ec53u;
  h ^= h >> 33;
  return static_cast<double>(h >> 11) * 0x1p-52 - 1;
}

/// Velocities that are noise, of so many speeds of sound, beside those of a flow [m/s], if there is one: uniform around
/// each particle, so without slopes of its own.
inline Start noisy(const RestingLattice& lattice, double amplitude, std::function<Vec2(const Vec2&)> flow = {}) {
  Start start;
  start.velocity = [=, shift = lattice.shift](const Vec2& x) -> Vec2 {
    const Vec2 place = x / RestingLattice::spacing - shift;
    const auto column = static_cast<std::uint64_t>(std::floor(place.x()) + 1),
               row = static_cast<std::uint64_t>(std::floor(place.y()) + 1);
    const Vec2 stir = amplitude * RestingLattice::sound_speed * Vec2(noise(column, row, 0), noise(column, row, 1));
    return flow ? Vec2(stir + flow(x)) : stir;
  };
  return start;
}

/// A wave along y, one over the side [m] of a lattice.
inline double wave_at(double y, double side) { return std::sin(2 * std::numbers::pi * y / side); }

/// The amplitude [m/s] of that wave in the particles' velocities along x.
inline double amplitude_of_wave(const Samples& s, double side) {
  const Scalars wave = (2 * std::numbers::pi / side * s.x.row(1).transpose().array()).sin();
  return (s.v.row(0).transpose().array() * wave).sum() / wave.square().sum();
}

/// The rate [1/s] at which viscosity takes the wave away.
inline double decay_of_wave(double kinematic_viscosity, double side) {
  return kinematic_viscosity * std::pow(2 * std::numbers::pi / side, 2);
}

}  // namespace touchstone::vnv

#pragma once
#include "vnv/stability/resting_lattice.hpp"

#include <cmath>
#include <cstdint>

namespace touchstone::vnv {

/// The same number between -1 and 1 for the same three integers, on any machine (the finaliser of MurmurHash3).
inline double noise(std::uint64_t column, std::uint64_t row, std::uint64_t what) {
  std::uint64_t h = (column * 0x9e3779b97f4a7c15u) ^ (row * 0xc2b2ae3d27d4eb4fu) ^ (what * 0x165667b19e3779f9u);
  h = (h ^ (h >> 33)) * 0xff51afd7ed558ccdu;
  h = (h ^ (h >> 33)) * 0xc4ceb9fe1a85ec53u;
  h ^= h >> 33;
  return static_cast<double>(h >> 11) * 0x1p-52 - 1;
}

/// Velocities that are noise, of so many speeds of sound: uniform around each particle, so without slopes of its own.
inline Start noisy(const RestingLattice& lattice, double amplitude) {
  Start start;
  start.velocity = [=, shift = lattice.shift](const Vec2& x) -> Vec2 {
    const Vec2 place = x / RestingLattice::spacing - shift;
    const auto column = static_cast<std::uint64_t>(std::floor(place.x()) + 1),
               row = static_cast<std::uint64_t>(std::floor(place.y()) + 1);
    return amplitude * RestingLattice::sound_speed * Vec2(noise(column, row, 0), noise(column, row, 1));
  };
  return start;
}

}  // namespace touchstone::vnv

#pragma once
/// Where particles start: all off their places by chance, or those of drops alone.

#include "solvers/fields.hpp"

#include <algorithm>
#include <functional>
#include <random>
#include <vector>

namespace touchstone::vnv {

/// The same lattice every time, each of its places moved along both axes by less than `by` [m]; another one for another
/// seed.
inline Vectors disturbed(const Vectors& lattice, double by, unsigned seed = 20) {
  std::mt19937_64 random(seed);  // std::uniform_real_distribution differs between standard libraries
  Vectors places = lattice;
  for (double& x : places.reshaped()) x += by * (2 * (static_cast<double>(random() >> 11) * 0x1p-53) - 1);
  return places;
}

/// How far off its place a particle starts in a chaotic flow, along each axis, of the spacing.
inline constexpr double jitter = 0.01;

/// The scene with particles so far [m] off their places, the same for the same start.
template <class AnyScene>
AnyScene from_start(unsigned start, double by, AnyScene scene) {
  scene.start.places = [=](const Vectors& lattice) { return disturbed(lattice, by, start); };
  return scene;
}

/// The places within a radius [m] of any of the centres [m].
inline std::function<Vectors(const Vectors&)> within(double radius, const std::vector<Vec2>& centres) {
  return [=](const Vectors& lattice) -> Vectors {
    std::vector<Eigen::Index> inside;
    for (Eigen::Index p = 0; p < lattice.cols(); ++p)
      if (std::ranges::any_of(centres, [&](const Vec2& at) { return (lattice.col(p) - at).norm() < radius; }))
        inside.push_back(p);
    return lattice(Eigen::all, inside);
  };
}

}  // namespace touchstone::vnv

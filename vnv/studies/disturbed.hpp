#pragma once
#include "solvers/fields.hpp"

#include <random>

namespace touchstone::vnv {

/// The same lattice every time, each of its places moved along both axes by less than `by` [m]; another one for another
/// seed.
inline Vectors disturbed(const Vectors& lattice, double by, unsigned seed = 20) {
  std::mt19937_64 random(seed);  // std::uniform_real_distribution differs between standard libraries
  Vectors places = lattice;
  for (double& x : places.reshaped()) x += by * (2 * (static_cast<double>(random() >> 11) * 0x1p-53) - 1);
  return places;
}

}  // namespace touchstone::vnv

#pragma once
/// Eight numbers side by side, for the loops over pairs: the vector details of this solver, all of them.
/// Kernels and terms are templates over `Real`; they are written for one pair (`Real` = double) and run for eight.

#include <cmath>
#include <cstddef>
#include <cstring>

namespace touchstone::sph {

/// Particles that are summed for side by side, one per lane of a vector instruction.
inline constexpr int lanes = 8;

/// Arithmetic and comparison are lane by lane (a vector extension of GCC and Clang, for any processor).
using Lanes = double __attribute__((vector_size(lanes * sizeof(double))));

inline Lanes load(const double* from) {
  Lanes to;
  std::memcpy(&to, from, sizeof to);
  return to;
}

inline Lanes gather(const double* field, const int* which) {
  return Lanes{field[which[0]], field[which[1]], field[which[2]], field[which[3]],
               field[which[4]], field[which[5]], field[which[6]], field[which[7]]};
}

inline Lanes square_root(const Lanes& a) {
  Lanes root;
  for (int lane = 0; lane < lanes; ++lane) root[lane] = std::sqrt(a[lane]);
  return root;
}
inline double square_root(double a) { return std::sqrt(a); }

/// The number where it is positive, else zero.
template <class Real>
constexpr Real positive_part(const Real& a) {
  return a > 0 ? a : Real{};
}

}  // namespace touchstone::sph

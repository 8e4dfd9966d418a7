#pragma once
#include "solvers/indices.hpp"

#include <array>
#include <cstddef>

namespace touchstone {

/// Polynomials of second degree that fit several fields around a place best, by least squares that weigh each
/// neighbour. `Real` is a number, or several of them side by side. Places are relative to the one in the middle, in a
/// length of the caller's choice, which should be about that of the neighbourhood.
template <class Real, std::size_t fields>
struct QuadraticFit {
  static constexpr std::size_t moments = 15, monomials = 6, count = moments + fields * monomials;
  /// Sums over the neighbours of weight times x^a y^b, up to the fourth degree, then for each field of weight times
  /// value times 1, x, y, x², xy, y².
  using Sums = std::array<Real, count>;
  /// The factors of 1, x, y, x², xy, y².
  using Polynomial = std::array<Real, monomials>;

  /// What one neighbour adds to the sums.
  static Sums terms(const Real& weight, const Real& x, const Real& y, const std::array<Real, fields>& values) {
    const Real wx = weight * x, wy = weight * y, wxx = wx * x, wxy = wx * y, wyy = wy * y;
    const Real wxxx = wxx * x, wxxy = wxx * y, wxyy = wyy * x, wyyy = wyy * y;
    Sums all{weight, wx, wy, wxx, wxy, wyy, wxxx, wxxy, wxyy, wyyy, wxxx * x, wxxx * y, wxxy * y, wyyy * x, wyyy * y};
    for (std::size_t f = 0; f < fields; ++f)
      for (std::size_t k = 0; k < monomials; ++k) all[place_of(f) + k] = all[k] * values[f];
    return all;
  }

  /// The best polynomials. Not numbers, or not meaningful, where the neighbours do not tell six factors apart.
  static std::array<Polynomial, fields> of(const Sums& sums) { return solve<0>(sums); }

  /// The best polynomials that vanish in the middle, which are told apart by five neighbours. Their first factor is
  /// what the fit leaves, the weighted mean of the values less those of the polynomial.
  static std::array<Polynomial, fields> through_zero(const Sums& sums) {
    std::array<Polynomial, fields> found = solve<1>(sums);
    const Real per_weight = 1 / sums[0];
    for (std::size_t f = 0; f < fields; ++f) {
      Real rest = sums[place_of(f)];
      for (std::size_t k = 1; k < monomials; ++k) rest -= found[f][k] * sums[k];
      found[f][0] = rest * per_weight;
    }
    return found;
  }

 private:
  static constexpr std::size_t place_of(std::size_t field) { return moments + field * monomials; }
  /// Where x^a y^b stands among the moments.
  static constexpr std::size_t moment(std::size_t i, std::size_t j) {
    constexpr std::array<std::size_t, monomials> a{0, 1, 0, 2, 1, 0}, b{0, 0, 1, 0, 1, 2};
    const std::size_t degree = a[i] + a[j] + b[i] + b[j];
    return degree * (degree + 1) / 2 + b[i] + b[j];
  }

  /// By Cholesky's factors without roots, for the monomials from `first` on.
  template <int first>
  static std::array<Polynomial, fields> solve(const Sums& sums) {
    constexpr int n = monomials - first;
    std::array<std::array<Real, n>, n> lower;  // below the diagonal; D above it, from the left times from above
    std::array<Real, n> per;
    for_indices<n>([&](auto j) {
      for_indices<n - j>([&](auto below) {
        constexpr int i = j + below;
        Real a = sums[moment(first + i, first + j)];
        for_indices<j>([&](auto k) { a -= lower[i][k] * lower[k][j]; });
        if constexpr (i == j) {
          per[j] = 1 / a;
        } else {
          lower[j][i] = a;
          lower[i][j] = a * per[j];
        }
      });
    });
    std::array<Polynomial, fields> found;  // factors before `first` are left to the caller
    for (std::size_t f = 0; f < fields; ++f) {
      std::array<Real, n> y;
      for_indices<n>([&](auto i) {
        y[i] = sums[place_of(f) + first + i];
        for_indices<i>([&](auto k) { y[i] -= lower[i][k] * y[k]; });
      });
      for_indices<n>([&](auto above) {
        constexpr int i = n - 1 - above;
        Real c = y[i] * per[i];
        for_indices<above>([&](auto k) { c -= lower[i + 1 + k][i] * found[f][first + i + 1 + k]; });
        found[f][first + i] = c;
      });
    }
    return found;
  }
};

}  // namespace touchstone

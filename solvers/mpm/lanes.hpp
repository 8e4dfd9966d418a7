#pragma once
/// Several particles in one register. Loop bodies are written once, for a `Real` that is `double` or `Lanes`.
/// The lanes are those of the processor compiled for, so sums are grouped alike in every run of one program.

#include "solvers/fields.hpp"

#include <type_traits>
#include <utility>

namespace touchstone::mpm {

#ifdef __AVX__
inline constexpr int lanes = 4;
#else
inline constexpr int lanes = 2;
#endif

using Lanes [[gnu::vector_size(lanes * sizeof(double))]] = double;
using LanesInMemory [[gnu::vector_size(lanes * sizeof(double)), gnu::aligned(alignof(double))]] = double;

template <class Real>
inline constexpr int width = 1;
template <>
inline constexpr int width<Lanes> = lanes;

/// The particles of a field from `slot` on.
template <class Real>
Real load(const Scalars& field, int slot) {
  const double* from = field.data() + slot;
  if constexpr (width<Real> == 1)
    return *from;
  else
    return *reinterpret_cast<const LanesInMemory*>(from);
}

template <class Real>
void store(const Real& value, Scalars& field, int slot) {
  double* to = field.data() + slot;
  if constexpr (width<Real> == 1)
    *to = value;
  else
    *reinterpret_cast<LanesInMemory*>(to) = value;
}

/// A vector of the plane in every lane.
struct LanePair {
  Lanes a, b;

  const Lanes& x() const { return a; }
  const Lanes& y() const { return b; }
  LanePair& operator+=(const LanePair& other) {
    a += other.a;
    b += other.b;
    return *this;
  }
};
inline LanePair operator*(const Lanes& scale, const LanePair& v) { return {scale * v.a, scale * v.b}; }
inline LanePair operator+(const LanePair& v, const LanePair& w) { return {v.a + w.a, v.b + w.b}; }

/// A vector of the plane: `Vec2` for one particle, `LanePair` for several.
template <class Real>
using Pair = std::conditional_t<width<Real> == 1, Vec2, LanePair>;

/// The same vector in every lane.
template <class Real>
Pair<Real> broadcast(const Vec2& v) {
  if constexpr (width<Real> == 1)
    return v;
  else
    return {Lanes{} + v.x(), Lanes{} + v.y()};
}

template <class Real>
Pair<Real> zero() {
  return broadcast<Real>(Vec2::Zero());
}

/// The sum over the lanes.
inline const Vec2& total(const Vec2& v) { return v; }
inline Vec2 total(const LanePair& v) {
#ifdef __AVX__
  const Lanes pairs = __builtin_shufflevector(v.a, v.b, 0, 4, 2, 6) + __builtin_shufflevector(v.a, v.b, 1, 5, 3, 7);
  const auto sums = __builtin_shufflevector(pairs, pairs, 0, 1) + __builtin_shufflevector(pairs, pairs, 2, 3);
#else
  const Lanes sums = __builtin_shufflevector(v.a, v.b, 0, 2) + __builtin_shufflevector(v.a, v.b, 1, 3);
#endif
  return {sums[0], sums[1]};
}

inline double total(double a) { return a; }
inline double total(const Lanes& a) { return total(LanePair{a, a}).x(); }

/// What a comparison of two `Real` yields, and-able with `&`.
template <class Real>
using Truth = decltype(std::declval<Real>() < std::declval<Real>());

/// Whether a number lies between two others, one of them included; false for what is not a number.
template <class Real>
Truth<Real> between(double low, const Real& number, double high) {
  return (number - low) * (high - number) >= 0;
}

inline bool all(bool truth) { return truth; }
inline bool all(const Truth<Lanes>& truth) {
  bool every = true;
  for (int lane = 0; lane < lanes; ++lane) every = every && truth[lane];
  return every;
}

}  // namespace touchstone::mpm

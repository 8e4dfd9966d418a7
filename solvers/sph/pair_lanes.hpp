#pragma once
/// Numbers side by side, for the loops over pairs: all their vector details.
/// Kernels and terms are templates over `Real`; they are written for one pair (`Real` = double) and run for as many as
/// a vector register of the processor holds.

#if defined(__AVX512F__)
#include <immintrin.h>
#endif

#include "solvers/indices.hpp"
#include "solvers/lanes.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace touchstone::sph {

// GCC vectorises a loop over lanes, and a selection, as wide as the processor prefers that it tunes for. Where it
// mistook one and preferred half of the register, both halves went through memory, and sums over pairs took 1.6 times
// as long. These fill the register, with the same bits.
namespace detail {

#if defined(__AVX512F__)
using Doubles = LanesOf<double>;
using Floats = LanesOf<float>;
inline Doubles root_of(const Doubles& a) { return _mm512_sqrt_pd(a); }
inline Floats root_of(const Floats& a) { return _mm512_sqrt_ps(a); }
inline Doubles greater_of(const Doubles& a, const Doubles& b) { return _mm512_max_pd(a, b); }
inline Floats greater_of(const Floats& a, const Floats& b) { return _mm512_max_ps(a, b); }
inline Doubles less_of(const Doubles& a, const Doubles& b) { return _mm512_min_pd(a, b); }
inline Floats less_of(const Floats& a, const Floats& b) { return _mm512_min_ps(a, b); }
#else
struct NoLanes {};
void root_of(NoLanes);
void greater_of(NoLanes, NoLanes);
void less_of(NoLanes, NoLanes);
#endif

}  // namespace detail

template <class Real>
Real square_root(const Real& a) {
  if constexpr (std::is_floating_point_v<Real>) {
    return std::sqrt(a);
  } else if constexpr (requires { detail::root_of(a); }) {
    return detail::root_of(a);
  } else {
    Real root;
    for (std::size_t lane = 0; lane < sizeof(Real) / sizeof(NumberIn<Real>); ++lane) root[lane] = std::sqrt(a[lane]);
    return root;
  }
}

/// f of doubles, at once where lanes hold doubles, else one by one.
template <class Real, class F>
Real each_lane(const Real& a, const F& f) {
  if constexpr (std::is_same_v<NumberIn<Real>, double>) {
    return f(a);
  } else {
    Real all;
    for (std::size_t lane = 0; lane < sizeof(Real) / sizeof(NumberIn<Real>); ++lane)
      all[lane] = static_cast<NumberIn<Real>>(f(static_cast<double>(a[lane])));
    return all;
  }
}

/// The number where it is positive, else zero.
template <class Real>
constexpr Real positive_part(const Real& a) {
  if constexpr (requires { detail::greater_of(a, Real{}); })
    return detail::greater_of(a, Real{});
  else
    return a > 0 ? a : Real{};
}
/// The number where it is negative, else zero.
template <class Real>
constexpr Real negative_part(const Real& a) {
  if constexpr (requires { detail::less_of(a, Real{}); })
    return detail::less_of(a, Real{});
  else
    return a < 0 ? a : Real{};
}

namespace detail {

/// The numbers that fill 16 bytes at each of several places, as many as make `width` numbers, one after the other.
template <class Real, int width, class At>
LanesOf<Real, width> loaded(const At& at) {
  constexpr int each = 16 / sizeof(Real);
  LanesOf<Real, width> all;
  if constexpr (width == each) {
    std::memcpy(&all, at(0), sizeof all);
#if defined(__AVX512DQ__)
  } else if constexpr (sizeof all == 64) {  // inserted: joined in registers they would crowd the one port that shuffles
    const auto part = [&](int k) { return _mm_loadu_pd(reinterpret_cast<const double*>(at(k))); };
    const __m256d low = _mm256_insertf128_pd(_mm256_castpd128_pd256(part(0)), part(1), 1);
    const __m512d whole = _mm512_insertf64x2(_mm512_insertf64x2(_mm512_castpd256_pd512(low), part(2), 2), part(3), 3);
    std::memcpy(&all, &whole, sizeof all);
#endif
  } else {
    const auto low = loaded<Real, width / 2>(at),
               high = loaded<Real, width / 2>([&](int k) { return at(k + width / 2 / each); });
    all = with_indices<width>(
        [&](auto... lane) -> LanesOf<Real, width> { return __builtin_shufflevector(low, high, lane.value...); });
  }
  return all;
}

/// Of lanes 0, 2, 4 ... and of lanes 1, 3, 5 ... two numbers each: the first ones of all, and the second ones.
template <int width>
std::array<LanesOf<double, width>, 2> unzipped(const LanesOf<double, width>& even, const LanesOf<double, width>& odd) {
  return with_indices<width>([&](auto... lane) -> std::array<LanesOf<double, width>, 2> {
    return {__builtin_shufflevector(even, odd, (lane.value % 2 * width + lane.value / 2 * 2)...),
            __builtin_shufflevector(even, odd, (lane.value % 2 * width + lane.value / 2 * 2 + 1)...)};
  });
}

/// The numbers of two rows of fours in turn: those in the first half of each four, and those in the second.
template <int width>
std::array<LanesOf<float, width>, 2> zipped(const LanesOf<float, width>& a, const LanesOf<float, width>& b) {
  return with_indices<width>([&](auto... lane) -> std::array<LanesOf<float, width>, 2> {
    return {__builtin_shufflevector(a, b, (lane.value / 4 * 4 + lane.value % 4 / 2 + lane.value % 2 * width)...),
            __builtin_shufflevector(a, b, (lane.value / 4 * 4 + lane.value % 4 / 2 + lane.value % 2 * width + 2)...)};
  });
}

}  // namespace detail

/// Two doubles that stand side by side in memory at each of `width` places: at(lane) points at the first of a lane's
/// two. One load brings both.
template <int width, class At>
std::array<LanesOf<double, width>, 2> gather_two(const At& at) {
  const auto half = [&](int parity) {
    return detail::loaded<double, width>([&](int k) { return at(2 * k + parity); });
  };
  return detail::unzipped<width>(half(0), half(1));
}

/// Four floats, likewise.
template <int width, class At>
std::array<LanesOf<float, width>, 4> gather_four(const At& at) {
  const auto fourth = [&](int first) { return detail::loaded<float, width>([&](int k) { return at(4 * k + first); }); };
  const auto even = detail::zipped<width>(fourth(0), fourth(2)), odd = detail::zipped<width>(fourth(1), fourth(3)),
             low = detail::zipped<width>(even[0], odd[0]), high = detail::zipped<width>(even[1], odd[1]);
  return {low[0], low[1], high[0], high[1]};
}

}  // namespace touchstone::sph

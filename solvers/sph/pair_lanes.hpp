#pragma once
/// Numbers side by side, for the loops over pairs: all their vector details.
/// Kernels and terms are templates over `Real`; they are written for one pair (`Real` = double) and run for as many as
/// a vector register of the processor holds.

#if defined(__AVX512F__)
#include <immintrin.h>
#endif

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>

namespace touchstone::sph {

/// Bytes of a vector register. Wider blocks than the processor's own do not stay in registers: eight doubles on a
/// processor with four took 3.5 times as long.
#if defined(__AVX512F__)
inline constexpr std::size_t vector_bytes = 64;
#elif defined(__AVX__)
inline constexpr std::size_t vector_bytes = 32;
#else
inline constexpr std::size_t vector_bytes = 16;
#endif

/// Particles that are summed for side by side, one per lane of a vector instruction.
template <class Real>
inline constexpr int lanes = static_cast<int>(vector_bytes / sizeof(Real));

template <class Real, int width>
struct Vector {
  typedef Real type __attribute__((vector_size(width * sizeof(Real))));
};
/// Arithmetic and comparison are lane by lane (a vector extension of GCC and Clang, for any processor).
template <class Real, int width = lanes<Real>>
using Lanes = typename Vector<Real, width>::type;

/// What a lane holds; a constant has to be cast to it before it meets lanes.
template <class Real>
struct NumberIn {
  using type = std::remove_cvref_t<decltype(std::declval<Real&>()[0])>;
};
template <class Real>
requires std::is_floating_point_v<Real>
struct NumberIn<Real> {
  using type = Real;
};
template <class Real>
using Number = typename NumberIn<Real>::type;

// GCC vectorises a loop over lanes, and a selection, as wide as the processor prefers that it tunes for. Where it
// mistook one and preferred half of the register, both halves went through memory, and sums over pairs took 1.6 times
// as long. These fill the register, with the same bits.
namespace detail {

#if defined(__AVX512F__)
inline Lanes<double, 8> root_of(const Lanes<double, 8>& a) { return _mm512_sqrt_pd(a); }
inline Lanes<float, 16> root_of(const Lanes<float, 16>& a) { return _mm512_sqrt_ps(a); }
inline Lanes<double, 8> greater_of(const Lanes<double, 8>& a, const Lanes<double, 8>& b) { return _mm512_max_pd(a, b); }
inline Lanes<float, 16> greater_of(const Lanes<float, 16>& a, const Lanes<float, 16>& b) { return _mm512_max_ps(a, b); }
inline Lanes<double, 8> less_of(const Lanes<double, 8>& a, const Lanes<double, 8>& b) { return _mm512_min_pd(a, b); }
inline Lanes<float, 16> less_of(const Lanes<float, 16>& a, const Lanes<float, 16>& b) { return _mm512_min_ps(a, b); }
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
    for (std::size_t lane = 0; lane < sizeof(Real) / sizeof(Number<Real>); ++lane) root[lane] = std::sqrt(a[lane]);
    return root;
  }
}

/// f of doubles, at once where lanes hold doubles, else one by one.
template <class Real, class F>
Real each_lane(const Real& a, const F& f) {
  if constexpr (std::is_same_v<Number<Real>, double>) {
    return f(a);
  } else {
    Real all;
    for (std::size_t lane = 0; lane < sizeof(Real) / sizeof(Number<Real>); ++lane)
      all[lane] = static_cast<Number<Real>>(f(static_cast<double>(a[lane])));
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

template <class Real, std::size_t... lane>
auto joined(const Lanes<Real, sizeof...(lane) / 2>& a, const Lanes<Real, sizeof...(lane) / 2>& b,
            std::index_sequence<lane...>) {
  return __builtin_shufflevector(a, b, lane...);
}

/// The numbers that fill 16 bytes at each of several places, as many as make `width` numbers, one after the other.
template <class Real, int width, class At>
Lanes<Real, width> loaded(const At& at) {
  constexpr int each = 16 / sizeof(Real);
  Lanes<Real, width> all;
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
    all = joined<Real>(loaded<Real, width / 2>(at),
                       loaded<Real, width / 2>([&](int k) { return at(k + width / 2 / each); }),
                       std::make_index_sequence<width>());
  }
  return all;
}

/// Of lanes 0, 2, 4 ... and of lanes 1, 3, 5 ... two numbers each: the first ones of all, and the second ones.
template <int width, std::size_t... lane>
std::array<Lanes<double, width>, 2> unzipped(const Lanes<double, width>& even, const Lanes<double, width>& odd,
                                             std::index_sequence<lane...>) {
  return {__builtin_shufflevector(even, odd, (lane % 2 * width + lane / 2 * 2)...),
          __builtin_shufflevector(even, odd, (lane % 2 * width + lane / 2 * 2 + 1)...)};
}

/// The numbers of two rows of fours in turn: those in the first half of each four, and those in the second.
template <int width, std::size_t... lane>
std::array<Lanes<float, width>, 2> zipped(const Lanes<float, width>& a, const Lanes<float, width>& b,
                                          std::index_sequence<lane...>) {
  return {__builtin_shufflevector(a, b, (lane / 4 * 4 + lane % 4 / 2 + lane % 2 * width)...),
          __builtin_shufflevector(a, b, (lane / 4 * 4 + lane % 4 / 2 + lane % 2 * width + 2)...)};
}

}  // namespace detail

/// Two doubles that stand side by side in memory at each of `width` places: at(lane) points at the first of a lane's
/// two. One load brings both.
template <int width, class At>
std::array<Lanes<double, width>, 2> gather_two(const At& at) {
  const auto half = [&](int parity) {
    return detail::loaded<double, width>([&](int k) { return at(2 * k + parity); });
  };
  return detail::unzipped<width>(half(0), half(1), std::make_index_sequence<width>());
}

/// Four floats, likewise.
template <int width, class At>
std::array<Lanes<float, width>, 4> gather_four(const At& at) {
  constexpr std::make_index_sequence<width> all;
  const auto fourth = [&](int first) { return detail::loaded<float, width>([&](int k) { return at(4 * k + first); }); };
  const auto even = detail::zipped<width>(fourth(0), fourth(2), all),
             odd = detail::zipped<width>(fourth(1), fourth(3), all), low = detail::zipped<width>(even[0], odd[0], all),
             high = detail::zipped<width>(even[1], odd[1], all);
  return {low[0], low[1], high[0], high[1]};
}

}  // namespace touchstone::sph

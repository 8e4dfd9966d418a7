#pragma once
/// Numbers side by side, for the loops over pairs: the vector details of this solver, all of them.
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
void root_of() = delete;
void greater_of() = delete;
void less_of() = delete;
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

/// The two numbers at each of count / 2 places, one after the other.
template <class Real, int count, class At>
Lanes<Real, count> twos(const At& at, int first) {
  Lanes<Real, count> all;
  if constexpr (sizeof(Real) == sizeof(float)) {  // two floats travel as one double
    Lanes<double, count / 2> both;
    for (int k = 0; k < count / 2; ++k) {
      double two;
      std::memcpy(&two, at(first + 2 * k), sizeof two);
      both[k] = two;
    }
    std::memcpy(&all, &both, sizeof all);
  } else if constexpr (count == 2) {
    std::memcpy(&all, at(first), sizeof all);
#if defined(__AVX512DQ__)
  } else if constexpr (count == 8) {  // inserted from memory: joined in registers they crowd the one port that shuffles
    const auto two = [&](int k) { return _mm_loadu_pd(at(first + k)); };
    const __m256d low = _mm256_insertf128_pd(_mm256_castpd128_pd256(two(0)), two(2), 1);
    all = _mm512_insertf64x2(_mm512_insertf64x2(_mm512_castpd256_pd512(low), two(4), 2), two(6), 3);
#endif
  } else {
    all = joined<Real>(twos<Real, count / 2>(at, first), twos<Real, count / 2>(at, first + count / 2),
                       std::make_index_sequence<count>());
  }
  return all;
}

template <class Real, int width, std::size_t... lane>
std::array<Lanes<Real, width>, 2> unzipped(const Lanes<Real, width>& even, const Lanes<Real, width>& odd,
                                           std::index_sequence<lane...>) {
  return {__builtin_shufflevector(even, odd, (lane % 2 * width + lane / 2 * 2)...),
          __builtin_shufflevector(even, odd, (lane % 2 * width + lane / 2 * 2 + 1)...)};
}

}  // namespace detail

/// Two numbers that stand side by side in memory at each of `width` places: at(lane) points at the first of a lane's
/// two. One load brings both.
template <class Real, int width, class At>
std::array<Lanes<Real, width>, 2> gather_two(const At& at) {
  return detail::unzipped<Real, width>(detail::twos<Real, width>(at, 0), detail::twos<Real, width>(at, 1),
                                       std::make_index_sequence<width>());
}

}  // namespace touchstone::sph

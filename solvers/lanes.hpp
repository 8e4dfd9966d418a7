#pragma once
/// Numbers side by side in a register of the processor, by vector extensions of GCC and Clang, for any processor.
/// Arithmetic and comparison are lane by lane, so a result never depends on what lies in the lanes beside it.

#include <type_traits>
#include <utility>

namespace touchstone {

/// Wider vectors than the processor's own do not stay in registers: eight doubles on a processor with four took 3.5
/// times as long.
#if defined(__AVX512F__)
inline constexpr int register_bytes = 64;
#elif defined(__AVX__)
inline constexpr int register_bytes = 32;
#else
inline constexpr int register_bytes = 16;
#endif

/// How many numbers a register holds.
template <class Number>
inline constexpr int lanes_of = register_bytes / static_cast<int>(sizeof(Number));

/// So many numbers, and the same where their address need not be aligned.
template <class Number, int width>
struct Register {
  typedef Number type __attribute__((vector_size(width * sizeof(Number))));
  typedef Number in_memory __attribute__((vector_size(width * sizeof(Number)), aligned(alignof(Number))));
};
template <class Number, int width = lanes_of<Number>>
using LanesOf = typename Register<Number, width>::type;

/// The type of the numbers in lanes, or of a number itself; a constant has to be cast to it before it meets lanes.
template <class Real>
struct ElementOf {
  using type = std::remove_cvref_t<decltype(std::declval<Real&>()[0])>;
};
template <class Real>
requires std::is_floating_point_v<Real>
struct ElementOf<Real> {
  using type = Real;
};
template <class Real>
using NumberIn = typename ElementOf<Real>::type;

}  // namespace touchstone

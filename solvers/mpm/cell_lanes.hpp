#pragma once
/// Several neighbouring cells in one register, a particle of each: the vector details of this solver, all of them.

#include "solvers/fields.hpp"
#include "solvers/indices.hpp"
#include "solvers/lanes.hpp"

#include <array>
#include <cstring>
#include <vector>

namespace touchstone::mpm {

/// Nodes are computed in double precision, whatever the particles are stored in.
using Lanes = LanesOf<double>;
inline constexpr int lanes = lanes_of<double>;

/// One number per slot or per node, aligned as registers like it.
template <class Number>
using Field = std::vector<Number, Eigen::aligned_allocator<Number>>;

/// One number for each column of nodes near a cell, and for each row; or for each function of X, and for each of Y.
template <class Real, int count>
using Square = std::array<std::array<Real, count>, count>;
template <class Real>
using ThreeByThree = Square<Real, 3>;

template <class Real>
using InMemory = typename Register<NumberIn<Real>, lanes_of<NumberIn<Real>>>::in_memory;
/// The numbers from an address on.
template <class Real>
Real load(const NumberIn<Real>* from) {
  return *reinterpret_cast<const InMemory<Real>*>(from);
}
template <class Real>
void store(const Real& value, NumberIn<Real>* to) {
  *reinterpret_cast<InMemory<Real>*>(to) = value;
}

/// The same number in every lane.
template <class Real>
Real fill(double number) {
  const auto n = static_cast<NumberIn<Real>>(number);
  return with_indices<lanes_of<NumberIn<Real>>>([&](auto... i) { return Real{(static_cast<void>(i), n)...}; });
}

/// Whole numbers from an address on.
template <class Real>
Real converted(const int* from) {
  using Whole [[gnu::vector_size(sizeof(int) * lanes_of<NumberIn<Real>>)]] = int;
  Whole numbers;
  std::memcpy(&numbers, from, sizeof numbers);
  return __builtin_convertvector(numbers, Real);
}

/// So many lanes to the right: the last of `before`, then all but the last of `these`.
template <int by>
Lanes shifted(const Lanes& before, const Lanes& these) {
  return with_indices<lanes>(
      [&](auto... i) -> Lanes { return __builtin_shufflevector(before, these, lanes - by + decltype(i)::value...); });
}

/// Registers of doubles that the lanes of a `Real` fill, one after the other.
template <class Real>
inline constexpr int parts_of = lanes_of<NumberIn<Real>> / lanes;

/// A part of the lanes as doubles.
template <int part, class Real>
Lanes widened(const Real& a) {
  if constexpr (parts_of<Real> == 1)
    return a;
  else
    return with_indices<lanes>([&](auto... i) -> Lanes {
      return __builtin_convertvector(__builtin_shufflevector(a, a, part * lanes + decltype(i)::value...), Lanes);
    });
}

/// Lanes put together from registers of doubles: part_of(lane) is the one that begins with that lane.
template <class Real, class PartOf>
Real joined(const PartOf& part_of) {
  if constexpr (parts_of<Real> == 1) {
    return part_of(0);
  } else {
    using Half [[gnu::vector_size(register_bytes / 2)]] = float;
    const Half low = __builtin_convertvector(part_of(0), Half), high = __builtin_convertvector(part_of(lanes), Half);
    return with_indices<2 * lanes>(
        [&](auto... i) -> Real { return __builtin_shufflevector(low, high, decltype(i)::value...); });
  }
}

/// The result of comparing two `Real`, lane by lane; masks are combined with `&`.
template <class Real>
using Mask = decltype(std::declval<Real>() < std::declval<Real>());

/// Whether numbers lie between two others, both of them included; false for what is not a number.
template <class Real>
Mask<Real> between(double low, const Real& number, double high) {
  return (fill<Real>(low) <= number) & (number <= fill<Real>(high));
}

/// A bit for each lane, from the first on.
using LaneBits = unsigned short;
static_assert(lanes_of<float> <= 16);

/// The lanes where the mask is true. By value: GCC 12 that checks bounds takes a wrong lane through a reference.
template <class Real>
LaneBits lanes_with(Mask<Real> mask) {
  unsigned bits = 0;
  for (int lane = 0; lane < lanes_of<NumberIn<Real>>; ++lane) bits |= (mask[lane] ? 1u : 0u) << lane;
  return static_cast<LaneBits>(bits);
}
/// Whether it is true in all lanes.
template <class Real>
bool all(const Mask<Real>& mask) {
  return lanes_with<Real>(mask) == (1u << lanes_of<NumberIn<Real>>)-1;
}

}  // namespace touchstone::mpm

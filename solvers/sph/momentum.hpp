#pragma once
/// The terms of a method's momentum equation, as types: one that is not listed costs nothing.

#include "solvers/sph/pair.hpp"

#include <tuple>

namespace touchstone::sph {

/// A term that divides by something of its own says by what; a pair divides once for all of them.
template <class Term, class Real>
concept Dividing = requires(const Term& term, const Pair<Real>& ij) {
  term.divisor(ij);
};

/// 1 / of[k] for all k, by one division.
template <class Real, std::size_t count>
std::array<Real, count> reciprocals(const std::array<Real, count>& of) {
  std::array<Real, count> product = of, per;
  if constexpr (count == 0) return per;
  for (std::size_t k = 1; k < count; ++k) product[k] *= product[k - 1];
  Real rest = 1 / product[count - 1];
  for (std::size_t k = count - 1; k > 0; --k) {
    per[k] = rest * product[k - 1];
    rest *= of[k];
  }
  per[0] = rest;
  return per;
}

/// A kernel that knows W'(q) / q without a division.
template <class Kernel>
concept DividedSlope = requires(double q) {
  Kernel::dw_per_q(q);
};

/// The slope of a kernel [m⁻⁴] at a distance whose reciprocal is known, where the kernel asks for it.
template <class Kernel>
struct Slope {
  static constexpr bool needs_reciprocal = !DividedSlope<Kernel>;

  explicit Slope(double h) : per_h(1 / h), per_h3(per_h * per_h * per_h), per_h4(per_h3 * per_h) {}

  template <class Real>
  Real operator()(const Real& r, const Real& per_r) const {
    return Kernel::dw(Real(r * NumberIn<Real>(per_h))) * NumberIn<Real>(per_h3) * per_r;
  }
  template <class Real>
  requires(!needs_reciprocal) Real operator()(const Real& r) const {
    return Kernel::dw_per_q(Real(r * NumberIn<Real>(per_h))) * NumberIn<Real>(per_h4);
  }

  double per_h, per_h3, per_h4;  // 1/m, 1/m³, 1/m⁴  once for all pairs
};

template <class... Terms>
struct Momentum {
  std::tuple<Terms...> terms;

  /// The acceleration by all terms, of a pair whose slope is found on the way.
  template <class Kernel, class Real>
  Acceleration<Real> on(Pair<Real>& ij, const Slope<Kernel>& slope) const {
    constexpr std::size_t first = Slope<Kernel>::needs_reciprocal;
    std::array<Real, first + (0 + ... + int(Dividing<Terms, Real>))> divisors;
    if constexpr (first) divisors[0] = ij.r2;  // and not r: the division need not wait for the root
    std::size_t next = first;
    std::apply([&](const auto&... term) { (add_divisor(term, ij, divisors, next), ...); }, terms);
    const auto per = reciprocals(divisors);
    if constexpr (first)
      ij.slope = slope(ij.r, Real(ij.r * per[0]));
    else
      ij.slope = slope(ij.r);
    Acceleration<Real> sum;
    next = first;
    std::apply([&](const auto&... term) { ((sum += acceleration_of(term, ij, per, next)), ...); }, terms);
    return sum;
  }

 private:
  template <class Term, class Real, std::size_t count>
  static void add_divisor(const Term& term, const Pair<Real>& ij, std::array<Real, count>& divisors,
                          std::size_t& next) {
    if constexpr (Dividing<Term, Real>) divisors[next++] = term.divisor(ij);
  }
  template <class Term, class Real, std::size_t count>
  static Acceleration<Real> acceleration_of(const Term& term, const Pair<Real>& ij, const std::array<Real, count>& per,
                                            std::size_t& next) {
    if constexpr (Dividing<Term, Real>)
      return term.acceleration(ij, per[next++]);
    else
      return term(ij);
  }
};

template <class... Terms>
Momentum<Terms...> momentum(const Terms&... terms) {
  return {{terms...}};
}

/// Particles i and their neighbours j, without the slope of the kernel between them.
template <class I, class J>
auto pair_of(const I& i, const J& j, double mass) {
  using Real = typename J::Real;
  using Packed = std::remove_cvref_t<decltype(*j.all)>;
  Pair<Real> ij;
  const auto sides = apart(i, j);
  ij.x = sides[0];
  ij.y = sides[1];
  ij.r2 = ij.x * ij.x + ij.y * ij.y;
  ij.r = square_root(ij.r2);
  const auto v_i = i.two(&Packed::vx), v_j = j.two(&Packed::vx);
  ij.vx = v_i[0] - v_j[0];
  ij.vy = v_i[1] - v_j[1];
  const auto rho_and_p_over_rho2_i = i.two(&Packed::rho), rho_and_p_over_rho2_j = j.two(&Packed::rho);
  ij.rho_i = rho_and_p_over_rho2_i[0], ij.p_over_rho2_i = rho_and_p_over_rho2_i[1];
  ij.rho_j = rho_and_p_over_rho2_j[0], ij.p_over_rho2_j = rho_and_p_over_rho2_j[1];
  const auto volume_and_p_i = i.two(&Packed::specific_volume), volume_and_p_j = j.two(&Packed::specific_volume);
  ij.specific_volume_i = volume_and_p_i[0], ij.p_i = volume_and_p_i[1];
  ij.specific_volume_j = volume_and_p_j[0], ij.p_j = volume_and_p_j[1];
  ij.mass = static_cast<NumberIn<Real>>(mass);
  return ij;
}

/// The same with the slope of the kernel.
template <class Kernel, class I, class J>
auto pair_of(const I& i, const J& j, double mass, const Slope<Kernel>& slope) {
  auto ij = pair_of(i, j, mass);
  using Real = typename J::Real;
  if constexpr (Slope<Kernel>::needs_reciprocal)
    ij.slope = slope(ij.r, Real(1 / ij.r));
  else
    ij.slope = slope(ij.r);
  return ij;
}

}  // namespace touchstone::sph

#pragma once
/// Neither diffusion of density nor shifting of particles: a method given these compiles none.

#include "solvers/forces/none.hpp"
#include "solvers/sph/pair.hpp"

namespace touchstone::sph {

struct NoDiffusion {};
struct NoShifting {};

/// The gradient of the kernel as it is.
struct PlainGradient {
  template <class Real, class I, class J>
  Acceleration<Real> operator()(const I&, const J&, const Acceleration<Real>& along) const {
    return along;
  }
};

}  // namespace touchstone::sph

template <>
inline constexpr bool touchstone::is_present<touchstone::sph::NoDiffusion> = false;
template <>
inline constexpr bool touchstone::is_present<touchstone::sph::NoShifting> = false;

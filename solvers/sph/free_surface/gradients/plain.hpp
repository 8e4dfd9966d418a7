#pragma once
#include "solvers/sph/pair.hpp"

namespace touchstone::sph {

/// The gradient of the kernel as it is.
struct PlainGradient {
  template <class Real, class I, class J>
  Acceleration<Real> operator()(const I&, const J&, const Acceleration<Real>& along) const {
    return along;
  }
};

}  // namespace touchstone::sph

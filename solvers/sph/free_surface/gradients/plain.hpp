#pragma once
#include "solvers/sph/pair.hpp"

namespace touchstone::sph {

/// The gradient of the kernel as it is.
struct PlainGradient {
  template <class Real, class I, class J>
  Pull<Real> operator()(const I&, const J&, const Pull<Real>& along) const {
    return along;
  }
};

}  // namespace touchstone::sph

#pragma once
/// The oracle of a decaying shear wave (vnv/flows/shear_wave.cpp).

#include "reference/shear_wave.hpp"
#include "vnv/flows/flow.hpp"

namespace touchstone::vnv::shear_wave {

inline reference::ShearWave exact_of(const Flow& flow) {
  return {.L = flow["L"], .U = flow["U"], .nu = flow.fluid.kinematic_viscosity()};
}

}  // namespace touchstone::vnv::shear_wave

#pragma once
/// A shear wave that decays by viscosity in a periodic square of 1 m, Reynolds number 100, Mach number 0.1.

#include "reference/shear_wave.hpp"
#include "vnv/flows/square.hpp"

namespace touchstone::vnv::shear_wave {

inline constexpr double U = 1, c = 10, rho = 1000, Re = 100;  // m/s, m/s, kg/m³, -
inline constexpr Newtonian fluid{{.density = rho, .bulk_modulus = rho * c * c / 7}, rho* U* square::side / Re};
inline const reference::ShearWave exact{.L = square::side, .U = U, .nu = fluid.kinematic_viscosity()};

inline Vec2 velocity(const Vec2& x, double t) { return {exact(x.y(), t), 0}; }

}  // namespace touchstone::vnv::shear_wave

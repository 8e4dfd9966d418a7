#pragma once
/// Methods for free surfaces that keep an energy budget of water in a tank (solvers/stepping/energy_budget.hpp).

#include "vnv/methods/free_surface_methods.hpp"

namespace touchstone::vnv {

inline const Quantity energy_by_viscosity{"energy by viscosity", "J/m"};
/// What a run of such a method monitors, after what its case does: what each part of it added so far, then what no part
/// accounts for.
inline const std::vector<Quantity> parts_of_energy{
    {"energy by pressure", "J/m"}, {"energy by gravity", "J/m"},
    energy_by_viscosity,           {"energy by density smoothing", "J/m"},
    {"energy by walls", "J/m"},    {"energy by transfer", "J/m"},
    {"energy by shifting", "J/m"}, {"energy that no part accounts for", "J/m"}};

/// delta-SPH, shifted and corrected SPH, and, as the plain `mpm::plain`, APIC, XPIC(5) and MPM as printed. Walls
/// with an extent are refused by MPM.
std::vector<Method> methods_with_energy_budget(const Scene<Tait, Uniform>& scene, double output_interval);

}  // namespace touchstone::vnv

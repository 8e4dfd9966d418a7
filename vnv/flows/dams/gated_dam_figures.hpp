#pragma once
/// Figures of the dam break with its gate, beside the experiment at H = 0.3 m: of the finest run of each method.

#include "vnv/flows/dams/gated_dam.hpp"

namespace touchstone::vnv::gated_dam {

/// x/H of the front over T_H.
Plot front_over_time();
/// h/H at each gauge, one figure each, with both runs of the experiment.
Plot levels_over_time();
/// p/(rho g H) at each sensor, one figure each, with the event and, at P2, the band of 100 repeats.
Plot pressures_over_time();
/// Kinetic and potential energy, and their sum with the elastic one, over the fall.
Plot energies_over_time();

/// Particles of these methods at these times [s].
Plot particles_coloured_by_pressure(std::vector<std::string> methods, std::vector<double> times);

}  // namespace touchstone::vnv::gated_dam

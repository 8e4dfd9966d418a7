#pragma once
/// Maps of where a method is stable and accurate: each point is a shear wave that decays on a resting lattice.

#include "vnv/stability/methods_on_lattice.hpp"

namespace touchstone::vnv {

inline const Quantity fraction_stable{"stable fraction of the map", "%", Kind::stability_limit},
    stable_as_theory{"fraction of the map where linear theory and simulation agree on stability", "%",
                     Kind::stability_limit},
    fraction_right{"stable and accurate fraction of the map", "%", Kind::stability_limit},
    stable_where_made_for{"stable fraction of the map up to Ma = 0.32 and Re = 100", "%", Kind::stability_limit};

/// Makes a map of a method, drawn into the figure of that id.
using MakeMap = Run (*)(const LatticeMethod& method, const std::string& figure);

/// Over the acoustic and the viscous Courant number, with the boundary of linear theory.
Run map_of_courant_numbers(const LatticeMethod& method, const std::string& figure);

/// Over the acoustic Courant number and the smoothing length in SPH, the particles in a cell in MPM; momentum diffuses
/// over a tenth of a length in a step. The wave is so slow that particles stay in their places: what crossing cells
/// adds is seen in the other map.
Run map_of_arrangements(const LatticeMethod& method, const std::string& figure);

/// Over the Reynolds number of the wave, by its amplitude and length, and the bulk modulus over that of a Mach number
/// of 0.1; the step is the method's own choice.
Run map_of_fluids(const LatticeMethod& method, const std::string& figure);

}  // namespace touchstone::vnv

#pragma once
/// All that a solver needs to compute a flow, in words or as JSON, and the particles that it starts from.

#include "vnv/flows/flow.hpp"
#include "vnv/record/description.hpp"

#include <string>

namespace touchstone::vnv::doors {

/// For a person. `spacing` [m] is that of the particles at the start.
std::string scene_in_words(const Flow& flow, double spacing);

/// For a program; each number of a flow has its SI unit in its name, such as "density [kg/m³]".
std::string scene_as_json(const Flow& flow, double spacing);

/// What a flow says of itself as a case does, with what is claimed of any code; last of this what is claimed of
/// resolved levels alone.
Description describe(const Flow& flow);

/// Where the particles are at the start [m].
Vectors places_at_start(const Flow& flow, double spacing);

/// The particles at the start, a row each, with the mass [kg/m] of a plane flow: "x [m],y [m],v_x [m/s],...".
std::string particles_as_csv(const Flow& flow, double spacing);

}  // namespace touchstone::vnv::doors

#pragma once
/// What flows in a periodic square share apart from any method.

#include "vnv/flows/flow.hpp"
#include "vnv/flows/squares/square.hpp"

namespace touchstone::vnv::flows {

/// The fields where something is wrong.
using VelocityWith = std::function<VelocityTruth(const Changes&)>;
using PressureWith = std::function<PressureTruth(const Changes&)>;

/// Fluid that fills a periodic square of this side [m] and starts with these fields.
Flow in_square(double side, const Newtonian& fluid, const VelocityWith& velocity_with, PressureTruth pressure,
               std::vector<Cause> causes);

/// Judges the pressure, too.
void add_pressure(Flow& flow, const PressureWith& with, std::vector<Cause> causes);

}  // namespace touchstone::vnv::flows

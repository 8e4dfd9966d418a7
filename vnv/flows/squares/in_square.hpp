#pragma once
/// What flows in a periodic square share apart from any method.

#include "vnv/flows/flow.hpp"
#include "vnv/flows/squares/square.hpp"

namespace touchstone::vnv::flows {

/// The fields where something is wrong.
using VelocityWith = std::function<VelocityTruth(const Changes&)>;
using PressureWith = std::function<PressureTruth(const Changes&)>;

/// A fluid that decays in a periodic square, by its Reynolds number; its words say what U is, and what L is besides.
struct DecaysInSquare {
  double L, U, rho, Re, c;  // m, m/s, kg/m³, -, m/s

  DecaysInSquare(Settings& set, const std::string& L_is, const std::string& U_is, double published_c)
      : L(set.positive("L", square::side, "m", "side of the periodic square" + L_is)),
        U(set.positive("U", 1, "m/s", U_is)),
        rho(set.positive("rho", 1000, "kg/m³", "density at rest")),
        Re(set.positive("Re", 100, "-", "Reynolds number U L / nu")),
        c(set.positive("c", published_c, "m/s", "speed of sound at rest")) {}

  double nu(const Changes& by) const { return U * L / Re * by.factor(Cause::viscosity); }  // m²/s
  Newtonian fluid() const { return fluid_of(rho, c, nu({})); }
};

/// Fluid fills the domain of a flow and starts with these fields; without a pressure at that of rest.
void fill(Flow& flow, const VelocityWith& velocity_with, PressureTruth pressure, std::vector<Cause> causes);

/// Fluid that fills a periodic square of this side [m] and starts with these fields.
Flow in_square(double side, const Newtonian& fluid, const VelocityWith& velocity_with, PressureTruth pressure,
               std::vector<Cause> causes);

/// Judges the pressure, too.
void add_pressure(Flow& flow, const PressureWith& with, std::vector<Cause> causes);

}  // namespace touchstone::vnv::flows

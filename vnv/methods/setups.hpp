#pragma once
/// Solvers as cases set them up: each is compiled once, in the .cpp of its method beside this file, and shared by
/// cases, tests and benchmarks. What a call needs besides is a level, which says spacing and cell, and a time step [s].
///
/// They are compiled for these scenes: `Scene<Newtonian>` with no force, `Uniform` or `ForceField`, and `Scene<Tait>`
/// with no force or `Uniform`; the methods for free surfaces and those that fill their domain for the scenes that they
/// are meant for. A linker that finds "undefined reference to ..._solver" asks for another: it is one line there.

#include "vnv/case.hpp"

namespace touchstone {
class AdamsBashforth;
class KickDriftKick;
class PredictorCorrector;
namespace mpm {
struct PrescribedMotion;
struct PrescribedVelocity;
struct VelocityReset;
}  // namespace mpm
namespace sph {
struct Pressure;
struct PressureDifference;
}  // namespace sph
}  // namespace touchstone

namespace touchstone::vnv {

/// MPM as printed by Sun et al., section 2.1, with one of the wall treatments of solvers/mpm/walls/; particles in
/// single precision where `Number` is float.
template <class WallTreatment = mpm::PrescribedMotion, class Number = double, class AnyScene>
Simulation mpm_solver(const AnyScene& scene, const Level& level, double time_step);

/// MPM with quadratic B-splines and affine particle velocities (APIC), the stress given to the nodes as in MLS-MPM.
Simulation mpm_affine_solver(const auto& scene, const Level& level, double time_step);

/// MPM by least squares, for fluid that fills its domain.
Simulation mpm_least_squares_solver(const auto& scene, const Level& level, double time_step);

/// SPH as printed by Sun et al., section 2.2, with one of the pressure terms of solvers/sph/terms/; laminar viscosity
/// only where the fluid has one.
template <class PressureTerm = sph::Pressure, class Integrator = PredictorCorrector, class AnyScene>
Simulation sph_printed_solver(const AnyScene& scene, const Level& level, double time_step);

/// SPH with a transport velocity (Adami, Hu & Adams 2013) and the conservative pressure term.
Simulation sph_transport_velocity_solver(const auto& scene, const Level& level, double time_step);

/// The same as regularised for channels: differences of pressure, and without the momentum that the drift carries,
/// which changes nothing there in 10 s (`ablation_poiseuille`).
template <class Integrator = KickDriftKick, class Real = double, class AnyScene>
Simulation sph_regularised_solver(const AnyScene& scene, const Level& level, double time_step);

/// SPH of second order by fits, for fluid that fills its domain.
Simulation sph_second_order_solver(const auto& scene, const Level& level, double time_step);

/// A run of a solver with a fixed step [s], unless a level names its own.
template <class AnyScene>
auto with_step(Simulation (*solver)(const AnyScene&, const Level&, double), const AnyScene& scene, double time_step) {
  return [=](const Level& level, const Schedule& when) {
    return simulate([&] { return solver(scene, level, level.step_or(time_step)); }, when);
  };
}

}  // namespace touchstone::vnv

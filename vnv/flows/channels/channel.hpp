#pragma once
/// What flows along a channel share: geometry and water of Sun et al., table 1, and their methods in words.

#include "solvers/fluids/newtonian.hpp"
#include "solvers/scene.hpp"
#include "vnv/case.hpp"
#include "vnv/measures/norms_of.hpp"
#include "vnv/measures/plots/along_ladders.hpp"
#include "vnv/measures/plots/profiles.hpp"
#include "vnv/measures/profile.hpp"
#include "vnv/measures/row_means.hpp"
#include "vnv/methods/methods.hpp"
#include "vnv/methods/setups.hpp"

namespace touchstone::vnv::channel {

inline constexpr double L = 0.5 * mm, H = 1 * mm;  // table 1
inline constexpr Newtonian water{{.density = 1000, .bulk_modulus = 143}, 1e-3};
inline constexpr double drive = 8 * mm;  // m/s²  the body force of its Poiseuille flow
inline constexpr double dt = 5 * us;

/// The box between the plates, periodic along x and full of water.
inline const Box gap{.high = {L, H}};

// Quantities that every method is judged by.
inline const Quantity l2_rows{"L2 v_x, row means", "%", Kind::norm}, linf_rows{"Linf v_x, row means", "%", Kind::norm};
inline const Quantity l2{"L2 v_x, per particle", "%", Kind::norm}, linf{"Linf v_x, per particle", "%", Kind::norm};

/// Rows as the paper averages them, one per particle row of the start.
inline Measure by_rows(const Level& level) { return row_means(velocity_x, level.spacing); }
inline Measure by_particles(const Level&) { return per_particle(velocity_x); }

// Runs of the solvers of vnv/methods/setups.hpp with a fixed step [s].

template <class WallTreatment, class Number = double, class SceneOfChannel>
auto mpm_with(const SceneOfChannel& scene, double time_step = dt) {
  return with_step(mpm_solver<WallTreatment, Number, SceneOfChannel>, scene, time_step);
}
template <class SceneOfChannel>
auto mpm_affine(const SceneOfChannel& scene, double time_step = dt) {
  return with_step(mpm_affine_solver<SceneOfChannel>, scene, time_step);
}
template <class PressureTerm = sph::Pressure, class Integrator = PredictorCorrector, class SceneOfChannel>
auto sph_as_printed(const SceneOfChannel& scene, double time_step = dt) {
  return with_step(sph_printed_solver<PressureTerm, Integrator, SceneOfChannel>, scene, time_step);
}
template <class Integrator = KickDriftKick, class Real = double, class SceneOfChannel>
auto sph_with_transport_velocity(const SceneOfChannel& scene, double time_step = 2 * dt) {
  return with_step(sph_regularised_solver<Integrator, Real, SceneOfChannel>, scene, time_step);
}

/// The methods in words.
inline const std::string mpm_words =
    "Material point method as printed by Sun et al., section 2.1: linear shape functions, lumped mass, explicit Euler, "
    "FLIP, remapped momentum (MUSL). The paper leaves open which acceleration a wall node transmits to its particles. ";
inline const std::string moving_words = "Here the node moves with the wall: v = V, a = dV/dt. Expected order 2.";
inline const std::string reset_words =
    "Here its velocity is reset, a = (V - v) / dt, which is transmitted to the particles. Expected order 1 in Linf; in "
    "L2, where only the cells at the wall are wrong, 1.5.";
inline const std::string affine_words =
    "Material point method with quadratic B-splines and affine particle velocities (APIC, Jiang et al. 2015), the "
    "stress given to the nodes as in MLS-MPM (Hu et al. 2018), explicit Euler, walls by mirrored cells. Particles take "
    "their velocity from the nodes, which adds a little dissipation in each step: the largest stable step is the most "
    "accurate.";
inline const std::string float_words = " Particles in single precision.";
inline const std::string sph_printed_words =
    "Smoothed particle hydrodynamics as printed by Sun et al., section 2.2: cubic spline with h = 1.2 spacings, "
    "continuity density, laminar viscosity (26), artificial viscosity (27), density reinitialised every 30 steps, "
    "ghost and repulsive particles, predictor-corrector. The paper leaves open the force of the repulsive particles; "
    "here it acts only on fluid particles that are closer to the wall than initially. ";
inline const std::string conservative_words =
    "The pressure term is the conservative one, with a plus between the pressures where (24) and (28) print a minus: "
    "any mean pressure then makes the lattice of particles elastic, and the flow is wrong until its rows have slipped; "
    "refining does not help.";
inline const std::string difference_words =
    "The minus that (24) and (28) print between the pressures is kept, with the leading sign corrected: a difference "
    "of pressures, which does not conserve momentum pair by pair but vanishes for uniform pressure.";
inline const std::string sph_regularised_words =
    "Smoothed particle hydrodynamics with a transport velocity (Adami, Hu & Adams 2013), quintic spline with h = 1 "
    "spacing, continuity density, pressure differences, viscosity of Morris, Fox & Zhu (1997), wall velocities "
    "mirrored (Adami, Hu & Adams 2012), kick-drift-kick with twice the paper's time step.";
inline const std::string one_evaluation_words =
    " Here with Adams-Bashforth steps of third order, one evaluation of the right-hand side per step.";

}  // namespace touchstone::vnv::channel

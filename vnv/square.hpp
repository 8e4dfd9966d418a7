#pragma once
/// What the flows in a square that repeats along both axes share: the methods, their ladders and figures.

#include "solvers/fluids/newtonian.hpp"
#include "solvers/mpm/affine.hpp"
#include "solvers/mpm/least_squares.hpp"
#include "solvers/mpm/mpm.hpp"
#include "solvers/sph/kernels/cubic_spline.hpp"
#include "solvers/sph/kernels/quintic_spline.hpp"
#include "solvers/sph/kernels/wendland_c2.hpp"
#include "solvers/sph/printed.hpp"
#include "solvers/sph/second_order.hpp"
#include "solvers/sph/terms/artificial_viscosity.hpp"
#include "solvers/sph/terms/laminar_viscosity.hpp"
#include "solvers/sph/terms/morris_viscosity.hpp"
#include "solvers/sph/terms/pressure.hpp"
#include "solvers/sph/transport_velocity.hpp"
#include "vnv/case.hpp"
#include "vnv/measures/field_errors.hpp"
#include "vnv/plots/along_ladders.hpp"

namespace touchstone::vnv::square {

inline constexpr double side = 1;  // m
inline const Box box{.high = {side, side}};
inline const Domain domain{.box = box, .periodic_x = true, .periodic_y = true};

inline const std::string ladder = "particles across";

/// So many particles across, in MPM with four to a cell, and how far each suite runs them [s].
struct Across {
  int particles;
  double acceptance, report, nightly;
};
inline std::vector<Rung> rungs(const std::vector<Across>& all) {
  std::vector<Rung> rungs;
  for (const Across& a : all)
    rungs.push_back({.name = std::to_string(a.particles) + " across",
                     .spacing = side / a.particles,
                     .cell = 2 * side / a.particles,
                     .acceptance = a.acceptance,
                     .report = a.report,
                     .nightly = a.nightly});
  return rungs;
}
inline std::vector<Ladder> ladders(const std::vector<Rung>& rungs) {
  Ladder all{ladder, {}};
  for (const Rung& rung : rungs) all.rungs.push_back(rung.name);
  return {all};
}

/// The step in which sound travels a share of a length [m], or less: there is a whole number of them in 0.1 s.
template <class SceneOfSquare>
double step_for(const SceneOfSquare& scene, double share, double length) {
  return 0.1 / std::ceil(0.1 * scene.fluid.sound_speed() / (share * length) * (1 - 1e-9));
}

// The methods, and their runs.

template <class SceneOfSquare>
auto mpm_as_printed(const SceneOfSquare& scene) {
  return [=](const Rung& rung, const Schedule& when) {
    return record(
        mpm::solver<mpm::LinearHat, mpm::PrescribedMotion>(
            scene, {.cell = rung.cell, .spacing = rung.spacing, .time_step = step_for(scene, 0.5, rung.cell)}),
        when);
  };
}
template <class SceneOfSquare>
auto mpm_affine(const SceneOfSquare& scene) {
  return [=](const Rung& rung, const Schedule& when) {
    return record(
        mpm::affine(scene, {.cell = rung.cell, .spacing = rung.spacing, .time_step = step_for(scene, 0.8, rung.cell)}),
        when);
  };
}
template <class SceneOfSquare>
auto mpm_least_squares(const SceneOfSquare& scene) {
  return [=](const Rung& rung, const Schedule& when) {
    return record(
        mpm::least_squares(scene,
                           {.cell = rung.cell, .spacing = rung.spacing, .time_step = step_for(scene, 0.3, rung.cell)}),
        when);
  };
}
template <class SceneOfSquare>
auto sph_as_printed(const SceneOfSquare& scene) {
  return [=](const Rung& rung, const Schedule& when) {
    const double h = 1.2 * rung.spacing;
    return record(
        sph::printed<sph::CubicSpline>(
            scene, {.spacing = rung.spacing, .smoothing_length = h, .time_step = step_for(scene, 0.25, rung.spacing)},
            sph::momentum(sph::Pressure{},
                          sph::LaminarViscosity{.nu = scene.fluid.kinematic_viscosity(), .eta = 0.1 * h},
                          sph::ArtificialViscosity{.alpha = 0.01, .sound_speed = scene.fluid.sound_speed(), .h = h})),
        when);
  };
}
template <class SceneOfSquare>
auto sph_transport_velocity(const SceneOfSquare& scene) {
  return [=](const Rung& rung, const Schedule& when) {
    return record(sph::transport_velocity<sph::QuinticSpline>(
                      scene,
                      {.spacing = rung.spacing,
                       .smoothing_length = rung.spacing,
                       .time_step = step_for(scene, 0.25, rung.spacing)},
                      sph::momentum(sph::Pressure{}, sph::MorrisViscosity{.mu = scene.fluid.viscosity})),
                  when);
  };
}
template <class SceneOfSquare>
auto sph_second_order(const SceneOfSquare& scene) {
  return [=](const Rung& rung, const Schedule& when) {
    return record(sph::second_order<sph::WendlandC2>(scene, {.spacing = rung.spacing,
                                                             .smoothing_length = 1.3 * rung.spacing,
                                                             .time_step = step_for(scene, 0.3, rung.spacing)}),
                  when);
  };
}

/// The methods in words.
inline const std::string mpm_words =
    "Material point method as printed by Sun et al., section 2.1: linear hats, lumped mass, FLIP, MUSL; four particles in "
    "a cell. Sound travels half a cell in a step.";
inline const std::string affine_words =
    "Material point method with quadratic B-splines and affine particle velocities (APIC), four particles in a cell. Sound "
    "travels 0.8 cells in a step, the longest that is stable, since each step damps.";
inline const std::string least_squares_words =
    "Material point method by least squares: nodes know the fluid by fits of second degree to its particles, the equations "
    "are solved by central differences on the nodes, particles are put back onto their lattice before it is strained by a "
    "quarter; third-order Adams-Bashforth, four particles in a cell. Sound travels 0.3 cells in a step.";
inline const std::string sph_words =
    "Smoothed particle hydrodynamics as printed by Sun et al., section 2.2, with the conservative pressure term. Sound "
    "travels a quarter of a spacing in a step.";
inline const std::string transport_words =
    "Smoothed particle hydrodynamics with a transport velocity (Adami, Hu & Adams 2013), quintic spline with h = 1 "
    "spacing, density by continuity, conservative pressure. Sound travels a quarter of a spacing in a step.";
inline const std::string second_order_words =
    "Smoothed particle hydrodynamics of second order: fits of second degree to velocity and pressure around each particle, "
    "drift from where particles are dense, third-order Adams-Bashforth, Wendland's C2 kernel with h = 1.3 spacings. Sound "
    "travels 0.3 spacings in a step.";

/// Flow that stretches its fluid doubles a rounding error every so often.
inline const Tolerance stretched{0.02, "tuned and portable builds differ by less"};

/// Error over spacing and over run time, with lines of first and second order.
inline std::vector<Plot> figures(double time, const std::string& quantity, double error_of_first_order) {
  const Axis error{.label = "L2 v [%]", .logarithmic = true};
  const auto guide = [&](const std::string& label, double order) {
    const double coarse = side / 24, fine = side / 200;
    return Curve{"order",
                 label,
                 Role::guide,
                 {coarse, fine},
                 {error_of_first_order, error_of_first_order * std::pow(fine / coarse, order)},
                 false};
  };
  return {along_ladders({"order",
                         "Error over spacing",
                         fmt::format("L2 error of the velocity, particle by particle, at t = {:g} s.", time),
                         {.label = "particle spacing [mm]", .scale = 1e3, .logarithmic = true},
                         error},
                        {}, spacing(), {{"", error_of(quantity, time)}}),
          beside({guide("order 1", 1), guide("order 2", 2)}),
          along_ladders(
              {"cost",
               "Error over run time",
               fmt::format("The same over the CPU seconds from the start to t = {:g} s; lower left is better.", time),
               {.label = "CPU time [s]", .logarithmic = true},
               error},
              {}, cpu_time_until(time), {{"", error_of(quantity, time)}})};
}

}  // namespace touchstone::vnv::square

/// Each method runs a dam break or a channel for a hundred steps. Built by Clang with MemorySanitizer, the program ends
/// with a report where a result comes to depend on memory that nobody has written; else it prints a line a run.

#include "solvers/forces/uniform.hpp"
#include "solvers/mpm/lanes/in_lanes.hpp"
#include "solvers/mpm/least_squares/least_squares.hpp"
#include "solvers/mpm/printed/mpm.hpp"
#include "solvers/mpm/walls/prescribed_motion.hpp"
#include "solvers/sph/free_surface/diffusion/antuono.hpp"
#include "solvers/sph/free_surface/free_surface.hpp"
#include "solvers/sph/free_surface/gradients/bonet_lok.hpp"
#include "solvers/sph/free_surface/shifting/tangential.hpp"
#include "solvers/sph/kernels/cubic_spline.hpp"
#include "solvers/sph/kernels/quintic_spline.hpp"
#include "solvers/sph/kernels/wendland_c2.hpp"
#include "solvers/sph/printed/printed.hpp"
#include "solvers/sph/second_order/second_order.hpp"
#include "solvers/sph/terms/bonet_lok_pressure.hpp"
#include "solvers/sph/terms/laminar_viscosity.hpp"
#include "solvers/sph/terms/monaghan_cleary_viscosity.hpp"
#include "solvers/sph/terms/morris_viscosity.hpp"
#include "solvers/sph/terms/pressure.hpp"
#include "solvers/sph/transport_velocity/transport_velocity.hpp"
#include "solvers/walls/free_slip.hpp"
#include "solvers/walls/no_slip.hpp"

#include <cstdio>

using namespace touchstone;

namespace {

constexpr double spacing = 0.02, c = 40, h = 2 * spacing;  // m, m/s, m
constexpr Newtonian water{{.density = 1000, .bulk_modulus = 1000 * c * c / 7}, 1e-3};
using Water = Scene<Newtonian, Uniform>;

/// A column in the corner of a tank.
const Water dam{.domain = {.box = {.high = {0.2, 0.4}}},
                .fluid = water,
                .filled = {.high = {0.12, 0.12}},
                .walls = {floor_at(0, free_slip()), left_at(0, free_slip()), right_at(0.2, free_slip())},
                .body_force = {{0, -9.81}}};
/// Between plates, without ends.
const Water channel{.domain = {.box = {.high = {0.4, 0.2}}, .periodic_x = true},
                    .fluid = water,
                    .filled = {.high = {0.4, 0.2}},
                    .walls = {floor_at(0, no_slip()), ceiling_at(0.2, no_slip())},
                    .body_force = {{1, 0}}};

/// A method is made and does its steps; what its samples add up to is printed, so that it counts.
template <class Make>
void run(const char* name, const Make& make) {
  auto solver = make();
  for (int step = 0; step < 100; ++step) solver.step();
  const Samples s = solver.samples();
  std::printf("%s: %.15g\n", name, s.x.sum() + s.v.sum() + s.density.sum() + s.pressure.sum());
}

sph::Settings in_sph(double smoothing_length) {
  return {.spacing = spacing, .smoothing_length = smoothing_length, .time_step = 2e-4};
}

void run_sph() {
  const auto viscous = sph::momentum(sph::MonaghanClearyViscosity{.mu = water.viscosity});
  const auto free_surface = [&](const auto& parts) {
    return sph::free_surface<sph::WendlandC2, KickDriftKick>(dam, in_sph(h), viscous, parts);
  };
  const sph::Antuono diffusion{.delta = 0.1, .sound_speed = water.sound_speed(), .h = h};
  run("sph_delta", [&] { return free_surface(sph::Parts<sph::PressureSum, sph::Antuono>{{}, diffusion}); });
  run("sph_corrected", [&] {
    return free_surface(sph::Parts<sph::BonetLokPressure, sph::Antuono, sph::BonetLok>{{}, diffusion});
  });
  run("sph_shifted", [&] {
    return free_surface(sph::Parts<sph::PressureSum, sph::Antuono, sph::PlainGradient, sph::TangentialShifting>{
        {}, diffusion, {}, sph::TangentialShifting{spacing}});
  });
  const auto printed_terms =
      sph::momentum(sph::Pressure{}, sph::LaminarViscosity{.nu = water.kinematic_viscosity(), .eta = 0.12 * spacing});
  run("sph",
      [&] { return sph::printed<sph::CubicSpline, PredictorCorrector>(dam, in_sph(1.2 * spacing), printed_terms); });
  run("sph, single precision", [&] {
    return sph::printed<sph::CubicSpline, PredictorCorrector, float>(channel, in_sph(1.2 * spacing), printed_terms);
  });
  run("sph_transport_velocity", [&] {
    return sph::transport_velocity<sph::QuinticSpline>(
        channel, in_sph(spacing), sph::momentum(sph::Pressure{}, sph::MorrisViscosity{.mu = water.viscosity}));
  });
  run("sph_second_order", [] { return sph::second_order<sph::WendlandC2>(channel, in_sph(1.3 * spacing)); });
}

void run_mpm() {
  const mpm::Settings settings{.cell = 2 * spacing, .spacing = spacing, .time_step = 2e-4};
  run("mpm", [&] { return mpm::printed<mpm::PrescribedMotion>(dam, settings); });
  run("mpm, single precision", [&] { return mpm::printed<mpm::PrescribedMotion, float>(channel, settings); });
  run("mpm_affine", [&] { return mpm::in_lanes<mpm::QuadraticBSpline, mpm::MlsApic>(dam, settings); });
  run("mpm_least_squares", [&] { return mpm::least_squares(channel, settings); });
  run("mpm_apic", [&] { return mpm::in_lanes<mpm::BSpline<2>, mpm::Apic, mpm::AffineDensity>(dam, settings); });
  run("mpm_xpic", [&] { return mpm::in_lanes<mpm::BSpline<2>, mpm::Xpic<5>, mpm::AffineDensity>(dam, settings); });
  run("FLIP on B-splines",
      [&] { return mpm::in_lanes<mpm::BSpline<2>, mpm::Flip, mpm::CarriedDensity>(dam, settings); });
  run("cubic B-splines", [&] { return mpm::in_lanes<mpm::BSpline<3>, mpm::Apic, mpm::AffineDensity>(dam, settings); });
  run("mpm_gimp", [&] { return mpm::in_lanes<mpm::Gimp, mpm::Flip>(dam, settings); });
}

}  // namespace

int main() {
  run_sph();
  run_mpm();
}

#include "solvers/clock.hpp"

#include "solvers/mpm/affine.hpp"
#include "solvers/mpm/composed.hpp"
#include "solvers/mpm/least_squares.hpp"
#include "solvers/mpm/mpm.hpp"
#include "solvers/mpm/shapes/b_spline.hpp"
#include "solvers/mpm/transfers/apic.hpp"
#include "solvers/mpm/updates/modified_stress_last.hpp"
#include "solvers/sph/free_surface.hpp"
#include "solvers/sph/kernels/wendland_c2.hpp"
#include "solvers/sph/printed.hpp"
#include "solvers/sph/second_order.hpp"
#include "solvers/sph/terms/morris_viscosity.hpp"
#include "solvers/sph/terms/pressure_difference.hpp"
#include "solvers/sph/transport_velocity.hpp"
#include "solvers/testing.hpp"

namespace touchstone {
namespace {

struct Ticking : Clock {
  explicit Ticking(double time_step) : Clock("ticking", time_step) {}
  Ticking& after(int steps) {
    for (int k = 0; k < steps; ++k) tick();
    return *this;
  }
};

TEST(Clock, MultipliesWhereNobodyChangesTheStep) { EXPECT_EQ(Ticking(0.1).after(3).time(), 3 * 0.1); }

TEST(Clock, GoesOnInStepsOfAnotherLength) {
  Ticking clock(0.1);
  clock.after(10).change_time_step(0.25);
  EXPECT_EQ(clock.time(), 1);
  EXPECT_EQ(clock.after(4).time(), 2);
  EXPECT_EQ(clock.steps(), 14);
  EXPECT_EQ(clock.time_step(), 0.25);
}

TEST(Clock, RefusesAStepThatIsNotPositive) {
  EXPECT_THROW(Ticking(0), std::invalid_argument);
  EXPECT_THROW(Ticking(0.1).change_time_step(std::nan("")), std::invalid_argument);
}

const Scene<Newtonian> vortices = endless({.velocity = [](const Vec2& x) -> Vec2 {
  const Vec2 k = 2 * std::numbers::pi * x;
  return {std::cos(k.x()) * std::sin(k.y()), -std::sin(k.x()) * std::cos(k.y())};
}});

constexpr double spacing = 0.05;
const mpm::Settings grid{.cell = 0.1, .spacing = spacing, .time_step = 1e-3};
const sph::Settings cloud{.spacing = spacing, .smoothing_length = 1.3 * spacing, .time_step = 1e-3};

/// Calls f(solver) for each kind of solver.
template <class F>
void for_each_solver(const F& f) {
  const auto terms = sph::momentum(sph::PressureDifference{}, sph::MorrisViscosity{.mu = oil.viscosity});
  f("printed MPM", mpm::solver<mpm::LinearHat, mpm::PrescribedMotion>(vortices, grid));
  f("affine MPM", mpm::affine(vortices, grid));
  f("composed MPM", mpm::composed<mpm::BSpline<2>, mpm::Apic, mpm::ModifiedStressLast>(vortices, grid));
  f("least squares MPM", mpm::least_squares(vortices, grid));
  f("printed SPH", sph::printed<sph::WendlandC2>(vortices, cloud, terms));
  f("transport velocity SPH", sph::transport_velocity<sph::WendlandC2>(vortices, cloud, terms));
  f("free surface SPH", sph::free_surface<sph::WendlandC2>(vortices, cloud, terms, sph::Parts{}));
  f("second order SPH", sph::second_order<sph::WendlandC2>(vortices, cloud));
}

/// So many steps of one length [s], then of another.
template <class Solver>
Samples after(Solver solver, int steps, int more, double of) {
  for (int k = 0; k < steps; ++k) solver.step();
  solver.change_time_step(of);
  for (int k = 0; k < more; ++k) solver.step();
  return solver.samples();
}

TEST(Clock, EachSolverMayChangeItsStepAndLosesLittle) {
  for_each_solver([](const char* name, const auto& solver) {
    const Samples even = after(solver, 20, 20, 1e-3), changed = after(solver, 20, 40, 5e-4),
                  halves = after(solver, 0, 80, 5e-4);
    EXPECT_NEAR(changed.time, 0.04, 1e-12) << name;
    const double between = (even.v - halves.v).norm();  // much for affine velocities, which each step damps
    EXPECT_LT((changed.v - halves.v).norm(), std::max(between, 0.005 * halves.v.norm())) << name;
  });
}

TEST(Extremes, AreThoseOfTheSamples) {
  for_each_solver([](const char* name, auto solver) {
    for (int k = 0; k < 20; ++k) solver.step();
    const Samples all = solver.samples();
    const Extremes seen = solver.extremes();
    EXPECT_NEAR(seen.speed, all.v.colwise().norm().maxCoeff(), 1e-12) << name;
    EXPECT_NEAR(seen.density, all.density.maxCoeff(), 1e-9) << name;
  });
}

}  // namespace
}  // namespace touchstone

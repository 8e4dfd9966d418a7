#include "solvers/forces/uniform.hpp"
#include "solvers/mpm/composed/composed.hpp"
#include "solvers/mpm/composed/densities/affine_density.hpp"
#include "solvers/mpm/composed/transfers/apic.hpp"
#include "solvers/mpm/composed/transfers/flip.hpp"
#include "solvers/mpm/composed/transfers/xpic.hpp"
#include "solvers/mpm/shapes/b_spline.hpp"
#include "solvers/mpm/shapes/gimp.hpp"
#include "solvers/mpm/shapes/linear_hat.hpp"
#include "solvers/testing.hpp"
#include "solvers/walls/free_slip.hpp"
#include "solvers/walls/no_slip.hpp"

namespace touchstone::mpm {
namespace {

/// By how much the flow between plates that is driven along them is wrong once it is steady (L2).
template <class Shape, class Transfer>
double error_between_plates() {
  constexpr double nu = 0.02, F = 0.1, V = 0.03;  // m²/s, m/s², m/s
  const Scene<Newtonian, Uniform> channel{.domain = {.box = {.high = {0.4, 1}}, .periodic_x = true},
                                          .fluid = {{.density = 1000, .bulk_modulus = 143}, 1000 * nu},
                                          .filled = {.high = {0.4, 1}},
                                          .walls = {floor_at(0, no_slip()), ceiling_at(1, no_slip({V, 0}))},
                                          .body_force = {{F, 0}}};
  auto flow = composed<Shape, Transfer>(channel, {.cell = 0.1, .spacing = 0.05, .time_step = 0.05});
  while (flow.time() < 50) flow.step();  // a diffusion time
  const Samples s = flow.samples();
  double wrong = 0, all = 0;
  for (Index p = 0; p < s.size(); ++p) {
    const double y = s.x(1, p), steady = F / (2 * nu) * y * (1 - y) + V * y;
    wrong += std::pow(s.v(0, p) - steady, 2);
    all += steady * steady;
  }
  return std::sqrt(wrong / all);
}

TEST(ComposedMpm, FlowsBetweenPlatesAsWellAsItsTransferLetsIt) {
  EXPECT_LT((error_between_plates<LinearHat, Flip>()), 0.015);
  EXPECT_LT((error_between_plates<Gimp, Flip>()), 0.015);
  EXPECT_LT((error_between_plates<BSpline<2>, Flip>()), 0.09);
  EXPECT_LT((error_between_plates<BSpline<3>, Flip>()), 0.16);
  EXPECT_LT((error_between_plates<BSpline<2>, Xpic<5>>()), 0.12);
  EXPECT_GT((error_between_plates<BSpline<2>, Xpic<1>>()), 0.5);
}

/// A column of water 1 m deep in a tank, under its own weight: each particle where it rests, with the pressure of the
/// water above it.
Scene<Tait, Uniform> column() {
  constexpr double g = 9.81, rho = 1000, depth = 1, c = 31.3, K = rho * c * c / 7, power = 7.0 / 6;
  const auto height_over = [=](double p) { return power * K / (rho * g) * std::expm1(std::log1p(p / K) / power); };
  const double surface = height_over(rho * g * depth);
  return {.domain = {.box = {.high = {0.3, 1.2}}},
          .fluid = {.density = rho, .bulk_modulus = K},
          .filled = {.high = {0.3, depth}},
          .walls = {floor_at(0, free_slip()), left_at(0, free_slip()), right_at(0.3, free_slip())},
          .body_force = {{0, -g}},
          .start = {.pressure =
                        [=](const Vec2& x) {
                          const double below = std::max(surface - x.y(), 0.0);
                          return K * std::expm1(power * std::log1p(rho * g * below / (power * K)));
                        },
                    .places = [=](const Vectors& lattice) -> Vectors {
                      Vectors places = lattice;
                      for (Index p = 0; p < places.cols(); ++p)
                        places(1, p) = surface - height_over(rho * g * (depth - lattice(1, p)));
                      return places;
                    }}};
}

template <class Transfer>
void expect_rest() {
  auto resting =
      composed<BSpline<2>, Transfer, AffineDensity>(column(), {.cell = 0.1, .spacing = 0.05, .time_step = 1.5e-3});
  const Samples start = resting.samples();
  while (resting.time() < 1) resting.step();
  const Samples end = resting.samples();
  EXPECT_LT((end.pressure - start.pressure).matrix().norm(), 0.01 * start.pressure.matrix().norm());
  EXPECT_LT((end.x - start.x).colwise().norm().maxCoeff(), 0.002);  // m
  EXPECT_LT(0.5 * end.v.squaredNorm() / static_cast<double>(end.size()), 1e-6 * 0.5 * 9.81);
}

TEST(AffineDensity, BearsItsWeightUnderAFreeSurface) {
  expect_rest<Apic>();
  expect_rest<Xpic<5>>();
}

/// By how much the velocity and the pressure of decaying vortices are wrong (L2; Taylor 1923).
template <class Density>
Vec2 errors_of_vortices() {
  constexpr double c = 40, rho = 1000, nu = 0.01, k = 2 * std::numbers::pi;
  const auto velocity = [](const Vec2& x) -> Vec2 {
    return {-std::cos(k * x.x()) * std::sin(k * x.y()), std::sin(k * x.x()) * std::cos(k * x.y())};
  };
  const auto pressure = [](const Vec2& x) { return -rho / 4 * (std::cos(2 * k * x.x()) + std::cos(2 * k * x.y())); };
  Scene<Newtonian> scene = endless({.velocity = velocity, .pressure = pressure});
  scene.fluid = {{.density = rho, .bulk_modulus = rho * c * c / 7}, rho * nu};
  auto vortices = composed<BSpline<2>, Xpic<5>, Density>(scene, {.cell = 0.05, .spacing = 0.025, .time_step = 6.25e-4});
  while (vortices.steps() < 160) vortices.step();
  const Samples s = vortices.samples();
  const double left = std::exp(-2 * nu * k * k * s.time), mean = s.pressure.mean();
  double v_wrong = 0, v_all = 0, p_wrong = 0, p_all = 0;
  for (Index p = 0; p < s.size(); ++p) {
    const Vec2 v = left * velocity(s.x.col(p));
    const double expected = left * left * pressure(s.x.col(p));
    v_wrong += (s.v.col(p) - v).squaredNorm();
    v_all += v.squaredNorm();
    p_wrong += std::pow(s.pressure[p] - mean - expected, 2);
    p_all += expected * expected;
  }
  return {std::sqrt(v_wrong / v_all), std::sqrt(p_wrong / p_all)};
}

TEST(AffineDensity, TakesTheNoiseOutOfThePressureOfVortices) {
  const Vec2 carried = errors_of_vortices<CarriedDensity>(), affine = errors_of_vortices<AffineDensity>();
  EXPECT_LT(affine.y(), 0.3);
  EXPECT_LT(affine.y(), carried.y() / 4);
  EXPECT_LT(affine.x(), 0.02);
  EXPECT_LT(affine.x(), carried.x());
}

TEST(AffineDensity, LeavesALinearFieldAsItIsUpToWallsAndKeepsTheVolume) {
  const Grid grid({.box = {.high = {1, 1}}}, 0.1);
  const Vec2 gradient(0.02, -0.03);
  constexpr int n = 400;
  PlainParticles particles{.mass = 1,
                           .x = Vectors(2, n),
                           .v = Vectors::Zero(2, n),
                           .expansion = Scalars(n),
                           .slopes = {n, Slopes<double>{}}};
  for (int p = 0; p < n; ++p) {
    particles.x.col(p) = Vec2(std::fmod(0.618034 * p, 1), std::fmod(0.7548777 * p, 0.55));
    particles.expansion[p] = 0.01 + gradient.dot(particles.x.col(p));
  }
  const Scalars start = particles.expansion;
  Weights<BSpline<2>> weights(grid, Vec2(0.05, 0.05));
  PlainNodes nodes(weights.nodes());
  weights.find(particles.x, 1);
  scatter_mass(weights, 1, nodes);
  AffineDensity density;
  density.begin(particles, gradient.replicate(1, n));
  density.update(weights, nodes, 1e-3, 1, particles);
  EXPECT_LT((particles.expansion - start).abs().maxCoeff(), 1e-12);

  for (int p = 0; p < n; ++p) particles.expansion[p] = 0.01 * std::sin(1.0 * p);
  const double volume = particles.expansion.sum();
  density.update(weights, nodes, 1e-3, 1, particles);
  EXPECT_LT(particles.expansion.abs().maxCoeff(), 0.009);  // smoothed
  EXPECT_NEAR(particles.expansion.sum(), volume, 1e-12);
}

}  // namespace
}  // namespace touchstone::mpm

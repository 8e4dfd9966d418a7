#include "solvers/sph/free_surface/kick_drift_kick_with_budget.hpp"

#include "solvers/forces/uniform.hpp"
#include "solvers/sph/free_surface/diffusion/antuono.hpp"
#include "solvers/sph/free_surface/free_surface.hpp"
#include "solvers/sph/free_surface/gradients/bonet_lok.hpp"
#include "solvers/sph/free_surface/shifting/tangential.hpp"
#include "solvers/sph/kernels/wendland_c2.hpp"
#include "solvers/sph/terms/artificial_viscosity.hpp"
#include "solvers/sph/terms/bonet_lok_pressure.hpp"
#include "solvers/testing.hpp"
#include "solvers/walls/free_slip.hpp"

namespace touchstone::sph {
namespace budget_test {

constexpr double spacing = 0.05, h = 2 * spacing, c = 30, g = 9.81;
constexpr double potential = 1000 * 0.5 * 0.5 * g * 0.5 / 2;  // J/m  that the column begins with
constexpr Antuono diffusion{.sound_speed = c, .h = h};
constexpr Parts delta(PressureSum{}, diffusion);
constexpr Parts shifted(PressureSum{}, diffusion, PlainGradient{}, TangentialShifting{spacing});
constexpr Parts corrected(BonetLokPressure{}, diffusion, BonetLok{});

/// A column of water that meets the far wall at about 0.3 s.
const Scene<Tait, Uniform> dam{
    .domain = {.box = {.high = {1, 4}}},
    .fluid = {.density = 1000, .bulk_modulus = 1000 * c * c / 7},
    .filled = {.high = {0.5, 0.5}},
    .walls = {floor_at(0, free_slip()), left_at(0, free_slip()), right_at(1, free_slip())},
    .body_force = {{0, -g}},
    .start = {.pressure = [](const Vec2& x) { return 1000 * g * (0.5 - x.y()); }},
};
constexpr int steps = 600;  // of 1 ms

template <class Integrator>
auto solver(const auto& parts, double alpha = 0.02) {
  return free_surface<WendlandC2, Integrator>(dam, {.spacing = spacing, .smoothing_length = h, .time_step = 0.001},
                                              momentum(ArtificialViscosity{.alpha = alpha, .sound_speed = c, .h = h}),
                                              parts);
}
template <class PartsOfMethod>
EnergyBudget budget_of(const PartsOfMethod& parts, double alpha = 0.02) {
  auto simulation = solver<KickDriftKickWithBudget>(PartsWithBudget<PartsOfMethod>{parts}, alpha);
  for (int k = 0; k < steps; ++k) simulation.step();
  return *simulation.integrator().budget;
}

template <class PartsOfMethod>
void expect_the_same_run(const PartsOfMethod& parts) {
  auto plain = solver<KickDriftKick>(parts);
  auto with_budget = solver<KickDriftKickWithBudget>(PartsWithBudget<PartsOfMethod>{parts});
  for (int k = 0; k < steps; ++k) plain.step(), with_budget.step();
  const Samples a = plain.samples(), b = with_budget.samples();
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.v, b.v);
  EXPECT_TRUE((a.density == b.density).all());
}

TEST(EnergyBudgetOfSph, KeepingItChangesNoBitOfARun) {
  expect_the_same_run(delta);
  expect_the_same_run(shifted);
  expect_the_same_run(corrected);
}

TEST(EnergyBudgetOfSph, AccountsForAllEnergyButRounding) {
  for (const EnergyBudget& budget : {budget_of(delta), budget_of(shifted), budget_of(corrected)}) {
    EXPECT_NEAR(budget.start.total(), potential, 0.01 * potential);
    EXPECT_LT(budget.now.total(), 0.99 * budget.start.total());
    EXPECT_NEAR(budget.residual(), 0, 1e-12 * potential);
  }
}

TEST(EnergyBudgetOfSph, PartsThatAMethodDoesNotHaveAddNothing) {
  const EnergyBudget without_shifting = budget_of(delta), with_shifting = budget_of(shifted);
  EXPECT_NEAR(without_shifting.shifting, 0, 1e-14 * potential);
  EXPECT_EQ(without_shifting.transfer, 0);
  EXPECT_GT(std::abs(with_shifting.shifting), 1e-6 * potential);
  EXPECT_EQ(budget_of(delta, 0).viscosity, 0);
}

TEST(EnergyBudgetOfSph, ViscosityDiffusionAndContactTakeEnergy) {
  const EnergyBudget budget = budget_of(delta);
  EXPECT_LT(budget.viscosity, -0.01 * potential);
  EXPECT_LT(budget.smoothing, 0);
  EXPECT_LT(budget.walls, 0);
  EXPECT_GT(budget_of(delta, 0.01).viscosity, budget.viscosity);
}

/// By how much the energy of a single particle that flies against a wall changes, over what it has, while it bounces
/// off the ghosts there.
template <class PartsOfMethod>
double change_in_a_bounce(const PartsOfMethod& parts) {
  Scene<Tait, Uniform> scene = dam;
  scene.filled = {.low = {0.3, 0.5}, .high = {0.3 + spacing, 0.5 + spacing}};
  scene.walls = {left_at(0, free_slip())};
  scene.body_force = {{0, 0}};
  scene.start = {.velocity = [](const Vec2&) -> Vec2 { return {-5, 0}; }};
  auto simulation = free_surface<WendlandC2, KickDriftKickWithBudget>(
      scene, {.spacing = spacing, .smoothing_length = h, .time_step = 5e-5},
      momentum(ArtificialViscosity{.alpha = 0, .sound_speed = c, .h = h}), PartsWithBudget<PartsOfMethod>{parts});
  double most = 0;
  const EnergyBudget& budget = *simulation.integrator().budget;
  for (int k = 0; k < 2400; ++k) {
    simulation.step();
    most = std::max(most, std::abs(budget.now.total() - budget.start.total()) / budget.start.total());
  }
  EXPECT_GT(simulation.samples().v(0, 0), 0);
  return most;
}

TEST(EnergyBudgetOfSph, ADropThatBouncesOffAWallKeepsItsEnergyAllTheWhile) {
  EXPECT_LT(change_in_a_bounce(delta), 0.02);
  EXPECT_LT(change_in_a_bounce(shifted), 0.02);
  EXPECT_LT(change_in_a_bounce(corrected), 0.02);
}

/// What a head-on collision of two single particles adds to their energy, over what they have, in steps in which sound
/// travels so many spacings.
template <class PartsOfMethod>
double gain_in_a_collision(const PartsOfMethod& parts, double courant) {
  Scene<Tait, Uniform> scene = dam;
  scene.filled = {.low = {0.3, 0.5}, .high = {0.3 + 2 * spacing, 0.5 + spacing}};
  scene.walls = {};
  scene.body_force = {{0, 0}};
  scene.start = {.velocity = [](const Vec2& x) -> Vec2 {
                   return {x.x() < 0.45 ? 3 : -3, 0};
                 },
                 .places =
                     [](const Vectors& lattice) {
                       Vectors apart = lattice;
                       apart.row(0) << 0.3, 0.6;
                       return apart;
                     }};
  auto simulation = free_surface<WendlandC2, KickDriftKickWithBudget>(
      scene, {.spacing = spacing, .smoothing_length = h, .time_step = courant * spacing / c},
      momentum(ArtificialViscosity{.alpha = 0, .sound_speed = c, .h = h}), PartsWithBudget<PartsOfMethod>{parts});
  while (simulation.time() < 0.1) simulation.step();
  const Samples after = simulation.samples();
  EXPECT_LT(after.v(0, 0) * after.v(0, 1), 0);
  EXPECT_LT((after.x(0, 0) - after.x(0, 1)) * (after.v(0, 1) - after.v(0, 0)), 0) << "they have not parted";
  const EnergyBudget& budget = *simulation.integrator().budget;
  return budget.now.total() / budget.start.total() - 1;
}

TEST(EnergyBudgetOfSph, CorrectedGradientsAddNoMoreEnergyToACollisionThanPlainOnes) {
  const double plain = gain_in_a_collision(delta, 1);
  EXPECT_LT(plain, 0.09);
  EXPECT_LT(gain_in_a_collision(delta, 0.5), 0.5 * plain) << "of first order in the time step";
  EXPECT_LT(gain_in_a_collision(corrected, 1), 1.01 * plain);
}

}  // namespace budget_test
}  // namespace touchstone::sph

#include "solvers/forces/uniform.hpp"
#include "solvers/sph/kernels/cubic_spline.hpp"
#include "solvers/sph/kernels/quintic_spline.hpp"
#include "solvers/sph/printed/printed.hpp"
#include "solvers/sph/terms/artificial_viscosity.hpp"
#include "solvers/sph/terms/laminar_viscosity.hpp"
#include "solvers/sph/terms/morris_viscosity.hpp"
#include "solvers/sph/terms/pressure.hpp"
#include "solvers/sph/terms/pressure_difference.hpp"
#include "solvers/sph/transport_velocity/transport_velocity.hpp"
#include "solvers/walls/free_slip.hpp"
#include "solvers/walls/no_slip.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace touchstone::sph {
namespace {

constexpr double width = 0.4 * mm, height = 0.5 * mm, spacing = 0.025 * mm, h = 1.2 * spacing;
constexpr Newtonian water{{.density = 1000, .bulk_modulus = 143}, 1e-3};
const Box box{.high = {width, height}};
const Domain channel{.box = box, .periodic_x = true};
const std::vector<Wall> plates = {floor_at(0, no_slip()), ceiling_at(height, no_slip({1, 0}))};
const Settings settings{.spacing = spacing, .smoothing_length = h, .time_step = 5 * us};

auto terms() {
  return momentum(Pressure{}, LaminarViscosity{.nu = 1e-6, .eta = 0.1 * h},
                  ArtificialViscosity{.alpha = 0.01, .sound_speed = water.sound_speed(), .h = h});
}

using Near = Neighbourhood<Record<double>>;
using Single = One<Record<double>>;

/// Writes the records of the fluid from its fields and the pressures [Pa] given.
void see(Near& near, const Scalars& pressure) {
  for (Index i = 0; i < near.all.fluid; ++i) {
    near.seen[i].stand_at(near.all.x[i], near.all.y[i]);
    near.seen[i].move(near.all.vx[i], near.all.vy[i]);
    near.seen[i].set_state(near.all.rho[i], pressure[i]);
  }
  near.images.refresh_fluid(near.all, near.seen);
  near.images.refresh_boundary(near.all, near.seen);
}

/// Fluid in disorder between plates, with its lists.
Near disordered(const Domain& domain, const std::vector<Wall>& walls) {
  Near near(Scene<Newtonian>{.domain = domain, .fluid = water, .filled = box}, spacing,
            {.kernel = 2 * h, .wall = 1.12 * spacing, .skin = 0.6 * spacing},
            lay_out_ghosts_and_walls(domain, walls, spacing, 2));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> jitter(-1, 1);
  Particles& all = near.all;
  Scalars pressure(all.fluid);
  for (Index i = 0; i < all.fluid; ++i) {
    all.x[i] += 0.13 * spacing * jitter(random);  // within what the skin allows
    all.y[i] += 0.13 * spacing * jitter(random);
    all.vx[i] = jitter(random);
    all.vy[i] = jitter(random);
    all.rho[i] = 1000 + jitter(random);
    pressure[i] = jitter(random);
  }
  see(near, pressure);
  return near;
}

double apart(const Near& near, Index i, Index j) {
  return distance(Single{near.seen.data(), i}, Single{near.seen.data(), j});
}

/// The neighbours of a particle closer than `reach` [m], in the order of its list.
std::vector<int> listed(const Near& near, Index i, double reach) {
  constexpr int side_by_side = Near::width;
  std::vector<int> found;
  for (const auto& block : near.fluid_near_fluid.parts[0].blocks) {
    const auto rows = near.fluid_near_fluid.parts[0].rows_of(block);
    for (int lane = 0; lane < block.particles; ++lane)
      for (std::size_t at = side_by_side + lane; rows[lane] == i && at < rows.size(); at += side_by_side)
        if (apart(near, i, rows[at]) < reach) found.push_back(rows[at]);
  }
  return found;
}
std::multiset<int> sorted(const std::vector<int>& numbers) { return {numbers.begin(), numbers.end()}; }

/// Particles i and j by the plain formula, for the loop that runs several of them.
Pair<double> pair_at(const Near& near, Index i, Index j) {
  return pair_of(Single{near.seen.data(), i}, Single{near.seen.data(), j}, near.all.mass, Slope<CubicSpline>(h));
}

TEST(Neighbours, LinkedCellsFindWhatAllPairsFindAlsoBeyondTheSeam) {
  const Near near = disordered(channel, plates);
  const Particles& all = near.all;
  ASSERT_GT(all.images, 0);
  for (Index i = 0; i < all.fluid; ++i) {
    std::multiset<int> expected;
    for (Index j = 0; j < all.nowhere(); ++j) {
      const Index source = j < all.fluid + all.boundary ? j : near.images.source(j - near.images.first(all));
      const bool on_wall = source >= all.fluid + near.ghosts();
      if (j != i && !on_wall && apart(near, i, j) < 2 * h) expected.insert(static_cast<int>(j));
    }
    ASSERT_EQ(sorted(listed(near, i, 2 * h)), expected) << "particle " << i;
  }
}

TEST(Neighbours, SumOverLanesEqualsAPlainLoop) {
  const Near near = disordered(channel, plates);
  const Particles& all = near.all;
  const auto pull_of = terms();
  Scalars ax(all.fluid), ay(all.fluid);
  sum_over_neighbours<2>(
      near.fluid_near_fluid, near.seen,
      [&](const auto& i, const auto& j) {
        auto ij = pair_of(i, j, all.mass);
        const auto pull = pull_of.on(ij, Slope<CubicSpline>(h));
        return std::array{pull.x, pull.y};
      },
      [&](Index i, const std::array<double, 2>& sums) { ax[i] = sums[0], ay[i] = sums[1]; });
  for (Index i = 0; i < all.fluid; ++i) {
    Pull<double> plain;
    for (const int j : listed(near, i, 2 * h))
      std::apply([&](const auto&... term) { ((plain += term(pair_at(near, i, j))), ...); }, pull_of.terms);
    EXPECT_NEAR(ax[i], plain.x, 1e-9 * std::abs(plain.x) + 1e-9);
    EXPECT_NEAR(ay[i], plain.y, 1e-9 * std::abs(plain.y) + 1e-9);
  }
}

template <class Term>
void expect_action_equals_reaction(const Term& term) {
  const Near near = disordered({.box = box}, {});
  double largest = 0;
  for (Index i = 0; i < near.all.fluid; ++i)
    for (const int j : listed(near, i, 2 * h)) {
      const Pull<double> there = term(pair_at(near, i, j)), back = term(pair_at(near, j, i));
      const double size = std::hypot(there.x, there.y);
      largest = std::max(largest, size);
      EXPECT_NEAR(there.x, -back.x, 1e-12 * size);
      EXPECT_NEAR(there.y, -back.y, 1e-12 * size);
    }
  EXPECT_GT(largest, 0);
}

TEST(Terms, ActionEqualsReaction) {
  expect_action_equals_reaction(Pressure{});
  expect_action_equals_reaction(LaminarViscosity{.nu = 1e-6, .eta = 0.1 * h});
  expect_action_equals_reaction(MorrisViscosity{.mu = 1e-3});
  expect_action_equals_reaction(ArtificialViscosity{.alpha = 0.01, .sound_speed = 1, .h = h});
}

TEST(Terms, PressureDifferenceIsNoForceInAUniformPressure) {
  Near near = disordered({.box = box}, {});
  see(near, Scalars::Constant(near.all.fluid, 12345));
  for (const int j : listed(near, 40, 2 * h)) {
    const Pull<double> pull = PressureDifference{}(pair_at(near, 40, j));
    EXPECT_EQ(pull.x, 0);
    EXPECT_EQ(pull.y, 0);
  }
}

TEST(Terms, PressureDifferencePushesTowardsTheLowerPressure) {
  Pair<double> ij{};
  ij.x = spacing;  // i is to the right of j
  ij.slope = -1;
  ij.volume_i = ij.volume_j = 1e-3;
  ij.mass = 1;
  ij.p_j = 1;  // j presses
  EXPECT_GT(PressureDifference{}(ij).x, 0);
}

TEST(Terms, ViscosityTakesEnergyFromEveryPair) {
  const Near near = disordered({.box = box}, {});
  const LaminarViscosity laminar{.nu = 1e-6, .eta = 0.1 * h};
  const ArtificialViscosity artificial{.alpha = 0.01, .sound_speed = 1, .h = h};
  for (const int j : listed(near, 40, 2 * h)) {
    const Pair<double> ij = pair_at(near, 40, j);
    const auto power = [&](const Pull<double>& pull) { return pull.x * ij.vx + pull.y * ij.vy; };
    EXPECT_LT(power(laminar(ij)), 0);
    EXPECT_LE(power(artificial(ij)), 0);
  }
}

TEST(Terms, ArtificialViscosityLeavesPartingPairsAlone) {
  Pair<double> ij{};
  ij.x = spacing;
  ij.r2 = spacing * spacing;
  ij.slope = -1;
  ij.vx = 1;  // parting
  ij.rho_i = ij.rho_j = 1000;
  ij.mass = 1;
  const ArtificialViscosity term{.alpha = 0.01, .sound_speed = 1, .h = h};
  EXPECT_EQ(term(ij).x, 0);
  ij.vx = -1;  // closing in: pushed apart
  EXPECT_GT(term(ij).x, 0);
}

TEST(Ghosts, MirrorTheVelocityAtEachWall) {
  const std::vector<Wall> walls = {floor_at(0, no_slip({3, 0})), ceiling_at(height, free_slip())};
  Near near = disordered(channel, walls);
  Particles& all = near.all;
  all.vx = 1;
  all.vy = 0.5;
  see(near, Scalars::Zero(all.fluid));
  mirror_to_ghosts<CubicSpline>(near, walls, h, 1000, 0);
  for (Index k = 0; k < near.ghosts(); ++k) {
    const bool below = near.boundary.ghosts[k].x.y() < 0;
    EXPECT_NEAR(near.seen[all.fluid + k].vx, below ? 5 : 1, 1e-9);
    EXPECT_NEAR(near.seen[all.fluid + k].vy, -0.5, 1e-9);
  }
}

TEST(Ghosts, FillTwoLayersBehindEachWallAndTheCorners) {
  const std::vector<Wall> tank = {floor_at(0, free_slip()), left_at(0, free_slip())};
  const BoundaryLayout layout = lay_out_ghosts_and_walls({.box = box}, tank, spacing, 2);
  EXPECT_EQ(layout.ghosts.size(), 16u * 2 + 20u * 2 + 4);
  EXPECT_EQ(layout.on_walls.size(), 16u + 20u);
  EXPECT_EQ(layout.on_upright, 20u);
  EXPECT_EQ(std::ranges::count_if(layout.ghosts, [](const auto& ghost) { return ghost.behind.size() == 2; }), 4);
}

TEST(Ghosts, CountIsThatOfThePaperInTheChannel) {
  const Box gap{.high = {0.5 * mm, 1 * mm}};
  const std::vector<Wall> walls = {floor_at(0, no_slip()), ceiling_at(1 * mm, no_slip())};
  const BoundaryLayout layout = lay_out_ghosts_and_walls({.box = gap, .periodic_x = true}, walls, spacing, 2);
  EXPECT_EQ(layout.ghosts.size() + layout.on_walls.size(), 120u);  // Sun et al., table 2, S1
}

const Scene<Newtonian, Uniform> falling{.domain = channel,
                                        .fluid = water,
                                        .filled = box,
                                        .walls = {floor_at(0, free_slip()), ceiling_at(height, free_slip())},
                                        .body_force = {{8e-3, 0}}};

TEST(Printed, FluidBetweenSlippingWallsFallsFreelyAcrossTheSeam) {
  auto solver = printed<CubicSpline>(falling, settings, terms());
  for (int k = 0; k < 400; ++k) solver.step();
  const Samples samples = solver.samples();
  EXPECT_NEAR(samples.v.row(0).minCoeff(), 8e-3 * solver.time(), 1e-12);
  EXPECT_NEAR(samples.v.row(0).maxCoeff(), 8e-3 * solver.time(), 1e-12);
}

TEST(TransportVelocity, FluidBetweenSlippingWallsFallsFreelyAcrossTheSeam) {
  auto solver = transport_velocity<QuinticSpline>(falling, {spacing, spacing, 5 * us},
                                                  momentum(PressureDifference{}, MorrisViscosity{1e-3}));
  for (int k = 0; k < 100; ++k) solver.step();  // before the square lattice turns into a denser one
  const Samples samples = solver.samples();
  EXPECT_NEAR(samples.v.row(0).minCoeff(), 8e-3 * solver.time(), 1e-9);
  EXPECT_NEAR(samples.v.row(0).maxCoeff(), 8e-3 * solver.time(), 1e-9);
}

TEST(Printed, StillWaterStaysStill) {
  const Scene<Newtonian> still{.domain = channel,
                               .fluid = water,
                               .filled = box,
                               .walls = {floor_at(0, no_slip()), ceiling_at(height, no_slip())}};
  auto solver = printed<CubicSpline>(still, settings, terms());
  for (int k = 0; k < 200; ++k) solver.step();
  EXPECT_LT(solver.samples().v.cwiseAbs().maxCoeff(), 1e-12);
}

TEST(TransportVelocity, TwoRunsAreBitEqual) {
  const Scene<Newtonian, Uniform> scene{
      .domain = channel, .fluid = water, .filled = box, .walls = plates, .body_force = {{8e-3, 0}}};
  const auto run = [&] {
    auto solver = transport_velocity<QuinticSpline>(scene, {spacing, spacing, 5 * us},
                                                    momentum(PressureDifference{}, MorrisViscosity{1e-3}));
    for (int k = 0; k < 300; ++k) solver.step();
    return solver.samples();
  };
  const Samples first = run(), second = run();
  EXPECT_EQ(first.x, second.x);
  EXPECT_EQ(first.v, second.v);
}

TEST(TransportVelocity, KeepsTheVolumeOfItsFluid) {
  auto solver = transport_velocity<QuinticSpline>(falling, {spacing, spacing, 5 * us},
                                                  momentum(PressureDifference{}, MorrisViscosity{1e-3}));
  for (int k = 0; k < 300; ++k) solver.step();
  EXPECT_NEAR(solver.samples().volumes().sum(), width * height, 1e-12 * width * height);
}

TEST(Printed, RefusesAPeriodShorterThanItsListsAndWallsOffTheDomain) {
  Scene<Newtonian, Uniform> narrow = falling;
  narrow.domain.box.high.x() = narrow.filled.high.x() = 2 * spacing;
  EXPECT_THROW(printed<CubicSpline>(narrow, settings, terms()), std::invalid_argument);
  Scene<Newtonian, Uniform> raised = falling;
  raised.walls[0].position = 0.1 * height;
  EXPECT_THROW(printed<CubicSpline>(raised, settings, terms()), std::invalid_argument);
}

TEST(Printed, TwoRunsAreBitEqual) {
  const Scene<Newtonian, Uniform> scene{
      .domain = channel, .fluid = water, .filled = box, .walls = plates, .body_force = {{8e-3, 0}}};
  const auto run = [&] {
    auto solver = printed<CubicSpline>(scene, settings, terms());
    for (int k = 0; k < 300; ++k) solver.step();
    return solver.samples();
  };
  const Samples first = run(), second = run();
  EXPECT_EQ(first.x, second.x);
  EXPECT_EQ(first.v, second.v);
  EXPECT_TRUE((first.density == second.density).all());
}

/// A force that is no number for one particle from a time on.
struct Poison {
  Vec2 at;
  double from;  // s
  Vec2 operator()(const Vec2& x, double time) const {
    return time >= from && (x - at).norm() < 0.2 * spacing ? Vec2(0, std::nan("")) : Vec2(0, 0);
  }
};

TEST(Printed, AParticleThatIsNoNumberIsNamedWithItsStep) {
  const Vec2 at(3.5 * spacing, 4.5 * spacing);  // column 3 of row 4: number 4 * 16 + 3
  const Scene<Newtonian, Poison> scene{
      .domain = channel, .fluid = water, .filled = box, .walls = plates, .body_force = {at, 20 * us}};
  auto solver = printed<CubicSpline>(scene, settings, terms());
  try {
    for (int k = 0; k < 100; ++k) solver.step();
    FAIL() << "expected Diverged";
  } catch (const Diverged& diverged) {
    EXPECT_EQ(diverged.fault.particle, 67);
    EXPECT_EQ(diverged.fault.step, 5);  // poisoned in the step from 20 us on, which is the fifth
    EXPECT_TRUE(std::isnan(diverged.fault.value));
  }
}

TEST(Printed, RefusesSettingsThatAreNoNumbersOfTheirKind) {
  const auto make = [](Settings bad) { return printed<CubicSpline>(falling, bad, terms()); };
  EXPECT_THROW(make({-spacing, h, 5 * us}), std::invalid_argument);
  EXPECT_THROW(make({spacing, 0, 5 * us}), std::invalid_argument);
  EXPECT_THROW(make({spacing, h, std::nan("")}), std::invalid_argument);
  EXPECT_THROW(make({10 * mm, h, 5 * us}), std::invalid_argument);  // larger than the box
}

TEST(Repulsion, PushesOnlyFluidThatCameCloserAndEvenlyAlongTheWall) {
  const SoftRepulsion<1> term{.sound_speed = 1, .spacing = spacing};
  const auto push_at = [&](double x, double y) {
    double sum = 0;
    for (int k = -3; k <= 3; ++k) {
      Pair<double> ij{};
      ij.x = x - k * spacing;
      ij.y = y;
      EXPECT_EQ(term(ij).x, 0);
      sum += term(ij).y;
    }
    return sum;
  };
  EXPECT_EQ(push_at(0, 0.5 * spacing), 0);
  EXPECT_GT(push_at(0, 0.4 * spacing), 0);
  EXPECT_NEAR(push_at(0.3 * spacing, 0.2 * spacing), push_at(0, 0.2 * spacing), 1e-9 * push_at(0, 0.2 * spacing));
}

TEST(RestoreDensity, KeepsAConstantDensityAlsoAtASurface) {
  Near near = disordered({.box = box}, {});
  near.all.rho = 1000;
  near.all.mass = 1000 * spacing * spacing;
  see(near, Scalars::Zero(near.all.fluid));
  restore_density<CubicSpline>(near, h);
  EXPECT_NEAR(near.all.rho.minCoeff(), 1000, 1e-9);
  EXPECT_NEAR(near.all.rho.maxCoeff(), 1000, 1e-9);
}

}  // namespace
}  // namespace touchstone::sph

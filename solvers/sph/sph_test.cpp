#include "solvers/sph/free_surface/surroundings.hpp"
#include "solvers/sph/kernels/cubic_spline.hpp"
#include "solvers/sph/printed/printed.hpp"
#include "solvers/sph/terms/artificial_viscosity.hpp"
#include "solvers/sph/terms/laminar_viscosity.hpp"
#include "solvers/sph/terms/morris_viscosity.hpp"
#include "solvers/sph/terms/pressure.hpp"
#include "solvers/sph/terms/pressure_difference.hpp"
#include "solvers/walls/free_slip.hpp"
#include "solvers/walls/no_slip.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

namespace touchstone::sph {
namespace sph_test {

constexpr double width = 0.4 * mm, height = 0.5 * mm, spacing = 0.025 * mm, h = 1.2 * spacing;
constexpr Newtonian water{{.density = 1000, .bulk_modulus = 143}, 1e-3};
const Box box{.high = {width, height}};
const Domain channel{.box = box, .periodic_x = true};
const std::vector<Wall> plates = {floor_at(0, no_slip()), ceiling_at(height, no_slip({1, 0}))};

auto terms() {
  return momentum(Pressure{}, LaminarViscosity{.nu = 1e-6, .eta = 0.1 * h},
                  ArtificialViscosity{.alpha = 0.01, .sound_speed = water.sound_speed(), .h = h});
}

using Near = Neighbourhood<Packed<double>>;
using Single = One<Packed<double>>;

/// Packs the fluid from its fields and the pressures [Pa] given.
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

TEST(Neighbours, LinkedCellsFindWhatAllPairsFindAlsoBeyondThePeriodicBoundary) {
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

/// The particles, of which images are their sources, that a list has beside each.
using Listed = std::map<Index, std::multiset<Index>>;
Index source(const Near& near, Index j) {
  return j < near.images.first(near.all) ? j : near.images.source(j - near.images.first(near.all));
}
Listed all_listed(const Near& near, const Near::Lists& lists) {
  Listed found;
  for (const auto& part : lists.parts)
    for (const auto& block : part.blocks) {
      const auto rows = part.rows_of(block);
      for (int lane = 0; lane < block.particles; ++lane)
        for (std::size_t at = Near::width + lane; at < rows.size(); at += Near::width)
          if (rows[at] != near.all.nowhere()) found[rows[lane]].insert(source(near, rows[at]));
    }
  return found;
}
/// Those closer than `reach` [m] of all pairs i, j of two ranges, a period further too.
Listed all_within(const Near& near, const Domain& domain, double reach, Index first, Index last, Index from, Index to) {
  const Particles& all = near.all;
  Listed found;
  for (Index i = first; i < last; ++i)
    for (Index j = from; j < to; ++j)
      for (const int across : {-1, 0, 1})
        for (const int up : {-1, 0, 1}) {
          if ((across != 0 && !domain.periodic_x) || (up != 0 && !domain.periodic_y)) continue;
          const Vec2 image = Vec2(all.x[j], all.y[j]) + domain.box.size().cwiseProduct(Vec2(across, up));
          const bool is_self = i == j && across == 0 && up == 0;
          if (!is_self && (image - Vec2(all.x[i], all.y[i])).norm() < reach) found[i].insert(j);
        }
  return found;
}

/// As runs have it: a skin that is a small part of the reach, so that what is missing at its edge is missed.
Near with_thin_skin(const Domain& domain, const std::vector<Wall>& walls, double skin, int threads = 1) {
  return Near(Scene<Newtonian>{.domain = domain,
                               .fluid = water,
                               .filled = box,
                               .start = {.places =
                                             [](const Vectors& lattice) {
                                               std::mt19937 random(7);
                                               std::uniform_real_distribution<double> jitter(-0.2, 0.2);
                                               Vectors places = lattice;
                                               for (double& x : places.reshaped()) x += spacing * jitter(random);
                                               return places;
                                             }}},
              spacing, {.kernel = 2 * h, .wall = 1.12 * spacing, .skin = skin},
              lay_out_ghosts_and_walls(domain, walls, spacing, 2), threads);
}

TEST(Neighbours, AreFoundSeveralAtOnceAsOneAtATime) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-1, 1);
  for (int count = 0; count < 40; ++count) {
    std::vector<double> x(count), y(count);
    std::vector<int> numbers(count);
    for (int k = 0; k < count; ++k) {
      x[k] = place(random);
      y[k] = place(random);
      numbers[k] = 100 + k;
    }
    const int self = 100 + count / 2;
    std::vector<int> found(count + close_ones_overrun), in_turn(found);
    const auto search = [&](auto how, std::vector<int>& into) {
      into.resize(how(x.data(), y.data(), numbers.data(), count, 0.1, -0.2, 0.7, self, into.data()));
    };
    search(close_ones, found);
    search(close_ones_in_turn, in_turn);
    EXPECT_EQ(found, in_turn) << count;
    EXPECT_EQ(std::ranges::count(found, self), 0) << count;
  }
}

TEST(Neighbours, AreListedToTheEndOfTheKernelAndOfTheSkinWhenListsAreMade) {
  constexpr double skin = 0.1 * spacing;
  const Near near = with_thin_skin(channel, plates, skin);
  const Index fluid = near.all.fluid, ghosts = fluid + near.ghosts(), all = fluid + near.all.boundary;
  const auto within = [&](double reach, Index first, Index last, Index from, Index to) {
    return all_within(near, channel, reach + skin, first, last, from, to);
  };
  EXPECT_EQ(all_listed(near, near.fluid_near_fluid), within(2 * h, 0, fluid, 0, ghosts));
  EXPECT_EQ(all_listed(near, near.fluid_near_ghost), within(2 * h, fluid, ghosts, 0, fluid));
  EXPECT_EQ(all_listed(near, near.wall_near_fluid[1]), within(1.12 * spacing, 0, fluid, ghosts, all));
}

TEST(Neighbours, StayListedForAsLongAsListsHold) {
  const Domain endless{.box = box, .periodic_x = true, .periodic_y = true};
  Near near = with_thin_skin(endless, {}, 0.3 * spacing);
  for (Index i = 0; i < near.all.fluid; ++i) {  // equally fast in all directions, so that many pairs close in
    near.all.vx[i] = std::cos(2.4 * static_cast<double>(i));
    near.all.vy[i] = std::sin(2.4 * static_cast<double>(i));
  }
  constexpr double dt = 0.04 * spacing;  // at 1 m/s: lists hold for three steps
  int made = 0;
  for (int step = 0; step < 12; ++step) {
    const Listed before = all_listed(near, near.fluid_near_fluid);
    near.follow(step, step * dt, dt);
    made += all_listed(near, near.fluid_near_fluid) != before;
    near.all.x.head(near.all.fluid) += dt * near.all.vx;
    near.all.y.head(near.all.fluid) += dt * near.all.vy;
    Listed listed = all_listed(near, near.fluid_near_fluid);
    for (const auto& [i, within] : all_within(near, endless, 2 * h, 0, near.all.fluid, 0, near.all.fluid))
      ASSERT_TRUE(std::ranges::includes(listed[i], within)) << "step " << step << ", particle " << i;
  }
  EXPECT_EQ(made, 3) << "as seldom as that";
}

TEST(Neighbours, AreListedTheFartherTheFasterTheyAre) {
  const Domain endless{.box = box, .periodic_x = true, .periodic_y = true};
  constexpr double least = 0.05 * spacing, greatest = 0.5 * spacing, dt = 1e-3;
  Near near(Scene<Newtonian>{.domain = endless, .fluid = water, .filled = box}, spacing,
            {.kernel = 2 * h, .wall = 0, .skin = least, .least_skin = least, .greatest_skin = greatest}, {});
  for (const auto& [way, skin] : {std::pair(1e-9, least), std::pair(1.0, greatest),
                                  std::pair(0.04 * spacing * spacing / (10 * h), 0.2 * spacing)}) {
    near.all.vx.setConstant(0.6 * way / dt);  // of which skin² is five times the reach
    near.all.vy.setConstant(-0.8 * way / dt);
    near.all.x[0] += spacing;  // too far for any list
    near.follow(0, 0, dt);
    EXPECT_EQ(all_listed(near, near.fluid_near_fluid),
              all_within(near, endless, 2 * h + skin, 0, near.all.fluid, 0, near.all.fluid))
        << skin;
  }
}

TEST(Neighbours, AreListedAnewWhicheverThreadSeesAParticleGoTooFar) {
  const Domain endless{.box = box, .periodic_x = true, .periodic_y = true};
  Near near = with_thin_skin(endless, {}, 0.1 * spacing, 4);
  for (Index i = 0; i < near.all.fluid; ++i) {
    near.all.x[i] += spacing;
    near.follow(i, 0, 0);
    const auto within = all_within(near, endless, 2 * h, i, i + 1, 0, near.all.fluid);
    Listed listed = all_listed(near, near.fluid_near_fluid);
    for (const auto& [row, expected] : within) ASSERT_TRUE(std::ranges::includes(listed[row], expected)) << i;
  }
}

TEST(Neighbours, TakeAllFieldsOfAParticleAlongWhenItIsSorted) {
  Near near = with_thin_skin({.box = box, .periodic_x = true, .periodic_y = true}, {}, 0.1 * spacing);
  near.carry(1, 3);
  Particles& all = near.all;
  const Index last = all.fluid - 1;
  const Scalars number = Eigen::Map<const Eigen::ArrayXi>(all.number.data(), all.fluid).cast<double>();
  all.each_field([&](Scalars& field) { field.head(all.fluid) = number; });
  all.vx.setZero();
  all.vy.setZero();
  std::swap(all.x[0], all.x[last]);
  std::swap(all.y[0], all.y[last]);
  near.follow(0, 0, 0);
  ASSERT_NE(all.number[0], static_cast<int>(number[0]));
  for (const Scalars* field : {&all.rho, &all.ax, &all.drho, &all.carried[0], &all.past[0], &all.past[2]})
    for (Index i = 0; i < all.fluid; ++i) ASSERT_EQ((*field)[i], all.number[i]);
}

TEST(Neighbours, SumOverLanesEqualsAPlainLoop) {
  const Near near = disordered(channel, plates);
  const Particles& all = near.all;
  const auto all_terms = terms();
  Scalars ax(all.fluid), ay(all.fluid);
  sum_over_neighbours<2>(
      near.fluid_near_fluid, near.seen,
      [&](const auto& i, const auto& j) {
        auto ij = pair_of(i, j, all.mass);
        const auto acceleration = all_terms.on(ij, Slope<CubicSpline>(h));
        return std::array{acceleration.x, acceleration.y};
      },
      [&](Index i, const std::array<double, 2>& sums) { ax[i] = sums[0], ay[i] = sums[1]; });
  for (Index i = 0; i < all.fluid; ++i) {
    Acceleration<double> plain;
    for (const int j : listed(near, i, 2 * h))
      std::apply([&](const auto&... term) { ((plain += term(pair_at(near, i, j))), ...); }, all_terms.terms);
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
      const Acceleration<double> there = term(pair_at(near, i, j)), back = term(pair_at(near, j, i));
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
    const Acceleration<double> acceleration = PressureDifference{}(pair_at(near, 40, j));
    EXPECT_EQ(acceleration.x, 0);
    EXPECT_EQ(acceleration.y, 0);
  }
}

TEST(Terms, PressureDifferencePushesTowardsTheLowerPressure) {
  Pair<double> ij{};
  ij.x = spacing;  // i is to the right of j
  ij.slope = -1;
  ij.specific_volume_i = ij.specific_volume_j = 1e-3;
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
    const auto power = [&](const Acceleration<double>& acceleration) {
      return acceleration.x * ij.vx + acceleration.y * ij.vy;
    };
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

TEST(Ghosts, MirrorTheVelocityAtBothWallsOfACornerUnderALid) {
  const std::vector<Wall> walls = {left_at(0, no_slip()), right_at(width, no_slip()),
                                   ceiling_at(height, no_slip({3, 0}))};
  Near near = disordered({.box = box}, walls);
  near.all.vx = 1;
  near.all.vy = 0.5;
  see(near, Scalars::Zero(near.all.fluid));
  mirror_to_ghosts<CubicSpline>(near, walls, h, 1000, 0);
  long in_corners = 0;
  for (Index k = 0; k < near.ghosts(); ++k) {
    const Vec2& x = near.boundary.ghosts[k].x;
    const auto& seen = near.seen[near.all.fluid + k];
    if (seen.vx == 0 && seen.vy == 0) continue;  // no fluid is near
    const bool is_beside = x.x() < 0 || x.x() > width, is_above = x.y() > height;
    in_corners += is_beside && is_above;
    EXPECT_NEAR(seen.vx, is_beside && is_above ? 2 * 3 + 1 : is_above ? 2 * 3 - 1 : -1, 1e-9) << x.transpose();
    EXPECT_NEAR(seen.vy, is_beside && is_above ? 0.5 : -0.5, 1e-9) << x.transpose();
  }
  EXPECT_GT(in_corners, 0);
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
  reinitialise_density<CubicSpline>(near, h);
  EXPECT_NEAR(near.all.rho.minCoeff(), 1000, 1e-9);
  EXPECT_NEAR(near.all.rho.maxCoeff(), 1000, 1e-9);
}

TEST(RestoreDensity, IsTheMassAroundOverItsVolumeTheParticleItselfIncluded) {
  const Domain free{.box = box};
  Near near = disordered(free, {});
  const Scalars rho = near.all.rho;
  const Listed around = all_within(near, free, 2 * h, 0, near.all.fluid, 0, near.all.fluid);
  reinitialise_density<CubicSpline>(near, h);
  for (Index i = 0; i < near.all.fluid; ++i) {
    double mass = CubicSpline::w(0.0), volume = CubicSpline::w(0.0) / rho[i];
    for (const Index j : around.at(i)) {
      const double w = CubicSpline::w(apart(near, i, j) / h);
      mass += w;
      volume += w / rho[j];
    }
    ASSERT_NEAR(near.all.rho[i], mass / volume, 1e-9);
  }
}

TEST(Walls, RefuseToStandAcrossAPeriodicAxis) {
  EXPECT_NO_THROW(require_no_wall_across_a_period(channel, plates));
  EXPECT_THROW(require_no_wall_across_a_period(channel, {left_at(0, no_slip())}), std::invalid_argument);
}

TEST(Walls, RefuseFluidThatStartsOnThem) {
  const Vectors places{{0.5, 0.3}, {0.2, 0.004}};
  const std::vector<Wall> walls = {floor_at(0, [](const NearWall& near) { return near.v; })};
  EXPECT_NO_THROW(require_off_walls(places, walls, 0.04));
  try {
    require_off_walls(places, walls, 0.05);
    FAIL();
  } catch (const std::invalid_argument& refusal) {
    EXPECT_STREQ(refusal.what(),
                 "sph: particle 1 starts at (0.3, 0.004) m, 0.004 m from a wall, expected at least 0.005 m");
  }
}

TEST(Images, StandBeyondBothPeriodicBoundariesAndBeyondTheCorner) {
  Particles all;
  all.fluid = 3;
  all.x = Scalars{{0.1, 0.5, 0.9, 0}};
  all.y = Scalars{{0.1, 0.5, 0.5, 0}};
  Images images;
  images.choose(all, {.box = {.high = {1, 1}}, .periodic_x = true, .periodic_y = true}, 0.2);
  ASSERT_EQ(all.images, 4);  // three of the one in the corner, one of that near the right edge
  std::vector<std::pair<double, double>> places;
  for (Index k = 0; k < 4; ++k) places.emplace_back(all.x[3 + k], all.y[3 + k]);
  EXPECT_EQ(places, (std::vector<std::pair<double, double>>{{1.1, 0.1}, {0.1, 1.1}, {1.1, 1.1}, {0.9 - 1, 0.5}}));
}

TEST(Precision, SinglePrecisionKeepsItsDigitsFarFromTheOrigin) {
  const auto distance_at = [](double x) {
    std::array<Packed<float>, 2> seen{};
    seen[0].stand_at(x, -x);
    seen[1].stand_at(x + spacing, -x);
    return double{distance(One<Packed<float>>{seen.data(), 0}, One<Packed<float>>{seen.data(), 1})};
  };
  for (const double x : {0.0, 0.1, 10.0}) EXPECT_NEAR(distance_at(x), spacing, 2e-7 * spacing) << x << " m";
}

/// Sums of all terms for fluid in disorder, `width` particles side by side.
template <int width>
Vectors accelerations() {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> jitter(-1, 1);
  Particles all;
  all.fluid = 400;
  all.mass = 1000 * spacing * spacing;
  all.x.resize(401);
  all.y.resize(401);
  std::vector<Packed<double>> seen(401);
  for (Index i = 0; i <= 400; ++i) {
    const double far = i < 400 ? 0 : 1;  // m  the last is nowhere
    all.x[i] = far + (static_cast<double>(i % 20) + 0.2 * jitter(random)) * spacing;
    all.y[i] = far + (static_cast<double>(i / 20) + 0.2 * jitter(random)) * spacing;
    seen[i].stand_at(all.x[i], all.y[i]);
    seen[i].move(jitter(random), jitter(random));
    seen[i].set_state(1000 + jitter(random), jitter(random));
  }
  NeighbourLists<width> lists;
  const Cells cells(all.x, all.y, all.fluid, 2 * h, [](Index) { return true; });
  fill(lists, all, cells, 0, all.fluid, 2 * h, true, 1);
  Vectors a(2, all.fluid);
  sum_over_neighbours<2>(
      lists, seen,
      [&, terms = terms()](const auto& i, const auto& j) {
        auto ij = pair_of(i, j, all.mass);
        const auto acceleration = terms.on(ij, Slope<CubicSpline>(h));
        return std::array{acceleration.x, acceleration.y};
      },
      [&](Index i, const std::array<double, 2>& sums) { a.col(i) = Vec2(sums[0], sums[1]); });
  return a;
}

TEST(Lanes, HowManyThereAreDoesNotChangeTheSums) {
  const Vectors two = accelerations<2>();
  const double rounding = 1e-13 * two.norm();  // compilers fuse products and sums of long registers otherwise
  EXPECT_GT(two.norm(), 0);
  EXPECT_LT((accelerations<4>() - two).norm(), rounding);
  EXPECT_LT((accelerations<8>() - two).norm(), rounding);
}

/// Any two fields that stand side by side, of `width` particles in disorder.
template <class Number, int width>
void expect_lanes_to_hold_fields() {
  using Packed = Surroundings<Number>;
  using Field = Number Packed::*;
  std::vector<Packed> seen(2 * width);
  Number next = 0;
  const std::array<Field, 6> firsts{&Packed::vx,          &Packed::rho,  &Packed::specific_volume,
                                    &Packed::rho_along_x, &Packed::l_xx, &Packed::l_yy},
      seconds{&Packed::vy,          &Packed::p_over_rho2, &Packed::p,
              &Packed::rho_along_y, &Packed::l_xy,        &Packed::least_eigenvalue};
  for (Packed& of : seen) {
    of.stand_at(next, -next);
    for (const auto& fields : {firsts, seconds})
      for (const Field field : fields) of.*field = next += 1;
  }
  std::array<int, width> which;
  for (int lane = 0; lane < width; ++lane) which[lane] = (5 * lane + 3) % (2 * width);
  const ParticleLanes<Packed, width> row{seen.data(), which.data()};
  const auto places = row.two(&Packed::x);
  for (int lane = 0; lane < width; ++lane) {
    EXPECT_EQ(places[0][lane], seen[which[lane]].x) << "lane " << lane << " of " << width;
    EXPECT_EQ(places[1][lane], seen[which[lane]].y) << "lane " << lane << " of " << width;
  }
  for (std::size_t k = 0; k < firsts.size(); ++k) {
    const auto two = row.two(firsts[k]);
    for (int lane = 0; lane < width; ++lane) {
      EXPECT_EQ(two[0][lane], seen[which[lane]].*firsts[k]) << "field " << k << ", lane " << lane << " of " << width;
      EXPECT_EQ(two[1][lane], seen[which[lane]].*seconds[k]) << "field " << k << ", lane " << lane << " of " << width;
    }
  }
}

TEST(Lanes, HoldTheFieldsOfTheirParticles) {
  expect_lanes_to_hold_fields<double, 2>();
  expect_lanes_to_hold_fields<double, 4>();
  expect_lanes_to_hold_fields<double, 8>();
  expect_lanes_to_hold_fields<float, 4>();
  expect_lanes_to_hold_fields<float, 8>();
  expect_lanes_to_hold_fields<float, 16>();
}

}  // namespace sph_test
}  // namespace touchstone::sph

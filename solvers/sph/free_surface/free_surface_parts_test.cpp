/// Laws of the parts of methods for free surfaces, on fluid in disorder and at once: nothing moves but by shifting.

#include "solvers/forces/uniform.hpp"
#include "solvers/sph/free_surface/diffusion/antuono.hpp"
#include "solvers/sph/free_surface/free_surface.hpp"
#include "solvers/sph/free_surface/gradients/bonet_lok.hpp"
#include "solvers/sph/free_surface/shifting/tangential.hpp"
#include "solvers/sph/kernels/wendland_c2.hpp"
#include "solvers/sph/terms/bonet_lok_pressure.hpp"
#include "solvers/sph/terms/pressure_difference.hpp"
#include "solvers/walls/free_slip.hpp"
#include "solvers/walls/no_slip.hpp"

#include <gtest/gtest.h>

#include <random>

namespace touchstone::sph {
namespace free_surface_parts_test {

constexpr double spacing = 0.05, h = 2 * spacing, c = 10, g = 9.81;
constexpr Tait water{.density = 1000, .bulk_modulus = 1000 * c * c / 7};
const Box square{.high = {1, 1}};

using Seen = SurroundingsWithGhosts<double>;
using Near = Neighbourhood<Seen>;
using Field = std::function<double(const Vec2&)>;
using Motion = std::function<Vec2(const Vec2&)>;

const Field even = [](const Vec2&) { return 1000.0; };
const Motion still = [](const Vec2&) -> Vec2 { return {0, 0}; };

Vectors in_disorder(const Vectors& lattice) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> jitter(-0.2 * spacing, 0.2 * spacing);
  Vectors all = lattice;
  for (double& place : all.reshaped()) place += jitter(random);
  return all;
}

Vectors within_a_circle(const Vectors& lattice) {
  Vectors all(2, lattice.cols());
  Index count = 0;
  for (Index i = 0; i < lattice.cols(); ++i)
    if ((lattice.col(i) - Vec2(0.5, 0.5)).norm() < 0.5) all.col(count++) = lattice.col(i);
  return all.leftCols(count);
}

Near neighbourhood(const Scene<Tait>& scene) {
  const Settings settings{.spacing = spacing, .smoothing_length = h, .time_step = 1};
  return Near(scene, spacing, reach_of<WendlandC2>(settings),
              lay_out_ghosts(scene.domain, scene.walls, spacing, ghost_layers<WendlandC2>(settings)));
}

const Antuono antuono{.sound_speed = c, .h = h};
const Parts all_parts(PressureSum{}, antuono, BonetLok{}, TangentialShifting{spacing});
using Found = Finds<std::remove_const_t<decltype(all_parts)>>;

/// Packs the fluid with fields of its place, and goes through the first pass.
void first_pass(Near& near, const Motion& velocity, const Field& density, const Field& pressure) {
  Particles& all = near.all;
  for (Index i = 0; i < all.fluid; ++i) {
    const Vec2 x(all.x[i], all.y[i]), v = velocity(x);
    all.vx[i] = v.x(), all.vy[i] = v.y(), all.rho[i] = density(x);
    near.seen[i].stand_at(x.x(), x.y());
    near.seen[i].move(v.x(), v.y());
    near.seen[i].set_state(density(x), pressure(x));
  }
  near.images.refresh_fluid(all, near.seen);
  near.carry(Found::carried, 0);
  sum_by_motion<WendlandC2>(near, momentum(), all_parts, h);
}

/// The second pass, and the gradient of density that it finds.
void second_pass(Near& near) {
  sum_by_pressure<WendlandC2>(near, all_parts, h);
  see_density_gradient<WendlandC2>(near, Found::first_of_density_gradient, h);
}

void see(Near& near, const Motion& velocity, const Field& density, const Field& pressure) {
  first_pass(near, velocity, density, pressure);
  second_pass(near);
}

/// Fluid with nothing around it, in disorder, round: corners are not corrected in full.
Near drop(const Motion& velocity, const Field& density, const Field& pressure) {
  Near near = neighbourhood(
      {.domain = {.box = {.low = {-1, -1}, .high = {2, 2}}},
       .fluid = water,
       .filled = square,
       .start = {.places = [](const Vectors& lattice) { return in_disorder(within_a_circle(lattice)); }}});
  see(near, velocity, density, pressure);
  return near;
}

/// Water in a tank, on a lattice.
Near tank(const WallVelocity& wall, const Motion& velocity, const Field& density, const Field& pressure) {
  Near near = neighbourhood({.domain = {.box = {.high = {1, 1.5}}},
                             .fluid = water,
                             .filled = square,
                             .walls = {floor_at(0, wall), left_at(0, wall), right_at(1, wall)}});
  see(near, velocity, density, pressure);
  return near;
}

template <class Parts>
Vectors accelerations(Near& near, const Parts& parts) {
  near.all.ax = near.all.ay = 0;
  sum_by_pressure<WendlandC2>(near, parts, h);
  Vectors a(2, near.all.fluid);
  a.row(0) = near.all.ax;
  a.row(1) = near.all.ay;
  return a;
}
template <class Parts>
Scalars density_rates(Near& near, const Parts& parts) {
  sum_by_motion<WendlandC2>(near, momentum(), parts, h);
  return near.all.drho;
}

/// What the sum of all forces is, of the sum of their sizes; and likewise what they turn.
double push(const Vectors& a) { return a.rowwise().sum().norm() / a.colwise().norm().sum(); }
double torque(const Near& near, const Vectors& a) {
  const auto x = near.all.x.head(near.all.fluid), y = near.all.y.head(near.all.fluid);
  const Scalars turn = x * a.row(1).transpose().array() - y * a.row(0).transpose().array();
  return std::abs(turn.sum()) / turn.abs().sum();
}

const Vec2 slope(300, -200);  // Pa/m
double linear(const Vec2& x) { return 500 + slope.dot(x); }
double curved(const Vec2& x) { return 500 * std::sin(3 * x.x()) * std::cos(2 * x.y()) + 400 * x.x() * x.x(); }

/// The largest error in the gradient of a linear pressure, of its size.
template <class Parts>
double error_of_slope(const Parts& parts) {
  Near near = drop(still, even, linear);
  const Vectors a = accelerations(near, parts);
  return ((-1000 * a).colwise() - slope).colwise().norm().maxCoeff() / slope.norm();
}

TEST(Gradients, OfBonetAndLokAreExactForALinearFieldUpToTheSurface) {
  EXPECT_LT(error_of_slope(Parts(PressureDifference{}, NoDiffusion{}, BonetLok{})), 1e-10);
  EXPECT_GT(error_of_slope(Parts(PressureDifference{})), 0.3);
}

TEST(Gradients, OfAUniformFieldVanishForDifferencesAndNotForSums) {
  const auto largest = [](const auto& parts) {
    Near near = drop(still, even, even);
    return accelerations(near, parts).colwise().norm().maxCoeff();
  };
  EXPECT_EQ(largest(Parts(PressureDifference{})), 0);
  EXPECT_EQ(largest(Parts(PressureDifference{}, NoDiffusion{}, BonetLok{})), 0);
  EXPECT_GT(largest(Parts{}), 1);
  EXPECT_GT(largest(Parts(PressureSum{}, NoDiffusion{}, BonetLok{})), 1);
  EXPECT_GT(largest(Parts(BonetLokPressure{})), 1);
}

TEST(Gradients, KeepMomentumAndItsMomentOnlyWhereTheySaySo) {
  Near near = drop(still, even, curved);
  const Vectors plain = accelerations(near, Parts{}),
                bonet_lok = accelerations(near, Parts(PressureSum{}, NoDiffusion{}, BonetLok{})),
                variational = accelerations(near, Parts(BonetLokPressure{})),
                difference = accelerations(near, Parts(PressureDifference{}));
  EXPECT_LT(push(plain), 1e-14);
  EXPECT_LT(torque(near, plain), 1e-14);
  EXPECT_LT(push(variational), 1e-14);
  EXPECT_LT(torque(near, variational), 1e-14);
  EXPECT_GT(push(bonet_lok), 1e-4);
  EXPECT_GT(torque(near, bonet_lok), 1e-4);
  EXPECT_GT(push(difference), 1e-4);
}

TEST(Gradients, OfBonetAndLokMakeContinuityExactForALinearVelocity) {
  const Motion stretching = [](const Vec2& x) -> Vec2 { return {3 * x.x() - x.y(), 2 * x.x() + x.y()}; };
  Near near = drop(stretching, linear, even);
  const Scalars expected = -4 * near.all.rho.head(near.all.fluid);
  const auto error = [&](const auto& parts) { return (density_rates(near, parts) / expected - 1).abs().maxCoeff(); };
  EXPECT_LT(error(Parts(PressureSum{}, NoDiffusion{}, BonetLok{})), 1e-10);
  EXPECT_GT(error(Parts{}), 0.3);
}

TEST(Gradients, OfARigidRotationNeedNoCorrectionForContinuity) {
  Near near = drop([](const Vec2& x) -> Vec2 { return {-x.y(), x.x()}; }, linear, even);
  EXPECT_LT(density_rates(near, Parts{}).abs().maxCoeff(), 1e-10);
}

/// The power of the pressure, sum of a_i · v_i, beside that of the compression by continuity, sum of p_i / rho_i²
/// drho_i: what is left of their sum, of the sum of its sizes.
template <class Parts>
double energy_from_nowhere(const Parts& parts) {
  const Field unequal = [](const Vec2& x) { return 1000 + 400 * std::sin(9 * x.x() + 7 * x.y()); };
  const Motion swirling = [](const Vec2& x) -> Vec2 { return {std::sin(5 * x.y()) + x.x(), std::cos(4 * x.x())}; };
  Near near = drop(swirling, unequal, curved);
  const Vectors a = accelerations(near, parts);
  const Particles& all = near.all;
  const Scalars compression = density_rates(near, parts) *
                              Scalars::NullaryExpr(all.fluid, [&](Index i) { return near.seen[i].p; }) /
                              all.rho.square();
  const Scalars work = a.row(0).transpose().array() * all.vx + a.row(1).transpose().array() * all.vy;
  return std::abs((work + compression).sum()) / (work.abs() + compression.abs()).sum();
}

TEST(Gradients, GiveBackInWorkWhatContinuityCompressesAlsoAtUnequalDensities) {
  EXPECT_LT(energy_from_nowhere(Parts{}), 1e-14);
  EXPECT_LT((energy_from_nowhere(Parts(BonetLokPressure{}, NoDiffusion{}, BonetLok{}))), 1e-14);
  EXPECT_GT(energy_from_nowhere(Parts(PressureDifference{})), 1e-3);
}

TEST(Surroundings, FindALinearRiseOfDensityUpToTheSurface) {
  const Near near = drop(still, linear, even);
  for (Index i = 0; i < near.all.fluid; ++i)
    ASSERT_LT((Vec2(near.seen[i].rho_along_x, near.seen[i].rho_along_y) - slope).norm(), 1e-9 * slope.norm()) << i;
}

TEST(Surroundings, OfImagesAreThoseOfTheirSources) {
  Near near = neighbourhood({.domain = {.box = square, .periodic_x = true, .periodic_y = true},
                             .fluid = water,
                             .filled = square,
                             .start = {.places = in_disorder}});
  const auto same = [&](auto field) {
    for (Index k = 0; k < near.all.images; ++k)
      ASSERT_EQ(near.seen[near.images.first(near.all) + k].*field, near.seen[near.images.source(k)].*field) << k;
  };
  first_pass(
      near, still, [](const Vec2& x) { return 1000 + 0.01 * curved(x); }, even);
  ASSERT_GT(near.all.images, 0);
  same(&Seen::least_eigenvalue);
  same(&Seen::l_xy);
  second_pass(near);
  same(&Seen::rho_along_x);
}

TEST(Surroundings, AreFullInsideAndNotAtASurface) {
  const Near near = drop(still, even, even);
  for (Index i = 0; i < near.all.fluid; ++i) {
    const double depth = 0.5 - (Vec2(near.all.x[i], near.all.y[i]) - Vec2(0.5, 0.5)).norm();
    const auto least_eigenvalue = near.seen[i].least_eigenvalue;
    ASSERT_TRUE(depth > 0.5 * spacing || least_eigenvalue < TangentialShifting::surface)
        << depth << " m, " << least_eigenvalue;
    ASSERT_TRUE(depth < 4 * spacing || least_eigenvalue > 0.9) << depth << " m, " << least_eigenvalue;
  }
}

TEST(Surroundings, OfALonelyParticleKeepItsCorrectionBounded) {
  Surroundings<double> lonely;
  lonely.set_surroundings(0, 0, 0);
  EXPECT_EQ(lonely.l_xx, 2.5);
  EXPECT_EQ(lonely.l_xy, 0);
  EXPECT_EQ(lonely.l_yy, 2.5);
}

TEST(Surroundings, HaveAnExtentOfOneWhereTheyAreFullAndLessWhereParticlesHaveComeClose) {
  const auto extent_on_a_lattice = [](double squeezed, int rows) {
    double moments = 0, weights = 0;
    for (int a = -rows; a <= rows; ++a)
      for (int b = -rows; b <= rows; ++b) {
        const double q = squeezed * spacing * std::hypot(a, b) / h, weight = -WendlandC2::dw_per_q(q);
        weights += weight;
        moments += weight * (q * h) * (q * h);
      }
    return extent<WendlandC2>(moments, weights, h);
  };
  EXPECT_NEAR(extent_on_a_lattice(1, 4), 1, 0.04);
  EXPECT_NEAR(extent_on_a_lattice(0.5, 1), 0.13, 0.01) << "nine particles, half a spacing apart";
}

TEST(Surroundings, CorrectLessWhereParticlesHaveComeClose) {
  const auto corrected_by = [](double extent) {
    Seen seen;
    seen.set_surroundings(0.5, 0, 1, extent);
    return Vec2(seen.l_xx, seen.l_yy);
  };
  EXPECT_EQ(corrected_by(1), Vec2(2, 1));
  EXPECT_EQ(corrected_by(0.7), Vec2(2, 1));
  EXPECT_EQ(corrected_by(0.35), Vec2(1, 0.5));
  EXPECT_EQ(corrected_by(0), Vec2(0, 0));
}

TEST(Surroundings, ByWhichPressurePullsFadeWhereNoFluidIsLeft) {
  const auto across = [](double eigenvalue) {
    Seen seen;
    seen.set_surroundings(eigenvalue, 0, 1, 1);
    return seen.l_xx;
  };
  EXPECT_DOUBLE_EQ(across(0.5), 2) << "a straight surface is corrected in full";
  EXPECT_DOUBLE_EQ(across(0.4), 2.5);
  EXPECT_DOUBLE_EQ(across(0.25), 1 / 0.7);
  EXPECT_DOUBLE_EQ(across(0.1), 1);
  EXPECT_DOUBLE_EQ(across(-0.1), 1);
}

/// What diffusion alone does to a density.
Scalars diffusion(Near& near) { return density_rates(near, Parts(PressureSum{}, antuono)); }

TEST(Diffusion, OfAntuonoLeavesALinearDensityAloneUpToTheSurface) {
  Near near = drop(still, linear, even);
  const double scale = antuono.delta * c * slope.norm();
  EXPECT_LT(diffusion(near).abs().maxCoeff(), 1e-9 * scale);
}

TEST(Diffusion, KeepsTheMeanAndLowersAPeak) {
  const Vec2 peak(0.5, 0.5);
  Near near = drop(
      still, [&](const Vec2& x) { return 1000 + (x - peak).norm() * 10; }, even);
  Index at = 0;
  for (Index i = 0; i < near.all.fluid; ++i)
    if (near.all.rho[i] < near.all.rho[at]) at = i;
  const Scalars rates = diffusion(near), weighed = rates / near.all.rho;
  EXPECT_LT(std::abs(weighed.sum()), 1e-12 * weighed.abs().sum());
  EXPECT_GT(rates[at], 0);  // the peak points down
}

/// Without the gradients of density it is that of Molteni & Colagrossi, delta h c times the Laplacian; with them,
/// nothing is left of a field of second degree, where neither a particle nor a neighbour of its feels a wall.
TEST(Diffusion, IsDeltaTimesHTimesTheSpeedOfSoundTimesTheLaplacianLessWhatTheGradientsExplain) {
  constexpr double laplacian = 2 * (0.3 + 0.5);  // kg/m⁵, so weak that all volumes are equal
  Near near = tank(
      free_slip(), still, [](const Vec2& x) { return 1000 + 0.3 * x.x() * x.x() + 0.5 * x.y() * x.y(); }, even);
  const auto largest = [&](const Scalars& rates, double expected) {
    double error = 0;
    for (Index i = 0; i < near.all.fluid; ++i)
      if ((Vec2(near.all.x[i], near.all.y[i]) - Vec2(0.5, 0.5)).lpNorm<Eigen::Infinity>() < 0.1)
        error = std::max(error, std::abs(rates[i] - expected));
    return error / (antuono.delta * h * c * laplacian);
  };
  EXPECT_LT(largest(diffusion(near), 0), 0.01);
  for (auto& seen : near.seen) seen.rho_along_x = seen.rho_along_y = 0;
  EXPECT_LT(largest(diffusion(near), antuono.delta * h * c * laplacian), 0.03);
}

TEST(Walls, BalanceWaterAtRestAlsoInTheCornersAndBesideTheSurface) {
  const auto weight = [](const Vec2& x) { return 1000 * g * (1 - x.y()); };
  Near near = tank(free_slip(), still, even, weight);
  balance_ghosts<WendlandC2>(near, {floor_at(0, free_slip()), left_at(0, free_slip()), right_at(1, free_slip())}, h,
                             water, Uniform{{0, -g}}, 0);
  int wet = 0, in_corners = 0;
  for (Index k = 0; k < near.ghosts(); ++k) {
    const auto& ghost = near.boundary.ghosts[k];
    const Surroundings<double>& seen = near.seen[near.all.fluid + k];
    if (seen.p == 0) continue;  // out of reach
    ++wet;
    in_corners += ghost.behind.size() > 1;
    ASSERT_NEAR(seen.p, weight(ghost.x), 1e-9 * weight({0, 0})) << ghost.x.transpose();
    ASSERT_NEAR(seen.rho, water.density_at(seen.p), 1e-9);
  }
  EXPECT_GT(wet, 200);
  EXPECT_GT(in_corners, 10);
}

/// Water on both sides of a gate at x = 0.5 m that is up to `lowest` and ends at `highest` [m]; behind it there is
/// water below it, or above it where it stands on the floor.
Near beside_a_gate(double lowest = 0.2, double highest = 1e9) {
  const Settings settings{.spacing = spacing, .smoothing_length = h, .time_step = 1};
  Scene<Tait> scene{.domain = {.box = square},
                    .fluid = water,
                    .filled = {.high = {1, 0.4}},
                    .walls = {floor_at(0, free_slip()), right_at(0.5, free_slip())},
                    .start = {.places = [=](const Vectors& lattice) {
                      Vectors all(2, 0);
                      for (Index i = 0; i < lattice.cols(); ++i)
                        if (lattice(0, i) < 0.5 || (lowest > 0 ? lattice(1, i) < lowest : lattice(1, i) > highest)) {
                          all.conservativeResize(2, all.cols() + 1);
                          all.rightCols(1) = lattice.col(i);
                        }
                      return all;
                    }}};
  scene.walls[1].extent = [=](double time) -> Range { return {lowest + time, highest}; };
  return Near(scene, spacing, reach_of<WendlandC2>(settings),
              lay_out_ghosts_and_gates(scene.domain, scene.walls, spacing, ghost_layers<WendlandC2>(settings)));
}

TEST(Gates, AreBetweenWhatDoesNotSeeEachOther) {
  for (const bool hangs : {true, false}) {  // from above down to 0.2 m, or it stands on the floor and ends there
    const Near near = hangs ? beside_a_gate() : beside_a_gate(-1, 0.2);
    const Particles& all = near.all;
    const auto gate_begins = all.fluid + near.ghosts() - static_cast<Index>(near.boundary.of_gates);
    int past_its_end = 0, ghosts_seen = 0;
    const auto check = [&](int i, int j) {
      if (j >= all.nowhere()) return;
      if (j >= all.fluid) {
        ghosts_seen += j >= gate_begins;
        ASSERT_TRUE(j < gate_begins || all.x[i] < 0.5);
      } else if ((all.x[i] < 0.5) != (all.x[j] < 0.5)) {
        const double share = (0.5 - all.x[i]) / (all.x[j] - all.x[i]);
        const double crossed_at = all.y[i] + share * (all.y[j] - all.y[i]);
        ASSERT_TRUE(hangs ? crossed_at < 0.2 : crossed_at > 0.2) << crossed_at;
        ++past_its_end;
      }
    };
    const auto each_pair = [](const Near::Lists& lists, const auto& call) {
      for (const auto& block : lists.parts[0].blocks) {
        const auto rows = lists.parts[0].rows_of(block);
        for (int k = Near::width; k < std::ssize(rows); ++k)
          if (k % Near::width < block.particles) call(rows[k % Near::width], rows[k]);
      }
    };
    each_pair(near.fluid_near_fluid, check);
    each_pair(near.fluid_near_ghost,
              [&](int ghost, int j) { ASSERT_TRUE(ghost < gate_begins || j >= all.fluid || all.x[j] < 0.5); });
    EXPECT_GT(past_its_end, 50);
    EXPECT_GT(ghosts_seen, 50);
  }
}

TEST(Gates, HaveGhostsWhereTheyAre) {
  Near near = beside_a_gate();
  for (const double time : {0.0, 0.1, 1.0, 0.1}) {
    near.move_gates(time);
    Index there = 0;
    for (Index k = near.all.fluid; k < near.all.fluid + near.ghosts(); ++k)
      there += near.seen[k].y > 0 && near.seen[k].y < 1;
    EXPECT_EQ(there, 4 * std::lround(std::max(0.0, 0.8 - time) / spacing)) << time;
  }
  Near low = beside_a_gate(0.2, 0.6);
  low.move_gates(0.1);
  for (Index k = low.all.fluid + low.ghosts() - static_cast<Index>(low.boundary.of_gates);
       k < low.all.fluid + low.ghosts(); ++k) {
    const double y = low.boundary.ghosts[k - low.all.fluid].x.y();
    EXPECT_EQ(low.seen[k].y == y, y > 0.3 && y < 0.6) << y;
  }
}

TEST(Gates, AreRefusedInOneLineWhereNoneCanBe) {
  const auto message = [](const Domain& domain, double x, auto lay_out) -> std::string {
    Wall gate = right_at(x, free_slip());
    gate.extent = [](double) -> Range { return {0, 1}; };
    try {
      lay_out(domain, {gate}, spacing, 4);
    } catch (const std::invalid_argument& e) {
      return e.what();
    }
    return "";
  };
  const Domain box{.box = square};
  EXPECT_EQ(message(box, 0.5, lay_out_ghosts_and_gates), "");
  EXPECT_EQ(message(box, 1, lay_out_ghosts_and_gates), "sph: gate at x = 1 m, expected inside the domain, 0 to 1 m");
  EXPECT_EQ(message({.box = square, .periodic_y = true}, 0.5, lay_out_ghosts_and_gates),
            "sph: gate at x = 0.5 m, expected none along a periodic axis");
  EXPECT_EQ(message(box, 0.5, lay_out_ghosts), "sph: wall at x = 0.5 m has an extent, expected one across the domain");
}

TEST(Walls, MirrorTheVelocityAtEachWallAGhostIsBehind) {
  const auto of = [](const WallVelocity& wall) {
    Near near = tank(
        wall,
        [](const Vec2&) -> Vec2 {
          return {2, -3};
        },
        even, even);
    balance_ghosts<WendlandC2>(near, {floor_at(0, wall), left_at(0, wall), right_at(1, wall)}, h, water, NoForce{}, 0);
    std::array<Vec2, 3> v;  // below the floor, beside the left wall, in the corner
    for (Index k = 0; k < near.ghosts(); ++k) {
      const Vec2& x = near.boundary.ghosts[k].x;
      const auto& seen = near.seen[near.all.fluid + k];
      if ((x - Vec2(0.525, -0.025)).norm() < 1e-9) v[0] = {seen.vx, seen.vy};
      if ((x - Vec2(-0.025, 0.525)).norm() < 1e-9) v[1] = {seen.vx, seen.vy};
      if ((x - Vec2(-0.025, -0.025)).norm() < 1e-9) v[2] = {seen.vx, seen.vy};
    }
    return v;
  };
  const auto slips = of(free_slip()), sticks = of(no_slip());
  EXPECT_TRUE(slips[0].isApprox(Vec2(2, 3), 1e-12));
  EXPECT_TRUE(slips[1].isApprox(Vec2(-2, -3), 1e-12));
  EXPECT_TRUE(slips[2].isApprox(Vec2(-2, 3), 1e-12));
  EXPECT_TRUE(sticks[0].isApprox(Vec2(-2, 3), 1e-12));
  const auto slide = of([](const NearWall& fluid) -> Vec2 {  // alike along each wall, and no fluid crosses them
    return 0.5 * Vec2(std::abs(fluid.n.y()), std::abs(fluid.n.x()));
  });
  EXPECT_TRUE(slide[0].isApprox(Vec2(1 - 2, 3), 1e-12));
  EXPECT_TRUE(slide[1].isApprox(Vec2(-2, 1 + 3), 1e-12));
  EXPECT_TRUE(slide[2].isApprox(Vec2(2 - 1, 1 - 3), 1e-12)) << "at the floor, and that at the wall beside it";
}

TEST(Walls, CarryALinearRiseOfDensityOn) {
  Near near = tank(free_slip(), still, even, even);
  see(
      near, still, [](const Vec2& x) { return 1000 + slope.dot(x); }, even);
  for (Index i = 0; i < near.all.fluid; ++i) near.seen[i].rho_along_x = slope.x(), near.seen[i].rho_along_y = slope.y();
  extrapolate_density_gradient_to_ghosts<WendlandC2>(near, h);
  int near_fluid = 0;
  for (Index k = 0; k < near.ghosts(); ++k) {
    const auto& seen = near.seen[near.all.fluid + k];
    if (seen.rho_along_x == 0) continue;
    ++near_fluid;
    ASSERT_LT((Vec2(seen.rho_along_x, seen.rho_along_y) - slope).norm(), 1e-9);
  }
  EXPECT_GT(near_fluid, 200);
}

/// The places of the fluid in the order of its numbers.
Vectors places(const Near& near) {
  Vectors x(2, near.all.fluid);
  for (Index i = 0; i < near.all.fluid; ++i) x.col(near.all.number[i]) = Vec2(near.all.x[i], near.all.y[i]);
  return x;
}
/// As the fastest particle goes in a time [s].
void shift(Near& near, double dt) {
  Particles& all = near.all;
  const double way = std::sqrt((all.vx.square() + all.vy.square()).maxCoeff()) * dt;
  all.x.head(all.fluid) += way * all.carried[Found::shift_x];
  all.y.head(all.fluid) += way * all.carried[Found::shift_y];
}

const Motion passing = [](const Vec2&) -> Vec2 { return {1, 0}; };

TEST(Shifting, MovesNothingInStillWater) {
  Near near = drop(still, even, even);
  const Vectors before = places(near);
  shift(near, 0.01);
  EXPECT_EQ(places(near), before);
}

TEST(Shifting, MovesNothingAcrossASurfaceAlsoInTheRowsBelowIt) {
  Near near = neighbourhood(
      {.domain = {.box = {.low = {-1, -1}, .high = {2, 2}}}, .fluid = water, .filled = square});  // on a lattice
  see(near, passing, even, even);
  const Vectors before = places(near);
  shift(near, 0.01);
  const Vectors way = places(near) - before;
  int in_the_middle = 0;
  for (Index k = 0; k < way.cols(); ++k) {
    if (std::abs(before(0, k) - 0.5) > 2 * spacing || before(1, k) < 1 - 6 * spacing) continue;
    ASSERT_LT(way.col(k).norm(), 1e-12) << (1 - before(1, k)) / spacing << " spacings below the surface";
    ++in_the_middle;
  }
  EXPECT_EQ(in_the_middle, 24);
}

TEST(Shifting, GoesNoFartherThanHalfTheWayOfTheFastest) {
  Near near = drop(passing, even, even);
  const Vectors before = places(near);
  shift(near, 0.01);
  EXPECT_LT((places(near) - before).colwise().norm().maxCoeff(), 0.005 * (1 + 1e-9));
}

/// The least distance between two particles that are deep inside, in spacings.
double least_distance(const Vectors& x) {
  const auto inside = [&](Index i) { return (x.col(i) - Vec2(0.5, 0.5)).lpNorm<Eigen::Infinity>() < 0.3; };
  double least = 1e9;
  for (Index i = 0; i < x.cols(); ++i)
    for (Index j = 0; j < i; ++j)
      if (inside(i) && inside(j)) least = std::min(least, (x.col(i) - x.col(j)).norm());
  return least / spacing;
}

TEST(Shifting, SpreadsParticlesEvenlyAndLeavesTheSurfaceWhereItIs) {
  Near near = drop(passing, even, even);
  const Vectors before = places(near);
  for (int k = 0; k < 200; ++k) {
    near.follow(k, 0, 0.003);
    see(near, passing, even, even);
    shift(near, 0.003);
  }
  const Vectors after = places(near);
  EXPECT_GT(least_distance(after), least_distance(before) + 0.1);
  for (const int axis : {0, 1}) {
    EXPECT_NEAR(after.row(axis).minCoeff(), before.row(axis).minCoeff(), 0.3 * spacing);
    EXPECT_NEAR(after.row(axis).maxCoeff(), before.row(axis).maxCoeff(), 0.3 * spacing);
  }
}

}  // namespace free_surface_parts_test
}  // namespace touchstone::sph

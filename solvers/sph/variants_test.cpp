#include "solvers/forces/uniform.hpp"
#include "solvers/integrators/adams_bashforth.hpp"
#include "solvers/integrators/kick_drift_kick.hpp"
#include "solvers/sph/free_surface/surroundings.hpp"
#include "solvers/sph/kernels/cubic_spline.hpp"
#include "solvers/sph/kernels/quintic_spline.hpp"
#include "solvers/sph/printed/printed.hpp"
#include "solvers/sph/terms/artificial_viscosity.hpp"
#include "solvers/sph/terms/laminar_viscosity.hpp"
#include "solvers/sph/terms/morris_viscosity.hpp"
#include "solvers/sph/terms/pressure.hpp"
#include "solvers/sph/terms/pressure_difference.hpp"
#include "solvers/sph/transport_velocity/transport_velocity.hpp"
#include "solvers/walls/no_slip.hpp"

#include <gtest/gtest.h>

#include <random>

namespace touchstone::sph {
namespace {

constexpr double spacing = 0.025 * mm, h = 1.2 * spacing, height = 0.5 * mm;
const Box box{.high = {0.4 * mm, height}};
const Scene<Newtonian, Uniform> channel{.domain = {.box = box, .periodic_x = true},
                                        .fluid = {{.density = 1000, .bulk_modulus = 143}, 1e-3},
                                        .filled = box,
                                        .walls = {floor_at(0, no_slip()), ceiling_at(height, no_slip({0.01, 0}))},
                                        .body_force = {{8e-3, 0}}};

auto all_terms() {
  return momentum(Pressure{}, LaminarViscosity{.nu = 1e-6, .eta = 0.1 * h},
                  ArtificialViscosity{.alpha = 0.01, .sound_speed = 1, .h = h});
}
auto regular_terms() { return momentum(PressureDifference{}, MorrisViscosity{.mu = 1e-3}); }

template <class Solver>
Samples after(Solver solver, int steps) {
  for (int k = 0; k < steps; ++k) solver.step();
  return solver.samples();
}
template <class Integrator = PredictorCorrector, class Real = double, class Left = Without<>>
Samples after_printed(int steps, int threads = 1) {
  return after(printed<CubicSpline, Integrator, Real, Left>(channel, {spacing, h, 5 * us, threads}, all_terms()),
               steps);
}
template <class Integrator = KickDriftKick, class Real = double, class Left = Without<>>
Samples after_transport(int steps, int threads = 1) {
  return after(transport_velocity<QuinticSpline, Integrator, Real, Left>(channel, {spacing, spacing, 10 * us, threads},
                                                                         regular_terms()),
               steps);
}

void expect_equal(const Samples& a, const Samples& b) {
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.v, b.v);
  EXPECT_TRUE((a.density == b.density).all());
}
double gap(const Samples& a, const Samples& b) { return (a.v - b.v).norm() / b.v.norm(); }

TEST(Threads, AnyNumberOfThemGivesTheSameBits) {
  const Samples one = after_printed<AdamsBashforth>(10), other = after_transport(10);
  for (const int threads : {2, 3}) {
    expect_equal(after_printed<AdamsBashforth>(10, threads), one);
    expect_equal(after_transport(10, threads), other);
  }
}

TEST(Threads, MustBeSome) {
  EXPECT_THROW(printed<CubicSpline>(channel, {spacing, h, 5 * us, 0}, all_terms()), std::invalid_argument);
}

TEST(Precision, SinglePrecisionStaysNearDouble) {
  EXPECT_LT((gap(after_printed<AdamsBashforth, float>(200), after_printed<AdamsBashforth>(200))), 1e-3);
  EXPECT_LT((gap(after_transport<AdamsBashforth, float>(200), after_transport<AdamsBashforth>(200))), 1e-3);
}

TEST(Precision, SinglePrecisionKeepsItsDigitsFarFromTheOrigin) {
  const auto distance_at = [](double x) {
    std::array<Record<float>, 2> seen{};
    seen[0].stand_at(x, -x);
    seen[1].stand_at(x + spacing, -x);
    return double{distance(One<Record<float>>{seen.data(), 0}, One<Record<float>>{seen.data(), 1})};
  };
  for (const double x : {0.0, 0.1, 10.0}) EXPECT_NEAR(distance_at(x), spacing, 2e-7 * spacing) << x << " m";
}

TEST(Integrators, AgreeOnAFlowThatTheyResolve) {
  const Samples printed_flow = after_printed<PredictorCorrector>(400);
  EXPECT_LT(gap(after_printed<AdamsBashforth>(400), printed_flow), 1e-3);
  EXPECT_LT(gap(after_printed<KickDriftKick>(400), printed_flow), 1e-3);
  EXPECT_LT(gap(after_transport<AdamsBashforth>(200), after_transport<KickDriftKick>(200)), 2e-3);
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
  std::vector<Record<double>> seen(401);
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
  fill(lists, all, cells, 0, all.fluid, 2 * h, true, 1, [](int) { return true; });
  Vectors a(2, all.fluid);
  sum_over_neighbours<2>(
      lists, seen,
      [&, terms = all_terms()](const auto& i, const auto& j) {
        auto ij = pair_of(i, j, all.mass);
        const auto pull = terms.on(ij, Slope<CubicSpline>(h));
        return std::array{pull.x, pull.y};
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

/// Any two fields that stand side by side, of `width` records in disorder.
template <class Number, int width>
void expect_lanes_to_hold_fields() {
  using Record = Surroundings<Number>;
  using Field = Number Record::*;
  std::vector<Record> seen(2 * width);
  Number next = 0;
  const std::array<Field, 6> firsts{&Record::vx,          &Record::rho,  &Record::volume,
                                    &Record::rho_along_x, &Record::l_xx, &Record::l_yy},
      seconds{&Record::vy, &Record::push, &Record::p, &Record::rho_along_y, &Record::l_xy, &Record::fullness};
  for (Record& of : seen) {
    of.stand_at(next, -next);
    for (const auto& fields : {firsts, seconds})
      for (const Field field : fields) of.*field = next += 1;
  }
  std::array<int, width> which;
  for (int lane = 0; lane < width; ++lane) which[lane] = (5 * lane + 3) % (2 * width);
  const Row<Record, width> row{seen.data(), which.data()};
  const auto places = row.two(&Record::x);
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

TEST(Without, RestorationIsLeftOutAndNothingElse) {
  using Left = Without<Restoration>;
  expect_equal(after_printed<PredictorCorrector, double, Left>(29), after_printed(29));
  EXPECT_GT(gap(after_printed<PredictorCorrector, double, Left>(60), after_printed(60)), 0);
}

TEST(Without, RepulsionIsLeftOutAndNothingElse) {
  // in so few steps nothing comes closer to a wall than it was, but by rounding
  const auto push = [](int steps) {
    return gap(after_printed<PredictorCorrector, double, Without<Repulsion>>(steps), after_printed(steps));
  };
  EXPECT_LT(push(2), 1e-9);
  EXPECT_GT(push(100), 0);
}

TEST(Without, VolumeKeepingIsLeftOutAndNothingElse) {
  using Left = Without<VolumeKeeping>;
  expect_equal(after_transport<KickDriftKick, double, Left>(29), after_transport(29));
  const auto volume = [](const Samples& samples) { return samples.volumes().sum() / (0.4 * mm * height) - 1; };
  EXPECT_NEAR(volume(after_transport(300)), 0, 1e-12);
  EXPECT_GT(std::abs(volume(after_transport<KickDriftKick, double, Left>(300))), 1e-12);
}

TEST(Without, SpreadingTakesTheMomentumOfDriftWithIt) {
  expect_equal(after_transport<KickDriftKick, double, Without<Spreading>>(100),
               after_transport<KickDriftKick, double, Without<Spreading, MomentumOfDrift>>(100));
  EXPECT_GT(gap(after_transport<KickDriftKick, double, Without<Spreading>>(100), after_transport(100)), 0);
  EXPECT_GT(gap(after_transport<KickDriftKick, double, Without<MomentumOfDrift>>(100), after_transport(100)), 0);
}

}  // namespace
}  // namespace touchstone::sph

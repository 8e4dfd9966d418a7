#include "solvers/mpm/lanes/in_lanes.hpp"

#include "solvers/forces/rolling.hpp"
#include "solvers/forces/skin_friction.hpp"
#include "solvers/mpm/plain/plain.hpp"
#include "solvers/mpm/printed/mpm.hpp"
#include "solvers/mpm/shapes/b_spline.hpp"
#include "solvers/mpm/testing.hpp"
#include "solvers/testing.hpp"
#include "solvers/walls/free_slip.hpp"
#include "solvers/walls/no_slip.hpp"

#include <random>

namespace touchstone::mpm {
namespace {

/// Numbers that are the same in every run.
class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  double between(double low, double high) { return low + (high - low) * static_cast<double>(engine_()) / 4294967296; }
  int below(int count) { return static_cast<int>(between(0, count)); }

 private:
  std::mt19937 engine_;
};

WallVelocity any_wall(Dice& dice) {
  if (dice.below(2) == 0) return free_slip();
  return no_slip({dice.between(-0.1, 0.1), 0});
}

/// Fluid anywhere in up to ten oblong cells along each axis, with empty cells and lonely particles, walls or periodic
/// boundaries at all edges, moving and compressed unevenly.
template <class FluidLaw, class Force>
Scene<FluidLaw, Force> random_scene(unsigned seed, const FluidLaw& fluid, const Force& force, int least_cells) {
  Dice dice(seed);
  const Vec2 size(0.1 * (least_cells + dice.below(10)), 0.09 * (least_cells + dice.below(10)));
  const Vec2 stretch(dice.between(-1, 1), dice.between(-1, 1)), filled(dice.between(0.3, 1), dice.between(0.3, 1));
  Scene<FluidLaw, Force> scene{
      .domain = {.box = {.high = size}, .periodic_x = dice.below(3) == 0, .periodic_y = dice.below(3) == 0},
      .fluid = fluid,
      .filled = {.high = 0.9 * size},  // which leaves room to come apart
      .body_force = force};
  if (!scene.domain.periodic_x) scene.walls = {left_at(0, any_wall(dice)), right_at(size.x(), any_wall(dice))};
  if (!scene.domain.periodic_y) {
    scene.walls.push_back(floor_at(0, any_wall(dice)));
    scene.walls.push_back(ceiling_at(size.y(), any_wall(dice)));
  }
  scene.start.velocity = [=](const Vec2& x) -> Vec2 { return 0.2 * Vec2(stretch.x() * x.y(), stretch.y() - x.x()); };
  scene.start.pressure = [=](const Vec2& x) { return 60 * std::sin(9 * x.x()) + 40 * stretch.x() * x.y(); };
  scene.start.places = [=](const Vectors& lattice) -> Vectors {
    Dice anywhere(seed + 1000);
    Vectors places = lattice;
    for (Index p = 0; p < places.cols(); ++p) {
      const bool is_lonely = p % 10 == 0;
      for (const int axis : {0, 1}) places(axis, p) = anywhere.between(0, is_lonely ? 1 : filled[axis]) * size[axis];
    }
    return places;
  };
  return scene;
}

/// Whether a step ends the run.
template <class Solver>
bool diverges(Solver& solver) {
  try {
    solver.step();
    return false;
  } catch (const Diverged&) {
    return true;
  }
}

/// Compares all that particles have over a few steps; returns how many until the run ends.
constexpr Settings some_settings{.cell = 0.095, .spacing = 0.045, .time_step = 2e-3};
template <class Plain, class Fast>
int compare_steps(Plain plain, Fast fast, bool may_end_earlier = false) {
  constexpr int most = 5;
  const auto expect_same = [](const char* what, const auto& a, const auto& b) {
    EXPECT_LE((a - b).abs().maxCoeff(), 1e-11 * b.abs().maxCoeff()) << what;
  };
  for (int step = 0; step < most; ++step) {
    const bool ends = diverges(plain), fast_ends = diverges(fast);
    EXPECT_TRUE(may_end_earlier || fast_ends == ends);
    if (ends || fast_ends) return step;
    const Samples a = fast.samples(), b = plain.samples();
    expect_same("place", a.x.array(), b.x.array());
    expect_same("velocity", a.v.array(), b.v.array());
    expect_same("density", a.density, b.density);
    expect_same("pressure", a.pressure, b.pressure);
  }
  return most;
}

template <class Shape, class Transfer, class Density, class FluidLaw, class Force>
void expect_as_plain(const FluidLaw& fluid, const Force& force) {
  int steps = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    const auto scene = random_scene(seed, fluid, force, std::same_as<Shape, Gimp> ? 2 : 1);
    steps += compare_steps(plain<Shape, Transfer, Density>(scene, some_settings),
                           in_lanes<Shape, Transfer, Density>(scene, some_settings));
  }
  EXPECT_GT(steps, 150);  // of 200
}

constexpr Tait water{.density = 1000, .bulk_modulus = 2000};
const Newtonian thick{water, 2};
const ForceField stirred = stirring({0.8, 0.7}, 3);
const Uniform gravity{{0.3, -1}};

// Each shape with each transfer and each density, each transfer with each density, fluid and force.

TEST(InLanes, DoWithQuadraticSplinesAndAnyPartsWhatPlainLoopsDo) {
  using Shape = BSpline<2>;
  expect_as_plain<Shape, Apic, CarriedDensity>(water, NoForce{});
  expect_as_plain<Shape, Apic, AffineDensity>(thick, stirred);
  expect_as_plain<Shape, Flip, CarriedDensity>(thick, stirred);
  expect_as_plain<Shape, Flip, AffineDensity>(water, gravity);
  expect_as_plain<Shape, Xpic<1>, AffineDensity>(thick, NoForce{});
  expect_as_plain<Shape, Xpic<2>, CarriedDensity>(thick, gravity);
  expect_as_plain<Shape, Xpic<5>, CarriedDensity>(water, stirred);
  expect_as_plain<Shape, Xpic<5>, AffineDensity>(water, gravity);
}

TEST(InLanes, DoWithLinearHatsAndAnyPartsWhatPlainLoopsDo) {
  expect_as_plain<LinearHat, Flip, CarriedDensity>(thick, gravity);
  expect_as_plain<LinearHat, Apic, AffineDensity>(water, stirred);
  expect_as_plain<LinearHat, Xpic<2>, AffineDensity>(thick, NoForce{});
}

TEST(PrintedMpm, DoesWithHatsAndFlipWhatPlainLoopsDo) {
  int steps = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    auto scene = random_scene(seed, thick, stirred, 1);
    scene.start.velocity = [](const Vec2&) -> Vec2 { return {0.1, -0.07}; };  // the same on both sides of a period
    steps += compare_steps(plain<LinearHat, Flip>(scene, some_settings),
                           printed<PrescribedMotion>(scene, some_settings),
                           true);  // which has no contact with walls
  }
  EXPECT_GT(steps, 150);  // of 200
}

TEST(InLanes, DoWithGimpAndAnyPartsWhatPlainLoopsDo) {
  expect_as_plain<Gimp, Flip, CarriedDensity>(thick, stirred);
  expect_as_plain<Gimp, Apic, CarriedDensity>(thick, gravity);
  expect_as_plain<Gimp, Xpic<3>, AffineDensity>(water, NoForce{});
}

TEST(InLanes, DoWithCubicSplinesAndAnyPartsWhatPlainLoopsDo) {
  expect_as_plain<BSpline<3>, Flip, AffineDensity>(thick, NoForce{});
  expect_as_plain<BSpline<3>, Apic, CarriedDensity>(water, gravity);
  expect_as_plain<BSpline<3>, Xpic<2>, CarriedDensity>(thick, stirred);
}

/// Water 0.3 m long and 0.2 m high at rest at the left end of a tank, behind a gate between two rows of nodes.
Scene<Tait, Uniform> behind_a_gate(const WallExtent& extent) {
  constexpr double g = 1;  // m/s²
  return {.domain = {.box = {.high = {0.8, 0.4}}},
          .fluid = water,
          .filled = {.high = {0.3, 0.2}},
          .walls = {floor_at(0, free_slip()),
                    left_at(0, free_slip()),
                    right_at(0.8, free_slip()),
                    {0, 0.3, -1, free_slip(), extent}},
          .body_force = {{0, -g}},
          .start = {.pressure = [](const Vec2& x) { return water.density * g * (0.2 - x.y()); }}};
}
auto run_behind_a_gate(const WallExtent& extent, int steps) {
  auto tank = in_lanes<BSpline<2>, Apic, AffineDensity>(behind_a_gate(extent),
                                                        {.cell = 0.04, .spacing = 0.02, .time_step = 4e-3});
  for (int step = 0; step < steps; ++step) tank.step();
  return tank.samples();
}

TEST(AGate, HoldsWaterWhileItIsDown) {
  const Samples s = run_behind_a_gate([](double) { return Range{0, 1}; }, 500);
  EXPECT_LT(s.x.row(0).maxCoeff(), 0.3);
  EXPECT_LT(s.v.cwiseAbs().maxCoeff(), 0.02);  // of sqrt(g H), 0.45
  for (Index p = 0; p < s.size(); ++p) EXPECT_NEAR(s.pressure[p], 1000 * (0.2 - s.x(1, p)), 20) << s.x.col(p);
}

TEST(AGate, LetsWaterThroughBelowItsEdgeAlone) {
  const Samples s = run_behind_a_gate([](double time) { return Range{0.4 * time, 1}; }, 75);  // its edge is at 0.12 m
  ASSERT_GT(s.x.row(0).maxCoeff(), 0.32);
  for (Index p = 0; p < s.size(); ++p) EXPECT_TRUE(s.x(0, p) < 0.305 || s.x(1, p) < 0.12) << s.x.col(p);
}

TEST(AGate, DoesNotHoldBackWaterThatLeavesIt) {
  auto scene = behind_a_gate([](double) { return Range{0, 1}; });
  scene.body_force = {{-1, 0}};
  scene.start = {};
  auto tank = in_lanes<BSpline<2>, Apic, AffineDensity>(scene, {.cell = 0.04, .spacing = 0.02, .time_step = 4e-3});
  scene.walls.pop_back();
  auto open = in_lanes<BSpline<2>, Apic, AffineDensity>(scene, {.cell = 0.04, .spacing = 0.02, .time_step = 4e-3});
  for (int step = 0; step < 20; ++step) tank.step(), open.step();
  EXPECT_EQ(tank.samples().x, open.samples().x);
}

TEST(AGate, IsRefusedCloserThanACellToAnEdgeAndByMethodsWithoutPartialWalls) {
  auto scene = behind_a_gate([](double) { return Range{0, 1}; });
  EXPECT_THROW((plain<BSpline<2>, Apic>(scene, {.cell = 0.04, .spacing = 0.02, .time_step = 1e-3})),
               std::invalid_argument);
  EXPECT_THROW((in_lanes<Gimp, Flip>(scene, {.cell = 0.04, .spacing = 0.02, .time_step = 1e-3})),
               std::invalid_argument);
  scene.walls.back().position = 0.78;
  EXPECT_THROW((in_lanes<BSpline<2>, Apic>(scene, {.cell = 0.04, .spacing = 0.02, .time_step = 1e-3})),
               std::invalid_argument);
}

TEST(SkinFriction, SlowsASlabAsItsWallsBear) {
  // dU/dt = -k U², k = c_f (2 / breadth + 1 / layer) / 2, where all of the slab is in the layer
  constexpr double c_f = 0.02, breadth = 0.1, layer = 1, U = 2, k = c_f / 2 * (2 / breadth + 1 / layer);
  Scene<Tait, SkinFriction> slab{.domain = {.box = {.high = {0.4, 0.2}}, .periodic_x = true},
                                 .fluid = water,
                                 .filled = {.high = {0.4, 0.2}},
                                 .walls = {floor_at(0, free_slip()), ceiling_at(0.2, free_slip())},
                                 .body_force = {Vec2::Zero(), c_f, layer, breadth}};
  slab.start.velocity = [=](const Vec2&) -> Vec2 { return {U, 0}; };
  auto run = in_lanes<BSpline<2>, Apic, AffineDensity>(slab, {.cell = 0.04, .spacing = 0.02, .time_step = 1e-3});
  for (int step = 0; step < 1000; ++step) run.step();
  const double expected = U / (1 + k * U);  // 1.41 m/s after 1 s
  EXPECT_NEAR(run.samples().v.row(0).minCoeff(), expected, 1e-3);
  EXPECT_NEAR(run.samples().v.row(0).maxCoeff(), expected, 1e-3);
}

TEST(SkinFriction, IsNothingOnWaterAtRestAndHasTheFloorsPartNearTheFloor) {
  const SkinFriction force{{0, -10}, 0.01, 0.1, 0.5};
  EXPECT_EQ(force({0, 0.01}, 0, Vec2::Zero()), Vec2(0, -10));
  EXPECT_LT((force({0, 0.2}, 0, {3, 4}) - Vec2(-0.3, -10.4)).norm(), 1e-12) << "c_f / 2 |v| v 2 / breadth";
  EXPECT_LT((force({0, 0.05}, 0, {3, 4}) - Vec2(-1.05, -11.4)).norm(), 1e-12) << "and the floor's";
}

TEST(ARollingTank, SeesALoneParticleFlyItsParabola) {
  const Rolling roll{9.81, 0.5, 4, {0.2, 0.1}};
  const auto in_tank = [&](const Vec2& world, double time) -> Vec2 {
    return roll.pivot + Eigen::Rotation2Dd(-roll.angle(time)) * (world - roll.pivot);
  };
  const Vec2 from(0.6, 0.5), v(0.5, 2);
  const auto flight = [&](double t) -> Vec2 { return from + t * v - Vec2(0, 9.81 / 2 * t * t); };
  Scene<Tait, Rolling> scene{
      .domain = {.box = {.high = {2, 2}}}, .fluid = water, .filled = {.high = {2, 2}}, .body_force = roll};
  scene.walls = {floor_at(0, free_slip()), left_at(0, free_slip()), right_at(2, free_slip()),
                 ceiling_at(2, free_slip())};
  scene.start.places = [&](const Vectors&) -> Vectors { return from; };
  // As seen from the tank, which is upright and turns at 2 rad/s.
  const Vec2 r = from - roll.pivot;
  scene.start.velocity = [=](const Vec2&) -> Vec2 { return v - 2 * Vec2(-r.y(), r.x()); };
  auto tank = in_lanes<BSpline<2>, Apic, AffineDensity>(scene, {.cell = 0.1, .spacing = 0.05, .time_step = 1e-4});
  for (int step = 0; step < 4000; ++step) tank.step();
  EXPECT_LT((tank.samples().x.col(0) - in_tank(flight(0.4), 0.4)).norm(), 1e-3) << tank.samples().x.col(0);
}

TEST(AffineDensity, ForgetsHowFarLoneParticlesWereTorn) {
  Scene<Tait> scene{.domain = {.box = {.high = {1, 1}}}, .fluid = water, .filled = {.high = {1, 1}}};
  scene.walls = {floor_at(0, free_slip()), left_at(0, free_slip()), right_at(1, free_slip()),
                 ceiling_at(1, free_slip())};
  scene.start.places = [](const Vectors&) -> Vectors { return (Vectors(2, 1) << 0.47, 0.52).finished(); };
  scene.start.velocity = [](const Vec2& x) -> Vec2 { return 10 * (x - Vec2(0.47, 0.52)); };  // m/s  it expands
  auto drop = in_lanes<BSpline<2>, Apic, AffineDensity>(scene, {.cell = 0.1, .spacing = 0.05, .time_step = 2e-3});
  for (int step = 0; step < 200; ++step) {
    drop.step();
    ASSERT_GE(drop.samples().density[0], water.density / 1.0031);
  }
}

/// One particle under tension, a thousandth of a cell above the floor, in a tank open at the top.
auto beside_the_floor() {
  Scene<Tait> scene{.domain = {.box = {.high = {1, 1}}}, .fluid = water, .filled = {.high = {1, 1}}};
  scene.walls = {floor_at(0, free_slip())};
  scene.start.places = [](const Vectors&) -> Vectors { return Vec2(0.47, 1e-4); };
  scene.start.pressure = [](const Vec2&) { return -0.01 * water.density * std::pow(water.sound_speed(), 2); };
  return in_lanes<BSpline<2>, Xpic<5>>(scene, {.cell = 0.1, .spacing = 0.05, .time_step = 2e-3});
}

TEST(ContactOfMpm, HoldsWhatItsTensionDrawsThroughAWall) {
  auto drop = beside_the_floor();
  for (int step = 0; step < 20; ++step) drop.step();
  EXPECT_GE(drop.contacts().particles, 1);
  EXPECT_GE(drop.contacts().energy, 0);
  EXPECT_GE(drop.contacts().impulse.y(), 0);
  EXPECT_GE(drop.samples().x(1, 0), 0);
}

TEST(ContactOfMpm, DoesNotTouchWaterAtRest) {
  auto tank = in_lanes<BSpline<2>, Xpic<5>, AffineDensity>(behind_a_gate([](double) {
                                                             return Range{0, 1};
                                                           }),
                                                           {.cell = 0.04, .spacing = 0.02, .time_step = 4e-3});
  for (int step = 0; step < 500; ++step) tank.step();
  EXPECT_EQ(tank.contacts().particles, 0);
}

TEST(ContactOfMpm, TakesWhatGoesIntoAWallUpToAHundredthOfACellBehindIt) {
  const Grid grid({.box = {.high = {1, 1}}}, 0.1);
  const Wall gate{0, 0.5, -1, free_slip(), [](double) { return Range{0, 1}; }};
  const auto after = [&](const Vec2& x, double velocity, WallContact& contact) {
    contact.meet(2, x, [&](const Wall&) -> double& { return velocity; });
    return velocity;
  };
  WallContact contact({floor_at(0, free_slip()), right_at(1, free_slip()), gate}, grid);
  EXPECT_EQ(after({0.5, -0.0009}, -3, contact), 0);
  EXPECT_EQ(after({1.0009, 0.5}, 3, contact), 0);
  EXPECT_EQ(after({0.5, -0.0009}, 1, contact), 1) << "it leaves the wall";
  EXPECT_EQ(contact.sum.particles, 3);
  EXPECT_EQ(contact.sum.energy, 18);
  EXPECT_EQ(contact.sum.impulse, Vec2(-6, 6));
  for (const Vec2& x : {Vec2(0.5, 0), Vec2(0.5, -0.0011), Vec2(-0.0009, 0.5), Vec2(0.5, 1.0009), Vec2(0.5009, 0.5)})
    EXPECT_EQ(after(x, -3, contact), -3) << "at " << x.transpose();
  EXPECT_EQ(contact.sum.particles, 3);
}

}  // namespace
}  // namespace touchstone::mpm

#include "solvers/mpm/plain/plain.hpp"
#include "solvers/mpm/shapes/b_spline.hpp"
#include "solvers/mpm/shapes/gimp.hpp"
#include "solvers/mpm/shapes/linear_hat.hpp"

#include <gtest/gtest.h>

namespace touchstone::mpm {
namespace {

constexpr double cell = 0.1;                                   // m
constexpr Tait water{.density = 1000, .bulk_modulus = 14300};  // sound travels at 10 m/s

/// An uneven patch of particles in the middle of 12 x 12 cells, spinning and stretched, each with a pressure of its
/// own.
template <class Shape, class Transfer>
struct Patch : Plain<Shape, Transfer, CarriedDensity, Tait, NoForce> {
  using Base = Plain<Shape, Transfer, CarriedDensity, Tait, NoForce>;
  using Base::at, Base::given, Base::move, Base::nodes_, Base::particles_, Base::scatter, Base::take;

  explicit Patch(const Mat2& gradient = Mat2{{0.3, -1.1}, {0.9, -0.2}})
      : Base({.domain = {.box = {.high = {1.2, 1.2}}}, .fluid = water, .filled = {.high = {0.6, 0.25}}},
             {.cell = cell, .spacing = cell / 2, .time_step = 5e-3}) {
    for (int p = 0; p < 60; ++p) {
      particles_.x.col(p) = Vec2(0.45 + 0.3 * fraction(0.618 * p), 0.45 + 0.3 * fraction(0.755 * p));
      particles_.v.col(p) = gradient * (particles_.x.col(p) - Vec2(0.6, 0.6));
      particles_.expansion[p] = 0.02 * (fraction(0.57 * p) - 0.5);
      particles_.slopes[p] = particles_.affine[p] = gradient;
    }
  }

  /// To the nodes and back, under no forces.
  void there_and_back() {
    scatter();
    nodes_.force.setZero();
    this->accelerate();
    take(Transfer{});
  }
  /// And under the forces of their pressure.
  void step() {
    scatter();
    this->accelerate();
    move();
  }
  void steps(int count) {
    for (int k = 0; k < count; ++k) step();
  }

  Vec2 momentum() const { return particles_.v.rowwise().sum(); }
  /// What the particles' velocities have, and with an affine transfer what turns around each.
  double angular_momentum(double spread = 0) const {
    double sum = 0;
    for (Index p = 0; p < particles_.count(); ++p) {
      const Vec2 x = particles_.x.col(p), v = particles_.v.col(p), here = given()(p, Vec2(0, 0));
      sum += x.x() * v.y() - x.y() * v.x();
      sum += spread * (given()(p, Vec2(1, 0)) - here).y() - spread * (given()(p, Vec2(0, 1)) - here).x();
    }
    return sum;
  }

  static double fraction(double x) { return x - std::floor(x); }
};

template <class Combination>
class Transfers : public testing::Test {};
// Each shape and each transfer, and all transfers with one shape: every combination takes a second to compile.
using Combinations = testing::Types<Patch<LinearHat, Xpic<1>>, Patch<Gimp, Apic>, Patch<BSpline<2>, Flip>,
                                    Patch<BSpline<2>, Apic>, Patch<BSpline<2>, Xpic<3>>, Patch<BSpline<3>, Apic>>;
TYPED_TEST_SUITE(Transfers, Combinations);

TYPED_TEST(Transfers, GiveTheNodesAllMassAndMomentum) {
  TypeParam patch;
  patch.scatter();
  EXPECT_NEAR(patch.nodes_.mass.sum(), 60, 1e-12);
  const Vec2 of_nodes = patch.nodes_.start * patch.nodes_.mass.matrix();
  EXPECT_LT((of_nodes - patch.momentum()).norm(), 1e-12);
}

TYPED_TEST(Transfers, KeepMomentumUnderForces) {
  TypeParam patch;
  const Vec2 start = patch.momentum();
  const Vectors v = patch.particles_.v;
  patch.steps(20);
  EXPECT_GT((patch.particles_.v - v).norm(), 0.1);  // m/s: forces have been at work
  EXPECT_LT((patch.momentum() - start).norm(), 1e-12);
}

TYPED_TEST(Transfers, LeaveUniformFlowAsItIs) {
  TypeParam patch;
  patch.particles_.v.colwise() = Vec2(3, -2);
  patch.particles_.affine.assign(60, Mat2::Zero());
  patch.there_and_back();
  EXPECT_LT((patch.particles_.v.colwise() - Vec2(3, -2)).norm(), 1e-12);
}

/// By how much the angular momentum changes in twenty steps, over what it was.
template <class Combination>
double lost(double spread) {
  const Mat2 spin{{0, -1}, {1, 0}};
  Combination patch(spin);
  const double start = patch.angular_momentum(spread);
  patch.steps(20);
  return std::abs(patch.angular_momentum(spread) / start - 1);
}

TEST(Apic, KeepsAngularMomentumWithBSplinesAwayFromWalls) {
  EXPECT_LT((lost<Patch<BSpline<2>, Apic>>(cell * cell / 4)), 1e-12);
  EXPECT_LT((lost<Patch<BSpline<3>, Apic>>(cell * cell / 3)), 1e-12);
}

TEST(Xpic, OfFirstOrderLosesAngularMomentum) {
  EXPECT_GT((lost<Patch<BSpline<2>, Xpic<1>>>(0)), 0.1);
  EXPECT_GT((lost<Patch<LinearHat, Xpic<1>>>(0)), 0.1);
}

/// What an affine field of velocity, given to the nodes and taken back in a corner between walls, is wrong by.
template <class Shape>
double wrong_in_a_corner() {
  const Mat2 gradient{{0.3, -1.1}, {0.9, -0.2}};
  Patch<Shape, Apic> patch(gradient);
  for (Index p = 0; p < patch.particles_.count(); ++p) {
    patch.particles_.x.col(p) -= Vec2(0.45, 0.45);
    if (p < 4) patch.particles_.x(p % 2, p) = p < 2 ? 0 : cell;  // on a wall, and where cells meet
    patch.particles_.v.col(p) = gradient * patch.particles_.x.col(p);
  }
  const Vectors start = patch.particles_.v;
  patch.there_and_back();
  double wrong = (patch.particles_.v - start).norm();
  for (Index p = 0; p < patch.particles_.count(); ++p)
    for (const Vec2& arm : {Vec2(1, 0), Vec2(0, 1)})
      wrong = std::max(wrong, (patch.given()(p, arm) - patch.particles_.v.col(p) - gradient * arm).norm());
  return wrong;
}

TEST(Apic, CarriesAnAffineFieldThroughTheNodesUpToWalls) {
  EXPECT_LT(wrong_in_a_corner<LinearHat>(), 1e-11);
  EXPECT_LT(wrong_in_a_corner<Gimp>(), 1e-11);
  EXPECT_LT(wrong_in_a_corner<BSpline<2>>(), 1e-11);
  EXPECT_LT(wrong_in_a_corner<BSpline<3>>(), 1e-11);
}

TEST(Xpic, OfFirstOrderTakesTheVelocityOfTheNodes) {
  Patch<BSpline<2>, Xpic<1>> patch;
  patch.step();
  for (Index p = 0; p < patch.particles_.count(); ++p)
    EXPECT_EQ(patch.particles_.v.col(p), patch.at(p, patch.nodes_.velocity));
}

TEST(Xpic, DampsLessTheHigherItsOrder) {
  const auto energy = []<class Combination>(Combination patch) {
    patch.steps(10);
    return patch.particles_.v.squaredNorm();
  };
  const double first = energy(Patch<BSpline<2>, Xpic<1>>()), second = energy(Patch<BSpline<2>, Xpic<2>>()),
               fifth = energy(Patch<BSpline<2>, Xpic<5>>()), kept = energy(Patch<BSpline<2>, Flip>());
  EXPECT_LT(1.05 * first, second);
  EXPECT_LT(1.01 * second, fifth);
  EXPECT_LT(fifth, kept);
}

TEST(Xpic, FiltersVelocitiesAsItsFormulaSays) {
  Patch<BSpline<2>, Xpic<3>> patch;
  for (int p = 0; p < 60; ++p) patch.particles_.v.col(p) = Vec2(std::sin(1.0 * p), std::cos(2.0 * p));
  Vectors rest = patch.particles_.v;
  for (int k = 0; k < 3; ++k) {  // (I - S S⁺)³ v
    Patch<BSpline<2>, Xpic<1>> smoothing;
    smoothing.particles_.v = rest;
    smoothing.there_and_back();
    rest -= smoothing.particles_.v;
  }
  const Vectors filtered = patch.particles_.v - rest;
  patch.there_and_back();
  EXPECT_GT(rest.norm(), 1);
  EXPECT_LT((patch.particles_.v - filtered).norm(), 1e-12);
}

}  // namespace
}  // namespace touchstone::mpm

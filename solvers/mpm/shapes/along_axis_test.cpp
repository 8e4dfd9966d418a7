#include "solvers/mpm/shapes/b_spline.hpp"
#include "solvers/mpm/shapes/gimp.hpp"
#include "solvers/mpm/shapes/linear_hat.hpp"
#include "solvers/mpm/shapes/quadratic_b_spline.hpp"

#include <gtest/gtest.h>

#include <map>

namespace touchstone::mpm {
namespace {

constexpr GridAxis walled{.cells = 7, .periodic = false, .reach = 0.25},
    endless{.cells = 7, .periodic = true, .reach = 0.25};

template <class Shape>
class ShapeAlongAxis : public testing::Test {};
using Shapes = testing::Types<LinearHat, Gimp, BSpline<1>, BSpline<2>, BSpline<3>>;
TYPED_TEST_SUITE(ShapeAlongAxis, Shapes);

/// Weights, or slopes, by the number of the node.
template <class Shape>
std::map<int, double> by_node(const NearNodes<AlongAxis<Shape>::width>& near,
                              const std::array<double, AlongAxis<Shape>::width>& values) {
  std::map<int, double> all;
  for (int a = 0; a < near.width; ++a)
    if (values[a] != 0) all[near.first + a] = values[a];
  return all;
}

TYPED_TEST(ShapeAlongAxis, KeepsUnityAndLinearFieldsUpToItsWalls) {
  for (const GridAxis& axis : {walled, endless}) {
    const ShapeErrors errors = errors_along<TypeParam>(axis);
    for (const double error : {errors.unity, errors.place, errors.slopes, errors.slope_of_place, errors.negative})
      EXPECT_LE(error, 1e-14);
    EXPECT_FALSE(errors.edges);
  }
}

TYPED_TEST(ShapeAlongAxis, HasTheSlopesOfItsWeights) {
  constexpr double d = 1e-5;
  for (const GridAxis& axis : {walled, endless}) {
    const AlongAxis<TypeParam> along(axis);
    for (double x = 0.0131; x < axis.cells; x += 0.0517) {
      const auto before = along.near(x - d), here = along.near(x), after = along.near(x + d);
      if (before.first != after.first) continue;  // across an edge
      for (int a = 0; a < here.width; ++a)
        EXPECT_NEAR((after.weight[a] - before.weight[a]) / (2 * d), here.slope[a], 1e-4) << x;
    }
  }
}

TYPED_TEST(ShapeAlongAxis, HasNoJumpsWhereCellsMeet) {
  for (const GridAxis& axis : {walled, endless}) {
    const AlongAxis<TypeParam> along(axis);
    for (double x = 0.25; x < axis.cells; x += 0.25) {  // where GIMP changes its nodes too
      auto below = by_node<TypeParam>(along.near(x - 1e-9), along.near(x - 1e-9).weight),
           above = by_node<TypeParam>(along.near(x), along.near(x).weight);
      for (int node = -1; node <= along.nodes(); ++node) EXPECT_NEAR(below[node], above[node], 1e-8) << x;
    }
  }
}

TYPED_TEST(ShapeAlongAxis, IsTheSameInEveryCellOfAPeriodicAxis) {
  const AlongAxis<TypeParam> along(endless);
  for (double x : {0.1, 0.4, 0.8})
    for (int cell = -1; cell < 9; ++cell) {
      const auto here = along.near(x), there = along.near(x + cell);
      EXPECT_EQ(there.first, here.first + cell);
      for (int a = 0; a < here.width; ++a) {
        EXPECT_NEAR(there.weight[a], here.weight[a], 1e-14);
        EXPECT_NEAR(there.arm[a], here.arm[a], 1e-14);
      }
    }
}

TYPED_TEST(ShapeAlongAxis, KnowsTheAffineSlopeOfALinearField) {
  for (const GridAxis& axis : {walled, endless}) {
    const AlongAxis<TypeParam> along(axis);
    for (int k = 0; k <= 16 * axis.cells; ++k) {
      const auto near = along.near(k / 16.0);
      const auto slopes = affine_slopes_of(near);
      double of_one = 0, of_place = 0;
      for (int a = 0; a < near.width; ++a) {
        of_one += slopes[a];
        of_place += slopes[a] * near.arm[a];
      }
      EXPECT_NEAR(of_one, 0, 1e-11) << k;
      EXPECT_NEAR(of_place, 1, 1e-11) << k;
    }
  }
}

TEST(BSpline, OfFirstDegreeIsTheHat) {
  for (const GridAxis& axis : {walled, endless})
    for (double x = 0; x < axis.cells; x += 0.1) {
      const auto spline = AlongAxis<BSpline<1>>(axis).near(x);
      const auto hat = AlongAxis<LinearHat>(axis).near(x);
      EXPECT_EQ(spline.first, hat.first);
      for (int a = 0; a < 2; ++a) {
        EXPECT_NEAR(spline.weight[a], hat.weight[a], 1e-15);
        EXPECT_NEAR(spline.arm[a], hat.arm[a], 1e-15);
      }
    }
}

TEST(BSpline, OfSecondDegreeAwayFromWallsIsTheOneAtCellCentres) {
  const AlongAxis<BSpline<2>> along(walled);
  for (double X : {0.0, 0.3, 0.75}) {
    const auto near = along.near(3 + X);
    for (int a = 0; a < 3; ++a) {
      EXPECT_NEAR(near.weight[a], QuadraticBSpline::weight(a, X), 1e-15);
      EXPECT_NEAR(near.slope[a], QuadraticBSpline::slope(a, X), 1e-15);
      EXPECT_NEAR(near.arm[a], QuadraticBSpline::place(a) - X, 1e-15);
    }
  }
}

TEST(BSpline, OfThirdDegreeHasTheWeightsOfTheTextbookOnAKnot) {
  const auto near = AlongAxis<BSpline<3>>(endless).near(3);
  EXPECT_NEAR(near.weight[0], 1.0 / 6, 1e-15);
  EXPECT_NEAR(near.weight[1], 4.0 / 6, 1e-15);
  EXPECT_NEAR(near.weight[2], 1.0 / 6, 1e-15);
  EXPECT_NEAR(near.weight[3], 0, 1e-15);
}

TEST(Gimp, TendsToTheHatForSmallParticles) {
  for (double reach : {1e-2, 1e-4}) {
    GridAxis axis = walled;
    axis.reach = reach;
    for (double x = 0.003; x < axis.cells; x += 0.07) {
      auto gimp = by_node<Gimp>(AlongAxis<Gimp>(axis).near(x), AlongAxis<Gimp>(axis).near(x).weight),
           hat = by_node<LinearHat>(AlongAxis<LinearHat>(axis).near(x), AlongAxis<LinearHat>(axis).near(x).weight);
      for (int node = 0; node <= axis.cells; ++node) EXPECT_NEAR(gimp[node], hat[node], 0.5 * reach) << x;
    }
  }
}

TEST(Gimp, IsTheMeanOfTheHatOverTheParticle) {
  const AlongAxis<Gimp> gimp(endless);
  const AlongAxis<LinearHat> hat(endless);
  constexpr int parts = 2000;
  for (double x : {2.1, 2.5, 2.95}) {
    std::map<int, double> mean;
    for (int k = 0; k < parts; ++k) {
      const auto near = hat.near(x + endless.reach * ((2 * k + 1.0) / parts - 1));
      for (int a = 0; a < 2; ++a) mean[near.first + a] += near.weight[a] / parts;
    }
    const auto near = gimp.near(x);
    for (int a = 0; a < 3; ++a) EXPECT_NEAR(near.weight[a], mean[near.first + a], 1e-7);
  }
}

TEST(Gimp, RefusesParticlesLargerThanACellAndASingleCell) {
  EXPECT_THROW(Gimp::Along({.cells = 7, .periodic = false, .reach = 0.6}), std::invalid_argument);
  EXPECT_THROW(Gimp::Along({.cells = 7, .periodic = false, .reach = 0}), std::invalid_argument);
  EXPECT_THROW(Gimp::Along({.cells = 1, .periodic = false, .reach = 0.25}), std::invalid_argument);
}

}  // namespace
}  // namespace touchstone::mpm

/// What all laminar viscosities have to do, and what only some do; and all terms at one pair against their formulas.

#include "solvers/fields.hpp"
#include "solvers/sph/kernels/quintic_spline.hpp"
#include "solvers/sph/kernels/wendland_c2.hpp"
#include "solvers/sph/momentum.hpp"
#include "solvers/sph/terms/artificial_viscosity.hpp"
#include "solvers/sph/terms/laminar_viscosity.hpp"
#include "solvers/sph/terms/monaghan_cleary_viscosity.hpp"
#include "solvers/sph/terms/morris_viscosity.hpp"
#include "solvers/sph/terms/pressure.hpp"
#include "solvers/sph/terms/pressure_difference.hpp"
#include "solvers/sph/terms/pressure_sum.hpp"

#include <gtest/gtest.h>

namespace touchstone::sph {
namespace {

constexpr double spacing = 0.1, rho = 1000, mu = 2;  // m, kg/m³, Pa s

/// A pair of particles of the lattice `spacing`, of equal density.
template <class Kernel>
Pair<double> pair_at(const Vec2& apart, const Vec2& v_ij, double h) {
  Pair<double> ij{};
  ij.x = apart.x();
  ij.y = apart.y();
  ij.r2 = apart.squaredNorm();
  ij.r = std::sqrt(ij.r2);
  ij.slope = Slope<Kernel>(h)(ij.r, 1 / ij.r);
  ij.vx = v_ij.x();
  ij.vy = v_ij.y();
  ij.rho_i = ij.rho_j = rho;
  ij.specific_volume_i = ij.specific_volume_j = 1 / rho;
  ij.mass = rho * spacing * spacing;
  return ij;
}

/// The acceleration of the particle in the middle of a lattice that moves with v(x).
template <class Kernel, class Term, class Velocity>
Vec2 acceleration(const Term& term, double h, const Velocity& v) {
  Vec2 sum = Vec2::Zero();
  const int reach = static_cast<int>(Kernel::support * h / spacing) + 1;
  for (int row = -reach; row <= reach; ++row)
    for (int column = -reach; column <= reach; ++column) {
      if (row == 0 && column == 0) continue;
      const Vec2 x(spacing * column, spacing * row);
      const Acceleration<double> by_one = term(pair_at<Kernel>(-x, v(Vec2(0, 0)) - v(x), h));
      sum += Vec2(by_one.x, by_one.y);
    }
  return sum;
}

struct LoAndShao {
  static constexpr bool turns_nothing = false;
  static constexpr double few_neighbours = 0.01, many = 0.01;  // what the viscosity may be off, as a fraction
  static LaminarViscosity term() { return {.nu = mu / rho, .eta = 1e-4 * spacing}; }
};
struct Morris {
  static constexpr bool turns_nothing = false;
  static constexpr double few_neighbours = 0.01, many = 0.01;
  static MorrisViscosity term() { return {.mu = mu}; }
};
struct MonaghanCleary {
  static constexpr bool turns_nothing = true;
  static constexpr double few_neighbours = 0.17, many = 0.015;
  static MonaghanClearyViscosity term() { return {.mu = mu}; }
};

template <class Viscosity>
class ViscosityOf : public testing::Test {};
using Viscosities = testing::Types<LoAndShao, Morris, MonaghanCleary>;
TYPED_TEST_SUITE(ViscosityOf, Viscosities);

TYPED_TEST(ViscosityOf, APairKeepsItsMomentumAndLosesEnergy) {
  const Vec2 apart(0.07, -0.05), v(0.3, 0.8);
  const auto on_i = TypeParam::term()(pair_at<QuinticSpline>(apart, v, spacing)),
             on_j = TypeParam::term()(pair_at<QuinticSpline>(-apart, -v, spacing));
  EXPECT_EQ(on_i.x, -on_j.x);
  EXPECT_EQ(on_i.y, -on_j.y);
  EXPECT_LT(on_i.x * v.x() + on_i.y * v.y(), 0);
}

TYPED_TEST(ViscosityOf, APairKeepsItsAngularMomentumIfThatIsClaimed) {
  const Vec2 apart(0.07, -0.05), v(0.3, 0.8);
  const auto on_i = TypeParam::term()(pair_at<QuinticSpline>(apart, v, spacing));
  const double torque = apart.x() * on_i.y - apart.y() * on_i.x;
  if (TypeParam::turns_nothing)
    EXPECT_NEAR(torque, 0, 1e-15);
  else
    EXPECT_GT(std::abs(torque), 1e-3);
}

TYPED_TEST(ViscosityOf, UniformFlowAndUniformShearFeelNothing) {
  for (const auto& v : {+[](const Vec2&) -> Vec2 {
                          return {3, -2};
                        },
                        +[](const Vec2& x) -> Vec2 {
                          return {4 * x.y(), 0};
                        }})
    EXPECT_LT((acceleration<QuinticSpline>(TypeParam::term(), spacing, v).norm()), 1e-13);
}

/// v_x = y², which is accelerated by 2 nu: by how much a viscosity is off, with more neighbours and more.
template <class Kernel, class Viscosity>
double miss(double h) {
  const Vec2 found = acceleration<Kernel>(Viscosity::term(), h, [](const Vec2& x) -> Vec2 {
    return {x.y() * x.y(), 0};
  });
  EXPECT_NEAR(found.y(), 0, 1e-12);
  return found.x() / (2 * mu / rho) - 1;
}

TYPED_TEST(ViscosityOf, ShearThatGrowsIsHeldBackByTheViscosity) {
  EXPECT_NEAR((miss<QuinticSpline, TypeParam>(spacing)), 0, TypeParam::few_neighbours);
  EXPECT_NEAR((miss<WendlandC2, TypeParam>(3 * spacing)), 0, TypeParam::many);
}

TYPED_TEST(ViscosityOf, IsMetMoreCloselyWithMoreNeighbours) {
  EXPECT_LT(std::abs(miss<WendlandC2, TypeParam>(4 * spacing)),
            0.3 * std::abs(miss<WendlandC2, TypeParam>(1.5 * spacing)));
}

TEST(MonaghanClearyViscosity, HoldsBackAChangeOfVolumeByThreeTimesTheShear) {
  // v_x = x²: mu (laplacian v + 2 grad div v) / rho for this form, so 2 nu (1 + 2).
  const Vec2 found = acceleration<WendlandC2>(MonaghanCleary::term(), 4 * spacing, [](const Vec2& x) -> Vec2 {
    return {x.x() * x.x(), 0};
  });
  EXPECT_NEAR(found.x() / (2 * mu / rho), 3, 0.03);
}

/// So close that softening is felt, with two particles that differ in all they have.
TEST(Terms, OfAClosePairAreWhatTheirPapersPrint) {
  constexpr double h = 0.12, eta = 0.1 * h, nu = 3e-3, alpha = 0.3, sound = 20;
  constexpr double rho_i = 800, rho_j = 1300, p_i = 700, p_j = -200;
  const Vec2 apart(0.011, -0.007), v_ij(-0.3, 0.4);
  Pair<double> ij = pair_at<QuinticSpline>(apart, v_ij, h);
  ij.rho_i = rho_i, ij.specific_volume_i = 1 / rho_i, ij.p_i = p_i, ij.p_over_rho2_i = p_i / (rho_i * rho_i);
  ij.rho_j = rho_j, ij.specific_volume_j = 1 / rho_j, ij.p_j = p_j, ij.p_over_rho2_j = p_j / (rho_j * rho_j);
  const Vec2 grad_W = ij.slope * apart;
  const double m = ij.mass, r2 = apart.squaredNorm(), closing = v_ij.dot(apart);
  ASSERT_LT(closing, 0);
  const auto expect = [&](const char* name, const Acceleration<double>& found, const Vec2& expected) {
    EXPECT_LT((Vec2(found.x, found.y) - expected).norm(), 1e-13 * expected.norm()) << name;
  };
  expect("Monaghan (1992), (3.3)", Pressure{}(ij), -m * (p_i / (rho_i * rho_i) + p_j / (rho_j * rho_j)) * grad_W);
  expect("Monaghan (1992), (3.1)", PressureDifference{}(ij), -m * (p_j - p_i) / (rho_i * rho_j) * grad_W);
  expect("Colagrossi & Landrini (2003)", PressureSum{}(ij), -m * (p_j + p_i) / (rho_i * rho_j) * grad_W);
  expect("Lo & Shao (2002)", LaminarViscosity{.nu = nu, .eta = eta}(ij),
         m * 4 * nu * apart.dot(grad_W) / ((rho_i + rho_j) * (r2 + eta * eta)) * v_ij);
  expect("Monaghan (1992), (4.1)", ArtificialViscosity{.alpha = alpha, .sound_speed = sound, .h = h}(ij),
         m * alpha * sound * (h * closing / (r2 + eta * eta)) / ((rho_i + rho_j) / 2) * grad_W);
  expect("Morris, Fox & Zhu (1997)", MorrisViscosity{.mu = mu}(ij),
         m * 2 * mu / (rho_i * rho_j) * apart.dot(grad_W) / r2 * v_ij);
  expect("Monaghan (2005)", MonaghanClearyViscosity{.mu = mu}(ij),
         m * 8 * mu / (rho_i * rho_j) * closing / r2 * grad_W);
  EXPECT_NEAR(ij.continuity(), m * v_ij.dot(grad_W), 1e-13 * std::abs(ij.continuity()));  // Sun et al. (23)
}

}  // namespace
}  // namespace touchstone::sph

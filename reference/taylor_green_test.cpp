#include "reference/taylor_green.hpp"

#include "reference/calculus.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace touchstone::reference {
namespace taylor_green_test {

constexpr TaylorGreen flow{.L = 1, .U = 1, .nu = 0.01, .rho = 1};  // Reynolds number 100
constexpr double step = 0.01;
constexpr std::array<std::array<double, 2>, 4> places{{{0.1, 0.2}, {0.37, 0.81}, {0.5, 0.5}, {0.93, 0.04}}};
constexpr std::array<double, 3> times{0.1, 0.5, 2};

// Slopes of a field f(x, y) at a place.
template <class Field>
double along_x(const Field& f, double x, double y) {
  return slope([&](double s) { return f(s, y); }, x, step);
}
template <class Field>
double along_y(const Field& f, double x, double y) {
  return slope([&](double s) { return f(x, s); }, y, step);
}
template <class Field>
double laplacian(const Field& f, double x, double y) {
  return along_x([&](double a, double b) { return along_x(f, a, b); }, x, y) +
         along_y([&](double a, double b) { return along_y(f, a, b); }, x, y);
}

TEST(TaylorGreen, LosesNoVolume) {
  for (const double t : times)
    for (const auto [x, y] : places) {
      const auto u = [t](double a, double b) { return flow.v_x(a, b, t); };
      const auto v = [t](double a, double b) { return flow.v_y(a, b, t); };
      EXPECT_NEAR(along_x(u, x, y) + along_y(v, x, y), 0, 1e-8);
    }
}

TEST(TaylorGreen, KeepsItsMomentum) {
  for (const double t : times)
    for (const auto& place : places) {
      const double x = place[0], y = place[1];
      const auto u = [t](double a, double b) { return flow.v_x(a, b, t); };
      const auto v = [t](double a, double b) { return flow.v_y(a, b, t); };
      const auto p = [t](double a, double b) { return flow.p(a, b, t); };
      const double here_u = u(x, y), here_v = v(x, y);
      const double change_u = slope([&](double s) { return flow.v_x(x, y, s); }, t, step),
                   change_v = slope([&](double s) { return flow.v_y(x, y, s); }, t, step);
      EXPECT_NEAR(change_u + here_u * along_x(u, x, y) + here_v * along_y(u, x, y),
                  -along_x(p, x, y) / flow.rho + flow.nu * laplacian(u, x, y), 1e-5);
      EXPECT_NEAR(change_v + here_u * along_x(v, x, y) + here_v * along_y(v, x, y),
                  -along_y(p, x, y) / flow.rho + flow.nu * laplacian(v, x, y), 1e-5);
    }
}

TEST(TaylorGreen, RepeatsAlongBothAxes) {
  for (const auto [x, y] : places) {
    EXPECT_NEAR(flow.v_x(x + flow.L, y, 0.3), flow.v_x(x, y, 0.3), 1e-14);
    EXPECT_NEAR(flow.v_y(x, y - 2 * flow.L, 0.3), flow.v_y(x, y, 0.3), 1e-14);
    EXPECT_NEAR(flow.p(x + flow.L, y + flow.L, 0.3), flow.p(x, y, 0.3), 1e-14);
  }
}

TEST(TaylorGreen, HasTheEnergyOfItsVelocities) {
  for (const double t : {0.0, 0.5}) {
    const auto speed = [t](double x, double y) {
      return flow.v_x(x, y, t) * flow.v_x(x, y, t) + flow.v_y(x, y, t) * flow.v_y(x, y, t);
    };
    const double of_all =
        integral([&](double y) { return integral([&](double x) { return speed(x, y); }, 0, flow.L); }, 0, flow.L);
    EXPECT_NEAR(flow.energy(t), flow.rho / 2 * of_all, 1e-9);
  }
  EXPECT_NEAR(flow.energy(1) / flow.energy(0), std::exp(-2 * flow.decay_rate()), 1e-14);
}

TEST(TaylorGreen, RefusesWhatIsNoFlow) {
  EXPECT_THROW(TaylorGreen({.L = 0, .U = 1, .nu = 1, .rho = 1}).v_x(0, 0, 0), std::domain_error);
  EXPECT_THROW(TaylorGreen({.L = 1, .U = 1, .nu = -1, .rho = 1}).p(0, 0, 0), std::domain_error);
  EXPECT_THROW(flow.v_y(0, 0, -1), std::domain_error);
  EXPECT_THROW(flow.v_y(std::numeric_limits<double>::quiet_NaN(), 0, 0), std::domain_error);
}

}  // namespace taylor_green_test
}  // namespace touchstone::reference

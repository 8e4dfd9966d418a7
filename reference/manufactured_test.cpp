#include "reference/manufactured.hpp"

#include "reference/calculus.hpp"

#include <gtest/gtest.h>

namespace touchstone::reference {
namespace manufactured_test {

constexpr Manufactured flow{.L = 2, .U = 1.5, .omega = 3, .rho0 = 1000, .ripple = 0.1, .K = 4000, .mu = 30};

struct Point {
  double x, y, t;
};
constexpr std::array points{Point{0.1, 0.2, 0}, Point{1.3, 0.7, 0.4}, Point{-0.6, 2.9, 1.1}};
constexpr double step = 1e-3;

/// A component of the velocity, or of what is made of it, as a function of one coordinate.
template <class Function>
double along_x(const Function& f, const Point& p) {
  return slope([&](double x) { return f(x, p.y, p.t); }, p.x, step);
}
template <class Function>
double along_y(const Function& f, const Point& p) {
  return slope([&](double y) { return f(p.x, y, p.t); }, p.y, step);
}

TEST(Manufactured, KeepsItsMass) {
  for (const Point& p : points) {
    const auto momentum = [](int i) {
      return [i](double x, double y, double t) { return flow.density(x, y) * flow.velocity(x, y, t)[i]; };
    };
    EXPECT_NEAR(along_x(momentum(0), p) + along_y(momentum(1), p), 0, 1e-6);
  }
}

TEST(Manufactured, ObeysTheEquationOfMotionWithItsForce) {
  for (const Point& p : points) {
    const double rho = flow.density(p.x, p.y);
    const auto v = [](int i) { return [i](double x, double y, double t) { return flow.velocity(x, y, t)[i]; }; };
    const auto divergence = [&](double x, double y, double t) {
      return along_x(v(0), {x, y, t}) + along_y(v(1), {x, y, t});
    };
    const auto pressure = [](double x, double y, double) { return flow.pressure(x, y); };
    for (const int i : {0, 1}) {
      const auto of_x = [&](double x, double y, double t) { return along_x(v(i), {x, y, t}); };
      const auto of_y = [&](double x, double y, double t) { return along_y(v(i), {x, y, t}); };
      const auto along = [&](const auto& f) { return i == 0 ? along_x(f, p) : along_y(f, p); };
      const double rate = slope([&](double t) { return v(i)(p.x, p.y, t); }, p.t, step) +
                          v(0)(p.x, p.y, p.t) * of_x(p.x, p.y, p.t) + v(1)(p.x, p.y, p.t) * of_y(p.x, p.y, p.t);
      const double drag = flow.mu / rho * (along_x(of_x, p) + along_y(of_y, p) + along(divergence) / 3);
      EXPECT_NEAR(flow.force(p.x, p.y, p.t)[i], rate + along(pressure) / rho - drag, 1e-5);
    }
  }
}

TEST(Manufactured, RepeatsAlongBothAxes) {
  const auto here = flow.force(0.3, 0.4, 0.2), there = flow.force(2.3, -1.6, 0.2);
  EXPECT_NEAR(here[0], there[0], 1e-10);
  EXPECT_NEAR(here[1], there[1], 1e-10);
}

TEST(Manufactured, HasItsForceFromEveryTerm) {
  const auto at = [](const Manufactured& f) { return f.force(0.3, 0.4, 0.2)[0]; };
  Manufactured steady = flow, still = flow, smooth = flow, thin = flow;
  steady.omega = 0;
  still.U = 0;
  smooth.ripple = 0;
  thin.mu = 1e-9;
  for (const Manufactured& other : {steady, still, smooth, thin}) EXPECT_GT(std::abs(at(other) - at(flow)), 0.01);
}

TEST(Manufactured, RefusesWhatIsNoFlow) {
  const auto with = [](double Manufactured::*field, double value) {
    Manufactured f = flow;
    f.*field = value;
    return f;
  };
  for (const auto field : {&Manufactured::L, &Manufactured::rho0, &Manufactured::K, &Manufactured::mu})
    EXPECT_THROW(with(field, 0).force(0, 0, 0), std::domain_error);
  EXPECT_THROW(with(&Manufactured::ripple, 1).density(0, 0), std::domain_error);
  EXPECT_THROW(flow.velocity(0, 0, std::nan("")), std::domain_error);
  EXPECT_THROW(flow.velocity(std::nan(""), 0, 0), std::domain_error);
}

}  // namespace manufactured_test
}  // namespace touchstone::reference

#include "solvers/quadratic_fit.hpp"

#include "solvers/sph/pair_lanes.hpp"

#include <gtest/gtest.h>

#include <random>

namespace touchstone {
namespace {

using Polynomial = std::array<double, 6>;

double at(const Polynomial& c, double x, double y) {
  return c[0] + c[1] * x + c[2] * y + c[3] * x * x + c[4] * x * y + c[5] * y * y;
}

struct Neighbour {
  double x, y, weight;
};
std::vector<Neighbour> scattered(int count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-1, 1), weight(0.1, 1);
  std::vector<Neighbour> all;
  for (int k = 0; k < count; ++k) all.push_back({place(random), place(random), weight(random)});
  return all;
}

template <class Real, std::size_t fields, class Field>
auto sums_of(const std::vector<Neighbour>& neighbours, const Field& field) {
  using Fit = QuadraticFit<Real, fields>;
  typename Fit::Sums sums{};
  for (const auto& [x, y, weight] : neighbours) {
    const auto added = Fit::terms(Real{} + weight, Real{} + x, Real{} + y, field(x, y));
    for (std::size_t k = 0; k < Fit::count; ++k) sums[k] += added[k];
  }
  return sums;
}

constexpr Polynomial one{3, -2, 5, 7, -1, 4}, another{0, 1, 0, -3, 2, 6};

TEST(QuadraticFit, FindsTwoPolynomialsOfSecondDegreeFromAnyNeighbours) {
  for (const int count : {6, 7, 30}) {
    const auto sums = sums_of<double, 2>(scattered(count), [](double x, double y) {
      return std::array{at(one, x, y), at(another, x, y)};
    });
    const auto found = QuadraticFit<double, 2>::of(sums);
    for (std::size_t k = 0; k < 6; ++k) {
      EXPECT_NEAR(found[0][k], one[k], 1e-9) << count;
      EXPECT_NEAR(found[1][k], another[k], 1e-9) << count;
    }
  }
}

TEST(QuadraticFit, ThroughZeroLeavesNothingOfAPolynomialThatVanishesInTheMiddle) {
  const auto sums = sums_of<double, 1>(scattered(5), [](double x, double y) { return std::array{at(another, x, y)}; });
  const auto found = QuadraticFit<double, 1>::through_zero(sums)[0];
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(found[k], another[k], 1e-9);
}

TEST(QuadraticFit, IsTheBestOfAllPolynomials) {
  const auto neighbours = scattered(20);
  const auto cube = [](double x, double y) { return std::array{x * x * x - 2 * y * y * x + 0.3}; };
  const auto found = QuadraticFit<double, 1>::of(sums_of<double, 1>(neighbours, cube))[0];
  const auto missed = [&](const Polynomial& c) {
    double squares = 0;
    for (const auto& [x, y, weight] : neighbours) squares += weight * std::pow(cube(x, y)[0] - at(c, x, y), 2);
    return squares;
  };
  for (std::size_t k = 0; k < 6; ++k)
    for (const double change : {-1e-3, 1e-3}) {
      Polynomial other = found;
      other[k] += change;
      EXPECT_GT(missed(other), missed(found)) << k;
    }
}

TEST(QuadraticFit, ThroughZeroLeavesTheWeightedMeanOfWhatItMisses) {
  const auto neighbours = scattered(12);
  const auto cone = [](double x, double y) { return std::array{std::hypot(x, y)}; };
  const auto found = QuadraticFit<double, 1>::through_zero(sums_of<double, 1>(neighbours, cone))[0];
  Polynomial fitted = found;
  fitted[0] = 0;
  double missed = 0, weights = 0;
  for (const auto& [x, y, weight] : neighbours) {
    missed += weight * (cone(x, y)[0] - at(fitted, x, y));
    weights += weight;
  }
  EXPECT_NEAR(found[0], missed / weights, 1e-12);
}

TEST(QuadraticFit, IsTheSameInEveryLane) {
  using Lanes = LanesOf<double>;
  const auto neighbours = scattered(9);
  const auto wide = QuadraticFit<Lanes, 1>::through_zero(
      sums_of<Lanes, 1>(neighbours, [](double x, double y) { return std::array{Lanes{} + at(one, x, y)}; }));
  const auto single = QuadraticFit<double, 1>::through_zero(
      sums_of<double, 1>(neighbours, [](double x, double y) { return std::array{at(one, x, y)}; }));
  for (std::size_t k = 0; k < 6; ++k)
    for (int lane = 0; lane < lanes_of<double>; ++lane) EXPECT_NEAR(wide[0][k][lane], single[0][k], 1e-12);
}

}  // namespace
}  // namespace touchstone

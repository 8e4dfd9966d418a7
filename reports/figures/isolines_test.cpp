#include "reports/figures/isolines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace touchstone::reports {
namespace {

/// Particles on a lattice of 0.05 in the unit square.
vnv::Cloud lattice(const std::function<double(double, double)>& colour) {
  vnv::Cloud cloud;
  for (int i = 0; i < 20; ++i)
    for (int k = 0; k < 20; ++k) {
      const double x = 0.05 * (i + 0.5), y = 0.05 * (k + 0.5);
      cloud.x.push_back(x), cloud.y.push_back(y), cloud.colour.push_back(colour(x, y));
    }
  return cloud;
}
double length(const IsolinePiece& piece) { return std::hypot(piece.to_x - piece.x, piece.to_y - piece.y); }

TEST(Isolines, OfAPlaneAreStraightAndWhereTheFieldHasTheirLevel) {
  const auto lines = isolines(lattice([](double x, double) { return 10 * x; }), 4, 0.05);
  ASSERT_FALSE(lines.empty());
  double whole = 0;
  for (const IsolinePiece& line : lines) {
    EXPECT_TRUE(line.level == 4 || line.level == 8) << line.level;
    EXPECT_NEAR(10 * line.x, line.level, 0.05);
    whole += length(line);
  }
  EXPECT_NEAR(whole, 2 * 0.95, 0.06) << "from the first row of particles to the last, twice";
}

TEST(Isolines, OfAConeAreACircle) {
  const auto lines = isolines(lattice([](double x, double y) { return std::hypot(x - 0.5, y - 0.5); }), 0.3, 0.05);
  double whole = 0;
  for (const IsolinePiece& line : lines)
    if (line.level == 0.3) whole += length(line);
  EXPECT_NEAR(whole, 2 * std::numbers::pi * 0.3, 0.05);
}

TEST(Isolines, OfASaddleDoNotCross) {
  for (const IsolinePiece& line :
       isolines(lattice([](double x, double y) { return (x - 0.5) * (y - 0.5); }), 0.01, 0.05))
    EXPECT_LT(length(line), 0.08) << "a piece lies within a cell";
}

TEST(Isolines, AreNotWhereThereAreNoParticles) {
  vnv::Cloud halves = lattice([](double, double y) { return y; });
  for (double& x : halves.x) x = x < 0.5 ? x : x + 1;  // with a gap from 0.5 to 1.5
  for (const IsolinePiece& line : isolines(halves, 0.1, 0.05)) EXPECT_TRUE(line.x < 0.6 || line.x > 1.4) << line.x;
  EXPECT_TRUE(isolines({}, 1, 1).empty());
  EXPECT_TRUE(isolines(halves, 0, 0.05).empty());
  halves.colour[0] = NAN, halves.x[1] = INFINITY;
  EXPECT_FALSE(isolines(halves, 0.1, 0.05).empty());
}

}  // namespace
}  // namespace touchstone::reports

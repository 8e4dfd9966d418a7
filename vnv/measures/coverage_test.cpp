#include "vnv/measures/coverage.hpp"

#include "solvers/lattice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace touchstone::vnv {
namespace coverage_test {

/// A square of 1 m, periodic along x, with so many rows across.
struct Square {
  long across;
  Domain domain{.box = {.high = {1, 1}}, .periodic_x = true};

  double spacing() const { return 1.0 / static_cast<double>(across); }
  Vectors regular() const { return lattice(domain.box, spacing()).places(); }
  /// Each row moved by up to a part of a spacing along both axes.
  Vectors shaken(double part, unsigned seed) const {
    std::mt19937 draw(seed);
    std::uniform_real_distribution<double> any(-part * spacing(), part * spacing());
    Vectors places = regular();
    for (double& one : places.reshaped()) one = std::clamp(one + any(draw), 0.0, 1 - 1e-9);
    return places;
  }
  Coverage of(const Vectors& places) const { return coverage_of(places, spacing(), {domain}); }
};

Vectors without(const Vectors& places, const std::function<bool(const Vec2&)>& is_gone) {
  std::vector<Eigen::Index> kept;
  for (Eigen::Index p = 0; p < places.cols(); ++p)
    if (!is_gone(places.col(p))) kept.push_back(p);
  return places(Eigen::all, kept);
}

TEST(Coverage, OfALatticeIsWithoutHolesAtAnyResolution) {
  for (const long across : {4, 7, 15, 33, 60, 101}) {
    const Coverage found = Square{across}.of(Square{across}.regular());
    EXPECT_EQ(found.grid_places, across * across);
    EXPECT_EQ(found.empty_places + found.in_one_place, 0);
    EXPECT_NEAR(found.hole, std::sqrt(2), 1e-5) << across;
  }
}

TEST(Coverage, OfACloudKeepsTheLimitsThatAreClaimed) {
  for (const long across : {5, 15, 60})
    for (unsigned seed = 0; seed < 5; ++seed)
      for (const double part : {0.05, 0.25, 0.5}) {
        const Square square{across};
        const Coverage found = square.of(square.shaken(part, seed));
        const auto rows = static_cast<double>(across * across);
        EXPECT_LT(found.hole, largest_sound_hole(rows)) << across << ", " << part;
        EXPECT_LT(found.crowded, most_crowded(rows)) << across << ", " << part;
        EXPECT_EQ(found.grid_places + found.in_one_place, 0);
      }
}

TEST(Coverage, LetsAStrainDrawALatticeApartAndFindsWhatIsMissingInIt) {
  constexpr long across = 40;
  const Square square{across};
  for (const double longer : {2.0, 4.0, 5.0}) {  // along x, and as much narrower along y
    const Lattice one = lattice({.high = {1, longer}}, 1.0 / across);
    Vectors drawn = one.places();
    drawn.row(1) /= longer;
    drawn.row(0) *= longer;
    drawn = drawn(Eigen::all, [&] {
      std::vector<Eigen::Index> within;
      for (Eigen::Index p = 0; p < drawn.cols(); ++p)
        if (drawn(0, p) < 1) within.push_back(p);
      return within;
    }());
    for (Eigen::Index p = 0; p < drawn.cols(); ++p) drawn(0, p) = std::fmod(drawn(0, p) + 0.3 * drawn(1, p), 1);
    EXPECT_LT(square.of(drawn).hole, 2.6) << longer;
    const Vectors holed = without(drawn, [](const Vec2& x) { return (x - Vec2(0.5, 0.5)).norm() < 0.15; });
    EXPECT_GT(square.of(holed).hole, largest_sound_hole(across * across)) << longer;
  }
}

TEST(Coverage, FindsTheDiameterOfAHoleAndWhereItIs) {
  for (const double width : {3.0, 4.0, 7.5})
    for (const long across : {20, 60}) {
      const Square square{across};
      for (const Vec2& centre : {Vec2(0.503, 0.47), Vec2(0.01, 0.6)}) {  // also over the periodic boundary
        const double radius = width / 2 * square.spacing();
        const auto apart = [&](const Vec2& x) {
          Vec2 d = x - centre;
          d.x() -= std::round(d.x());
          return d.norm();
        };
        const Coverage found =
            square.of(without(square.shaken(0.25, 1), [&](const Vec2& x) { return apart(x) < radius; }));
        EXPECT_GE(found.hole, width - 0.01);
        EXPECT_LT(found.hole, width + 1.5);
        EXPECT_LT(apart(found.hole_at), square.spacing());
      }
    }
}

TEST(Coverage, FindsAStripWithoutRowsAlongWallsAndAcross) {
  for (const auto& [across, missing] : {std::pair(16L, 2.5), {24L, 2.5}, {48L, 1.7}})
    for (unsigned seed = 0; seed < 3; ++seed)
      for (const int axis : {0, 1}) {
        const Square square{across};
        const Vectors places = square.shaken(0.25, seed);
        const double width = missing * square.spacing(), most = largest_sound_hole(static_cast<double>(places.cols()));
        for (const double from : {0.0, 0.4, 1 - width}) {
          const auto is_gone = [&](const Vec2& x) { return x[axis] >= from && x[axis] < from + width; };
          const Coverage found = square.of(without(places, is_gone));
          EXPECT_GT(found.hole, most) << across << " across, from " << from << " along " << axis;
          EXPECT_NEAR(found.hole_at[axis], from + width / 2, 0.5 * square.spacing());
        }
      }
}

TEST(Coverage, OfADropThatIsDrawnOutIsWithoutStrips) {
  const Square square{30};
  Vectors drop = without(square.regular(), [](const Vec2& x) { return (x - Vec2(0.5, 0.5)).norm() > 0.5; });
  drop.row(0) = 2 * (drop.row(0).array() - 0.5);
  drop.row(1) = (drop.row(1).array() - 0.5) / 2;
  const auto depth = [](const Vec2& x) { return (0.5 - std::hypot(x.x() / 2, 2 * x.y())) / 2; };
  const Domain domain{.box = {.low = {-1, -1}, .high = {1, 1}}};
  const auto hole = [&](const Vectors& places) {
    return coverage_of(places, square.spacing(), {.domain = domain, .depth = depth, .drawn = {2, 0.5}}).hole;
  };
  EXPECT_LT(hole(drop), 2.5);
  const auto is_in_band = [](const Vec2& x) { return std::abs(x.x()) < 0.15; };
  EXPECT_GT(hole(without(drop, is_in_band)), 3.9);
}

TEST(Coverage, OfAnUprightGridComparesGapsWithThoseBesideThem) {
  const Square square{20};
  const auto graded = [](double y) { return (1 - std::cos(std::numbers::pi * y)) / 2; };
  Vectors places = square.regular();
  for (double& y : places.row(1).reshaped()) y = graded(y);
  EXPECT_LT(square.of(places).hole, std::numbers::sqrt2 * widest_sound_gap) << "a graded mesh";
  const auto in_line = [&](double y) { return [=](const Vec2& x) { return std::abs(x.y() - y) < 1e-9; }; };
  EXPECT_NEAR(square.of(without(square.regular(), in_line(0.525))).hole, 2 * std::numbers::sqrt2, 1e-5);
  const Coverage at_wall = square.of(without(square.regular(), in_line(0.025)));
  EXPECT_NEAR(at_wall.hole, 1.5 * std::numbers::sqrt2, 1e-5);
  EXPECT_NEAR(at_wall.hole_at.y(), 0.0375, 1e-6);
  const Coverage without_one =
      square.of(without(square.regular(), [](const Vec2& x) { return (x - Vec2(0.325, 0.475)).norm() < 1e-9; }));
  EXPECT_EQ(without_one.empty_places, 1);
  EXPECT_NEAR((without_one.empty_at - Vec2(0.325, 0.475)).norm(), 0, 1e-6);
}

TEST(Coverage, CountsRowsInOnePlaceButNotNodesOfBothEndsOfAPeriod) {
  const Square square{12};
  for (const bool is_shaken : {false, true}) {
    const Vectors places = is_shaken ? square.shaken(0.2, 3) : square.regular();
    Vectors more(2, places.cols() + 3);
    more << places, places.col(5), places.col(50), places.col(5);
    EXPECT_EQ(square.of(more).in_one_place, 3) << is_shaken;
  }
  Vectors nodes(2, 13 * 13);
  for (Eigen::Index k = 0; k < 169; ++k)
    nodes.col(k) = Vec2(static_cast<double>(k % 13 % 12), static_cast<double>(k / 13)) / 12;
  EXPECT_EQ(square.of(nodes).in_one_place, 0);
  EXPECT_EQ(square.of(nodes).empty_places, 0);
}

TEST(Coverage, CallsPairsCrowdedAndARefinedPartNot) {
  const Square square{20};
  Vectors pairs = square.shaken(0.1, 2);
  for (Eigen::Index p = 1; p < pairs.cols(); p += 2) pairs.col(p) = pairs.col(p - 1) + Vec2(1e-3, 1e-3);
  EXPECT_EQ(square.of(pairs).crowded, 1);
  Vectors refined(2, 400 + 1600);
  refined << square.shaken(0.1, 2), 0.2 * Square{40}.shaken(0.1, 4);
  EXPECT_LT(square.of(refined).crowded, 0.05);
}

TEST(Coverage, EndsAtASurface) {
  const Square square{30};
  const Vectors lower = without(square.shaken(0.2, 5), [](const Vec2& x) { return x.y() > 0.6; });
  const auto below = [&](double height) {
    return coverage_of(lower, square.spacing(),
                       {.domain = square.domain, .depth = [=](const Vec2& x) { return height - x.y(); }})
        .hole;
  };
  EXPECT_LT(below(0.6), 2.5);
  EXPECT_GT(below(0.75), 4);
  EXPECT_NEAR(square.of(lower).hole, 30 * 0.4 + 0.5, 1) << "all of the square";
}

TEST(Coverage, OfOneRowIsAllAround) {
  Vectors one(2, 1);
  one << 0.5, 0.5;
  EXPECT_GT(Square{10}.of(one).hole, 3);
  EXPECT_EQ(Square{10}.of(one).in_one_place, 0);
}

TEST(Coverage, OfARunIsTheWorstOfItsTimesAndKnowsHolesOfAFullDomainAlone) {
  const Square square{10};
  const Level level{.name = "M1", .spacing = 0.1};
  vnv::Run run;  // not that of a test
  run.samples = {{.time = 1, .x = square.shaken(0.1, 1)}, {.time = 2, .x = square.shaken(0.3, 2)}};
  run.samples[0].x.col(7) = run.samples[0].x.col(8);
  run.summary = {.end_time = 2, .finished = true, .cost = {.particles = 100}};
  EXPECT_TRUE(coverage_of(level, run).empty()) << "of no simulation";
  run.room = Room{square.domain, square.domain.box};
  const std::vector<Value> found = coverage_of(level, run);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].quantity, largest_hole);
  EXPECT_EQ(found[0].value, std::max(square.of(run.samples[0].x).hole, square.of(run.samples[1].x).hole));
  EXPECT_EQ(found[1].quantity, rows_in_one_place);
  EXPECT_EQ(found[1].value, 1);
  EXPECT_EQ(found[1].time, 2);
  EXPECT_EQ(found[2].quantity, rows_crowded);
  EXPECT_GE(found[2].value, 2);
  run.room->filled.high.y() /= 2;
  EXPECT_EQ(coverage_of(level, run).size(), 2u);
  run.room = Room{square.domain, square.domain.box};
  run.summary.cost.particles = 80;
  EXPECT_EQ(coverage_of(level, run).size(), 2u) << "a shape in it";
}

}  // namespace coverage_test
}  // namespace touchstone::vnv

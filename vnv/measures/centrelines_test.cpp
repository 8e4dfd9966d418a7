#include "vnv/measures/centrelines.hpp"

#include "solvers/lattice.hpp"
#include "vnv/files/data_folder.hpp"
#include "vnv/files/tables.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace touchstone::vnv {
namespace centrelines_test {

constexpr double spacing = 0.05;
constexpr Cavity cavity{.side = 2, .lid_speed = 3};

/// A field of second degree.
double bowl(const Vec2& x) {
  return 0.3 - x.x() + 0.5 * x.y() + x.x() * x.x() - 2 * x.x() * x.y() + 0.7 * x.y() * x.y();
}

/// Particles off their lattice, which move as a field says, with v_y its opposite.
template <class Moving>
Samples scattered(const Moving& field) {
  const Vectors places = lattice({.high = {2, 2}}, spacing).places();
  Samples s{
      1, places, places, Scalars::Ones(places.cols()), Scalars::Ones(places.cols()), Scalars::Zero(places.cols())};
  for (Eigen::Index p = 0; p < s.size(); ++p) {
    s.x.col(p) +=
        0.3 * spacing * Vec2(std::sin(37.0 * static_cast<double>(p)), std::cos(53.0 * static_cast<double>(p)));
    const double value = field(Vec2(s.x.col(p)));
    s.v.col(p) = Vec2(value, -value);
  }
  return s;
}

vnv::Run ended_with(Samples s) {
  vnv::Run run{.summary = {.end_time = 1, .finished = true}};
  run.samples.push_back(std::move(s));
  return run;
}

/// The field of the samples as it would be published.
Centreline published(Centreline::Direction direction, double sign) {
  Centreline line{direction, {0.03, 0.4, 0.97}, {}};
  for (const double at : line.at)
    line.velocity.push_back(sign * bowl(direction == Centreline::vertical ? Vec2(1, 2 * at) : Vec2(2 * at, 1)) / 3);
  return line;
}

const Level level{.name = "M1", .spacing = spacing};

TEST(FittedAt, IsExactForAFieldOfSecondDegreeAlsoAtAWall) {
  const Samples s = scattered(bowl);
  for (const Vec2& x : {Vec2(1, 1), Vec2(0.33, 1.71), Vec2(0, 1), Vec2(2, 2)})
    EXPECT_NEAR(fitted_at(s, velocity_x, x, 2.5 * spacing), bowl(x), 1e-10);
}

TEST(FittedAt, ConvergesWithThirdOrderOrBetter) {
  const auto wave = [](const Vec2& x) { return std::sin(3 * x.x() + x.y()); };
  const Samples s = scattered(wave);
  const Vec2 x(1.013, 0.97);
  EXPECT_NEAR(fitted_at(s, velocity_x, x, 2.5 * spacing), wave(x), 0.1 * std::pow(3 * 2.5 * spacing, 3));
}

TEST(FittedAt, WhereThereAreNoParticlesIsNotANumber) {
  EXPECT_TRUE(std::isnan(fitted_at(scattered(bowl), velocity_x, {5, 5}, 2.5 * spacing)));
}

/// Moves as a smooth vortex below a lid does, on the grid of these lines.
double below_a_lid(const Vec2& x) {
  return std::pow(x.y(), 6) * std::cos(2 * (x.x() - 0.5)) - 0.3 * std::sin(3 * x.y());
}
Samples on_lines(const std::vector<double>& along_x, const std::vector<double>& along_y) {
  Samples s{.time = 1, .x = Vectors(2, static_cast<Eigen::Index>(along_x.size() * along_y.size()))};
  Eigen::Index p = 0;
  for (const double x : along_x)
    for (const double y : along_y) s.x.col(p++) = Vec2(x, y);
  s.v = s.x;
  for (p = 0; p < s.x.cols(); ++p) s.v.col(p) = Vec2::Constant(below_a_lid(s.x.col(p)));
  return s;
}

/// The middles of cells from 0 to 1, graded towards both ends, or their corners.
std::vector<double> lines(int cells, double graded = 0, bool at_corners = false) {
  std::vector<double> all;
  for (double k = at_corners ? 0 : 0.5; k <= cells; ++k) {
    const double even = k / cells;
    all.push_back(graded > 0 ? 0.5 + 0.5 * std::tanh(graded * (2 * even - 1)) / std::tanh(graded) : even);
  }
  return all;
}

/// The largest error on both centrelines, at the places of Ghia et al. and more.
double worst_on_centrelines(const Samples& s) {
  constexpr Cavity unit{.side = 1, .lid_speed = 1};
  const double spacing_of_all = 1 / std::sqrt(static_cast<double>(s.size()));
  double worst = 0;
  for (const auto direction : {Centreline::vertical, Centreline::horizontal}) {
    std::vector<double> places = converged_centreline(data_folder(), direction, 100).at;
    for (double at = 0.05; at < 0.96; at += 0.0137) places.push_back(at);
    for (const double at : places) {
      const double right = below_a_lid(direction == Centreline::vertical ? Vec2(0.5, at) : Vec2(at, 0.5));
      const double off = std::abs(unit.velocity_at(s, direction, at, spacing_of_all) - right);
      if (std::isnan(off)) return off;
      worst = std::max(worst, off);
    }
  }
  return worst;
}

TEST(Centrelines, AreReadOnCellsOfAnyAspect) {
  for (const bool at_corners : {false, true})
    for (const int coarse : {20, 21, 32, 33, 48})
      for (const int aspect : {1, 2, 4}) {
        const auto few = lines(coarse, 0, at_corners), many = lines(aspect * coarse, 0, at_corners);
        EXPECT_LT(worst_on_centrelines(on_lines(many, few)), 0.01) << coarse << " along y, aspect " << aspect;
        EXPECT_LT(worst_on_centrelines(on_lines(few, many)), 0.01) << coarse << " along x, aspect " << aspect;
      }
}

TEST(Centrelines, AreReadOnGridsGradedTowardsTheWalls) {
  for (const bool at_corners : {false, true})
    for (const int cells : {24, 32, 33, 48, 64})
      for (const double graded : {0.5, 1.0, 1.5, 2.0, 2.5}) {
        const auto along = lines(cells, graded, at_corners);
        EXPECT_LT(worst_on_centrelines(on_lines(along, along)), 0.01) << cells << " cells, graded by " << graded;
      }
}

TEST(Centrelines, AreNoNumbersWhereARowThatIsReadIsNone) {
  for (const int along_y : {64, 32, 16}) {  // cells 1:1, and those whose rows are sought along x and y apart
    Samples s = on_lines(lines(64), lines(along_y));
    Eigen::Index closest = 0;
    (s.x.colwise() - Vec2(0.5, 0.9766)).colwise().squaredNorm().minCoeff(&closest);
    s.v(0, closest) = not_a_number;
    EXPECT_TRUE(std::isnan(worst_on_centrelines(s))) << along_y;
  }
}

TEST(CentrelineErrors, OfWhatWasPublishedAreNone) {
  const vnv::Run run = ended_with(scattered(bowl));
  for (const Centreline& line : {published(Centreline::vertical, 1), published(Centreline::horizontal, -1)})
    for (const Value& e : cavity.compare(level, run, line)) EXPECT_NEAR(e.value, 0, 1e-8) << e.quantity.name;
}

TEST(CentrelineErrors, AreInPerCentOfTheSpeedOfTheLid) {
  Centreline line = published(Centreline::vertical, 1);
  line.velocity[1] += 0.03;
  const std::vector<Value> errors = cavity.compare(level, ended_with(scattered(bowl)), line);
  ASSERT_EQ(errors.size(), 2u);
  EXPECT_EQ(errors[0].quantity.heading(), "L2 v_x, vertical centreline [%]");
  EXPECT_NEAR(errors[0].value, 3 / std::sqrt(3), 1e-8);
  EXPECT_EQ(errors[1].quantity.heading(), "Linf v_x, vertical centreline [%]");
  EXPECT_NEAR(errors[1].value, 3, 1e-8);
}

TEST(CentrelineErrors, AreThoseOfTheMeanOverTheLastSpanOfARun) {
  vnv::Run run;
  run.summary.finished = true;
  const auto add = [&](double time, double faster) {
    Samples s = scattered([&](const Vec2& x) { return bowl(x) + faster; });
    s.time = time;
    run.samples.push_back(std::move(s));
  };
  add(6.9, 100);  // before that span
  add(7, 0.3);
  add(9, -0.2);
  add(12, 0.2);
  Cavity averaged = cavity;
  averaged.span = 5;
  const Centreline line = published(Centreline::vertical, 1);
  EXPECT_NEAR(averaged.compare(level, run, line)[1].value, 100 * 0.1 / 3, 1e-8);
  EXPECT_NEAR(cavity.compare(level, run, line)[1].value, 100 * 0.2 / 3, 1e-8) << "of its last instant";
}

TEST(CentrelineErrors, OfWhatIsNoNumberAreNoNumbers) {
  Samples s = scattered(bowl);
  s.v.row(1).setConstant(not_a_number);
  for (const Value& e : cavity.compare(level, ended_with(s), published(Centreline::horizontal, -1)))
    EXPECT_TRUE(std::isnan(e.value)) << e.quantity.name;
}

TEST(CentrelineErrors, OfARunThatDivergedAreNotTold) {
  vnv::Run run = ended_with(scattered(bowl));
  run.summary.finished = false;
  EXPECT_TRUE(cavity.compare(level, run, published(Centreline::vertical, 1)).empty());
}

const Extremum highest{"largest v_y", Centreline::horizontal, 1}, lowest{"smallest v_y", Centreline::horizontal, -1};

TEST(PeakOf, IsExactForAFieldOfSecondDegree) {
  for (const double at : {0.04, 0.237, 0.5, 0.9631}) {
    const Peak top = peak_of([=](double s) { return 0.3 - std::pow(s - at, 2); }, highest),
               bottom = peak_of([=](double s) { return std::pow(s - at, 2) - 0.3; }, lowest);
    EXPECT_NEAR(top.velocity, 0.3, 1e-12);
    EXPECT_NEAR(top.at, at, 1e-10);
    EXPECT_NEAR(bottom.velocity, -0.3, 1e-12);
    EXPECT_NEAR(bottom.at, at, 1e-10);
  }
}

TEST(PeakOf, IsAsFarFromTheWallsAsIsAsked) {
  const Peak top = peak_of([](double s) { return s; }, highest);
  EXPECT_NEAR(top.at, 0.98, 0.005 + 1e-12);
  EXPECT_NEAR(peak_of([](double s) { return s; }, highest, 0.08).at, 0.92, 0.005 + 1e-12);
}

TEST(PeakOf, IsNoNumberWhereAVelocityIsNone) {
  const Peak top = peak_of([](double s) { return s > 0.7 ? not_a_number : s * (1 - s); }, highest);
  EXPECT_TRUE(std::isnan(top.velocity) && std::isnan(top.at));
}

TEST(Peaks, AreComparedInPerCentOfTheLidAndOfTheSide) {
  const vnv::Run run = ended_with(scattered([](const Vec2& x) { return 3 * (0.4 - std::pow(x.x() - 0.6, 2)); }));
  const std::vector<Value> errors = cavity.compare(level, run, lowest, {-0.42, 0.31});  // v_y has the opposite sign
  ASSERT_EQ(errors.size(), 2u);
  EXPECT_EQ(errors[0].quantity.heading(), "error of the smallest v_y, horizontal centreline [%]");
  EXPECT_NEAR(errors[0].value, 2, 1e-6);
  EXPECT_EQ(errors[1].quantity.heading(), "shift of the smallest v_y, horizontal centreline [%]");
  EXPECT_NEAR(errors[1].value, 1, 1e-6);
}

TEST(ConvergedCentrelines, AreAtThePlacesOfGhiaWithTheDoubtfulOne) {
  for (const int Re : {100, 400, 1000, 3200})
    for (const auto direction : {Centreline::vertical, Centreline::horizontal}) {
      const Centreline line = converged_centreline(data_folder(), direction, Re);
      EXPECT_EQ(line.at.size(), 15u);
      EXPECT_EQ(line.velocity.size(), 15u);
    }
  EXPECT_THROW(converged_centreline(data_folder(), Centreline::vertical, 200), BadData);
  EXPECT_THROW(converged_peak(data_folder(), highest, 200), BadData);
}

TEST(ConvergedProfiles, GoThroughTheirPlaces) {
  const DataTable table = read_table(data_folder() / "computed/cavity_profiles.csv").only("Re", "1000");
  const ConvergedProfile profile(data_folder(), Centreline::horizontal, 1000);
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const double at = table.numbers("s [-]")[k], velocity = table.numbers("v [-]")[k];
    EXPECT_EQ(profile(at), velocity);
    EXPECT_NEAR(profile(at + 1e-14 * (0.5 - at)), velocity, 1e-11);
  }
}

TEST(GhiasCentrelines, HaveTheirWallsAndDoubtfulEntriesLeftOut) {
  for (const int Re : {100, 400, 1000}) {
    EXPECT_EQ(ghia_centreline(data_folder(), Centreline::vertical, Re).at.size(), 15u);
    EXPECT_EQ(ghia_centreline(data_folder(), Centreline::horizontal, Re).at.size(), Re == 400 ? 14u : 15u);
  }
  EXPECT_THROW(ghia_centreline(data_folder(), Centreline::vertical, 200), BadData);
}

/// Fluid is not made: what flows one way through a centreline flows back the other way.
TEST(GhiasCentrelines, LetAsMuchThroughOneWayAsTheOther) {
  for (const int Re : {100, 400, 1000})
    for (const auto direction : {Centreline::vertical, Centreline::horizontal}) {
      Centreline line = ghia_centreline(data_folder(), direction, Re);
      const bool is_vertical = direction == Centreline::vertical;
      line.at.insert(line.at.begin(), 1);
      line.velocity.insert(line.velocity.begin(), is_vertical ? 1 : 0);
      line.at.push_back(0);
      line.velocity.push_back(0);
      double net = 0, all = 0;
      for (std::size_t k = 1; k < line.at.size(); ++k) {
        const double flow = (line.at[k - 1] - line.at[k]) * (line.velocity[k - 1] + line.velocity[k]) / 2;
        net += flow;
        all += std::abs(flow);
      }
      EXPECT_LT(std::abs(net), 0.08 * all)
          << Re << norm_of("L2", line.direction).name;  // the trapezia between sixteen points
    }
}

/// One vortex fills the cavity: fluid goes one way on the one side of its centre and back on the other; from Re 1000 on
/// its core turns like a solid (Batchelor 1956), in a straight line but for 2 % of the lid.
TEST(GhiasCentrelines, TurnOnceAndPassStraightThroughTheCoreOfTheVortex) {
  for (const int Re : {100, 400, 1000, 3200, 5000, 7500, 10000})
    for (const auto direction : {Centreline::vertical, Centreline::horizontal}) {
      const auto [way, at, velocity] = ghia_centreline(data_folder(), direction, Re);
      int turns = 0;
      for (std::size_t k = 1; k < at.size(); ++k) turns += (velocity[k] > 0) != (velocity[k - 1] > 0);
      EXPECT_EQ(turns, 1) << Re << norm_of("L2", way).name;
      if (Re < 1000) continue;
      std::size_t k = 1;  // the smallest velocity away from the walls
      for (std::size_t other = 1; other + 1 < at.size(); ++other)
        if (std::abs(velocity[other]) < std::abs(velocity[k])) k = other;
      const double along = (at[k] - at[k - 1]) / (at[k + 1] - at[k - 1]),
                   straight = velocity[k - 1] + along * (velocity[k + 1] - velocity[k - 1]);
      EXPECT_NEAR(velocity[k], straight, 0.02) << Re << norm_of("L2", way).name << " at " << at[k];
    }
}

}  // namespace centrelines_test
}  // namespace touchstone::vnv

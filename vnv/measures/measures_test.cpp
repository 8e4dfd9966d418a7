#include "vnv/measures/front.hpp"
#include "vnv/measures/profile.hpp"
#include "vnv/measures/row_means.hpp"
#include "vnv/record/quantity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>
#include <stdexcept>
#include <vector>

namespace touchstone::vnv {
namespace {

constexpr double nan = not_a_number;

/// A lattice of equal square particles that fills size, its lower left corner at `corner`.
Samples block(const Vec2& corner, const Vec2& size, double spacing) {
  const auto columns = std::lround(size.x() / spacing), rows = std::lround(size.y() / spacing);
  Samples s;
  s.x.resize(2, columns * rows);
  for (Eigen::Index p = 0; p < s.size(); ++p)
    s.x.col(p) =
        corner + spacing * Vec2(static_cast<double>(p % columns) + 0.5, static_cast<double>(p / columns) + 0.5);
  s.v = Vectors::Zero(2, s.size());
  s.density = Scalars::Constant(s.size(), 1000);
  s.mass = s.density * spacing * spacing;
  s.pressure = Scalars::Zero(s.size());
  return s;
}

Samples joined(const Samples& a, const Samples& b) {
  Samples s = a;
  s.x.resize(2, a.size() + b.size());
  s.x << a.x, b.x;
  s.v = Vectors::Zero(2, s.size());
  for (const auto field : {&Samples::mass, &Samples::density, &Samples::pressure}) {
    (s.*field).resize(s.size());
    s.*field << a.*field, b.*field;
  }
  return s;
}

Samples moved(Samples s, const Vec2& by) {
  s.x.colwise() += by;
  return s;
}

Samples drop(const Vec2& at, double spacing) { return block(at, {spacing, spacing}, spacing); }

Samples disordered(Samples s, double amplitude) {
  std::mt19937_64 generator(7);
  std::uniform_real_distribution<double> anywhere(-amplitude, amplitude);
  for (auto& coordinate : s.x.reshaped()) coordinate += anywhere(generator);
  return s;
}

const auto channel = block({0, 0}, {0.5, 1}, 0.1);  // 5 columns, 10 rows

TEST(Fields, AreTakenFromTheParticleAsked) {
  auto s = channel;
  s.v.col(3) << 1, 2;
  s.pressure(3) = 3;
  EXPECT_EQ(velocity_x(s, 3), 1);
  EXPECT_EQ(velocity_y(s, 3), 2);
  EXPECT_EQ(pressure(s, 3), 3);
  EXPECT_EQ(velocity_x(s, 4), 0);
}

TEST(RowMeans, OfALatticeAreItsRowsUpwards) {
  const auto profile = row_means(velocity_x, 0.1)(channel);
  ASSERT_EQ(profile.at.size(), 10u);
  EXPECT_NEAR(profile.at.front(), 0.05, 1e-14);
  EXPECT_NEAR(profile.at.back(), 0.95, 1e-14);
  EXPECT_TRUE(std::ranges::is_sorted(profile.at));
  EXPECT_EQ(profile.weight, std::vector<double>(10, profile.weight[0]));
}

TEST(RowMeans, AverageAlongTheRowOnly) {
  auto s = channel;
  for (Eigen::Index p = 0; p < s.size(); ++p) s.v(0, p) = s.x(1, p) + std::sin(2 * std::numbers::pi * s.x(0, p) / 0.5);
  const auto profile = row_means(velocity_x, 0.1)(s);
  for (std::size_t i = 0; i < profile.at.size(); ++i) EXPECT_NEAR(profile.value[i], profile.at[i], 1e-14);
}

TEST(RowMeans, KeepRowsThatDriftByLessThanHalfASpacing) {
  const auto profile = row_means(velocity_x, 0.1)(disordered(channel, 0.049));
  EXPECT_EQ(profile.at.size(), 10u);
}

TEST(RowMeans, OfDisorderAreStillOnALinearProfile) {
  auto s = disordered(block({0, 0}, {0.5, 1}, 0.05), 0.2);
  s.v.row(0) = 3 * s.x.row(1).array() - 1;
  const auto profile = row_means(velocity_x, 0.05)(s);
  EXPECT_GT(profile.at.size(), 20u) << "disorder is not one row";
  for (std::size_t i = 0; i < profile.at.size(); ++i) EXPECT_NEAR(profile.value[i], 3 * profile.at[i] - 1, 1e-13);
}

TEST(RowMeans, StandWhereTheirMembersAre) {
  const auto profile = row_means(velocity_x, 0.1)(moved(channel, {0, 0.03}));
  ASSERT_EQ(profile.at.size(), 10u);
  EXPECT_NEAR(profile.at.front(), 0.08, 1e-14);
}

TEST(RowMeans, LeaveOutRowsWithoutParticles) {
  const auto profile = row_means(velocity_x, 0.1)(joined(channel, moved(channel, {0, 3})));
  EXPECT_EQ(profile.at.size(), 20u);
}

TEST(RowMeans, DoNotHideWhatIsNotANumber) {
  auto s = channel;
  s.v(0, 7) = nan;
  const auto values = row_means(velocity_x, 0.1)(s).value;
  EXPECT_EQ(std::ranges::count_if(values, [](double v) { return std::isnan(v); }), 1);
  s.x(1, 7) = s.x(1, 33) = nan;
  const auto places = row_means(velocity_x, 0.1)(s).at;
  EXPECT_EQ(places.size(), 11u) << "both particles at no place are one row";
  EXPECT_EQ(std::ranges::count_if(places, [](double y) { return std::isnan(y); }), 1);
}

TEST(RowMeans, OfAMeshAreThoseOfItsLines) {
  auto s = block({0, 0}, {0.5, 1}, 0.1);
  for (double& y : s.x.row(1).reshaped()) y = y * y;  // graded
  s.v.row(0) = s.x.row(1).array().square();
  const auto profile = means_of_lines(velocity_x, 0.1)(s);
  ASSERT_EQ(profile.at.size(), 10u);
  for (std::size_t i = 0; i < 10; ++i) EXPECT_NEAR(profile.value[i], profile.at[i] * profile.at[i], 1e-14);
  const auto disorder = disordered(channel, 0.049);
  EXPECT_EQ(means_of_lines(velocity_x, 0.1)(disorder).at, row_means(velocity_x, 0.1)(disorder).at);
}

TEST(RowMeans, RefuseAHeightThatIsNone) {
  for (const double height : {0.0, -0.1, nan, std::numeric_limits<double>::infinity()})
    EXPECT_THROW(row_means(velocity_x, height), std::invalid_argument) << height;
}

TEST(PerParticle, KeepsEachParticleWithItsVolume) {
  auto s = channel;
  s.v.row(0) = s.x.row(1);
  s.density(4) *= 2;
  const auto profile = per_particle(velocity_x)(s);
  ASSERT_EQ(profile.at.size(), 50u);
  EXPECT_EQ(profile.value, profile.at);
  EXPECT_NEAR(profile.weight[4], profile.weight[5] / 2, 1e-16);
  EXPECT_NEAR(std::accumulate(profile.weight.begin(), profile.weight.end(), profile.weight[4]), 0.5, 1e-14);
}

const auto water_column = block({0, 0}, {1, 1}, 0.05);  // an upright face at x = 1
constexpr double cell = 0.1;

TEST(Fronts, MoveWithTheFluid) {
  const auto pushed = moved(water_column, {0.0371, 0});
  EXPECT_NEAR(farthest_particle(pushed) - farthest_particle(water_column), 0.0371, 1e-14);
  EXPECT_NEAR(percentile_front(pushed) - percentile_front(water_column), 0.0371, 1e-14);
  EXPECT_NEAR(half_full_slab(pushed, cell) - half_full_slab(water_column, cell), 0.0371, 1e-13);
}

TEST(Fronts, DoNotDependOnTheOrderOfTheParticles) {
  auto reversed = water_column;
  reversed.x = water_column.x.rowwise().reverse().eval();
  EXPECT_EQ(farthest_particle(reversed), farthest_particle(water_column));
  EXPECT_EQ(percentile_front(reversed), percentile_front(water_column));
  EXPECT_NEAR(half_full_slab(reversed, cell), half_full_slab(water_column, cell), 1e-13);
}

TEST(Fronts, OnlyTheFarthestParticleFollowsADrop) {
  const auto spray = joined(water_column, drop({1.7, 0}, 0.05));
  EXPECT_NEAR(farthest_particle(spray), 1.725, 1e-14);
  EXPECT_LT(percentile_front(spray), 1);
  EXPECT_NEAR(farthest_of_body(spray, cell), 0.975, 1e-14);
  EXPECT_NEAR(half_full_slab(spray, cell), 1, 1e-13);
}

TEST(Fronts, AreNotANumberWithoutFluidOrWithAPlaceOrVolumeThatIsNone) {
  std::vector<Samples> bad(4, water_column);
  bad[0] = block({0, 0}, {0, 0}, 0.05);
  bad[1].x(0, 17) = nan;
  bad[2].x(1, 17) = -std::numeric_limits<double>::infinity();
  bad[3].density(17) = -1000;
  for (std::size_t i = 0; i < bad.size(); ++i) {
    EXPECT_TRUE(std::isnan(farthest_particle(bad[i]))) << i;
    EXPECT_TRUE(std::isnan(percentile_front(bad[i]))) << i;
    EXPECT_TRUE(std::isnan(farthest_of_body(bad[i], cell))) << i;
    EXPECT_TRUE(std::isnan(half_full_slab(bad[i], cell))) << i;
  }
}

TEST(FarthestOfBody, FollowsAThinSheetAndNotALargerDropBehindAGap) {
  const auto sheet = joined(water_column, block({1, 0}, {0.5, 0.05}, 0.05));
  EXPECT_NEAR(farthest_of_body(sheet, cell), 1.475, 1e-14);
  EXPECT_NEAR(farthest_of_body(joined(sheet, block({1.6, 0}, {0.3, 0.3}, 0.05)), cell), 1.475, 1e-14);
  EXPECT_NEAR(farthest_of_body(moved(sheet, {-3, 0}), cell), -1.525, 1e-14);
}

TEST(VolumeBehind, IsThatOfTheParticlesAndOfTheirParts) {
  EXPECT_NEAR(volume_behind(water_column, 0.2), 0.2, 1e-13);
  EXPECT_NEAR(volume_behind(water_column, 2.5), 1, 1e-13);
  EXPECT_EQ(volume_behind(water_column, -0.1), 0);
}

TEST(VolumeBehind, IsExactOfALatticeWhoseParticlesStandAcross) {
  for (int across = 11; across < 61; across += 2)
    EXPECT_NEAR(volume_behind(block({0, 0}, {1, 1}, 1.0 / across), 0.1), 0.1, 1e-13) << across;
}

TEST(PercentileFront, HasNearlyAllOfTheVolumeBehindIt) {
  for (const double times : {0.1, 1.0, 10.0}) {  // of the volumes in the farther half
    auto s = disordered(water_column, 0.4);
    const Scalars x = s.x.row(0);
    s.mass = (x > (x.minCoeff() + x.maxCoeff()) / 2).select(times * s.mass, s.mass);
    const double front = percentile_front(s), all = s.volumes().sum();
    const auto volume_where = [&](auto chosen) { return chosen.select(s.volumes(), 0.0).sum(); };
    EXPECT_GE(volume_where(x <= front), (0.995 - 1e-12) * all) << times;
    EXPECT_LT(volume_where(x < front), 0.995 * all) << times;
  }
}

TEST(PercentileFront, OfParticlesInOnePlaceIsThatPlace) {
  EXPECT_EQ(percentile_front(drop({1.7, 0}, 0.05)), drop({1.7, 0}, 0.05).x(0, 0));
}

TEST(PercentileFront, IsFoundAmongAllTheOthersWhenOneDropFlewFarAway) {
  EXPECT_EQ(percentile_front(joined(water_column, drop({1e6, 0}, 0.01))), percentile_front(water_column));
}

TEST(HalfFullSlab, StandsAtAnUprightFaceWhateverTheSpacing) {
  for (const double spacing : {0.1, 0.05, 0.04, 0.02}) {
    const double face = 1 + 0.3 * spacing;
    EXPECT_NEAR(half_full_slab(block({face - 1, 0}, {1, 1}, spacing), cell), face, 1e-12) << spacing;
  }
}

TEST(HalfFullSlab, RunsAheadOnASheetByLessThanHalfACell) {
  const auto sheet = block({1, 0}, {0.6, 0.04}, 0.04);
  const double front = half_full_slab(joined(water_column, sheet), cell);
  EXPECT_GT(front, 1.01);
  EXPECT_LT(front, 1 + cell / 2);
}

TEST(HalfFullSlab, FollowsASheetThickerThanHalfACell) {
  const auto sheet = block({1, 0}, {0.6, 0.06}, 0.06);
  const double front = half_full_slab(joined(water_column, sheet), cell);
  EXPECT_LT(front, 1.6);
  EXPECT_GT(front, 1.6 - cell / 2);
}

TEST(HalfFullSlab, DoesNotSeeFluidAboveTheFirstCell) {
  EXPECT_NEAR(half_full_slab(joined(water_column, block({1, 0.1}, {0.5, 0.5}, 0.05)), cell), 1, 1e-12);
}

TEST(HalfFullSlab, MovesLittleWhenTheParticlesDo) {
  const auto thin = joined(water_column, block({1, 0}, {0.6, 0.06}, 0.06));
  for (const double lift : {1e-6, 1e-4}) {
    EXPECT_NEAR(half_full_slab(moved(thin, {0, lift}), cell), half_full_slab(thin, cell), 10 * lift);
    EXPECT_NEAR(half_full_slab(disordered(thin, lift), cell), half_full_slab(thin, cell), 10 * lift);
  }
}

TEST(HalfFullSlab, FindsTheFarthestOfSeveral) {
  const auto two = joined(water_column, block({2, 0}, {0.3, 0.3}, 0.05));
  EXPECT_NEAR(half_full_slab(two, cell), 2.3, 1e-12);
}

TEST(HalfFullSlab, IsNotANumberWhereTheFluidIsNowhereThickEnough) {
  EXPECT_TRUE(std::isnan(half_full_slab(block({0, 0}, {1, 0.04}, 0.04), cell)));
}

TEST(HalfFullSlab, RefusesACellThatIsNone) {
  for (const double size : {0.0, -0.1, nan}) EXPECT_THROW(half_full_slab(water_column, size), std::invalid_argument);
}

}  // namespace
}  // namespace touchstone::vnv

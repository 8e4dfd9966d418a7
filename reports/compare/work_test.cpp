#include "reports/compare/work.hpp"

#include "reports/compare/price_ratios.hpp"
#include "reports/testing.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace touchstone::reports {
namespace {

vnv::WorkPoint point(const std::string& series, double cpu, double error, double particles = 800) {
  return {.diagram = "work",
          .series = series,
          .family = series.starts_with("mpm") ? "MPM" : "SPH",
          .particles = particles,
          .per_step = cpu / 1000,
          .error = error,
          .cpu = cpu,
          .cpu_lowest = 0.9 * cpu,
          .cpu_highest = 1.1 * cpu};
}

vnv::WorkPoint published(const std::string& series, const std::string& family, double cpu, double error) {
  vnv::WorkPoint p = point(series, cpu, error);
  p.family = family;
  p.elsewhere = true;
  return p;
}

const vnv::WorkDiagram diagram{"work", "Error against run time", "At 1 s.", {"L2", "%", vnv::Kind::norm}, {1, 0.1}, 1};

/// mpm reaches 1 % in 2 s, sph in 20 s; the paper's pair is there twice, once a record.
CaseRecords two_methods() {
  CaseRecords records{"poiseuille", {sample_record("mpm"), sample_record("sph")}};
  records.records[0].work = {point("mpm", 1, 2), point("mpm", 4, 0.5), point("mpm", 5, 3)};
  records.records[1].work = {point("sph", 10, 2), point("sph", 40, 0.5)};
  for (auto& record : records.records) {
    record.diagrams = {diagram};
    record.work.push_back(published("paper MPM", "MPM", 100, 2));
    record.work.push_back(published("paper SPH", "SPH", 1100, 3));
  }
  return records;
}

const vnv::Curve* find_curve(const CaseRecords& records, const std::string& label) {
  for (const auto& record : records.records)
    for (const auto& curve : record.curves)
      if (curve.figure == "work" && curve.label == label) return &curve;
  return nullptr;
}

const vnv::Table& find_table(const CaseRecords& records, const std::string& id) {
  return *std::ranges::find(records.records.front().tables, id, &vnv::Table::id);
}

TEST(Work, DrawsEachMethodsFrontAndWhatNoRunBeats) {
  CaseRecords records = two_methods();
  add_work(records);
  EXPECT_EQ(figures_of(records).back().id, "work");
  EXPECT_EQ(find_curve(records, "mpm")->x, (std::vector<double>{1, 4}));
  EXPECT_EQ(find_curve(records, "Pareto front of all methods here")->x, (std::vector<double>{1, 4}));
  EXPECT_EQ(find_curve(records, "beaten by another run of its method")->x, (std::vector<double>{5}));
  EXPECT_EQ(find_curve(records, "paper SPH")->role, vnv::Role::published);
}

TEST(Work, RanksMethodsByTheTimeToAnError) {
  CaseRecords records = two_methods();
  add_work(records);
  const vnv::Table& prices = find_table(records, "work_prices");
  ASSERT_EQ(prices.rows.size(), 4u);
  EXPECT_EQ(std::get<std::string>(prices.rows[0][1]), "mpm");
  EXPECT_EQ(std::get<std::string>(prices.rows[0][2]), "2 (0.9 to 4.4)");
  EXPECT_EQ(std::get<std::string>(prices.rows[0][3]), "not reached");
  EXPECT_EQ(std::get<std::string>(prices.rows[1][1]), "sph");
  EXPECT_EQ(std::get<std::string>(prices.rows[2][1]), "paper MPM, measured elsewhere");
}

TEST(PriceRatios, SetEqualParticleNumberBesideEqualError) {
  const auto records = two_methods();
  std::vector<vnv::WorkPoint> points = records.records[0].work;
  points.insert(points.end(), records.records[1].work.begin(), records.records[1].work.end());
  const vnv::Table table = price_ratios(diagram, points);
  EXPECT_EQ(table.columns, (std::vector<std::string>{"at equal", "of", "SPH over MPM, Sun et al.",
                                                     "SPH over MPM, cheapest SPH here", "SPH over MPM, sph"}));
  ASSERT_EQ(table.rows.size(), 3u);
  EXPECT_DOUBLE_EQ(std::get<double>(table.rows[0][2]), 11);
  EXPECT_DOUBLE_EQ(std::get<double>(table.rows[0][3]), 10);
  EXPECT_DOUBLE_EQ(std::get<double>(table.rows[0][4]), 10);
  EXPECT_EQ(std::get<std::string>(table.rows[1][3]), "10");
  EXPECT_EQ(std::get<std::string>(table.rows[2][2]), "neither reaches it");
  EXPECT_TRUE(
      contains(table.caption,
               "(800 particles) a step of SPH costs so many times one of MPM: Sun et al.: 11; cheapest SPH here: 10."));
}

TEST(PriceRatios, SayWhoDoesNotReachAnError) {
  const vnv::Table table = price_ratios(diagram, {point("mpm", 1, 2), point("mpm", 4, 0.05), point("sph", 10, 2)});
  EXPECT_EQ(std::get<std::string>(table.rows[1][2]), "SPH does not reach it");
}

TEST(PriceRatios, AreNoneWithoutBothFamilies) { EXPECT_TRUE(price_ratios(diagram, {point("mpm", 1, 2)}).rows.empty()); }

}  // namespace
}  // namespace touchstone::reports

#include "vnv/harness/describe.hpp"

#include "vnv/judge/baselines.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

namespace touchstone::vnv {
namespace describe_test {

namespace fs = std::filesystem;

class ADescription : public testing::Test {
 protected:
  ADescription() { fs::create_directories(data_); }
  ~ADescription() override { fs::remove_all(data_); }

  const fs::path data_ = fs::path(testing::TempDir()) /
                         ("describe." + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

const Quantity l2{"L2", "%", Kind::norm};

Case small_case() {
  return {
      .title = "A \"small\" case",
      .description = "Two\n\nparagraphs, ν",
      .times = {0.1, 1},
      .measurements = {},
      .claims = {at_most(l2, 10, theory("any method"))},
      .methods = {{
          .name = "mpm",
          .description = "grid",
          .time_step = [](const Level& level) { return level.cell / 100; },
          .levels = {{.name = "M1", .spacing = 0.5, .cell = 1, .acceptance = 0.1, .nightly = 1},
                     {.name = "M2", .spacing = 0.25, .smoothing_length = 3, .time_step = 2, .nightly = 1}},
          .ladders = {{"grid", {"M1", "M2"}}},
          .claims = {between(l2, 1, 2, literature("table 3")).on("M2").at(0.1),
                     order_at_least("grid", l2, 1.9, 1.5, theory("second order"))},
          .tolerance = {0.02, "tuned builds", 1e-9},
          .relative_cost = 7,
      }},
      .timed = true,
      .label = "stability",
  };
}

TEST_F(ADescription, TellsOfEachRungWhichSuiteRunsItAndHowFar) {
  const Description said = describe("small", small_case(), data_);
  const std::vector<LevelDescription>& levels = said.methods.at(0).levels;
  EXPECT_EQ(levels.at(0).until, (std::map<std::string, double>{{"acceptance", 0.1}, {"nightly", 1}}));
  EXPECT_EQ(levels.at(1).until, (std::map<std::string, double>{{"nightly", 1}}));
  EXPECT_EQ(said.suites, (std::vector<std::string>{"acceptance", "nightly"}));
  EXPECT_TRUE(said.methods.at(0).is_run_in("nightly"));
  EXPECT_FALSE(said.methods.at(0).is_run_in("report"));
}

TEST_F(ADescription, TellsTheStepOfTheRungOrElseOfTheMethod) {
  const std::vector<LevelDescription> levels = describe("small", small_case(), data_).methods.at(0).levels;
  EXPECT_EQ(levels.at(0).time_step, 0.01);
  EXPECT_EQ(levels.at(1).time_step, 2);
}

TEST_F(ADescription, LeavesOutWhatThereIsNoneOf) {
  const std::vector<LevelDescription> levels = describe("small", small_case(), data_).methods.at(0).levels;
  EXPECT_EQ(levels.at(0).cell, 1);
  EXPECT_EQ(levels.at(0).smoothing_length, std::nullopt);
  EXPECT_EQ(levels.at(1).cell, std::nullopt);
}

TEST_F(ADescription, KeepsLimitsAuthorsAndPlacesOfClaims) {
  const Description said = describe("small", small_case(), data_);
  EXPECT_EQ(said.claims.at(0).upper, 10);
  EXPECT_EQ(said.claims.at(0).time, std::nullopt);
  const ClaimDescription& printed = said.methods.at(0).claims.at(0);
  EXPECT_EQ(printed.author, "literature: table 3");
  EXPECT_EQ(printed.level, "M2");
  EXPECT_EQ(printed.time, 0.1);
  const ClaimDescription& order = said.methods.at(0).claims.at(1);
  EXPECT_EQ(order.ladder, "grid");
  EXPECT_EQ(order.surely_above, 1.5);
  EXPECT_EQ(order.upper, std::nullopt);
}

TEST_F(ADescription, CountsBaselinesAndQuotesTheirAcceptance) {
  write_baselines(data_ / "baselines" / "small.csv",
                  {{"mpm", "M1", 0.1, "L2 [%]", 1, 0.9, 1.1, "tuned builds"},
                   {"sph", "S1", 0.1, "L2 [%]", 1, 0.9, 1.1, "tuned builds"}},
                  {"Last accepted values of small", "abc", "2026-01-01", "first measured"});
  const Description said = describe("small", small_case(), data_);
  EXPECT_EQ(said.methods.at(0).baselines, 1);
  EXPECT_EQ(said.acceptance.reason, "first measured");
}

TEST_F(ADescription, TellsWhichValuesMayBeFartherFromTheirBaselinesAndWhy) {
  Case one = small_case();
  one.methods[0].tolerance.exceptions = {{"L2 of v", 0.35, "the edge of a sheet"}};
  EXPECT_EQ(describe("small", one, data_).methods.at(0).tolerance.basis,
            "tuned builds; values of \"L2 of v\" by 35 %: the edge of a sheet");
}

TEST_F(ADescription, ComesBackFromItsText) {
  const Description said = describe("small", small_case(), data_);
  EXPECT_EQ(description_in(json_of(said), "small --describe"), said);
}

TEST_F(ADescription, IsRefusedWithItsSourceIfItIsNone) {
  const auto refusal = [](const std::string& text) -> std::string {
    try {
      description_in(text, "small --describe");
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "read without complaint";
  };
  EXPECT_EQ(refusal("").find("small --describe: not a complete description: "), 0) << refusal("");
  EXPECT_NE(refusal("{\"schema\": 1}").find("small --describe: name is not there"), std::string::npos)
      << refusal("{\"schema\": 1}");
  EXPECT_NE(refusal("{\"schema\": 9}").find("schema is 9, expected 1"), std::string::npos);
}

}  // namespace describe_test
}  // namespace touchstone::vnv

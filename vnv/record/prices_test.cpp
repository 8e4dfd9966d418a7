#include "vnv/record/prices.hpp"

#include "vnv/files/data_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace touchstone::vnv {
namespace prices_test {

Price price(const std::string& method, double cpu, double smallest, double target = 1) {
  return {"couette", "L2 v_x [%]", target, 1, method, method == "mpm", cpu, smallest};
}

std::vector<std::string> names(const std::vector<Price>& prices) {
  std::vector<std::string> found;
  for (const Price& p : prices) found.push_back(p.method);
  return found;
}

TEST(Prices, RankThoseThatReachAnErrorByCostAndOthersByTheirSmallestError) {
  EXPECT_EQ(
      names(ranked({price("poor", not_a_number, 9), price("dear", 3, 0.5), price("none", not_a_number, not_a_number),
                    price("cheap", 2, 0.9), price("fair", not_a_number, 2), price("cheap", 1, 0.9, 3)},
                   1)),
      (std::vector<std::string>{"cheap", "dear", "fair", "poor", "none"}));
}

TEST(DefaultMethod, IsTheCheapestAndOfThoseAsCheapTheMostAccurate) {
  const auto clear = default_method({price("mpm", 6, 0.9), price("fine", 2, 0.1)});
  EXPECT_EQ(clear->method, "fine");
  EXPECT_EQ(clear->reason, "2 CPU s to 1 %, the next, mpm, 3 times as much; mpm as printed 3 times");
  const auto alike = default_method({price("mpm", 2, 0.9), price("fine", 2.4, 0.1), price("finer", 2.6, 0.01)});
  EXPECT_EQ(alike->method, "fine");
  EXPECT_NE(alike->reason.find("as cheap as mpm and with a smaller least error, 0.1 % instead of 0.9 %"),
            std::string::npos)
      << alike->reason;
}

TEST(DefaultMethod, IsTheMostAccurateWhereNoneReachesTheError) {
  EXPECT_EQ(default_method({price("mpm", not_a_number, 5), price("sph", not_a_number, 4)})->reason,
            "no method reaches 1 %; its error is the smallest, 4 %");
  EXPECT_FALSE(default_method({}).has_value());
}

TEST(Prices, AreReadAsTheyWereWritten) {
  const std::vector<Price> all = {price("mpm", 6, 0.9), price("sph", 2.5, 0.1)};
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "prices.csv";
  std::ofstream(file) << csv_of(all, "made up");
  EXPECT_EQ(read_prices(file), all);
}

TEST(Prices, AreThoseOfAMethodsOwnRunsInADiagram) {
  Record record;
  record.case_name = "couette";
  record.method = "mpm";
  record.as_printed = true;
  record.diagrams = {{"work", "", "", {"L2 v_x", "%"}, {1, 0.1}, 1}};
  for (const auto& [cpu, error] : {std::pair(1, 4.0), std::pair(4, 0.25)})
    record.work.push_back({.diagram = "work", .series = "mpm", .error = error, .cpu = 1.0 * cpu});
  record.work.push_back({.diagram = "work", .series = "paper", .elsewhere = true, .error = 0.01, .cpu = 1});
  record.work.push_back({.diagram = "another", .series = "mpm", .error = 0.01, .cpu = 1});
  const std::vector<Price> prices = prices_of({record});
  ASSERT_EQ(prices.size(), 2u);
  EXPECT_NEAR(prices[0].cpu, 2, 1e-12);
  EXPECT_TRUE(std::isnan(prices[1].cpu));
  EXPECT_EQ(prices[1].smallest, 0.25);
}

/// What `vnv explain` rests on.
TEST(Prices, OfTheProjectReachWhatTheirSmallestErrorsSay) {
  for (const Price& p : read_prices(data_folder() / "work.csv")) {
    EXPECT_GT(p.target, 0);
    EXPECT_TRUE(p.cpu > 0 || !(p.smallest <= p.target)) << p.case_name << " " << p.method;
  }
}

}  // namespace prices_test
}  // namespace touchstone::vnv

#include "reports/figures/order_plot.hpp"

#include "reports/figures/figures.hpp"
#include "reports/testing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace touchstone::reports {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

OrderComparison comparison_of(const std::vector<vnv::ObservedOrder>& orders) {
  OrderComparison comparison{{orders.front().quantity, orders.front().time}, {}};
  for (const auto& order : orders) {
    const std::size_t place = comparison.lines.size();
    comparison.lines.push_back({place == 0 ? "mpm" : fmt::format("sph{}", place), place, order});
  }
  return comparison;
}

/// The rows of the data, without the heading and the name of the ladder.
std::vector<std::vector<double>> rows_of(const Plot& plot) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(plot.data);
  std::string line, field;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::istringstream fields(line);
    std::getline(fields, field, ',');
    rows.emplace_back();
    while (std::getline(fields, field, ',')) rows.back().push_back(std::stod(field));
  }
  return rows;
}

double slope(const std::vector<std::vector<double>>& rows, std::size_t column) {
  return std::log(rows.front()[column] / rows.back()[column]) / std::log(rows.front()[0] / rows.back()[0]);
}

TEST(OrderPlot, HasABandOfAllOrdersInTheIntervalAboutTheCentreOfTheData) {
  const auto rows = rows_of(plot_orders(comparison_of({sample_order()})));
  ASSERT_EQ(rows.size(), 3);
  EXPECT_NEAR(slope(rows, 3), 1.9, 1e-6);
  EXPECT_NEAR(slope(rows, 4), 2.1, 1e-6);
  EXPECT_NEAR(rows[1][0], 2, 1e-9);
  for (const std::size_t line : {2, 3, 4})
    EXPECT_NEAR(rows[1][line], 0.4, 1e-6) << "the level in the middle is the centre";
}

TEST(OrderPlot, TellsTheOrderOfEachMethodInItsKey) {
  vnv::ObservedOrder growing = sample_order();
  growing.order = -1.234;
  growing.half_width = 0.0123;
  const std::string script =
      plot_orders(comparison_of({sample_order(), growing, sample_order("L2 v_x [%]", 1, 2)})).script;
  for (const char* label : {"title 'mpm: order 2.00 ± 0.10'", "title 'sph1: order −1.23 ± 0.01'",
                            "title 'sph2: order 2.00 of two spacings'"})
    EXPECT_TRUE(contains(script, label)) << label;
}

TEST(OrderPlot, DrawsNoBandWhereTheOrderIsNotKnown) {
  vnv::ObservedOrder vague = sample_order();
  vague.half_width = 1.5;
  const Plot sure = plot_orders(comparison_of({sample_order()})), unsure = plot_orders(comparison_of({vague}));
  EXPECT_TRUE(contains(sure.script, "filledcurves"));
  EXPECT_FALSE(contains(unsure.script, "filledcurves"));
  EXPECT_FALSE(contains(order_figure(comparison_of({vague})).caption, "Bands"));
  EXPECT_TRUE(contains(order_figure(comparison_of({sample_order(), vague})).caption, "no wider than ± 1"));
  EXPECT_TRUE(contains(unsure.script, "order 2.00 ± 1.50")) << "it is reported all the same";
  vague.half_width = infinite;
  EXPECT_TRUE(std::isnan(rows_of(plot_orders(comparison_of({vague})))[0][3]));
}

TEST(OrderPlot, DrawsAFloorWhereOneWasFoundAndLeavesRoomForIt) {
  vnv::ObservedOrder order = sample_order();
  EXPECT_FALSE(contains(plot_orders(comparison_of({order})).script, "using 2:7"));
  EXPECT_FALSE(contains(order_figure(comparison_of({order})).caption, "Dashed"));
  order.floor = 0.004;
  const std::string script = plot_orders(comparison_of({order})).script;
  EXPECT_TRUE(contains(script, "using 2:7 with lines"));
  EXPECT_TRUE(contains(script, "set yrange [0.002:")) << script;
  EXPECT_TRUE(contains(order_figure(comparison_of({order})).caption, "Dashed"));
}

TEST(OrderPlot, HasGuidesOfSlopesOneAndTwoBelowItsData) {
  const std::string script = plot_orders(comparison_of({sample_order()})).script;  // 1.6 to 0.1 % over 4 to 1 mm
  EXPECT_TRUE(contains(script, "set arrow from first 1,0.06 to first 2,0.12 nohead")) << script;
  EXPECT_TRUE(contains(script, "set arrow from first 1,0.06 to first 2,0.24 nohead")) << script;
}

TEST(OrderPlot, SaysAlongWhichLaddersItCompares) {
  vnv::ObservedOrder spacing = sample_order();
  EXPECT_TRUE(contains(order_figure(comparison_of({spacing, spacing})).caption, "Along the ladder “grid”."));
  spacing.ladder = "spacing";
  EXPECT_TRUE(contains(order_figure(comparison_of({sample_order(), spacing, sample_order()})).caption,
                       "mpm, sph2 along “grid”; sph1 along “spacing”."));
}

TEST(OrderPlot, IsDrawnEvenOfErrorsThatAreNotNumbers) {
  const ScratchFolder folder;
  vnv::ObservedOrder broken = sample_order();
  broken.order = broken.half_width = vnv::not_a_number;
  broken.errors = std::vector(3, vnv::not_a_number);
  for (const auto& comparison : {comparison_of({broken}), comparison_of({sample_order(), broken})}) {
    const Plot plot = plot_orders(comparison);
    draw({{order_figure(comparison), plot}}, folder.path());
    EXPECT_EQ(plot.undrawn, 3);
    EXPECT_TRUE(contains(read_whole(folder / plot.image), "no order"));
  }
}

TEST(OrderPlot, OfTheSameRecordsHasTheSameBytes) {
  const ScratchFolder first, second;
  vnv::Record record = sample_record();
  record.orders = {sample_order()};
  const Plots plots = plots_of_orders({"poiseuille", {record}});
  ASSERT_EQ(plots.size(), 1);
  for (const auto* folder : {&first, &second}) draw(plots, folder->path());
  for (const char* kind : {".svg", ".gp", ".csv"}) {
    const std::string file = std::string("order_L2_v_x_at_1_s") + kind;
    EXPECT_FALSE(read_whole(first / file).empty()) << file;
    EXPECT_EQ(read_whole(first / file), read_whole(second / file)) << file;
  }
}

}  // namespace
}  // namespace touchstone::reports

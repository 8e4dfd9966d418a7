#include "vnv/harness/assess.hpp"
#include "solvers/lattice.hpp"
#include "vnv/measures/coverage.hpp"
#include "vnv/record/record.hpp"

#include <gtest/gtest.h>

namespace touchstone::vnv {
namespace assess_test {

const Quantity l2{"L2 v_x", "%", Kind::norm}, other{"L2 v_y", "%", Kind::norm};

const Level coarse{.name = "coarse", .spacing = 0.2, .acceptance = 1},
    fine{.name = "fine", .spacing = 0.1, .acceptance = 1};

/// A case whose one method has an error of spacing squared.
Case second_order() {
  return {
      .title = "Second order",
      .times = {0.5, 1},
      .measurements = {[](const Level& level, const Run& run) -> std::vector<Value> {
        if (!run.summary.finished) return {};
        return {{level.name, level.spacing, 1, l2, level.spacing * level.spacing}};
      }},
      .methods = {{
          .name = "made_up",
          .run =
              [](const Level&, const Schedule& when) {
                return Run{.summary = {.end_time = when.times.back(), .finished = true, .outcome = "finished"}};
              },
          .levels = {coarse, fine},
          .ladders = {{"spacing", {"coarse", "fine"}}},
      }},
  };
}

Record assessed(const Case& declared, const std::optional<Baselines>& baselines = std::nullopt) {
  return assess("made_up_case", declared, declared.methods.front(), Suite::acceptance, baselines);
}

long count(const Record& record, Outcome outcome) {
  return std::ranges::count(record.verdicts, outcome, &Verdict::outcome);
}

Baselines accepted(double value, std::string quantity = "L2 v_x [%]") {
  return {.acceptance = {},
          .rows = {{"made_up", "coarse", 1, quantity, value, value - 1e-6, value + 1e-6, "made up"},
                   {"made_up", "fine", 1, "L2 v_x [%]", 0.01, 0.01 - 1e-6, 0.01 + 1e-6, "made up"}}};
}

TEST(Assess, JudgesEachLevelAndTheOrderAlongALadder) {
  Case declared = second_order();
  declared.methods[0].claims = {at_most(l2, 0.02, theory("")),
                                order_between("spacing", l2, 1.9, 2.1, theory("")).at(1)};
  const Record record = assessed(declared);
  ASSERT_EQ(record.orders.size(), 1u);
  EXPECT_NEAR(record.orders[0].order, 2, 1e-12);
  EXPECT_EQ(count(record, Outcome::fails), 1);         // coarse: 0.04 > 0.02
  EXPECT_EQ(count(record, Outcome::inconclusive), 1);  // two levels leave the order without an interval
}

TEST(Assess, JudgesInTheSuiteOfErrorAgainstRunTimeWhatIsClaimedThereAlone) {
  Case declared = second_order();
  Method& method = declared.methods[0];
  method.claims = declared.claims = {at_most(l2, 1e-9, theory("not on all levels of a study"))};
  method.claims_of_work = {at_most(l2, 1, theory(""))};
  for (Level& level : method.levels) level.work = 1, level.time_step = 1;
  const Record record = assess("made_up_case", declared, method, Suite::work, std::nullopt);
  EXPECT_EQ(count(record, Outcome::fails), 0);
  EXPECT_TRUE(claims_more_than_ends(record));
}

TEST(Assess, FailsARunThatDidNotEndAndWhatWasClaimedOfIt) {
  Case declared = second_order();
  declared.methods[0].run = [](const Level&, const Schedule&) {
    return vnv::Run{.summary = {.outcome = "diverged at step 3"}};
  };
  declared.methods[0].claims = {at_most(l2, 1, theory("")).on("fine").at(1)};
  const Record record = assessed(declared);
  EXPECT_EQ(count(record, Outcome::fails), 3);  // two ends and the claim
  EXPECT_NE(record.verdicts[0].sentence.find("diverged at step 3"), std::string::npos);
}

TEST(Assess, FailsAClaimThatNothingMeasures) {
  Case declared = second_order();
  declared.methods[0].claims = {at_most(other, 1, theory(""))};
  EXPECT_EQ(count(assessed(declared), Outcome::fails), 1);
  declared.methods[0].claims = {order_between("spacing", other, 1, 2, theory("")).at(1)};
  EXPECT_EQ(count(assessed(declared), Outcome::fails), 1);
}

TEST(Assess, AsksForAnOrderOnlyWhereTheSuiteRunsEnoughLevels) {
  Case declared = second_order();
  const Claim order = order_at_least("spacing", l2, 1.9, 1.75, theory("")).at(1);
  declared.methods[0].claims = {order.with_at_least_levels(3)};
  EXPECT_EQ(count(assessed(declared), Outcome::inconclusive), 0) << "two levels are run";
  declared.methods[0].claims = {order.with_at_least_levels(2)};
  EXPECT_EQ(count(assessed(declared), Outcome::inconclusive), 1);
}

TEST(Assess, RefusesClaimsAndLaddersThatNameNoLevel) {
  Case declared = second_order();
  declared.methods[0].claims = {at_most(l2, 1, theory("")).on("M9")};
  EXPECT_THROW(assessed(declared), std::invalid_argument);
  declared = second_order();
  declared.methods[0].ladders.push_back({"cells", {"M1"}});
  EXPECT_THROW(assessed(declared), std::invalid_argument);
}

TEST(Assess, KeepsAValueWithinItsBaselineToBothSides) {
  EXPECT_EQ(count(assessed(second_order(), accepted(0.04)), Outcome::fails), 0);
  EXPECT_EQ(count(assessed(second_order(), accepted(0.05)), Outcome::fails), 1);  // unexpectedly good
  EXPECT_EQ(count(assessed(second_order(), accepted(0.03)), Outcome::fails), 1);
}

TEST(Assess, IsInconclusiveWithoutABaselineAndFailsForOneThatIsNoLongerMeasured) {
  const Record of_none = assessed(second_order(), Baselines{});
  ASSERT_EQ(count(of_none, Outcome::inconclusive), 1) << "one line however many values";
  EXPECT_EQ(
      of_none.verdicts.back().sentence,
      "made_up_case.made_up: 2 values have no accepted baseline yet (fine, 1 s: L2 v_x [%] = 0.01); accept them with: "
      "build/vnv/vnv accept made_up_case.made_up --reason \"...\"");
  const Record record = assessed(second_order(), accepted(0.04, "L2 v_y [%]"));
  EXPECT_EQ(count(record, Outcome::inconclusive), 1);
  EXPECT_EQ(count(record, Outcome::fails), 1);
}

TEST(Assess, MissesNoValueOfTheEndOfARunThatGoesOnLongerThanTheAcceptedOne) {
  Baselines of_shorter = accepted(0.04);
  of_shorter.rows.push_back({"made_up", "coarse", 0.5, "L2 v_x [%]", 0.03, 0.02, 0.04, "made up"});
  EXPECT_EQ(count(assessed(second_order(), of_shorter), Outcome::fails), 0);
  of_shorter.rows.back().quantity = "L2 v_y [%]";  // measured at no time any more
  EXPECT_EQ(count(assessed(second_order(), of_shorter), Outcome::fails), 1);
}

TEST(Assess, RunsToATimeThatTheCaseDoesNotName) {
  Case declared = second_order();
  declared.methods[0].levels = {{.name = "coarse", .spacing = 0.2, .acceptance = 0.3},
                                {.name = "fine", .spacing = 0.1, .acceptance = 0.7}};
  const Record record = assessed(declared);
  EXPECT_EQ(record.runs[0].end_time, 0.3);
  EXPECT_EQ(record.runs[1].end_time, 0.7);
}

TEST(Assess, KeepsWhatWasMonitoredAsCsv) {
  Case declared = second_order();
  declared.monitor = {
      .interval = 0.5, .evaluate = [](const Samples&) { return std::vector{0.0}; }, .quantities = {{"front", "m"}}};
  declared.methods[0].levels = {{.name = "2 across", .spacing = 0.2, .acceptance = 1}};
  declared.methods[0].ladders.clear();
  declared.methods[0].run = [](const Level&, const Schedule&) {
    return vnv::Run{.summary = {.end_time = 1, .finished = true}, .history = {{0, 0.5}, {{1}, {not_a_number}}}};
  };
  const Record record = assessed(declared);
  ASSERT_EQ(record.histories.size(), 1u);
  EXPECT_EQ(record.histories[0].level, "2 across");
  EXPECT_EQ(record.histories[0].file, "histories/made_up_case.made_up.2_across.csv");
  EXPECT_EQ(record.histories[0].text,
            "# title: made_up_case.made_up 2 across, monitored quantities\ntime [s],front [m]\n0,1\n0.5,nan\n");
  declared.monitor.quantities.clear();
  EXPECT_THROW(assessed(declared), std::invalid_argument) << "a number without a name";
}

TEST(Assess, DistinguishesAClaimFromTheEndOfARun) {
  Case declared = second_order();
  const Record only_ends = assessed(declared);
  EXPECT_FALSE(only_ends.verdicts.empty());
  EXPECT_FALSE(claims_more_than_ends(only_ends));
  declared.claims = {at_most(l2, 1, theory(""))};
  EXPECT_TRUE(claims_more_than_ends(assessed(declared)));
}

TEST(Assess, ClaimsThatTheFluidOfARunStaysTogetherByTheoryAlone) {
  Case declared = second_order();
  declared.methods[0].run = [](const Level& level, const Schedule& when) {
    vnv::Run run{.summary = {.end_time = when.times.back(), .finished = true, .outcome = "finished"}};
    run.room = Room{{.box = {.high = {1, 1}}}, {.high = {1, 1}}};
    Samples sound{.time = 0.5, .x = lattice(run.room->filled, level.spacing).places()}, torn = sound;
    torn.time = 1;
    if (level.name == "fine")
      for (const Index p : {33, 34, 35, 43, 44, 45, 53, 54, 55}) torn.x.col(p) = torn.x.col(0);
    run.samples = {sound, torn};
    run.summary.cost.particles = sound.size();
    return run;
  };
  const Record record = assessed(declared, Baselines{});
  const auto outcome = [&](const std::string& level, const Quantity& quantity) {
    for (const Verdict& v : record.verdicts)
      if (v.level == level && v.quantity == quantity.name) return v.outcome;
    return Outcome::inconclusive;
  };
  EXPECT_EQ(outcome("coarse", rows_in_one_place), Outcome::holds);
  EXPECT_EQ(outcome("coarse", rows_crowded), Outcome::holds);
  EXPECT_EQ(outcome("coarse", largest_hole), Outcome::holds);
  EXPECT_EQ(outcome("fine", rows_in_one_place), Outcome::fails);
  EXPECT_FALSE(claims_more_than_ends(assessed(declared)));
  for (const Verdict& v : record.verdicts)
    if (v.quantity == never_accepted) {
      EXPECT_EQ(v.value, 2) << "the errors of two levels";
    }
  EXPECT_EQ(baselines_from(record, {}).size(), 2u);
}

TEST(Assess, LetsNoMethodPassWithFewerClaimsThanAccepted) {
  Case declared = second_order();
  declared.claims = {at_most(l2, 1, theory("of both levels"))};
  const Record record = assessed(declared);
  AcceptedClaims claims{{}, {claims_in(record)}};
  EXPECT_EQ(claims.rows[0].theory, 4) << "two ends and two values";
  EXPECT_TRUE(complaints(record, claims).empty());
  ++claims.rows[0].theory;
  EXPECT_EQ(complaints(record, claims),
            std::vector<std::string>{"made_up_case.made_up: 1 claim fewer than accepted: 1 of 5 theory"});
  EXPECT_EQ(complaints(assessed(second_order()), {}).size(), 1u) << "nothing but ends";
}

TEST(Baselines, AreMadeOfTheValuesOfARecord) {
  const std::vector<Baseline> rows = baselines_from(assessed(second_order()), {.relative = 0.1, .basis = "wide"});
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_NEAR(rows[0].lower, 0.036, 1e-12);
  EXPECT_NEAR(rows[0].upper, 0.044, 1e-12);
  EXPECT_EQ(rows[0].basis, "wide");
}

TEST(Baselines, OfSomeValuesMayBeWider) {
  const Record record = assessed(second_order());
  const std::string heading = record.values.front().quantity.heading();
  const Tolerance tolerance{.relative = 0.1, .basis = "wide", .exceptions = {{heading.substr(1), 0.5, "wider"}}};
  for (const Baseline& row : baselines_from(record, tolerance)) {
    const bool is_exception = row.quantity == heading;
    EXPECT_NEAR(row.upper, (is_exception ? 1.5 : 1.1) * row.value, 1e-12) << row.quantity;
    EXPECT_EQ(row.basis, is_exception ? "wider" : "wide") << row.quantity;
  }
}

TEST(Baselines, OfNegativeValuesAllowAsMuchAsOfPositiveOnes) {
  Record record = assessed(second_order());
  record.values[0].value = -3;
  const Baseline row = baselines_from(record, {.relative = 0.1}).front();
  EXPECT_NEAR(row.lower, -3.3, 1e-12);
  EXPECT_NEAR(row.upper, -2.7, 1e-12);
}

TEST(Baselines, OfWhatIsZeroButForRoundingAllowForRounding) {
  Record record = assessed(second_order());
  record.values[0].value = 2e-15;
  const Baseline row = baselines_from(record, {.relative = 0.02}).front();
  EXPECT_LT(row.lower, -1e-14);
  EXPECT_GT(row.upper, 1e-14);
}

TEST(Assess, LetsARunDivergeThatIsMadeToSeeWhetherItDoes) {
  Case declared = second_order();
  declared.methods[0].run = [](const Level&, const Schedule&) {
    return vnv::Run{.summary = {.outcome = "diverged at step 3"}};
  };
  EXPECT_EQ(count(assessed(declared), Outcome::fails), 2);
  for (Level& level : declared.methods[0].levels) level.may_diverge = true;
  EXPECT_EQ(count(assessed(declared), Outcome::fails), 0);
}

TEST(Assess, JudgesWhatWasFoundOverAllRunsAndKeepsItOutOfTheErrors) {
  Case declared = second_order();
  declared.findings = {[](const Results& results, const Record&) -> std::vector<Value> {
    return {{"", not_a_number, 1, {"runs"}, static_cast<double>(results.runs.size())}};
  }};
  declared.methods[0].claims = {at_most({"runs"}, 1, theory(""))};
  const Record record = assessed(declared);
  EXPECT_EQ(count(record, Outcome::fails), 1);
  EXPECT_TRUE(std::ranges::none_of(record.values, [](const Value& e) { return e.quantity.name == "runs"; }));
}

}  // namespace assess_test
}  // namespace touchstone::vnv

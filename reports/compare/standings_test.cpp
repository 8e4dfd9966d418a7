#include "reports/compare/standings.hpp"

#include "reports/testing.hpp"

#include <gtest/gtest.h>

namespace touchstone::reports {
namespace {

const vnv::Quantity l2{"L2 v_x", "%", vnv::Kind::norm};

vnv::Verdict claim(const std::string& author, vnv::Kind kind) {
  vnv::Verdict verdict = sample_verdict(vnv::Outcome::holds, 0.5);
  verdict.author = author;
  verdict.kind = kind;
  verdict.lower = kind == vnv::Kind::order ? std::optional(1.9) : std::nullopt;
  verdict.trend = kind == vnv::Kind::order ? vnv::Trend::converging : vnv::Trend::inconclusive;
  return verdict;
}

/// Errors of second order at 1 s, times a factor, in runs of 1, 2 and 4 s; no claim.
vnv::Record with_errors(const std::string& method, double factor) {
  vnv::Record record = sample_record(method);
  record.orders = {sample_order()};
  record.values = errors_of(record.orders[0]);
  for (vnv::Value& value : record.values) {
    value.quantity = l2;
    value.value *= factor;
  }
  record.runs = {sample_run("M1", 1), sample_run("M2", 2), sample_run("M3", 4)};
  record.verdicts.clear();
  return record;
}

const std::optional<Work> of_l2 = Work{{"work", "", "", l2, {}}, 1, {}, ""};

TEST(Standing, IsCalledRightByTheoryOrLiteratureOfItsErrorOnly) {
  EXPECT_TRUE(says_right(claim("theory: of second order", vnv::Kind::order), of_l2));
  EXPECT_TRUE(says_right(claim("literature: table 3", vnv::Kind::norm), of_l2));
  EXPECT_FALSE(says_right(claim("baseline: as measured", vnv::Kind::norm), of_l2));
  vnv::Verdict other = claim("theory: gravity is the only source of energy", vnv::Kind::invariant);
  other.quantity = "rise of the energy";
  EXPECT_FALSE(says_right(other, of_l2));
  EXPECT_TRUE(says_right(other, std::nullopt)) << "where no error is measured";
  other.author = "baseline: as measured";
  EXPECT_FALSE(says_right(other, std::nullopt));
}

TEST(Standing, IsNotCalledRightByAClaimThatItStallsOrIsWrongOrEnds) {
  vnv::Verdict stalls = claim("theory: the lattice is elastic", vnv::Kind::order);
  stalls.trend = vnv::Trend::stalled;
  EXPECT_FALSE(says_right(stalls, of_l2));
  vnv::Verdict wrong = claim("theory: the impulse of the wall is missing", vnv::Kind::norm);
  wrong.lower = 5;
  wrong.upper = std::nullopt;
  EXPECT_FALSE(says_right(wrong, of_l2));
  vnv::Verdict ends = claim("theory: a stable method reaches the end time", vnv::Kind::value);
  ends.quantity = "end time reached";
  EXPECT_FALSE(says_right(ends, std::nullopt));
}

TEST(Standing, TakesNoClaimThatFails) {
  vnv::Record record = with_errors("mpm", 1);
  record.verdicts = {claim("theory: of second order", vnv::Kind::order)};
  EXPECT_TRUE(standings_of({"poiseuille", {record}}).methods[0].converges());
  record.verdicts[0].outcome = vnv::Outcome::fails;
  EXPECT_TRUE(standings_of({"poiseuille", {record}}).methods[0].right_by.empty());
}

TEST(Standings, HaveTheErrorOrderAndCostOfEachMethodAndMarkTheBest) {
  const CaseRecords records{"poiseuille", {with_errors("sph", 2), with_errors("mpm", 1)}};
  const Standings all = standings_of(records);
  ASSERT_TRUE(all.work);
  EXPECT_EQ(all.work->diagram.quantity.heading(), "L2 v_x [%]");
  EXPECT_EQ(all.work->time, 1);
  const Standing& first = all.methods[0];
  EXPECT_EQ(first.record->method, "mpm") << "the cheapest stands first";
  EXPECT_TRUE(first.is_cheapest && first.is_most_accurate);
  EXPECT_FALSE(all.methods[1].is_cheapest || all.methods[1].is_most_accurate);
  EXPECT_DOUBLE_EQ(first.error, 0.1);
  EXPECT_DOUBLE_EQ(all.methods[1].error, 0.2);
  EXPECT_EQ(first.order->order, 2);
  EXPECT_LT(first.cost.cpu, all.methods[1].cost.cpu);
}

TEST(Standings, CallNoMethodBestThatFails) {
  CaseRecords records{"poiseuille", {with_errors("sph", 2), with_errors("mpm", 1)}};
  records.records[1].verdicts = {sample_verdict(vnv::Outcome::fails, -1)};
  const Standings all = standings_of(records);
  EXPECT_FALSE(all.methods[0].is_cheapest || all.methods[0].is_most_accurate);
  EXPECT_TRUE(all.methods[1].is_cheapest && all.methods[1].is_most_accurate);
}

TEST(Standings, KnowHowWrongAMethodIsAtItsEnd) {
  vnv::Record record = with_errors("mpm", 1);
  record.values.push_back({"M1", 4e-3, 2, l2, 60});
  record.values.push_back({"M2", 2e-3, 2, l2, 51});
  const Standings all = standings_of({"poiseuille", {record}});
  EXPECT_EQ(all.methods[0].at_end->value, 51);
  EXPECT_EQ(all.methods[0].at_end->time, 2);
}

TEST(Standings, TakeNoErrorsOfRunsThatDifferInSomethingElseThanTheirSpacing) {
  vnv::Record record = sample_record("mpm");
  record.values = {{"plain", 1e-3, 1, l2, 0.5}};
  EXPECT_TRUE(standings_of({"invariance", {record}}).work);
  record.values.push_back({"mirrored", 1e-3, 1, l2, 0.5});
  EXPECT_FALSE(standings_of({"invariance", {record}}).work);
  record.values = {{"stiff", 1e-3, vnv::not_a_number, l2, 0.5}};
  EXPECT_FALSE(standings_of({"extreme", {record}}).work) << "at no time";
}

TEST(Standings, WithoutAnErrorHaveNone) {
  const Standings all = standings_of({"speed", {sample_record("mpm")}});
  EXPECT_FALSE(all.work);
  ASSERT_EQ(all.methods.size(), 1u);
  EXPECT_TRUE(std::isnan(all.methods[0].error));
}

}  // namespace
}  // namespace touchstone::reports

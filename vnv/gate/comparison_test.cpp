#include "vnv/gate/comparison.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <set>

namespace touchstone::gate {
namespace comparison_test {

using vnv::Value, vnv::ObservedOrder, vnv::Outcome, vnv::Record, vnv::RunSummary, vnv::Verdict;

constexpr double steps_limit = 5.6;  // us

Verdict verdict(std::string level, std::string quantity, double value, std::optional<double> lower,
                std::optional<double> upper, std::string author) {
  return {.case_name = "poiseuille",
          .method = "mpm",
          .level = std::move(level),
          .time = 1,
          .quantity = std::move(quantity),
          .unit = "%",
          .kind = vnv::Kind::norm,
          .better = vnv::Better::smaller,
          .value = value,
          .lower = lower,
          .upper = upper,
          .author = std::move(author),
          .outcome = Outcome::holds,
          .sentence = ""};
}

/// A method as the suites leave it: two runs with an error each, an order, a limit of stability, a memory, claims.
Record plain() {
  Record record;
  record.case_name = "poiseuille";
  record.method = "mpm";
  record.suite = "acceptance";
  for (const std::string level : {"M1", "M2"})
    record.runs.push_back({.level = level, .end_time = 1, .finished = true, .outcome = "finished"});
  record.values = {
      {"M1", 2e-5, 1, {"L2 v_x", "%", vnv::Kind::norm}, 0.4},
      {"M2", 1e-5, 1, {"L2 v_x", "%", vnv::Kind::norm}, 0.1},
      {"M2", 1e-5, 1, {"relative error of the period", "%", vnv::Kind::deviation}, -0.2},
      {"M2", 1e-5, 1, {"slope dL/dT"}, 1.34},
      {"M2", 1e-5, 1, {"largest stable time step, lower bound", "us", vnv::Kind::stability_limit}, steps_limit},
      {"M2", 1e-5, 1, {"peak memory", "GB", vnv::Kind::cost}, 2}};
  ObservedOrder order;
  order.ladder = "grid";
  order.quantity = "L2 v_x [%]";
  order.time = 1;
  order.order = 2;
  order.half_width = 0.4;
  order.levels = {"M1", "M2"};
  order.spacings = {2e-5, 1e-5};
  order.errors = {0.4, 0.1};
  record.orders = {order};
  record.verdicts = {verdict("M2", "L2 v_x", 0.1, std::nullopt, 0.17, "literature: table 3, M2"),
                     verdict("M2", "L2 v_x", 0.1, 0.0999, 0.1001, "baseline: rounding"),
                     verdict("M2", "largest stable time step, lower bound", steps_limit, 0.97 * steps_limit,
                             1.03 * steps_limit, "baseline: bisection")};
  return record;
}

Record changed(const std::function<void(Record&)>& change) {
  Record record = plain();
  change(record);
  return record;
}

/// All that is not the same.
std::vector<Difference> changes(const Record& before, const Record& after) {
  std::vector<Difference> found = compare({before}, {after});
  std::erase_if(found, [](const Difference& d) { return d.change == Change::same; });
  return found;
}

std::vector<Difference> changes_by(const std::function<void(Record&)>& change) {
  return changes(plain(), changed(change));
}

Change change_of(const std::vector<Difference>& found) {
  return found.size() == 1 ? found.front().change : Change::unjudged;
}

TEST(Comparison, OfARecordWithItselfFindsAllTheSame) {
  EXPECT_EQ(compare({plain()}, {plain()}).size(), 12u);
  for (const Difference& d : changes(plain(), plain())) EXPECT_EQ(d.quantity, "peak memory [GB]") << sentence_of(d);
}

TEST(Comparison, NamesAnErrorThatIsATenthLarger) {
  const auto found = changes_by([](Record& r) { r.values[0].value *= 1.1; });
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(sentence_of(found.front()),
            "poiseuille.mpm M1: L2 v_x [%] at 1 s: 0.4 before, 0.44 after: worse: by +10 %; allowed are 0.008");
}

TEST(Comparison, SwappedFindsBetterWhatWasWorse) {
  const Record worse = changed([](Record& r) { r.values[0].value *= 1.1; });
  EXPECT_EQ(changes(worse, plain()).front().change, Change::better);
}

TEST(Comparison, KnowsNoOrderOfRecordsAndOfWhatTheyHoldAndNoRepetition) {
  std::mt19937_64 random(36);
  const auto sentences = [](const std::vector<Difference>& found) {
    std::multiset<std::string> all;
    for (const Difference& d : found) all.insert(sentence_of(d));
    return all;
  };
  for (int trial = 0; trial < 50; ++trial) {
    Records before, after;
    for (const std::string method : {"mpm", "mpm_apic", "sph", "sph_delta"}) {
      for (Records* side : {&before, &after}) {
        Record record = plain();
        record.method = method;
        for (Verdict& verdict : record.verdicts) verdict.method = method;
        for (Value& value : record.values) value.value *= random() % 2 ? 1 : 1.1;
        side->push_back(record);
      }
    }
    if (trial % 2) after.pop_back();
    Records other_before = before, other_after = after;
    for (Records* side : {&other_before, &other_after}) {
      std::ranges::shuffle(*side, random);
      for (Record& record : *side) {
        std::ranges::shuffle(record.runs, random);
        std::ranges::shuffle(record.values, random);
        std::ranges::shuffle(record.verdicts, random);
      }
    }
    const auto found = sentences(compare(before, after));
    EXPECT_EQ(sentences(compare(other_before, other_after)), found);
    EXPECT_EQ(sentences(compare_repeated({before, other_before}, {after, other_after, after})), found);
  }
}

TEST(Comparison, NamesAStabilityLimitShrunkByATwentieth) {
  const auto found = changes_by([](Record& r) { r.values[4].value *= 0.95; });
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found.front().kind, Kind::stability);
  EXPECT_EQ(found.front().quantity, "largest stable time step, lower bound [us]");
  EXPECT_EQ(found.front().change, Change::worse);
}

TEST(Comparison, NamesAnOrderFallenByThreeTenthsHoweverWideItsInterval) {
  const auto found = changes_by([](Record& r) { r.orders[0].order = 1.7; });
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found.back().kind, Kind::order);
  EXPECT_EQ(found.back().change, Change::worse);
}

TEST(Comparison, LeavesBaselinesTheirToleranceButNoMore) {
  const auto moved = [](double fraction) {
    return change_of({changes_by([fraction](Record& r) { r.values[1].value *= 1 + fraction; }).front()});
  };
  EXPECT_EQ(moved(0.0009), Change::unjudged);  // only the memory is left
  EXPECT_EQ(moved(0.0011), Change::worse);
  EXPECT_EQ(moved(-0.0011), Change::better);
}

TEST(Comparison, LetsAValueMoveByTheNarrowestOfItsBaselines) {
  for (const bool is_narrow_first : {true, false}) {
    Record before = plain(), after;
    before.verdicts.insert(before.verdicts.begin() + (is_narrow_first ? 2 : 1),
                           verdict("M2", "L2 v_x", 0.1, 0.09, 0.11, "baseline: wide"));
    after = before;
    after.values[1].value *= 1.0011;
    EXPECT_EQ(changes(before, after).front().change, Change::worse) << is_narrow_first;
  }
}

TEST(Comparison, ComparesErrorsWithASignByTheirSize) {
  const auto moved = [](double to) { return changes_by([to](Record& r) { r.values[2].value = to; }).front().change; };
  EXPECT_EQ(moved(0.1), Change::better);
  EXPECT_EQ(moved(-0.3), Change::worse);
  EXPECT_EQ(moved(0.3), Change::worse);
}

TEST(Comparison, LeavesToAPersonWhatHasNoBetterWay) {
  EXPECT_EQ(changes_by([](Record& r) { r.values[3].value = 1.5; }).front().change, Change::inconclusive);
}

TEST(Comparison, AsksTheQuantityWhichWayIsBetterAndOfAFormerRecordThatOfToday) {
  const auto former = changed([](Record& r) { r.values[3].quantity = vnv::with_heading("slope dL/dT [-]"); });
  const auto after =
      changed([](Record& r) { r.values[3].quantity.better = vnv::Better::smaller, r.values[3].value = 1.5; });
  EXPECT_EQ(changes(former, after).front().change, Change::worse);
}

TEST(Comparison, FindsWhatIsNoNumberAnyMoreWorse) {
  const auto found = changes_by([](Record& r) { r.values[0].value = r.orders[0].order = vnv::not_a_number; });
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found.front().change, Change::worse);
  EXPECT_EQ(found.back().change, Change::worse);
  EXPECT_EQ(changes(changed([](Record& r) { r.values[0].value = vnv::not_a_number; }), plain()).front().change,
            Change::better);
}

TEST(Comparison, FindsARunThatVanishedOrDivergedWorse) {
  const auto vanished = changes_by([](Record& r) { r.runs.pop_back(); });
  EXPECT_EQ(vanished.front().level, "M2");
  EXPECT_EQ(vanished.front().change, Change::worse);
  const auto diverged = changes_by([](Record& r) {
    r.runs[0].finished = false;
    r.runs[0].outcome = "diverged at step 7";
  });
  EXPECT_EQ(diverged.front().why, "diverged at step 7");
  EXPECT_EQ(diverged.front().change, Change::worse);
}

TEST(Comparison, FindsAnErrorAnOrderOrAClaimThatVanishedWorse) {
  for (const auto& vanish : std::vector<std::function<void(Record&)>>{
           [](Record& r) { r.values.erase(r.values.begin()); }, [](Record& r) { r.orders.clear(); },
           [](Record& r) { r.verdicts.pop_back(); }}) {
    const auto found = changes_by(vanish);
    EXPECT_EQ(std::ranges::count(found, Change::worse, &Difference::change), 1);
  }
}

TEST(Comparison, FindsAMethodThatVanishedWorseAndTellsANewOne) {
  const auto vanished = compare({plain()}, {});
  ASSERT_EQ(vanished.size(), 1u);
  EXPECT_EQ(sentence_of(vanished.front()), "poiseuille.mpm: method: worse: no longer there");
  EXPECT_EQ(change_of(compare({}, {plain()})), Change::unjudged);
}

TEST(Comparison, FindsAClaimWorseThatFailsOrIsInconclusiveNow) {
  for (const Outcome outcome : {Outcome::fails, Outcome::inconclusive}) {
    const auto found = changes_by([&](Record& r) { r.verdicts[0].outcome = outcome; });
    EXPECT_EQ(found.front().kind, Kind::claim);
    EXPECT_EQ(found.front().change, Change::worse);
    EXPECT_EQ(changes(changed([&](Record& r) { r.verdicts[0].outcome = outcome; }), plain()).front().change,
              Change::better);
  }
}

TEST(Comparison, FindsABaselineBetterThatIsLeftBecauseTheErrorFell) {
  const auto found = changes_by([](Record& r) {
    r.values[1].value = r.verdicts[1].value = 0.05;
    r.verdicts[1].outcome = Outcome::fails;
  });
  for (const Difference& d : found)
    EXPECT_TRUE(d.change == Change::better || d.quantity == "peak memory [GB]") << sentence_of(d);
}

TEST(Comparison, TakesAFirstAcceptanceForNoLoss) {
  Record before = plain();
  before.verdicts.push_back(verdict("", std::string(vnv::never_accepted), 3, std::nullopt, 0, "baseline: none yet"));
  for (const Difference& d : compare({before}, {plain()})) EXPECT_LE(d.change, Change::same) << sentence_of(d);
}

TEST(Comparison, LeavesALoosenedLimitToAPerson) {
  EXPECT_EQ(changes_by([](Record& r) { r.verdicts[0].upper = 0.3; }).front().change, Change::inconclusive);
  EXPECT_TRUE(changes_by([](Record& r) { r.verdicts[0].upper = 0.15; }).front().kind != Kind::claim);
}

TEST(Comparison, LeavesABaselineWithMoreRoomToAPersonButNotOneThatFollowsItsValue) {
  const auto with_limits = [](double lower, double upper) {
    return changed([=](Record& r) { r.verdicts[1].lower = lower, r.verdicts[1].upper = upper; });
  };
  const auto claims_changed = [](const Record& before, const Record& after) {
    return std::ranges::count(changes(before, after), Kind::claim, &Difference::kind);
  };
  const auto found = changes(plain(), with_limits(0.098, 0.102));
  EXPECT_EQ(found.front().change, Change::inconclusive);
  EXPECT_EQ(sentence_of(found.front()),
            "poiseuille.mpm M2: claim on L2 v_x (baseline: rounding) at 1 s: inconclusive: holds before, holds now, by "
            "limits that allow more");
  EXPECT_EQ(claims_changed(plain(), with_limits(0.09995, 0.10005)), 0);
  EXPECT_EQ(claims_changed(plain(), with_limits(0.0999 * 1.5, 0.1001 * 1.5)), 0);  // 0.1 % of 0.15
  EXPECT_EQ(claims_changed(plain(), with_limits(0.0999 / 1.5, 0.1001 / 1.5)), 0);
  EXPECT_EQ(claims_changed(plain(), with_limits(0.0498, 0.0502)), 1);
  EXPECT_EQ(claims_changed(with_limits(-0.1, 0.1), with_limits(-1, 1)), 1);
}

TEST(Comparison, NeverJudgesWhatIsTheMachines) {
  const auto found = changes_by([](Record& r) {
    r.values[5].value = 200;
    for (RunSummary& run : r.runs) run.cost.cpu = 1e3;
  });
  EXPECT_EQ(change_of(found), Change::unjudged);
}

TEST(Comparison, RefusesTwoRecordsOfAMethod) {
  EXPECT_THROW(compare({plain(), plain()}, {plain()}), std::invalid_argument);
}

TEST(Comparison, OfRepeatedRunsSetsAsideWhatVariedBefore) {
  const Record other = changed([](Record& r) { r.values[0].value *= 1.5; });
  const auto find = [](const std::vector<Difference>& all) {
    return std::ranges::find(all, "L2 v_x [%]", &Difference::quantity)->change;
  };
  EXPECT_EQ(find(compare_repeated({{plain()}, {other}}, {{other}, {plain()}})), Change::unjudged);
  EXPECT_EQ(find(compare_repeated({{plain()}, {plain()}}, {{plain()}, {other}})), Change::inconclusive);
  EXPECT_EQ(find(compare_repeated({{plain()}, {plain()}}, {{other}, {other}})), Change::worse);
}

TEST(Comparison, NamesTheMachinesOfWhatDiffersBetweenThem) {
  Record before = plain(), after = plain();
  before.machine = "a";
  after.machine = "b";
  EXPECT_TRUE(
      std::ranges::none_of(compare({before}, {after}), [](const Difference& d) { return d.why.ends_with("b after"); }));
  after.values[0].value *= 2;
  const auto said = [&] {
    const std::vector<Difference> all = compare({before}, {after});
    return std::ranges::find(all, Change::worse, &Difference::change)->why;
  };
  EXPECT_TRUE(said().ends_with("; this value depends on the machine: a before, b after")) << said();
  after.revision = "another";
  EXPECT_TRUE(said().ends_with("; on another machine: a before, b after")) << said();
  after.machine = "a";
  EXPECT_EQ(said().find("machine"), std::string::npos) << said();
}

}  // namespace comparison_test
}  // namespace touchstone::gate

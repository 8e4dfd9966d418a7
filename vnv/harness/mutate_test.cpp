#include "vnv/harness/mutate.hpp"

#include "vnv/record/record.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace touchstone::vnv {
namespace mutate_test {

const Quantity l2{"L2 v_x", "%", Kind::norm}, slope{"slope", "-"};

Level level_of(const char* name, double spacing) { return {.name = name, .spacing = spacing, .acceptance = 1}; }

/// A case whose one method has an error of spacing squared, and a particle with that velocity; and a finding of 1.
Case second_order() {
  Case declared{
      .title = "Second order",
      .times = {1},
      .measurements = {[](const Level& level, const Run& run) -> std::vector<Value> {
        return {{level.name, level.spacing, 1, l2, run.samples.front().v(0, 0)}};
      }},
      .findings = {[](const Results&, const Record&) -> std::vector<Value> {
        return {{"", not_a_number, 1, slope, 1}};
      }},
      .claims = {at_most(l2, 1, theory("small")), between(slope, 0.5, 1.5, theory("one"))},
      .methods = {{
          .name = "made_up",
          .run =
              [](const Level& level, const Schedule&) {
                Run run{.summary = {.time_step = 1, .end_time = 1, .finished = true, .outcome = "finished"}};
                const Vectors one = Vectors::Constant(2, 1, level.spacing * level.spacing);
                run.samples = {
                    {.time = 1, .x = one, .v = one, .mass = one.row(0), .density = one.row(0), .pressure = one.row(0)}};
                return run;
              },
          .levels = {level_of("coarse", 0.4), level_of("middle", 0.2), level_of("fine", 0.1)},
          .ladders = {{"spacing", {"coarse", "middle", "fine"}}},
          .claims = {order_between("spacing", l2, 1.9, 2.1, theory("second")).at(1)},
      }},
  };
  return declared;
}

const Baselines accepted{.acceptance = {},
                         .rows = {{"made_up", "fine", 1, "L2 v_x [%]", 0.01, 0.0099, 0.0101, "made up"}}};

Record record_of(const Case& declared) {
  Record record = assess("made_up_case", declared, declared.methods[0], Suite::report, accepted);
  return record;
}

class Mutation : public testing::Test {
 protected:
  Mutation() {
    for (Level& level : declared.methods[0].levels) level.report = 1;
  }
  Case declared = second_order();
};

TEST_F(Mutation, IsSeenOfEachClaimThatHolds) {
  const Record record = record_of(declared);
  const Mutations all = mutate_record(declared, declared.methods[0], record, accepted, {{}, {claims_in(record)}});
  EXPECT_EQ(all.sentence(), "9 claims hold: beyond 9/9, nan 6/6, missing 9/9, elsewhere 5/5, unmeasured 6/6");
  EXPECT_TRUE(all.survivors.empty());
}

TEST_F(Mutation, OfAMissingValueSurvivesWithoutTheListOfAcceptedClaims) {
  declared.methods[0].claims.clear();
  const Mutations all = mutate_record(declared, declared.methods[0], record_of(declared), accepted, {});
  EXPECT_LT(all.seen[2], all.tried[2]) << "the claim of each level is not missed where others have a value";
  EXPECT_FALSE(all.survivors.empty());
}

TEST_F(Mutation, RefusesARecordThatIsJudgedOtherwise) {
  const Record record = record_of(declared);
  declared.claims[0].upper = 0.1;
  EXPECT_THROW(mutate_record(declared, declared.methods[0], record, accepted, {}), std::invalid_argument);
}

TEST_F(Mutation, OfSamplesIsSeenOfEachClaimOnThem) {
  std::vector<std::string> least;
  const Mutations all = mutate_samples("made_up_case", declared, declared.methods[0], Suite::report, accepted, least);
  EXPECT_EQ(all.claims, 9);
  EXPECT_EQ(all.seen[0], 8);
  ASSERT_TRUE(all.failing);
  EXPECT_FALSE(complaints(*all.failing, {}).empty());
  ASSERT_EQ(all.survivors.size(), 1u);
  EXPECT_NE(all.survivors[0].find("slope"), std::string::npos) << "which no sample is read for";
}

}  // namespace mutate_test
}  // namespace touchstone::vnv

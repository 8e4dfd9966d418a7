#include "vnv/studies/ensemble.hpp"
#include "vnv/record/record.hpp"

#include "vnv/harness/assess.hpp"

#include <gtest/gtest.h>

namespace touchstone::vnv {
namespace {

const Quantity height{"height", "m"};

/// A case of 16 starts, of which each has a height that follows from its number.
Case splashing(double mean, double spread) {
  const Ensemble ensemble;
  return {
      .title = "Made up",
      .times = {1},
      .measurements = {[=](const Level& level, const Run&) -> std::vector<Value> {
        const double number = std::stod(level.name.substr(6));
        return {{level.name, level.spacing, 1, height, mean + spread * std::sin(100 * number)}};
      }},
      .methods = {{
          .name = "made_up",
          .run =
              [](const Level&, const Schedule& when) {
                return vnv::Run{.summary = {.end_time = when.times.back(), .finished = true, .outcome = "finished"}};
              },
          .levels = ensemble.levels({.name = "", .spacing = 0.1, .acceptance = 1}),
          .tolerance = {1, "a member"},
      }},
      .ensemble = true,
  };
}

Record assessed(const Case& declared, const Baselines& baselines) {
  return assess("made_up_case", declared, declared.methods.front(), Suite::acceptance, baselines);
}

Baselines accepted(const Case& declared) {
  return {.acceptance = {}, .rows = baselines_from(assessed(declared, {}), declared.methods.front().tolerance)};
}

const Verdict& verdict_on_height(const Record& record) {
  return *std::ranges::find_if(record.verdicts, [](const Verdict& v) { return v.quantity.starts_with("height"); });
}

TEST(Ensemble, IsJudgedByWhatItsStartsAreTogether) {
  const Baselines before = accepted(splashing(1, 0.2));
  const Record record = assessed(splashing(1, -0.2), before);  // no start has the height that it had
  EXPECT_EQ(record.verdicts.size(), 16u + 1);                  // each run ends, and the distribution
  EXPECT_EQ(verdict_on_height(record).outcome, Outcome::holds) << verdict_on_height(record).sentence;
  EXPECT_GT(verdict_on_height(record).value, 0.1);
}

TEST(Ensemble, FailsWithAnotherMean) {
  const Baselines before = accepted(splashing(1, 0.2));
  EXPECT_EQ(verdict_on_height(assessed(splashing(1.4, 0.2), before)).outcome, Outcome::fails);
  EXPECT_EQ(verdict_on_height(assessed(splashing(0.6, 0.2), before)).outcome, Outcome::fails);
}

TEST(Ensemble, FailsWithAStartThatHasNoNumber) {
  const Baselines before = accepted(splashing(1, 0.2));
  EXPECT_EQ(verdict_on_height(assessed(splashing(not_a_number, 0), before)).outcome, Outcome::fails);
}

TEST(Ensemble, IsInconclusiveBeforeOneWasAccepted) {
  const Verdict verdict = assessed(splashing(1, 0.2), {}).verdicts.back();
  EXPECT_EQ(verdict.outcome, Outcome::inconclusive);
  EXPECT_NE(verdict.sentence.find("no accepted baseline yet"), std::string::npos) << verdict.sentence;
}

TEST(Ensemble, StartsEachOfItsMembersElsewhere) {
  const Ensemble ensemble{.members = 3, .jitter = 0.1};
  std::vector<double> seen;
  const Method method =
      ensemble.method(Scene<int>{}, {.name = "", .spacing = 0.5, .acceptance = 1}, [&](const Scene<int>& scene) {
        return Method{.name = "made_up", .run = [&seen, scene](const Level&, const Schedule&) {
                        if (scene.start.places) seen.push_back(scene.start.places(Vectors::Zero(2, 1)).coeff(0, 0));
                        return vnv::Run{};
                      }};
      });
  ASSERT_EQ(method.levels.size(), 3u);
  EXPECT_EQ(method.levels[2].name, "start 3");
  for (const Level& level : method.levels) method.run(level, {});
  method.run(method.levels[0], {});
  ASSERT_EQ(seen.size(), 4u);
  EXPECT_NE(seen[0], seen[1]);
  EXPECT_NE(seen[1], seen[2]);
  EXPECT_EQ(seen[3], seen[0]) << "the same again";
  for (const double moved : seen) EXPECT_LE(std::abs(moved), 0.05);
}

}  // namespace
}  // namespace touchstone::vnv

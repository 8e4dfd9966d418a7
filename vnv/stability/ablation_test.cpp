#include "vnv/stability/ablation.hpp"

#include <gtest/gtest.h>

namespace touchstone::vnv {
namespace {

const Outcomes all{.error = 1, .critical_step = 10 * us, .per_particle_step = 1e-8};

Outcomes with(double error, double step) { return {.error = error, .critical_step = step * us}; }

TEST(AnIngredient, IsNeededForAccuracyIfTheErrorGrowsWithoutIt) {
  EXPECT_EQ(needed_for(all, with(1.2, 10)), "accuracy");
  EXPECT_EQ(needed_for(all, with(1.05, 10)), "neither");
  EXPECT_EQ(needed_for(all, with(0.5, 10)), "neither");
}

TEST(AnIngredient, IsNeededForStabilityIfTheStepShrinksOrTheRunEndsEarly) {
  EXPECT_EQ(needed_for(all, with(1, 9)), "stability");
  EXPECT_EQ(needed_for(all, with(1, 12)), "neither");
  EXPECT_EQ(needed_for(all, {.finished = false, .critical_step = 10 * us}), "stability");
}

TEST(AnIngredient, WhoseLackLeavesNoNumberIsNeeded) {
  EXPECT_EQ(needed_for(all, with(not_a_number, not_a_number)), "accuracy and stability");
}

TEST(Ablation, RunsTheVariantThatALevelNames) {
  const auto ends_at = [](double time) {
    return [time](const Level&, const Schedule&) { return vnv::Run{.summary = {.end_time = time}}; };
  };
  const Method method = ablation({.name = "made_up"}, {.spacing = 0.5, .report = 1},
                                 {{unabridged, ends_at(1)}, {"without glue", ends_at(2)}});
  ASSERT_EQ(method.levels.size(), 2u);
  EXPECT_EQ(method.levels[1].name, "without glue");
  EXPECT_EQ(method.levels[1].report, 1);
  EXPECT_FALSE(method.levels[0].may_diverge);
  EXPECT_TRUE(method.levels[1].may_diverge);
  EXPECT_EQ(method.run(method.levels[1], {}).summary.end_time, 2);
}

TEST(Ablation, WantsTheWholeMethodFirst) {
  EXPECT_THROW(ablation({.name = "made_up"}, {.spacing = 0.5}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace touchstone::vnv

#include "vnv/command/tasks.hpp"

#include "vnv/programs/scratch_folder.hpp"
#include "vnv/record/record.hpp"

#include <gtest/gtest.h>

namespace touchstone::vnv::command {
namespace {

class APlan : public testing::Test {
 protected:
  APlan() {
    described_.name = "small";
    described_.methods.resize(1);
    MethodDescription& method = described_.methods.front();
    method.name = "mpm";
    method.levels.resize(3);
    method.levels[0] = {.name = "M1", .spacing = 1, .until = {{"acceptance", 0.1}, {"nightly", 1}}};
    method.levels[1] = {.name = "M2", .spacing = 0.5, .until = {{"nightly", 1}}};
    method.levels[2] = {.name = "M3", .spacing = 0.25, .until = {{"report", 1}}};
  }

  std::vector<Task> tasks(const std::string& suite) const {
    return tasks_of({{&described_, &described_.methods.front()}}, suite, scratch_.path());
  }

  const programs::ScratchFolder scratch_;
  Description described_;
};

TEST_F(APlan, HasTheRungsOfItsSuite) {
  const std::vector<Task> nightly = tasks("nightly");
  ASSERT_EQ(nightly.size(), 2u);
  EXPECT_EQ(nightly[1].name, "small.mpm");
  EXPECT_EQ(nightly[1].level, "M2");
  EXPECT_EQ(nightly[1].until, 1);
  EXPECT_EQ(nightly[1].cpu, std::nullopt);
}

TEST_F(APlan, TakesCostsWithAllRepeatsFromTheLastRecords) {
  Record record;
  record.runs = {{.level = "M1", .cost = {.repeats = 3, .cpu = 2}}};
  write(record, scratch_.path() / "small.mpm.json");
  const std::vector<Task> nightly = tasks("nightly");
  EXPECT_EQ(nightly.at(0).cpu, 6);
  EXPECT_EQ(nightly.at(1).cpu, std::nullopt);
}

TEST(AnEstimate, SharesMethodsOutAndRunsTimedOnesAlone) {
  const auto costs = [](const std::string& name, double cpu, bool timed = false) {
    return Task{name, "M1", 1, 1, cpu, timed};
  };
  const std::vector<Task> tasks{costs("a.mpm", 4), costs("a.sph", 2), costs("b.mpm", 2), costs("speed.mpm", 5, true)};
  EXPECT_EQ(estimate(tasks, 1).shortest_wall, 13);
  EXPECT_EQ(estimate(tasks, 2).shortest_wall, 5 + 4);
  EXPECT_EQ(estimate(tasks, 100).shortest_wall, 5 + 4);
}

TEST(AnEstimate, CountsRungsOfAMethodAsOneAndWhatIsUnknown) {
  const std::vector<Task> tasks{
      {"a.mpm", "M1", 1, 1, 3.0, false}, {"a.mpm", "M2", 1, 1, 4.0, false}, {"a.sph", "S1", 1, 1, {}, false}};
  const Estimate all = estimate(tasks, 2);
  EXPECT_EQ(all.longest, 7);
  EXPECT_EQ(all.shortest_wall, 7);
  EXPECT_EQ(all.unknown, 1);
}

}  // namespace
}  // namespace touchstone::vnv::command

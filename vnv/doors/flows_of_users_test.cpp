/// Flows in formulas, as users write them, are judged and diagnosed as those that are built in.

#include "vnv/doors/judge.hpp"
#include "vnv/doors/right_data.hpp"
#include "vnv/doors/solver.hpp"
#include "vnv/files/whole_file.hpp"
#include "vnv/flows/formulas/flow_file.hpp"
#include "vnv/programs/scratch_folder.hpp"

#include <gtest/gtest.h>

namespace touchstone::vnv::doors {
namespace {

class FlowsOfUsers : public testing::Test {
 protected:
  static Flow lamb_oseen(Settings settings = Settings()) { return flow_of("lamb_oseen", std::move(settings)); }
  /// What a code of second order hands in that computes the flow with these settings.
  static Record judged(const Flow& flow, const Flow& computed, const Judged& what = {}) {
    Given given{.fields = std::vector<std::string>{"velocity", velocity_along_x, "particles"}};
    for (const double across : {20, 40, 80}) {
      GivenLevel level{.spacing = flow.across / across};
      for (const double t : flow.judged.times) level.at.emplace(t, right_of(computed, across, t));
      given.levels.push_back(std::move(level));
    }
    return judge_given(flow, std::move(given), what).record;
  }
  static std::string sentences(const Record& record) {
    std::string all;
    for (const Verdict& v : record.verdicts) all += v.sentence + "\n";
    return all;
  }
  static bool holds(const Record& record) {
    return std::ranges::all_of(record.verdicts, [](const Verdict& v) { return v.outcome == Outcome::holds; });
  }
};

TEST_F(FlowsOfUsers, HoldWhereACodeConverges) {
  const Record record = judged(lamb_oseen(), lamb_oseen());
  EXPECT_TRUE(holds(record)) << sentences(record);
  ASSERT_FALSE(record.orders.empty());
  EXPECT_NEAR(record.orders[0].order, 2, 0.02);
}

TEST_F(FlowsOfUsers, AreDiagnosedByTheirParametersAndByWhatTheseAre) {
  const Record thicker = judged(lamb_oseen(), lamb_oseen(Settings({{"nu", 0.05 * 1.1}})), {.at_most = 0.1});
  EXPECT_FALSE(holds(thicker));
  EXPECT_NE(sentences(thicker).find("too viscous (at vanishing spacing 10.0"), std::string::npos) << sentences(thicker);
  const Record stronger = judged(lamb_oseen(), lamb_oseen(Settings({{"G", 1.05}})), {.at_most = 0.1});
  EXPECT_NE(sentences(stronger).find("G is 5."), std::string::npos) << sentences(stronger);
  EXPECT_NE(sentences(stronger).find("% too large"), std::string::npos) << sentences(stronger);
}

TEST_F(FlowsOfUsers, AreThoseOfAProgramToo) {
  const programs::ScratchFolder folder;
  files::write_whole(folder / "decay.toml", R"toml(times = [0.1]
[parameters]
nu = 0.01
[domain]
x = [0, 1]
y = [0, 1]
periodic = ["x", "y"]
[fluid]
density = 1
[exact]
v_x = "sin(2*pi*y)*exp(-nu*4*pi^2*t)"
v_y = 0
)toml");
  files::write_whole(folder / "mine.toml", R"toml(flow = "decay.toml"
set = {nu = 0.02}
across = [10, 20]
command = ["true"]
output = "out.csv"
)toml");
  EXPECT_EQ(read_solver(folder / "mine.toml").case_and_method(), "decay_nu=2e-2.mine");
}

}  // namespace
}  // namespace touchstone::vnv::doors

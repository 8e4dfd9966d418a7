/// Places at which a flow was probed, lines of them and profiles.

#include "vnv/doors/judge.hpp"
#include "vnv/files/whole_file.hpp"
#include "vnv/measures/coverage.hpp"
#include "vnv/programs/scratch_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace touchstone::vnv::doors {
namespace probes_test {

class Probes : public testing::Test {
 protected:
  static Flow channel() {
    return flow_named("poiseuille", Settings({{"H", 1}, {"L", 0.5}, {"nu", 0.01}, {"F", 0.01}}));
  }

  /// The exact channel, 4 % too fast, at places across it, as a table with these columns of x, y and v_x.
  Judgement profile(const std::string& names, const std::string& row, const Mapping& said = {}, int count = 20) const {
    const Flow flow = channel();
    std::string text = names + "\n";
    for (int k = 0; k < count; ++k) {
      const double y = (k + 0.5) / count;
      text += fmt::format(fmt::runtime(row), fmt::arg("y", y), fmt::arg("mm", 1e3 * y),
                          fmt::arg("v", 1.04 * flow.velocity()({0, y}, 20).x())) +
              "\n";
    }
    files::write_whole(folder / "profile.csv", text);
    Mapping mapping = said;
    mapping.time = 20;
    return judge_files(flow, {folder / "profile.csv"}, mapping, std::nullopt, {.at_most = 1});
  }
  static double l2(const Judgement& judgement) {
    const auto is_it = [](const Value& v) { return v.quantity.name == "L2 v_x, per particle"; };
    const auto found = std::ranges::find_if(judgement.record.values, is_it);
    return found == judgement.record.values.end() ? not_a_number : found->value;
  }

  const programs::ScratchFolder folder;
};

TEST_F(Probes, OfOneCoordinateAreAProfile) {
  for (const Judgement& judgement :
       {profile("y,v_x", "{y},{v}"), profile("y [mm],v_x [m/s]", "{mm},{v}"),
        profile("x,y,v_x", "0.25,{y},{v}", {.probes = true}), profile("y,v_x", "{y},{v}", {.at = "x=0.1"})}) {
    EXPECT_NEAR(l2(judgement), 4, 1e-9);
    EXPECT_EQ(judgement.record.runs[0].level, "20 across");
    for (const Value& v : judgement.record.values) EXPECT_FALSE(is_of_coverage(v.quantity.name)) << v.quantity.name;
    EXPECT_NE(judgement.words.size(), 0u);
  }
}

TEST_F(Probes, AreJudgedAsTheRowsOfACloudAtTheSamePlaces) {
  const Flow flow = channel();
  const auto text = [&](int columns) {
    std::string all = "x,y,v_x,v_y\n";
    for (int i = 0; i < columns; ++i)
      for (int k = 0; k < 20; ++k) {
        const double y = (k + 0.5) / 20;
        all += fmt::format("{},{},{},0\n", (i + 0.5) / 20, y, 1.04 * flow.velocity()({0, y}, 20).x());
      }
    return all;
  };
  files::write_whole(folder / "cloud.csv", text(10));
  files::write_whole(folder / "line.csv", text(1));
  const Judgement cloud = judge_files(flow, {folder / "cloud.csv"}, {.time = 20}),
                  line = judge_files(flow, {folder / "line.csv"}, {.probes = true, .time = 20});
  EXPECT_NEAR(l2(cloud), l2(line), 1e-12);
  EXPECT_THROW(judge_files(flow, {folder / "line.csv"}, {.time = 20}), Unreadable) << "a line is not all the fluid";
}

TEST_F(Probes, MayBeASinglePlace) { EXPECT_NEAR(l2(profile("y,v_x", "{y},{v}", {}, 1)), 4, 1e-9); }

TEST_F(Probes, OfAFlowInThePlaneNeedBothCoordinates) {
  const Flow flow = flow_named("taylor_green");
  std::string text = "y,vx,vy\n";
  for (int k = 0; k < 20; ++k) {
    const Vec2 x(0.25, (k + 0.5) / 20), v = flow.velocity()(x, 0.1);
    text += fmt::format("{},{},{}\n", x.y(), v.x(), v.y());
  }
  files::write_whole(folder / "cut.csv", text);
  const auto judged = [&](const std::string& at) {
    return judge_files(flow, {folder / "cut.csv"}, {.at = at, .time = 0.1}, 0.05, {.at_most = 1}).record;
  };
  try {
    judged("");
    FAIL() << "nothing says where the cut is";
  } catch (const Unreadable& error) {
    EXPECT_NE(std::string(error.what()).find("'y' is the only coordinate, expected x too, or --at x=PLACE [m]"),
              std::string::npos)
        << error.what();
  }
  const Record record = judged("x=0.25");
  EXPECT_NEAR(record.values.front().value, 0, 1e-6);
  EXPECT_NE(judged("x=0.1").verdicts.front().outcome, Outcome::holds) << "it is another cut";
}

}  // namespace probes_test
}  // namespace touchstone::vnv::doors

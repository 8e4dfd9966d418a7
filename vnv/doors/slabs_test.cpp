/// Plane flows that were computed in three dimensions: rows that fill a slab.

#include "vnv/doors/filling.hpp"
#include "vnv/doors/judge.hpp"
#include "vnv/files/whole_file.hpp"
#include "vnv/measures/coverage.hpp"
#include "vnv/programs/scratch_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

namespace touchstone::vnv::doors {
namespace slabs_test {

struct Row {
  double x, y, z, v_x, v_z = 0;
};

class Slabs : public testing::Test {
 protected:
  /// The exact channel, its fluid `error` too fast, so many across and so many layers deep, each row moved by up to a
  /// part of the spacing along all axes.
  std::vector<Row> channel(int across = 20, int layers = 4, double error = 0.04, double shaken = 0) const {
    std::mt19937 draw(3);
    std::uniform_real_distribution<double> any(-shaken, shaken);
    const double s = 1.0 / across;
    std::vector<Row> rows;
    for (int k = 0; k < layers; ++k)
      for (int i = 0; i < across / 2; ++i)
        for (int j = 0; j < across; ++j) {
          const double y = std::clamp((j + 0.5 + any(draw)) * s, 0.0, 1.0);
          rows.push_back(
              {(i + 0.5 + any(draw)) * s, y, (k + 0.5 + any(draw)) * s, (1 + error) * exact({0, y}, 20).x()});
        }
    return rows;
  }
  Judgement judged(const std::vector<Row>& rows, const Mapping& said = {}, std::optional<double> spacing = {},
                   const std::string& names = "x,y,z,vx,vy,vz", bool has_mass = false) const {
    std::string text = names + (has_mass ? ",mass\n" : "\n");
    for (const Row& r : rows)
      text += fmt::format("{},{},{},{},0,{}{}\n", r.x, r.y, r.z, r.v_x, r.v_z, has_mass ? ",0.125" : "");  // rho s³
    files::write_whole(folder / "slab.csv", text);
    Mapping mapping = said;
    mapping.time = 20;
    return judge_files(flow, {folder / "slab.csv"}, mapping, spacing, {.at_most = 1});
  }
  static double value(const Judgement& judgement, const std::string& quantity) {
    const auto found = std::ranges::find(judgement.record.values, quantity,
                                         [](const Value& v) -> const std::string& { return v.quantity.name; });
    return found == judgement.record.values.end() ? not_a_number : found->value;
  }
  static std::string complaints(const Judgement& judgement) {
    std::string all;
    for (const Verdict& v : judgement.record.verdicts)
      if (v.outcome != Outcome::holds) all += v.quantity + "\n";
    return all;
  }
  std::string refusal(const std::vector<Row>& rows, const std::string& names = "x,y,z,vx,vy,vz") const {
    try {
      judged(rows, {}, {}, names);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "judged without complaint";
  }

  const Flow flow = flow_named("poiseuille", Settings({{"H", 1}, {"L", 0.5}, {"nu", 0.01}, {"F", 0.01}}));
  const VelocityTruth exact = flow.velocity();
  const std::string l2 = "L2 v_x, per particle";
  const programs::ScratchFolder folder;
};

TEST_F(Slabs, AreJudgedByAllTheirRows) {
  for (const int layers : {2, 4, 10}) {
    const Judgement judgement = judged(channel(20, layers));
    EXPECT_NEAR(value(judgement, l2), 4, 1e-9);
    EXPECT_EQ(judgement.record.runs[0].level, "20 across") << layers << " layers";
    EXPECT_EQ(complaints(judgement).find("hole"), std::string::npos) << complaints(judgement);
  }
  EXPECT_NE(complaints(judged(channel())).find(l2), std::string::npos) << "4 % is more than the limit";
  EXPECT_EQ(complaints(judged(channel(20, 4, 0))), "");
}

TEST_F(Slabs, MayBeASingleLayerAPlaneOfAxesOrASlice) {
  EXPECT_NEAR(value(judged(channel(20, 1)), l2), 4, 1e-9);
  EXPECT_NEAR(value(judged(channel(), {.axes = "xy"}), l2), 4, 1e-9);
  EXPECT_NEAR(value(judged(channel(), {.axes = "xz"}, {}, "x,z,y,vx,vz,vy"), l2), 4, 1e-9) << "z is upwards";
  EXPECT_NEAR(value(judged(channel(), {}, {}, "x,z,y,vx,vz,vy"), l2), 4, 1e-9) << "the only plane that fits";
  for (const std::string slice : {"z<0.05", "z=0.025"}) {
    const Judgement one = judged(channel(), {.only = slice});
    EXPECT_NEAR(value(one, l2), 4, 1e-9);
    EXPECT_EQ(value(one, rows_found.name), 200);
  }
  EXPECT_NE(refusal(channel(20, 20)).find("which may be xy or xz; say which with --axes"), std::string::npos)
      << refusal(channel(20, 20));
}

TEST_F(Slabs, OfADisorderedCloudAreSound) {
  for (const double shaken : {0.1, 0.25}) {
    const Judgement judgement = judged(channel(20, 8, 0, shaken));
    EXPECT_EQ(complaints(judgement), "") << shaken;
    EXPECT_NEAR(judgement.record.runs[0].spacing, 0.05, 0.002);
    EXPECT_EQ(complaints(judged(channel(20, 8, 0, shaken), {}, 0.05)), "") << "at a spacing that is said";
  }
}

TEST_F(Slabs, HaveMassesOfTheirDepth) {
  const Judgement judgement = judged(channel(), {}, {}, "x,y,z,vx,vy,vz", true);
  EXPECT_NEAR(value(judgement, mass_found.name), 0, 1e-9);
  EXPECT_NEAR(value(judgement, l2), 4, 1e-9);
}

TEST_F(Slabs, LackFluidWhereASliceDoes) {
  for (const auto& [shaken, quantity] : {std::pair(0.0, empty_places_of_grid.name), std::pair(0.25, largest_hole.name)}) {
    std::vector<Row> hollow = channel(40, 8, 0, shaken);
    std::erase_if(hollow, [](const Row& r) {
      return std::hypot(r.x - 0.25, r.y - 0.5, r.z - 0.1) < 0.08;  // a sphere 6 spacings across
    });
    const Judgement judgement = judged(hollow, {}, 1.0 / 40);
    EXPECT_NE(complaints(judgement).find(quantity), std::string::npos) << complaints(judgement);
  }
  std::vector<Row> twice = channel(20, 4, 0);
  twice.push_back(twice.front());
  EXPECT_NE(complaints(judged(twice)).find(rows_in_one_place.name), std::string::npos);
  std::vector<Row> half = channel(20, 4, 0);
  std::erase_if(half, [](const Row& r) { return r.y > 0.6; });
  EXPECT_NE(complaints(judged(half, {}, 0.05)), "");
}

TEST_F(Slabs, DoNotMoveAcrossTheirPlane) {
  std::vector<Row> rows = channel(20, 4, 0);
  for (Row& r : rows) r.v_z = 0.3 * r.v_x;
  const Judgement judgement = judged(rows);
  EXPECT_NEAR(value(judgement, velocity_across.name), 30, 1e-9);
  EXPECT_NE(complaints(judgement).find(velocity_across.name), std::string::npos);
  for (Row& r : rows) r.v_z = 0.02 * r.v_x;
  EXPECT_NE(complaints(judged(rows)).find(velocity_across.name), std::string::npos) << "more than the user's limit";
  EXPECT_TRUE(std::isnan(value(judged(channel()), velocity_across.name))) << "nothing is said where nothing moves";
}

TEST_F(Slabs, MayBeHalvesThatAreMirrored) {
  for (const int layers : {1, 4}) {
    std::vector<Row> lower = channel(20, layers, 0), wrong = channel(20, layers);
    for (std::vector<Row>* rows : {&lower, &wrong}) std::erase_if(*rows, [](const Row& r) { return r.y > 0.5; });
    const Mapping said{.axes = "xy", .symmetric = {"y=0.5"}};
    EXPECT_EQ(complaints(judged(lower, said)), "");
    EXPECT_EQ(judged(lower, said).record.runs[0].level, "20 across");
    EXPECT_NEAR(value(judged(wrong, said), l2), 4, 1e-9);
    EXPECT_NE(complaints(judged(lower, {.axes = "xy"}, 0.05)), "") << "half of the fluid is missing";
  }
  for (const std::string line : {"y", "y=", "z=1", "y=up", "0.5"})
    EXPECT_THROW(require_known_names({.symmetric = {line}}, "judge"), std::invalid_argument) << line;
}

}  // namespace slabs_test
}  // namespace touchstone::vnv::doors

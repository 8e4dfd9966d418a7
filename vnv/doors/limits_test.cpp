#include "solvers/lattice.hpp"
#include "vnv/doors/judge.hpp"
#include "vnv/files/whole_file.hpp"
#include "vnv/measures/centrelines.hpp"
#include "vnv/programs/scratch_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace touchstone::vnv::doors {
namespace limits_test {

bool says(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

class Limits : public testing::Test {
 protected:
  using RowOf = std::function<std::string(const Vec2&)>;
  std::filesystem::path table(const std::string& name, const std::string& headings, const Box& box, double spacing,
                              const RowOf& row) const {
    std::string text = headings + "\n";
    const Vectors places = lattice(box, spacing).places();
    for (const auto& x : places.colwise()) text += fmt::format("{},{},{}\n", x.x(), x.y(), row(x));
    files::write_whole(folder / name, text);
    return folder / name;
  }
  /// Vortices of 1 m/s in a fluid of 1 kg/m³ with `pressure` in place of the exact one.
  std::string complaints_of_vortices(const std::function<std::string(double exact, const Vec2& x)>& pressure) const {
    const Flow flow = flow_named("taylor_green", Settings({{"rho", 1}}));
    const FieldTruth v = flow.exact[0].with({}), p = flow.exact[1].with({});
    const auto row = [&](const Vec2& x) {
      const Vec2 velocity = v(x, 0.5);
      return fmt::format("{},{},{}", velocity.x(), velocity.y(), pressure(p(x, 0.5).x(), x));
    };
    return complaints(flow, {table("tgv.csv", "x,y,u,v,p", flow.filled, 1.0 / 24, row)}, 0.5, 1);
  }
  std::string complaints(const Flow& flow, const std::vector<std::filesystem::path>& files, double time,
                         std::optional<double> at_most) const {
    record = judge_files(flow, files, {.time = time}, {}, {.at_most = at_most}).record;
    std::string all;
    for (const Verdict& v : record.verdicts)
      if (v.outcome != Outcome::holds) all += v.sentence + "\n";
    return all;
  }
  const Flow channel = flow_named("poiseuille", Settings({{"H", 1}, {"L", 0.5}, {"nu", 0.01}, {"F", 0.01}}));
  const programs::ScratchFolder folder;
  mutable Record record;
};

TEST_F(Limits, HoldForAPressureToo) {
  EXPECT_EQ(complaints_of_vortices([](double exact, const Vec2&) { return fmt::format("{}", exact); }), "");
  EXPECT_TRUE(says(complaints_of_vortices([](double exact, const Vec2&) { return fmt::format("{}", -exact); }),
                   "L2 p - mean(p), per particle = 200 %"));
  const std::string not_a_number = complaints_of_vortices(
      [](double exact, const Vec2& x) { return x.x() < 0.1 && x.y() < 0.1 ? "nan" : fmt::format("{}", exact); });
  EXPECT_TRUE(says(not_a_number, "L2 p - mean(p), per particle = nan")) << not_a_number;
}

TEST_F(Limits, AreNotNeededToFailWhatIsNoNumber) {
  std::string text = "x,y,u,v,p\n";
  const Flow flow = flow_named("taylor_green");
  const auto row = [&](const Vec2& x) { return fmt::format("0,0,{}", x.x() < 0.1 ? NAN : 0.1); };
  EXPECT_TRUE(says(complaints(flow, {table("nan.csv", "x,y,u,v,p", flow.filled, 0.05, row)}, 0.5, {}),
                   "L2 p - mean(p), per particle = nan at 0.5 s"));
}

TEST_F(Limits, HoldForTheComponentAcrossAChannel) {
  const FieldTruth exact = channel.exact[0].with({});
  const auto file = [&](double across) {
    return table("across.csv", "x,y,vx,vy", channel.filled, 0.05, [&](const Vec2& x) {
      return fmt::format("{},{}", exact(x, 20).x(), across * 0.125 * std::sin(40 * x.y() + 7 * x.x()));
    });
  };
  EXPECT_EQ(complaints(channel, {file(0)}, 20, 1), "");
  EXPECT_TRUE(says(complaints(channel, {file(0.02)}, 20, 1), "L2 v_y over that of v_x, per particle"));
  EXPECT_TRUE(says(complaints(channel, {file(0.5)}, 20, {}), "nothing drives a flow across the plates"));
  for (const char* norm :
       {"L2 v_x, per particle", "Linf v_x, per particle", "L2 v_x, row means", "Linf v_x, row means"})
    EXPECT_EQ(std::ranges::count(record.values, std::string(norm), [](const Value& v) { return v.quantity.name; }), 1);
}

TEST_F(Limits, ApplyToAllErrorsThatAreMeasured) {
  const FieldTruth exact = channel.exact[0].with({});
  const auto wrong = table("wrong.csv", "x,y,vx,vy", channel.filled, 0.05,
                           [&](const Vec2& x) { return fmt::format("{},0", 1.04 * exact(x, 20).x()); });
  const std::string found = complaints(channel, {wrong}, 20, 1);
  for (const char* norm :
       {"L2 v_x, per particle", "Linf v_x, per particle", "L2 v_x, row means", "Linf v_x, row means"})
    EXPECT_TRUE(says(found, fmt::format("{} = 4 %", norm))) << norm;
  for (const Value& v : record.values)
    if (v.quantity.kind == Kind::norm) {
      EXPECT_TRUE(is_limited(v, record)) << v.quantity.name;
    }
  complaints(channel, {wrong}, 20, {});
  EXPECT_FALSE(is_limited(record.values.front(), record));
}

TEST_F(Limits, FailWhatIsWorseThanNothingWithoutAnOption) {
  const FieldTruth exact = channel.exact[0].with({});
  const auto with_first = [&](double factor) {
    return table("wild.csv", "x,y,vx,vy", channel.filled, 0.05, [&](const Vec2& x) {
      return fmt::format("{},0", (x.x() < 0.05 && x.y() < 0.05 ? factor * 0.125 : exact(x, 20).x()));
    });
  };
  EXPECT_FALSE(says(complaints(channel, {with_first(1)}, 20, {}), "% off"));
  const std::string found = complaints(channel, {with_first(10)}, 20, {});
  EXPECT_TRUE(says(found, "Linf v_x, per particle") && says(found, "a fluid at rest is 100 % off")) << found;
}

TEST_F(Limits, HoldForTheLargestSpeedInACavity) {
  const Flow flow = flow_named("cavity");
  const auto speed = [&](double corner) {
    const auto file = table("fast.csv", "x,y,u,v", flow.filled, 0.05, [&](const Vec2& x) {
      return fmt::format("0.1,{}", x.x() < 0.05 && x.y() < 0.05 ? corner : 0.0);
    });
    return complaints(flow, {file}, 50, {});
  };
  EXPECT_FALSE(says(speed(1.5), "largest speed"));
  EXPECT_TRUE(says(speed(3), "largest speed over that of the lid = 3."));
}

TEST_F(Limits, AreNotToldOfAFieldOfWhichNothingIsMeasured) {
  const auto file = table("p.csv", "x,y,vx,vy,p", channel.filled, 0.05, [](const Vec2&) { return "0,0,7"; });
  const Judgement judgement = judge_files(channel, {file}, {.time = 20});
  EXPECT_EQ(std::ranges::count(judgement.not_judged, "pressure: nothing of it is measured in this flow"), 1);
  EXPECT_TRUE(std::ranges::none_of(judgement.not_judged,
                                   [](const std::string& line) { return line.starts_with("velocity: nothing"); }));
}

TEST_F(Limits, ThatApplyToNothingFail) {
  const Flow flow = flow_named("cavity");
  const auto file = table("early.csv", "x,y,u,v", flow.filled, 0.05, [](const Vec2&) { return "0,0"; });
  EXPECT_TRUE(says(complaints(flow, {file}, 1, 2), "the limit of 2 % applies to nothing: no error was measured"));
}

TEST_F(Limits, OfASteadyFlowAreJudgedAtOneLateTime) {
  const Flow flow = flow_named("cavity");
  const auto file = table("steady.csv", "x,y,u,v", flow.filled, 0.05, [](const Vec2&) { return "0.1,0"; });
  const std::string found = complaints(flow, {file}, 50, 2);
  EXPECT_TRUE(says(found, "L2 v_x, vertical centreline") && says(found, "at 50 s")) << found;
  EXPECT_FALSE(says(found, "nan")) << found;
}

TEST_F(Limits, AreKeptByErrorsAtRoundingWhichHaveNoOrder) {
  const FieldTruth exact = channel.exact[0].with({});
  std::vector<std::filesystem::path> files;
  for (const int across : {10, 20, 40})
    files.push_back(table(fmt::format("exact_{}.csv", across), "x,y,vx,vy", channel.filled, 1.0 / across,
                          [&](const Vec2& x) { return fmt::format("{},0", exact(x, 1e4).x()); }));
  EXPECT_EQ(complaints(channel, files, 1e4, 1), "");
  EXPECT_TRUE(record.orders.empty() || record.orders.front().quantity != "L2 v_x, per particle [%]");
}

TEST_F(Limits, AreOfALongerChannelWhereItsRowsSpanThat) {
  const Flow shorter = flow_named("poiseuille", Settings({{"H", 1}, {"L", 0.1}, {"nu", 0.01}, {"F", 0.01}}));
  const FieldTruth exact = channel.exact[0].with({});
  const auto file = table("long.csv", "x,y,vx,vy", channel.filled, 0.05,
                          [&](const Vec2& x) { return fmt::format("{},0", exact(x, 20).x()); });
  const Judgement judgement = judge_files(shorter, {file}, {.time = 20}, {}, {.at_most = 1});
  EXPECT_EQ(judgement.record.runs.at(0).level, "20 across");
  EXPECT_TRUE(std::ranges::any_of(judgement.words, [](const std::string& line) {
    return says(line, "the rows span 0.5 m along x, L is 0.1 m: --set L=0.5?");
  }));
  const Flow vortices = flow_named("taylor_green", Settings({{"L", 0.4}}));
  const auto square = table("square.csv", "x,y,u,v", {.high = {1, 1}}, 0.05, [](const Vec2&) { return "0,0"; });
  EXPECT_THROW(judge_files(vortices, {square}, {.time = 1}), LongerThanPeriod);
}

TEST_F(Limits, LetParticlesMoveOnBeyondAPeriod) {
  const FieldTruth exact = channel.exact[0].with({});
  std::string text = "x,y,vx,vy\n";
  const Vectors places = lattice(channel.filled, 0.05).places();
  for (const auto& x : places.colwise())
    text += fmt::format("{},{},{},0\n", x.x() + 20 * exact(x, 20).x(), x.y(), exact(x, 20).x());
  files::write_whole(folder / "moved.csv", text);
  EXPECT_EQ(complaints(channel, {folder / "moved.csv"}, 20, 1), "");
}

}  // namespace limits_test
}  // namespace touchstone::vnv::doors

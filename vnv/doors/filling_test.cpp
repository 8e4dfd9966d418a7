#include "vnv/doors/filling.hpp"
#include "vnv/doors/right_data.hpp"

#include "vnv/files/whole_file.hpp"
#include "vnv/flows/channels/driven_channel.hpp"
#include "vnv/measures/coverage.hpp"
#include "vnv/programs/scratch_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

namespace touchstone::vnv::doors {
namespace filling_test {

const std::map<std::string, double> channel{{"H", 1}, {"L", 0.5}, {"nu", 0.01}, {"F", 0.01}};

Samples those(const Samples& s, const std::function<bool(Eigen::Index)>& are_kept) {
  std::vector<Eigen::Index> kept;
  for (Eigen::Index p = 0; p < s.size(); ++p)
    if (are_kept(p)) kept.push_back(p);
  return {s.time, s.x(Eigen::all, kept), s.v(Eigen::all, kept), s.mass(kept), s.density(kept), s.pressure(kept)};
}

/// As files in which rows have no volumes would be judged, with a limit that their errors keep.
Record judged(const Flow& flow, std::vector<Samples> all, double spacing = not_a_number, bool has_volumes = false) {
  Given given;
  given.fields = {"particles", "velocity", velocity_along_x, "pressure"};
  GivenLevel level{.spacing = spacing, .spacing_is_said = !std::isnan(spacing), .has_volumes = has_volumes};
  if (std::isnan(spacing)) level.spacing = std::sqrt(flow.filled_area() / static_cast<double>(all.front().size()));
  for (Samples& samples : all) level.at.emplace(samples.time, std::move(samples));
  given.levels.push_back(std::move(level));
  return judge_given(flow, std::move(given), {.at_most = 1}).record;
}

/// The quantities of the verdicts that do not hold, and where.
std::string complaints_of(const Record& record) {
  std::string all;
  for (const Verdict& v : record.verdicts)
    if (v.outcome != Outcome::holds) all += v.sentence.substr(v.sentence.find(": ") + 2) + "\n";
  return all;
}
bool says(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

TEST(Filling, IsFoundWhereAllTheFluidIsThere) {
  for (const std::string name : {"poiseuille", "couette", "taylor_green", "hydrostatic", "elliptic_drop"}) {
    const Flow flow = flow_named(name);
    const double time = name == "elliptic_drop" ? 0 : flow.judged.times.front();
    for (const double across : {8.0, 20.0, 41.0, 60.0})
      for (const double spacing : {not_a_number, flow.across / across}) {
        const std::string found = complaints_of(judged(flow, {right_of(flow, across, time)}, spacing));
        EXPECT_EQ(found, "") << name << ", " << across << " across";
      }
  }
}

TEST(Filling, MayBeOfNodesOfGradedGridsOrOfADisorderedCloud) {
  const Flow flow = flow_named("poiseuille", Settings(channel));
  Samples nodes = right_of(flow, 20, 20);
  const FieldTruth truth = flow.exact[0].with({});
  const auto with_velocity = [&](Samples s) {
    for (Eigen::Index p = 0; p < s.size(); ++p) s.v.col(p) = truth(s.x.col(p), s.time);
    return s;
  };
  const auto of_grid = [&](int columns, int lines, const std::function<double(double)>& stretched) {
    Samples s = nodes;
    s.x.resize(2, (columns + 1) * (lines + 1));
    for (int i = 0; i <= columns; ++i)
      for (int j = 0; j <= lines; ++j)
        s.x.col(i * (lines + 1) + j) = Vec2(0.5 * i / columns, stretched(1.0 * j / lines));
    for (double& x : s.x.row(0).reshaped()) x = flow.domain.wrapped(0, x);  // both ends, as readers leave them
    s.v = Vectors::Zero(2, s.x.cols());
    s.pressure = Scalars::Zero(s.size());
    s.density = s.mass = Scalars::Constant(s.size(), 1000);
    return with_velocity(s);
  };
  EXPECT_EQ(complaints_of(judged(flow, {of_grid(10, 20, [](double y) { return y; })}, 0.05)), "");
  EXPECT_EQ(
      complaints_of(judged(flow, {of_grid(4, 60, [](double y) { return (1 - std::cos(std::numbers::pi * y)) / 2; })})),
      "");
  const Samples lines = of_grid(10, 20, [](double y) { return y; });
  EXPECT_EQ(complaints_of(judged(
                flow, {those(lines, [&](Eigen::Index p) { return lines.x(1, p) > 0 && lines.x(1, p) < 1; })}, 0.05)),
            "")
      << "without nodes on the plates";
  std::mt19937 draw(7);
  std::uniform_real_distribution<double> any(-0.025, 0.025);
  Samples cloud = right_of(flow, 20, 20);
  for (Eigen::Index p = 0; p < cloud.size(); ++p)
    cloud.x.col(p) =
        Vec2(flow.domain.wrapped(0, cloud.x(0, p) + any(draw)), std::clamp(cloud.x(1, p) + any(draw), 0.0, 1.0));
  EXPECT_EQ(complaints_of(judged(flow, {with_velocity(cloud)}, 0.05)), "");
}

TEST(Filling, FailsWithoutAPartOfTheFluidAtAResolutionThatIsSaidOrNot) {
  const Flow flow = flow_named("poiseuille", Settings(channel));
  const Samples all = right_of(flow, 20, 20);
  std::mt19937 draw(7);
  std::vector<bool> is_in_tenth(static_cast<std::size_t>(all.size()), false);
  for (std::size_t k = 0; k < 20; ++k) is_in_tenth[10 * k + draw() % 10] = true;
  const auto y_above = [&](double y) { return [&all, y](Eigen::Index p) { return all.x(1, p) > y; }; };
  const auto outside = [&](Vec2 centre, double radius) {
    return [=, &all](Eigen::Index p) { return (all.x.col(p) - centre).norm() > radius; };
  };
  const std::vector<std::tuple<std::string, std::function<bool(Eigen::Index)>, std::string>> parts{
      {"45 % were excluded", y_above(0.45), "largest hole"},
      {"a void in the core", [&](Eigen::Index p) { return std::abs(all.x(1, p) - 0.5) > 0.2; }, "largest hole"},
      {"a hole 4 spacings wide", outside({0.25, 0.5}, 0.1), "empty places of the grid"},
      {"a tenth at random", [&](Eigen::Index p) { return !is_in_tenth[static_cast<std::size_t>(p)]; },
       "empty places of the grid"},
      {"one row", [](Eigen::Index p) { return p != 77; }, "empty places of the grid = 1"},
  };
  for (const auto& [what, are_kept, quantity] : parts) {
    const std::string found = complaints_of(judged(flow, {those(all, are_kept)}));
    EXPECT_TRUE(says(found, quantity) && says(found, "; at (")) << what << ": " << found;
    if (what != "one row") {
      EXPECT_TRUE(
          says(complaints_of(judged(flow, {those(all, are_kept)}, 0.05)), "200 in the scene at this resolution"))
          << what;
    }
    const std::string heavy = complaints_of(judged(flow, {those(all, are_kept)}, not_a_number, true));
    EXPECT_TRUE(says(heavy, quantity)) << what << ", with volumes: " << heavy;
  }
}

TEST(Filling, LetsTheFlowItselfDrawParticlesApartAndFindsWhatIsMissingAmongThem) {
  const Flow flow = flow_named("manufactured");
  const double across = 50, end = flow.judged.times.back();
  Samples moved = right_of(flow, across, 0);
  const FieldTruth velocity = flow.exact.front().with({});
  constexpr int steps = 200;
  for (int k = 0; k < steps; ++k)
    for (Eigen::Index p = 0; p < moved.x.cols(); ++p) {
      const Vec2 x = moved.x.col(p);
      const double dt = end / steps, t = k * dt;
      moved.x.col(p) += dt * velocity(x + dt / 2 * velocity(x, t), t + dt / 2);
    }
  for (double& x : moved.x.reshaped()) x -= std::floor(x);
  moved.time = end;
  for (Eigen::Index p = 0; p < moved.x.cols(); ++p) moved.v.col(p) = velocity(moved.x.col(p), end);
  EXPECT_FALSE(says(complaints_of(judged(flow, {moved})), "largest hole"));
  const Samples holed =
      those(moved, [&](Eigen::Index p) { return (moved.x.col(p) - Vec2(0.5, 0.5)).norm() > 3.5 / across; });
  EXPECT_TRUE(says(complaints_of(judged(flow, {holed})), "largest hole"));
}

TEST(Filling, FailsOfADisorderedCloudWithAHoleFourSpacingsWideAndSaysWhere) {
  const Flow flow = flow_named("taylor_green");
  std::mt19937 draw(3);
  std::uniform_real_distribution<double> any(-0.25, 0.25);
  for (const double across : {10.0, 40.0, 100.0}) {
    Samples cloud = right_of(flow, across, 0.1);
    for (double& x : cloud.x.reshaped()) x += any(draw) / across;
    for (double& x : cloud.x.reshaped()) x -= std::floor(x);
    const Vec2 centre(0.503, 0.497);
    const Coverage found =
        coverage_of(those(cloud, [&](Eigen::Index p) { return (cloud.x.col(p) - centre).norm() > 2 / across; }).x,
                    1 / across, {flow.domain});
    EXPECT_GE(found.hole, 4);
    EXPECT_GT(found.hole, largest_sound_hole(across * across - 13));
    EXPECT_NEAR((found.hole_at - centre).norm(), 0, 0.5 / across);
    EXPECT_LT(coverage_of(cloud.x, 1 / across, {flow.domain}).hole, 2);
  }
}

TEST(Filling, FailsWithRowsInOnePlaceCrowdedOrAlone) {
  const Flow flow = flow_named("taylor_green");
  const Samples all = right_of(flow, 20, 0.1);
  const auto with_places = [&](const Vectors& x) {
    Samples s = all;
    s.x = x;
    s.v = Vectors::Zero(2, x.cols());
    s.pressure = Scalars::Zero(x.cols());
    s.density = s.mass = Scalars::Constant(x.cols(), 1000);
    return s;
  };
  Vectors twice(2, 2 * all.size()), one_twice(2, all.size() + 1), pairs = all.x, alone(2, 1), corners(2, 200);
  twice << all.x, all.x;
  one_twice << all.x, all.x.col(7);
  for (Eigen::Index p = 1; p < pairs.cols(); p += 2) pairs.col(p) = pairs.col(p - 1) + Vec2(0.004, 0.003);
  alone << 0.3, 0.4;
  for (Eigen::Index p = 0; p < 200; ++p)
    corners.col(p) = 0.1 * all.x.col(2 * p) + (p % 2 == 0 ? Vec2(0, 0) : Vec2(0.9, 0.9));
  EXPECT_TRUE(says(complaints_of(judged(flow, {with_places(twice)})), "rows in the place of another = 400"));
  EXPECT_TRUE(says(complaints_of(judged(flow, {with_places(one_twice)})), "rows in the place of another = 1 "));
  EXPECT_TRUE(says(complaints_of(judged(flow, {with_places(pairs)})), "rows crowded = 100 %"));
  EXPECT_TRUE(says(complaints_of(judged(flow, {with_places(alone)})), "rows = 1 "));
  EXPECT_TRUE(says(complaints_of(judged(flow, {with_places(corners)})), "largest hole"));
}

TEST(Filling, OfARunIsThatOfItsFirstTime) {
  const Flow flow = flow_named("poiseuille", Settings(channel));
  const Samples first = right_of(flow, 20, 5), last = right_of(flow, 20, 20);
  const auto without_ninth = those(last, [](Eigen::Index p) { return p % 11 != 5; });
  EXPECT_EQ(complaints_of(judged(flow, {first, last})), "");
  EXPECT_TRUE(says(complaints_of(judged(flow, {first, without_ninth})), "rows = 182 at 20 s, expected in [200, 200]"));
  std::string text = "t,x,y,vx,vy\n", of_last = "x,y,vx,vy\n", of_first = of_last;
  for (const Samples* s : {&first, &without_ninth})
    for (Eigen::Index p = 0; p < s->size(); ++p) {
      const std::string row = fmt::format("{},{},{},0\n", s->x(0, p), s->x(1, p), s->v(0, p));
      text += fmt::format("{},{}", s->time, row);
      (s == &first ? of_first : of_last) += row;
    }
  const programs::ScratchFolder folder;
  files::write_whole(folder / "run.csv", text);
  const Record in_one = judge_files(flow, {folder / "run.csv"}, {}, {}, {.at_most = 1}).record;
  ASSERT_EQ(in_one.runs.size(), 1u) << "not another resolution";
  EXPECT_EQ(in_one.runs[0].level, "20 across");
  EXPECT_TRUE(says(complaints_of(in_one), "rows = 182 at 20 s"));
}

TEST(Filling, OfWaterAtRestEndsAtItsSurface) {
  const Flow flow = flow_named("hydrostatic");
  const Samples all = right_of(flow, 40, 2);
  const auto lower = those(all, [&](Eigen::Index p) { return all.x(1, p) < 0.7; });
  EXPECT_TRUE(says(complaints_of(judged(flow, {lower})), "largest hole"));
  const auto holed = those(all, [&](Eigen::Index p) { return (all.x.col(p) - Vec2(0.25, 0.5)).norm() > 0.05; });
  EXPECT_TRUE(says(complaints_of(judged(flow, {holed})), "empty places of the grid"));
}

TEST(Filling, SaysWhereNothingTellsHowManyRowsThereShouldBe) {
  const Flow flow = flow_named("taylor_green");
  Samples cloud = right_of(flow, 20, 0.1, 0.25), grid = right_of(flow, 20, 0.1);
  cloud = those(cloud, [](Eigen::Index p) { return p % 10 != 3; });
  const auto judge = [&](const Samples& s, bool is_said, bool has_volumes) {
    Given given{.fields = std::vector<std::string>{"particles", "velocity", velocity_along_x, "pressure"}};
    given.levels.push_back({.spacing = 0.05, .spacing_is_said = is_said, .has_volumes = has_volumes});
    given.levels[0].at.emplace(0.1, s);
    return judge_given(flow, std::move(given), {.at_most = 1});
  };
  const auto is_told = [](const Judgement& judgement) {
    return std::ranges::any_of(judgement.not_judged,
                               [](const std::string& line) { return says(line, "how many rows there should be"); });
  };
  EXPECT_TRUE(is_told(judge(cloud, false, false)));
  EXPECT_FALSE(is_told(judge(grid, false, false))) << "a grid shows its empty places";
  for (const bool is_said : {false, true}) {
    const Judgement judgement = judge(cloud, is_said, !is_said);
    EXPECT_FALSE(is_told(judgement));
    EXPECT_NE(complaints_of(judgement.record), "");
  }
}

TEST(Filling, OfMassesIsThatOfTheSceneOrOfADepth) {
  const Flow flow = flow_named("taylor_green");
  Samples s = right_of(flow, 20, 0.1);
  s.mass = Scalars::Constant(s.size(), flow.fluid.density / 400);
  EXPECT_EQ(complaints_of(judged(flow, {s}, not_a_number, true)), "");
  s.mass *= 0.96;
  EXPECT_TRUE(says(complaints_of(judged(flow, {s}, not_a_number, true)), "mass, less that of the scene = -4 %"));
  s.mass *= 0.01;
  EXPECT_EQ(complaints_of(judged(flow, {s}, not_a_number, true)), "") << "of a layer 1 cm deep";
  Samples later = s;
  later.time = 0.2;
  later.mass *= 0.96;
  EXPECT_TRUE(
      says(complaints_of(judged(flow, {s, later}, not_a_number, true)), "mass, less that at the first time = -4 %"));
}

TEST(Filling, OfMassesHasRoomForNodesOnWallsAndRowsThatStandOffThem) {
  const Flow flow = flow_named("poiseuille", Settings(channel));
  for (const int across : {16, 25, 60})
    for (const int lines : {across + 1, across - 1}) {
      const double spacing = flow.across / across, first = lines > across ? 0 : spacing;
      const auto columns = static_cast<int>(std::lround(0.5 * across));
      Vectors x(2, columns * lines);
      for (int k = 0; k < x.cols(); ++k)
        x.col(k) = Vec2((k % columns + 0.5) * 0.5 / columns, first + spacing * (k / columns));
      Samples all = right_of(flow, across, flow.judged.times.front());
      all.x = x, all.v = Vectors::Zero(2, x.cols());
      const auto exact = flow.exact[0].with({});
      for (Eigen::Index p = 0; p < x.cols(); ++p) all.v.col(p) = exact(x.col(p), all.time);
      all.pressure = Scalars::Zero(x.cols());
      all.density = Scalars::Constant(x.cols(), flow.fluid.density);
      all.mass = all.density * (spacing * 0.5 / columns);
      EXPECT_EQ(complaints_of(judged(flow, {all}, not_a_number, true)), "") << across << ", " << lines << " lines";
      all.mass *= 0.85;
      EXPECT_NE(complaints_of(judged(flow, {all}, not_a_number, true)), "") << across << ", " << lines << " lines";
    }
}

TEST(Filling, OfAVelocityThatIsNoNumberAnywhereFails) {
  for (const std::string name : {"cavity", "dam_break", "poiseuille"}) {
    const Flow flow = flow_named(name);
    Samples s = right_of(flow, 20, flow.judged.times.back());
    s.v(1, s.size() / 2) = NAN;
    EXPECT_TRUE(says(complaints_of(judged(flow, {s})), "rows whose velocity is no number = 1")) << name;
  }
}

}  // namespace filling_test
}  // namespace touchstone::vnv::doors

#include "reference/poiseuille.hpp"
#include "solvers/lattice.hpp"
#include "vnv/doors/filling.hpp"
#include "vnv/doors/judge.hpp"
#include "vnv/doors/scene.hpp"
#include "vnv/files/tables.hpp"
#include "vnv/files/whole_file.hpp"
#include "vnv/flows/dam_break.hpp"
#include "vnv/flows/channels/driven_channel.hpp"
#include "vnv/flows/drop.hpp"
#include "vnv/flows/gravity_wave.hpp"
#include "vnv/flows/lid_driven.hpp"
#include "vnv/flows/patch.hpp"
#include "vnv/flows/water_at_rest.hpp"
#include "vnv/measures/steadiness.hpp"
#include "vnv/programs/scratch_folder.hpp"
#include "vnv/record/same_time.hpp"
#include "vnv/run/vtp_series.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <random>
#include <regex>
#include <set>

namespace touchstone::vnv::doors {
namespace {

class Doors : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    files::write_whole(folder.path() / name, text);
    return folder.path() / name;
  }
  /// The exact flow at 1 s on a lattice with so many particles across, `error` times too fast, in another unit of
  /// length.
  std::filesystem::path poiseuille(int across, double error = 0, double unit = 1, const std::string& name = "m") const {
    const Box gap{.high = {0.5e-3, 1e-3}};
    std::string text = fmt::format("x [{0}],y [{0}],v_x,v_y\n", name);
    const Vectors places = lattice(gap, 1e-3 / across).places();
    for (const auto& x : places.colwise())
      text += fmt::format("{},{},{},0\n", x.x() / unit, x.y() / unit, (1 + error) * exact(x.y(), 1));
    return write(fmt::format("poiseuille_{}.csv", across), text);
  }
  Judgement judged(const std::string& flow, const std::vector<std::filesystem::path>& files,
                   Mapping mapping = {}) const {
    if (!mapping.time) mapping.time = 1;
    return judge_files(flow_named(flow), files, mapping);
  }
  /// The particles at the start of a flow with `across` of them across, changed, at a time.
  using Change = std::function<void(Samples&)>;
  std::filesystem::path changed(const Flow& flow, double time, const Change& change, int across = 20) const {
    const Lattice regular = lattice(flow.filled, flow.across / across);
    Samples s{.time = time, .x = flow.start.places_on(regular.places())};
    s.v = s.x;
    s.pressure = s.density = s.mass = Scalars::Zero(s.size());
    for (Eigen::Index p = 0; p < s.size(); ++p) {
      s.v.col(p) = flow.start.velocity_at(s.x.col(p));
      s.pressure[p] = flow.start.pressure_at(s.x.col(p));
      s.density[p] = flow.fluid.density_at(s.pressure[p]);
      s.mass[p] = flow.fluid.density * regular.volume();
    }
    change(s);
    const std::filesystem::path file = folder.path() / fmt::format("{}_{}_{:g}.vtp", flow.name, across, time);
    write_vtp(file, s);
    return file;
  }
  /// One quantity of a judgement; not a number where it was not measured.
  static double value_of(const Judgement& judgement, const Quantity& quantity) {
    const auto found = std::ranges::find(judgement.record.values, quantity, &Value::quantity);
    return found == judgement.record.values.end() ? not_a_number : found->value;
  }
  static Outcome outcome_of(const Judgement& judgement, const Quantity& quantity) {
    const auto found = std::ranges::find(judgement.record.verdicts, quantity.name, &Verdict::quantity);
    return found == judgement.record.verdicts.end() ? Outcome::inconclusive : found->outcome;
  }

  std::string refusal(const std::string& flow, const std::filesystem::path& file, const Mapping& mapping = {}) const {
    try {
      judged(flow, {file}, mapping);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "judged without complaint";
  }

  const programs::ScratchFolder folder;
  const reference::Poiseuille exact{.H = 1e-3, .F = 8e-3, .nu = 1e-6};
};

/// A flow as it is, and with each parameter larger by another factor, so that no two that are equal stay so.
std::vector<Flow> as_published_and_not(const std::string& name) {
  std::map<std::string, double> others;
  double factor = 1.1;
  const Flow published = flow_named(name);
  for (const Parameter& p : published.parameters) others[p.name] = p.value * (factor += 0.05);
  if (name == "cavity") others["Re"] = 400;  // one that is tabulated
  return {published, flow_named(name, Settings(others))};
}

bool says(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

TEST_F(Doors, FindTheErrorThatWasPutIn) {
  const Record record = judged("poiseuille", {poiseuille(20, 0.03)}).record;
  const auto is_norm = [](const Value& value) { return value.quantity.kind == Kind::norm; };
  EXPECT_EQ(std::ranges::count_if(record.values, is_norm), 4) << "L2 and Linf, per particle and of row means";
  for (const Value& value : record.values)
    if (is_norm(value)) {
      EXPECT_NEAR(value.value, 3, 1e-9) << value.quantity.name;
    }
  for (const Verdict& v : record.verdicts)
    EXPECT_EQ(v.outcome, v.quantity == anything_claimed ? Outcome::fails : Outcome::holds) << v.sentence;
  EXPECT_TRUE(says(record.verdicts.back().sentence, "poiseuille.files: nothing was claimed of its errors: three"));
}

TEST_F(Doors, CallTheNearestSampleAloneByTheTimeThatWasAskedFor) {
  std::vector<std::filesystem::path> files;
  const Flow flow = flow_named("shear_wave");  // at 1 s
  for (const double time : {0.992, 0.996, 1.003})
    for (const int across : {10, 20})
      files.push_back(changed(
          flow, time, [](Samples&) {}, across));
  std::set<double> times;
  for (const Value& value : judge_files(flow, files).record.values) times.insert(value.time);
  EXPECT_EQ(times, std::set<double>({0.992, 0.996, 1.0}));
}

TEST_F(Doors, SayOfWhatFailsWhatIsWrongAndKeepItInTheRecord) {
  const Judged limited{.at_most = 1};
  Mapping at_end;
  at_end.time = 1;
  const Record record = judge_files(flow_named("poiseuille"), {poiseuille(20, 0.03)}, at_end, {}, limited).record;
  ASSERT_FALSE(record.verdicts.empty());
  for (const Verdict& v : record.verdicts) {
    if (v.outcome == Outcome::holds) continue;  // that the fluid is there, and does not cross the channel
    EXPECT_TRUE(says(v.sentence, "FAILS; ") && says(v.sentence, "% too large")) << v.sentence;
    EXPECT_TRUE(says(v.sentence, "; or, indistinguishable by these data: ")) << v.sentence;
    EXPECT_EQ(diagnosis_of(v, record), record.diagnoses.data()) << v.quantity;
  }
  ASSERT_EQ(record.diagnoses.size(), 1u);
  EXPECT_EQ(record.diagnoses[0].level, "20 across");
  EXPECT_NEAR(record.diagnoses[0].error, 3, 1e-9);
  EXPECT_EQ(record_in(as_json(record), "as written").diagnoses, record.diagnoses);
  auto json = nlohmann::ordered_json::parse(as_json(record));
  json.erase("diagnoses");
  EXPECT_TRUE(record_in(json.dump(), "written before").diagnoses.empty());
  EXPECT_TRUE(
      judge_files(flow_named("poiseuille"), {poiseuille(20, 0.003)}, at_end, {}, limited).record.diagnoses.empty());
  EXPECT_EQ(judge_files(flow_named("poiseuille"), {poiseuille(20, 0.003)}, at_end, {}, {.at_most = 1, .diagnose = true})
                .record.diagnoses.size(),
            1u);
}

TEST_F(Doors, ObserveTheOrderOverThreeResolutions) {
  const Record record =
      judged("poiseuille", {poiseuille(10, 0.04), poiseuille(40, 0.0025), poiseuille(20, 0.01)}).record;
  ASSERT_EQ(record.orders.size(), 4u);
  for (const ObservedOrder& order : record.orders) EXPECT_NEAR(order.order, 2, 1e-9);
  const auto of_order = std::ranges::count_if(record.verdicts, [](const Verdict& v) {
    return v.quantity.starts_with("order of") && v.outcome == Outcome::holds;
  });
  EXPECT_EQ(of_order, 1);
}

TEST_F(Doors, DiagnoseOfAnOrderThatFailsTheFinestLevelAlone) {
  const Record record = judged("poiseuille", {poiseuille(40, 0.05), poiseuille(10, 0.02), poiseuille(20, 0.03)}).record;
  ASSERT_EQ(record.diagnoses.size(), 1u);
  EXPECT_EQ(record.diagnoses[0].level, "40 across");
  EXPECT_NEAR(record.diagnoses[0].error, 5, 1e-6);
}

TEST_F(Doors, ReadOtherUnitsFromHeadingsOrAsTheUserSays) {
  const double in_mm = judged("poiseuille", {poiseuille(20, 0.03, 1e-3, "mm")}).record.values[0].value;
  EXPECT_NEAR(in_mm, 3, 1e-9);
  Mapping mapping;
  mapping.units = {{"length", "um"}};
  EXPECT_NEAR(judged("poiseuille", {poiseuille(20, 0.03, 1e-6, "any")}, mapping).record.values[0].value, 3, 1e-9);
  EXPECT_TRUE(says(refusal("poiseuille", poiseuille(20, 0, 1e-3, "m")), "they fit with --unit length=mm"));
}

TEST_F(Doors, OfferWhatMakesAllOfItFit) {
  struct Written {
    double unit;  // m
    bool swapped;
    Vec2 origin;  // m, as written
    std::string hint;
    Mapping mapping;
  };
  const std::vector<Written> all{
      {1, true, {0, 0}, "they fit with --axes yx", {.axes = "yx"}},
      {1e-3, true, {0, 0}, "they fit with --unit length=mm --axes yx", {.units = {{"length", "mm"}}, .axes = "yx"}},
      {1, false, {0, -5e-4}, "they fit with --origin 0 -0.0005", {.origin = {0, -5e-4}}},
      {1, true, {2e-3, 0}, "they fit with --axes yx --origin 0 0.002", {.axes = "yx", .origin = {0, 2e-3}}},
      {1e-2,
       false,
       {0, 1},
       "they fit with --unit length=cm --origin 0 1",
       {.units = {{"length", "cm"}}, .origin = {0, 1}}},
  };
  for (const Written& one : all) {
    std::string text = "x,y,v_x,v_y\n";
    const Vectors places = lattice({.high = {0.5e-3, 1e-3}}, 5e-5).places();
    for (const auto& x : places.colwise()) {
      const Vec2 row = ((one.swapped ? x.reverse().eval() : Vec2(x)) + one.origin) / one.unit;
      const double v = exact(x.y(), 1);
      text += fmt::format("{},{},{},{}\n", row.x(), row.y(), one.swapped ? 0 : v, one.swapped ? v : 0);
    }
    const std::filesystem::path file = write("elsewhere.csv", text);
    const std::string line = refusal("poiseuille", file);
    EXPECT_TRUE(line.ends_with(one.hint)) << line;
    EXPECT_LT(judged("poiseuille", {file}, one.mapping).record.values[0].value, 1e-9) << one.hint;
  }
}

TEST_F(Doors, ReadUnitsInRoundBracketsAndOfTimes) {
  std::string text = "x (mm),y (mm),v_x (mm/s),v_y (mm/s),time (min)\n";
  const Vectors places = lattice({.high = {0.5e-3, 1e-3}}, 5e-5).places();
  for (const auto& x : places.colwise())
    text += fmt::format("{},{},{},0,{}\n", 1e3 * x.x(), 1e3 * x.y(), 1e3 * exact(x.y(), 0.6), 0.01);
  const Judgement judgement = judge_files(flow_named("poiseuille"), {write("brackets.csv", text)});
  EXPECT_LT(judgement.record.values.at(0).value, 1e-8);
  EXPECT_EQ(judgement.record.values.at(0).time, 0.6);
}

TEST_F(Doors, TellInWhichUnitTheirTimesFit) {
  for (const auto& [unit, seconds] : {std::pair("ms", 1e-3), {"min", 60.0}}) {
    std::string text = "x,y,v_x,v_y,time\n";
    const Vectors places = lattice({.high = {0.5e-3, 1e-3}}, 5e-5).places();
    for (const double t : {0.1, 0.2, 0.3})
      for (const auto& x : places.colwise())
        text += fmt::format("{},{},{},0,{}\n", x.x(), x.y(), exact(x.y(), t), t / seconds);
    const std::filesystem::path file = write("times.csv", text);
    const Judgement judgement = judge_files(flow_named("poiseuille"), {file});
    EXPECT_EQ(judgement.words.back(), fmt::format("times in {0}? Velocities fit with --unit time={0}", unit));
    const Judgement right = judge_files(flow_named("poiseuille"), {file}, {.units = {{"time", unit}}});
    EXPECT_LT(right.record.values.at(0).value, 1e-7);
    EXPECT_TRUE(std::ranges::none_of(right.words, [](const std::string& line) { return says(line, "times in"); }));
  }
}

TEST_F(Doors, OfferForWaterWhatPutsItWhereTheFluidIs) {
  const Flow water = flow_named("hydrostatic");
  const auto lower = [](Samples& s) { s.x.row(1).array() -= 1; };
  const std::filesystem::path file = changed(water, 2, lower);
  EXPECT_TRUE(says(refusal("hydrostatic", file), "they fit with --origin 0 -1")) << refusal("hydrostatic", file);
  EXPECT_LT(value_of(judged("hydrostatic", {file}, {.origin = {0, -1}}), water_at_rest::l2_p), 1e-6);
  const Flow dam = flow_named("dam_break");
  const auto mirrored = [](Samples& s) { s.x.row(0) = 1.61 - s.x.row(0).array(); };
  EXPECT_TRUE(refusal("dam_break", changed(dam, 0, mirrored)).ends_with("; they fit with --axes=-xy --origin 1.61 0"));
  EXPECT_EQ(refusal("dam_break", changed(dam, 0, mirrored), {.axes = "-xy", .origin = {1.61, 0}}),
            "judged without complaint");
}

TEST_F(Doors, TellWhereRowsBesideAPeriodicBoxFit) {
  const Flow wave = flow_named("shear_wave");
  const auto moved = [](Samples& s) { s.x.colwise() += Vec2(0.7, 0.4); };
  const auto hints = [](const Judgement& judgement) {
    return std::ranges::count_if(judgement.words, [](const std::string& line) {
      return line.ends_with("lie beside it: they fit with --origin 0.7 0.4");
    });
  };
  Mapping at_start{.time = 0};
  EXPECT_EQ(hints(judged("shear_wave", {changed(wave, 0, moved)}, at_start)), 1);
  at_start.origin = {0.7, 0.4};
  EXPECT_EQ(hints(judged("shear_wave", {changed(wave, 0, moved)}, at_start)), 0);
  const auto by_periods = [&](Samples& s) { s.x.array() += 3 * wave.across; };
  EXPECT_EQ(judged("shear_wave", {changed(wave, 0, by_periods)}, {.time = 0}).words,
            judged("shear_wave", {changed(wave, 0, [](Samples&) {})}, {.time = 0}).words);
}

TEST_F(Doors, OfferNoUnitInWhichTheyDoNotFit) {
  const std::string line = refusal("poiseuille", poiseuille(20, 0, 2.54e-5, "m"));  // thousandths of an inch
  EXPECT_FALSE(says(line, "they fit with")) << line;
  EXPECT_FALSE(says(line, "--unit")) << line;
}

TEST_F(Doors, TellTheLengthThatRowsOfAGridSpanInPlaceOfThePeriod) {
  for (const double length : {0.4e-3, 0.6e-3, 0.75e-3}) {
    std::string text = "x,y,v_x,v_y\n";
    const Vectors places = lattice({.high = {length, 1e-3}}, 5e-5).places();
    for (const auto& x : places.colwise()) text += fmt::format("{},{},{},0\n", x.x(), x.y(), exact(x.y(), 1));
    const Judgement judgement = judged("poiseuille", {write("period.csv", text)});
    EXPECT_TRUE(std::ranges::any_of(judgement.words, [&](const std::string& line) {
      return says(line, fmt::format("the rows span {0:g} m along x, L is 0.0005 m: --set L={0:g}?", length));
    })) << length;
    EXPECT_EQ(outcome_of(judgement, largest_hole) == Outcome::holds, length > 0.5e-3)
        << "a longer channel is judged as one, a shorter one lacks fluid";
  }
}

TEST_F(Doors, TakeACoarserGridForAnotherResolutionAtALaterTimeAndLostRowsForNone) {
  const auto at = [&](int across, double time, double kept) {
    std::string text = "x,y,v_x,v_y,t\n";
    const Vectors places = lattice({.high = {0.5e-3, 1e-3}}, 1e-3 / across).places();
    for (Eigen::Index p = 0; p < places.cols(); ++p)
      if (std::fmod(0.618 * static_cast<double>(p), 1) < kept)
        text += fmt::format("{},{},{},0,{}\n", places(0, p), places(1, p), exact(places(1, p), time), time);
    return write(fmt::format("{}_{}_{}.csv", across, time, kept), text);
  };
  const Flow flow = flow_named("poiseuille");
  const Judgement three = judge_files(flow, {at(24, 0.3, 1), at(32, 0.2, 1), at(48, 0.3, 1)});
  EXPECT_EQ(three.record.runs.size(), 3u);
  EXPECT_EQ(three.not_judged.at(0), "order of L2 v_x, per particle: no time at which there are three resolutions");
  for (const double kept : {0.95, 0.8, 0.55}) {
    const Record record = judge_files(flow, {at(32, 0.2, 1), at(32, 0.3, kept)}).record;
    EXPECT_EQ(record.runs.size(), 1u) << kept;
  }
}

TEST_F(Doors, JudgeTwoColumnsOfCellsAndFailAChannelWithoutItsLeftHalf) {
  std::string text = "x,y,p\n";
  const Flow flow = flow_named("hydrostatic");
  const double surface = flow.oracle<reference::Hydrostatic>().h, width = flow["L"];
  for (int k = 0; k < 40; ++k)
    for (const double x : {0.25, 0.75}) {
      const double y = (k + 0.5) / 40 * surface;
      text += fmt::format("{},{},{}\n", x * width, y, flow.pressure()({0, y}, 1));
    }
  const Judgement two = judged("hydrostatic", {write("two_columns.csv", text)});
  EXPECT_LT(value_of(two, water_at_rest::l2_p), 1e-9);
  EXPECT_EQ(outcome_of(two, largest_hole), Outcome::holds);
  text = "x,y,v_x,v_y\n";
  const Vectors places = lattice({.high = {0.5e-3, 1e-3}}, 5e-5).places();
  for (const auto& x : places.colwise())
    if (x.x() > 0.25e-3) text += fmt::format("{},{},{},0\n", x.x(), x.y(), exact(x.y(), 1));
  EXPECT_EQ(outcome_of(judged("poiseuille", {write("right_half.csv", text)}), largest_hole), Outcome::fails);
}

TEST_F(Doors, SayPlainlyWhatIsFarTooSmallAndWhichTimesAreLacking) {
  const Flow flow = flow_named("poiseuille");
  std::string text = "x,y,v_x,v_y\n";
  const Vectors places = lattice(flow.filled, 5e-5).places();
  for (const auto& x : places.colwise()) text += fmt::format("{},{},{},0\n", x.x(), x.y(), 1e-200 * exact(x.y(), 1));
  const Record record = judge_files(flow, {write("small.csv", text)}, {.time = 1}, {}, {.at_most = 1}).record;
  for (const Verdict& v : record.verdicts) EXPECT_LT(v.sentence.size(), 600u) << v.sentence;
  const Judgement early = judged("cavity", {changed(flow_named("cavity"), 3, [](Samples&) {})}, {.time = 3});
  for (const std::string& line : early.not_judged) EXPECT_FALSE(says(line, "inf")) << line;
}

TEST_F(Doors, MultiplyAKinematicPressureByTheDensity) {
  const Flow flow = flow_named("taylor_green");
  std::string text = "x,y,vx,vy,p [m2/s2]\n";
  const Vectors places = lattice(flow.filled, 0.05).places();
  for (const auto& x : places.colwise())
    text += fmt::format("{},{},0,0,{}\n", x.x(), x.y(), flow.start.pressure_at(x) / flow.fluid.density);
  Mapping at_start;
  at_start.time = 0;
  const Record record = judged("taylor_green", {write("kinematic.csv", text)}, at_start).record;
  const auto pressure = std::ranges::find(record.values, l2_pressure, &Value::quantity);
  ASSERT_NE(pressure, record.values.end());
  EXPECT_LT(pressure->value, 1e-9);
}

TEST_F(Doors, JudgeEachFlowByItsOwnInitialState) {
  for (const std::string& name : flow_names())
    for (const Flow& flow : as_published_and_not(name)) {
      const std::filesystem::path file = write(name + ".csv", particles_as_csv(flow, flow.across / 20));
      Mapping at_start;
      at_start.time = 0;
      const Judgement judgement = judge_files(flow, {file}, at_start);
      for (const Value& value : judgement.record.values) {
        if (value.quantity.kind == Kind::norm || value.quantity.kind == Kind::deviation) {
          EXPECT_LT(value.value, 1e-10) << flow.case_name() << ": " << value.quantity.name;
        }
        if (value.quantity.name == mass_found.name) {
          EXPECT_NEAR(value.value, 0, 1e-9) << flow.case_name();
        }
        if (value.quantity.name.starts_with("residual height") || value.quantity.name.starts_with("front L, ")) {
          EXPECT_NEAR(value.value, 1, 0.1) << flow.case_name() << ": " << value.quantity.name;
        }
      }
      EXPECT_FALSE(judgement.record.values.empty() && judgement.not_judged.empty()) << name << ": nothing is judged";
    }
}

TEST_F(Doors, FindInEachNormTheErrorThatWasPutIntoVelocityAndPressure) {
  for (const std::string& name : flow_names())
    for (const Flow& flow : as_published_and_not(name)) {
      const auto too_large = [](Samples& s) { s.v *= 1.03, s.pressure *= 1.03; };
      for (const Value& value : judge_files(flow, {changed(flow, 0, too_large)}, {}).record.values)
        if (value.quantity.kind == Kind::norm) {
          EXPECT_NEAR(value.value, 3, 1e-9) << flow.case_name() << ": " << value.quantity.name;
        }
    }
}

TEST_F(Doors, RefuseAFluidThatIsElsewhereAtTheStart) {
  for (const std::string name : {"dam_break", "elliptic_drop"}) {
    const Flow flow = flow_named(name);
    const auto moved = [&](double by) {
      return refusal(name, changed(flow, 0, [&](Samples& s) { s.x.row(0).array() += by * flow.across; }), {.time = 0});
    };
    EXPECT_EQ(moved(0.01), "judged without complaint") << name;
    EXPECT_TRUE(says(moved(0.25), "the middle of the rows at the start is")) << name << ": " << moved(0.25);
  }
}

TEST_F(Doors, SeeWaterAtRestMove) {
  for (const auto& [depth, g] : {std::pair(1.0, 9.81), std::pair(0.5, 2.0)}) {
    const Flow flow = flow_named("hydrostatic", Settings({{"h", depth}, {"g", g}}));
    const auto raised = [](double by) { return [by](Samples& s) { s.x.row(1).array() += by, s.v.setConstant(by); }; };
    const auto files = [&](double by) -> std::vector<std::filesystem::path> {
      return {changed(flow, 0, raised(0)), changed(flow, 1, raised(0)), changed(flow, 2, raised(by))};
    };
    EXPECT_EQ(value_of(judge_files(flow, files(0), {}), water_at_rest::displacement), 0);
    const double by = 0.02 * depth;
    const Judgement moved = judge_files(flow, files(by), {});
    EXPECT_NEAR(value_of(moved, water_at_rest::displacement), 2, 1e-9);
    EXPECT_NEAR(value_of(moved, water_at_rest::kinetic), by * by / g / (0.52 * depth), 1e-3 * by * by);
    EXPECT_NEAR(value_of(judge_files(flow, files(-by), {}), water_at_rest::displacement), 2, 1e-9)
        << "it may sink, too";
    EXPECT_TRUE(says(judge_files(flow, {changed(flow, 2, raised(0))}, {}).not_judged.at(0),
                     "rest over time: 1 time from 2 to 2 s, expected 3 or more, the first at 0 s or before, the last at "
                     "1 s or after"));
  }
}

TEST_F(Doors, MeasureHowFastAWaveSwings) {
  using gravity_wave::published;
  const auto judged_wave = [&](const reference::StandingWave& wave, double faster) {
    const Flow flow = flow_named(
        "standing_wave", Settings({{"L", wave.L}, {"h", wave.h}, {"a", wave.a}, {"g", wave.g}, {"nu", wave.nu}}));
    const double scale = published.omega() / wave.omega();
    std::vector<std::filesystem::path> all;
    for (int k = 0; k <= 80; ++k)
      all.push_back(changed(flow, 0.05 * k * scale, [&](Samples& s) {
        reference::StandingWave now = wave;
        now.a *= std::cos(faster * wave.omega() * s.time) * std::exp(-wave.decay_rate() * s.time);
        s.x = gravity_wave::heaped(now, lattice(flow.filled, flow.across / 20).places());
      }));
    return judge_files(flow, all, {});
  };
  for (const reference::StandingWave& wave : {published, {.L = 2, .a = 0.03, .h = 0.5, .g = 4, .nu = 6e-3}}) {
    EXPECT_NEAR(value_of(judged_wave(wave, 1), gravity_wave::period_error), 0, 0.05) << wave.L;
    const Judgement faster = judged_wave(wave, 1.03);
    EXPECT_NEAR(value_of(faster, gravity_wave::period_error), 100 * (1 / 1.03 - 1), 0.05) << wave.L;
    EXPECT_NEAR(value_of(faster, gravity_wave::decay_error), 0, 0.5) << wave.L;
  }
}

TEST_F(Doors, MeasureTheHalfAxesOfADrop) {
  for (const auto& drop : {reference::EllipticDrop{.R = 1, .s0 = 1, .rho = 1000}, {.R = 0.5, .s0 = 2, .rho = 900}}) {
    const Flow flow = flow_named("elliptic_drop", Settings({{"R", drop.R}, {"s", drop.s0}, {"rho", drop.rho}}));
    const auto stretched = [&](double too_long, double too_much_pressure = 0) {
      return [&, too_long, too_much_pressure](Samples& s) {
        const auto now = drop.at(s.time);
        s.x.row(0) *= now.a / drop.R * too_long, s.x.row(1) *= now.b / drop.R;
        for (Eigen::Index p = 0; p < s.size(); ++p) {
          s.v.col(p) = Vec2(now.s * s.x(0, p), -now.s * s.x(1, p));
          s.pressure[p] = now.p(s.x(0, p), s.x(1, p)) + too_much_pressure * drop.at(0).p_centre;
        }
      };
    };
    const auto judged_drop = [&](double error, double of_pressure = 0) {
      return judge_files(
          flow, {changed(flow, 0, stretched(1)), changed(flow, 0.8 / drop.s0, stretched(1 + error, of_pressure))}, {});
    };
    const Judgement unchanged = judged_drop(0);
    for (const Quantity& quantity : {drop::axes_error, l2_velocity, drop::pressure_error})
      EXPECT_NEAR(value_of(unchanged, quantity), 0, 1e-8) << quantity.name;
    EXPECT_NEAR(value_of(judged_drop(0.01), drop::axes_error), 1, 1e-9);
    std::vector<double> of_pressure;
    for (const Value& value : judged_drop(0, 0.05).record.values)
      if (value.quantity == drop::pressure_error) of_pressure.push_back(value.value);
    ASSERT_EQ(of_pressure.size(), 2u);
    EXPECT_NEAR(of_pressure[1], 5, 1e-6) << "of that at the start";
  }
}

TEST_F(Doors, SeeWhatAPatchLoses) {
  for (const Vec2& parameters : {Vec2(1, 1), Vec2(0.5, 3)}) {
    const double side = parameters.x(), spin = parameters.y();  // m, 1/s
    const Flow flow = flow_named("rotating_patch", Settings({{"L", side}, {"omega", spin}}));
    const auto judged_patch = [&](double slower, int across) {
      const auto slow = [](double by) { return [by](Samples& s) { s.v *= 1 - by; }; };
      return judge_files(flow, {changed(flow, 0, slow(0), across), changed(flow, 1 / spin, slow(slower), across)}, {});
    };
    const Judgement kept = judged_patch(0, 20), lost = judged_patch(0.02, 40);
    for (const Quantity& quantity : {patch::drift, patch::angular_momentum_error, patch::loss, patch::asymmetry})
      EXPECT_NEAR(value_of(kept, quantity), 0, 1e-9) << quantity.name;
    EXPECT_NEAR(value_of(lost, patch::angular_momentum_error), 2, 1e-9);
    EXPECT_NEAR(value_of(lost, patch::loss), 100 * (1 - 0.98 * 0.98), 1e-9);
    EXPECT_EQ(outcome_of(lost, patch::angular_momentum_error), Outcome::fails);
    EXPECT_EQ(outcome_of(lost, patch::drift), Outcome::holds);
  }
}

TEST_F(Doors, CompareACavityWithItsSteadyFlow) {
  const Flow flow = flow_named("cavity");
  const auto moved = [](Samples& s) { s.v.colwise() = Vec2(0.1, 0); };
  const Judgement judgement = judged("cavity", {changed(flow, 12, moved)});
  double squares = 0;
  const Centreline line = converged_centreline(data_folder(), Centreline::vertical, 100);
  for (const double u : line.velocity) squares += (u - 0.1) * (u - 0.1) / static_cast<double>(line.velocity.size());
  EXPECT_NEAR(value_of(judgement, norm_of("L2", Centreline::vertical)), 100 * std::sqrt(squares), 1e-6);
  EXPECT_THROW(flow_named("cavity", Settings({{"Re", 250}})), std::invalid_argument);
  EXPECT_TRUE(std::isnan(value_of(judged("cavity", {changed(flow, 5, moved)}), norm_of("L2", Centreline::vertical))))
      << "not steady yet";
  EXPECT_NEAR(value_of(judged("cavity", {changed(flow, 50, moved)}), norm_of("L2", Centreline::vertical)),
              100 * std::sqrt(squares), 1e-6)
      << "at one time, later";
}

TEST_F(Doors, TakeASampleWithinOnePerCentOfATimeForOneOfThatTime) {
  const Flow flow = flow_named("cavity");
  const auto moved = [](Samples& s) { s.v.colwise() = Vec2(0.1, 0); };
  const auto from = [&](double first) {
    return judged("cavity", {changed(flow, first, moved), changed(flow, 11.9, moved)});
  };
  EXPECT_EQ(value_of(from(7.06), change_of_energy), 0);
  EXPECT_TRUE(says(from(7.1).not_judged.at(0), "2 times from 7.1 to 11.9 s, expected 2 or more, the first at 7 s or "
                                               "before, the last at 12 s or after"));
}

TEST_F(Doors, CompareADamWithItsExperimentsByEachFront) {
  const Flow flow = flow_named("dam_break");
  const DataTable table = read_table(data_folder() / "experiments" / "lobovsky_2014_front_600.csv");
  const std::vector<double> T = table.numbers("T [-]"), L = table.numbers("L [-]");
  const auto run_out = [&](double ahead) {
    std::vector<std::filesystem::path> all;
    for (int k = 0; k <= 50; ++k)
      all.push_back(changed(flow, 0.01 * k, [&](Samples& s) {
        const double now = dam_break::front.scaled_time(s.time);
        const auto after =
            std::clamp<std::ptrdiff_t>(std::ranges::lower_bound(T, now) - T.begin(), 1, std::ssize(T) - 1);
        const auto i = static_cast<std::size_t>(after);
        const double front =
            std::min(2.683, std::lerp(L[i - 1], L[i], (now - T[i - 1]) / (T[i] - T[i - 1])) + (k > 0 ? ahead : 0));
        const double length = 0.6 * front;
        const long columns = std::lround(length / 0.03);
        for (long p = 0; p < s.size(); ++p)
          s.x.col(p) = Vec2((static_cast<double>(p % columns) + 0.5) * length / static_cast<double>(columns),
                            (static_cast<double>(p / columns) + 0.5) * 0.03);
      }));
    return judged("dam_break", all);
  };
  const auto rms = [](const std::string& front) { return DamFront::rms_of(front, "Lobovský et al. 2014"); };
  const Judgement as_measured = run_out(0), ahead = run_out(0.1);
  for (const std::string front : {"farthest particle", "farthest particle of the main body"}) {
    EXPECT_NEAR(value_of(as_measured, rms(front)), 0.025, 0.003) << front << ", half a spacing behind";
    EXPECT_NEAR(value_of(ahead, rms(front)), 0.1 - value_of(as_measured, rms(front)), 0.02) << front;
  }
  EXPECT_EQ(value_of(as_measured, DamFront::lost), 0);
  const Quantity speed = DamFront::speed_of(DamFront::of_thin_slab);
  EXPECT_LT(value_of(as_measured, speed), 2) << "Ritter 1892";
  EXPECT_EQ(std::ranges::count(as_measured.record.verdicts, speed.name, &Verdict::quantity), 0)
      << "which is no law of a jet";
  EXPECT_TRUE(std::isnan(value_of(as_measured, DamFront::rms_of("farthest particle", "Koshizuka & Oka 1995"))))
      << "a tall column";
}

TEST_F(Doors, FailADamThatHardlyRunsAtAnyResolutionAndAnyTime) {
  const auto lead = [&](const std::map<std::string, double>& set, double stretch, int across,
                        const std::vector<double>& times) {
    const Flow flow = flow_named("dam_break", Settings(set));
    const auto run_out = [&](Samples& s) {  // as a block that keeps its area
      s.x.row(0) *= stretch;
      s.x.row(1) /= stretch;
    };
    std::vector<std::filesystem::path> all;
    for (const double time : times) all.push_back(changed(flow, time, run_out, across));
    const Judgement judgement = judge_files(flow, all, {});
    return std::pair(outcome_of(judgement, DamFront::least_lead), value_of(judgement, DamFront::least_lead));
  };
  const double at_one = 1 / dam_break::front.scaled_time(1), slowest = 1.67 + 0.01 / 0.17 * 0.22;  // at T = 0.98
  for (const int across : {5, 10, 20, 60}) {
    const auto [outcome, value] = lead({}, 1, across, {1.28 * at_one});
    EXPECT_EQ(outcome, Outcome::fails) << across;
    EXPECT_NEAR(value, 1 - slowest, 1e-3) << across;
    EXPECT_EQ(lead({}, slowest + 0.02, across, {1.28 * at_one}).first, Outcome::holds) << across;
    EXPECT_EQ(lead({}, slowest + 0.02, across, {1.28 * at_one, 1.4 * at_one}).first, Outcome::fails) << across;
    EXPECT_EQ(lead({}, 1, across, {0.9 * at_one}).first, Outcome::inconclusive) << "too early to tell";
  }
  EXPECT_EQ(lead({{"h0", 1.2}, {"H", 2}}, 1.05, 10, {1.28 * at_one / std::numbers::sqrt2}).first, Outcome::fails);
  EXPECT_EQ(lead({{"h0", 0.2}}, 1, 10, {1.28 * at_one * std::numbers::sqrt3}).first, Outcome::inconclusive)
      << "no experiment";
}

TEST_F(Doors, RefuseAColumnOfAnotherAspect) {
  const auto unchanged = [](Samples&) {};
  Flow tall = flow_named("dam_break", Settings({{"h0", 1.2}, {"H", 2}}));
  const std::filesystem::path at_start = changed(tall, 0, unchanged);
  EXPECT_TRUE(says(refusal("dam_break", at_start), "outside the domain") ||
              says(refusal("dam_break", at_start), "at the start"));
  tall = flow_named("dam_break", Settings({{"l0", 0.3}}));
  EXPECT_TRUE(says(refusal("dam_break", changed(tall, 0, unchanged)),
                   "rows spread over 0.285 m by 0.585 m, expected about 0.5786 m by 0.5786 m at the start"));
  EXPECT_TRUE(says(refusal("dam_break", changed(tall, 0.4, unchanged)), "expected room for the 0.36 m² of fluid"));
  EXPECT_TRUE(says(refusal("hydrostatic", changed(flow_named("hydrostatic", Settings({{"h", 0.7}})), 1, unchanged)),
                   "expected 0.5 m²"));
}

TEST_F(Doors, JudgeFrontsOfFilesWithoutVolumes) {
  const Flow flow = flow_named("dam_break");
  std::string text = "x,y\n";
  const Vectors places = flow.start.places_on(lattice(flow.filled, 0.02).places());
  for (const auto& x : places.colwise()) text += fmt::format("{},{}\n", x.x(), x.y());
  Mapping at_start;
  at_start.time = 0;
  const Judgement judgement = judged("dam_break", {write("places.csv", text)}, at_start);
  EXPECT_NEAR(value_of(judgement, {"front L, half-full slab of two spacings"}), 1, 1e-9);
  EXPECT_TRUE(std::ranges::any_of(judgement.not_judged,
                                  [](const std::string& line) { return says(line, "no pressure in the files"); }));
}

TEST_F(Doors, JudgeOfAMeshTheMassOfWaterAndNotTheNumberOfItsCells) {
  const auto write_cells = [&](double time, const std::vector<double>& water) {
    std::string points, cells, types;  // two columns of four squares
    for (int k = 0; k < 15; ++k) points += fmt::format("{} {} 0\n", 0.3 * (k % 3), 0.3 * (k / 3));
    for (int k = 0; k < 8; ++k) {
      const int corner = k % 2 + 3 * (k / 2);
      cells += fmt::format("4 {} {} {} {}\n", corner, corner + 1, corner + 4, corner + 3);
      types += "9\n";
    }
    return write(fmt::format("{}.vtk", time),
                 fmt::format("# vtk DataFile Version 3.0\nwater\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                             "FIELD FieldData 1\nTIME 1 1 double\n{}\nPOINTS 15 double\n{}CELLS 8 40\n{}CELL_TYPES "
                             "8\n{}CELL_DATA 8\nSCALARS alpha.water double 1\nLOOKUP_TABLE default\n{}\n",
                             time, points, cells, types, fmt::join(water, " ")));
  };
  const auto judged_cells = [&](double last) {
    const Mapping by_fraction{.arrays = {{"fraction", "alpha.water"}}, .only = "alpha.water>0"};
    return judge_files(flow_named("dam_break"),
                       {write_cells(0, {1, 1, 1, 1, 0, 0, 0, 0}), write_cells(0.1, {1, 1, 1, 0.5, 0, 0, last, 0})},
                       by_fraction, 0.3);
  };
  const Judgement kept = judged_cells(0.5), losing = judged_cells(0.4);
  const Quantity since_first{"relative change of the mass since the first time", "", Kind::invariant};
  EXPECT_EQ(outcome_of(kept, since_first), Outcome::holds);
  EXPECT_EQ(outcome_of(losing, since_first), Outcome::fails);
  EXPECT_NEAR(value_of(losing, since_first), -0.1 / 4, 1e-12);
  EXPECT_NEAR(value_of(losing, DamFront::mass_change), -0.1 / 4, 1e-12);
  EXPECT_TRUE(std::isnan(value_of(kept, DamFront::lost))) << "five cells hold water where four did";
  EXPECT_EQ(outcome_of(kept, DamFront::lost), Outcome::inconclusive);
  EXPECT_EQ(std::ranges::count(kept.not_judged, "no particles in the files: what is measured of it is not judged"), 1);
}

TEST_F(Doors, LeaveUnjudgedWhatNoFieldIsThereFor) {
  const Judgement judgement =
      judged("taylor_green", {write("a.csv", "x,y,vx,vy\n0.1,0.1,0,0\n0.9,0.1,0,0\n0.1,0.9,0,0\n0.9,0.9,0,0\n")});
  ASSERT_EQ(judgement.not_judged.size(), 2u) << "and what limits would add";
  EXPECT_EQ(judgement.not_judged[0], "no pressure in the files: what is measured of it is not judged");
  EXPECT_TRUE(says(judgement.not_judged[1], "--at-most PERCENT"));
}

TEST_F(Doors, TakeNoLossOfRowsForAnotherResolution) {
  std::mt19937 random(3);
  const auto rows = [&](int across, double time, double lost) {
    std::string text = fmt::format("# t = {}\nx,y,v_x,v_y\n", time);
    const Vectors places = lattice({.high = {0.5e-3, 1e-3}}, 1e-3 / across).places();
    for (const auto& x : places.colwise())
      if (std::uniform_real_distribution<double>()(random) >= lost)
        text += fmt::format("{},{},{},0\n", x.x(), x.y(), exact(x.y(), time));
    return write(fmt::format("{}_{}.csv", across, time), text);
  };
  const auto fails_on_rows = [](const Record& record) {
    return std::ranges::any_of(
        record.verdicts, [](const Verdict& v) { return v.quantity == "rows" && v.outcome == Outcome::fails; });
  };
  for (const double lost : {0.2, 0.6, 0.8}) {
    const Record record = judge_files(flow_named("poiseuille"), {rows(40, 0.5, 0), rows(40, 1, lost)}, {}).record;
    EXPECT_EQ(record.runs.size(), 1u) << lost;
    EXPECT_TRUE(fails_on_rows(record)) << lost;
  }
  const double as_many = 1 - std::pow(20.0 / 22, 2);
  EXPECT_TRUE(fails_on_rows(judge_files(flow_named("poiseuille"),
                                        {rows(20, 0.5, 0), rows(20, 1, 0), rows(22, 0.5, 0), rows(22, 1, as_many)}, {})
                                .record));
}

TEST_F(Doors, FailAVelocityThatIsNoNumberInOneRow) {
  const std::string whole = files::read_whole(poiseuille(20));
  for (const char* bad : {",nan,0\n", ",0,nan\n", ",inf,0\n"}) {
    const std::string holed = std::regex_replace(whole, std::regex(",[^,]+,0\n$"), bad);
    ASSERT_NE(holed, whole);
    const Record record = judged("poiseuille", {write("holed.csv", holed)}).record;
    EXPECT_TRUE(std::ranges::any_of(record.verdicts, [](const Verdict& v) {
      return v.outcome == Outcome::fails && says(v.quantity, "v_");
    })) << bad;
  }
}

TEST_F(Doors, JudgeAChannelWithoutTheVelocityAcrossAndNoSquare) {
  const std::string whole = files::read_whole(poiseuille(20, 0.01));
  const Judgement both = judged("poiseuille", {write("both.csv", whole)}),
                  along = judged("poiseuille",
                                 {write("along.csv", std::regex_replace(whole, std::regex(",(v_y|0)\n"), "\n"))});
  std::vector<Value> expected = both.record.values;
  EXPECT_EQ(std::erase_if(expected, [](const Value& v) { return says(v.quantity.name, "v_y"); }), 2u);
  ASSERT_EQ(along.record.values.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k)
    EXPECT_EQ(along.record.values[k].value, expected[k].value) << expected[k].quantity.name;
  ASSERT_FALSE(along.not_judged.empty());
  EXPECT_EQ(along.not_judged[0], "no velocity along y in the files: what is measured of it is not judged");
  const std::string corners = "x,y,vx\n0.1,0.1,0\n0.9,0.1,0\n0.1,0.9,0\n0.9,0.9,0\n";
  EXPECT_TRUE(says(refusal("taylor_green", write("square.csv", corners)), "velocity along x alone, expected"));
}

TEST_F(Doors, RefuseInOneLineWhatIsNoSuchFlow) {
  const std::string rows = "0.0001,0.0001,0,0\n0.0004,0.0001,0,0\n0.0001,0.0009,0,0\n0.0004,0.0009,0,0\n";
  EXPECT_TRUE(says(refusal("poiseuille", write("a.csv", "x,y,vx,vy\n" + rows + "nan,0.0001,0,0\n")),
                   "row 5: x, y = nan, expected a finite number"));
  EXPECT_TRUE(says(refusal("poiseuille", write("b.csv", "x,y,vx,vy\n" + rows + "0.0001,0.002,0,0\n")),
                   "1 of 5 rows lie outside the domain"));
  EXPECT_TRUE(says(refusal("poiseuille", write("c.csv", "x,y,vx,vy,velx,vely\n1e-4,1e-4,0,0,0,0\n")),
                   "velocity may be 'velx, vely' or 'vx, vy': say which"));
  EXPECT_TRUE(says(refusal("poiseuille", write("d.csv", "x,y,z,vx,vy\n1e-4,1e-4,0,0,0\n1e-4,2e-4,1,0,0\n")),
                   "expected a cloud in a plane"));
  EXPECT_TRUE(says(refusal("poiseuille", write("e.csv", "x,y,vx,vy\n1e-4,1e-4,0\n")),
                   "e.csv: 4 names of columns, 'x,y,vx,vy', expected 3 as in the first row"));
  EXPECT_TRUE(says(refusal("poiseuille", write("f.csv", "a,b\n1,2\n")), "no places, expected --field position=NAME"));
  EXPECT_TRUE(says(
      refusal("poiseuille", write("g.csv", "x,y,vx,vy\n1e-6,1e-6,0,0\n2e-6,1e-6,0,0\n1e-6,2e-6,0,0\n2e-6,2e-6,0,0\n")),
      "expected most of the 0.0005 m by 0.001 m"));
  EXPECT_TRUE(says(refusal("poiseuille", write("h.csv", "x [mm],y [m],vx,vy\n1e-4,1e-4,0,0\n")),
                   "x [mm], y [m]: two units, expected the same of all columns"));
  EXPECT_TRUE(says(refusal("no_flow", poiseuille(4)), "no flow 'no_flow', expected one of: cavity"));
}

TEST(Flows, AreAskedAtOtherParametersAndRefuseUnknownOnes) {
  const Flow flow = flow_named("poiseuille", Settings({{"H", 1}, {"F", 1e-5}, {"nu", 0.01}}));
  EXPECT_EQ(flow.filled.high, Vec2(0.5, 1)) << "the box keeps its shape";
  EXPECT_NE(scene_in_words(flow, flow.across / 40).find("800 particles"), std::string::npos);
  EXPECT_DOUBLE_EQ(flow.fluid.kinematic_viscosity(), 0.01);
  EXPECT_EQ(flow.drive.amplitude.x(), 1e-5);
  EXPECT_EQ(flow.case_name(), "poiseuille_H=1_nu=1e-2_F=1e-05");
  EXPECT_EQ(flow.title(), "Start-up of plane Poiseuille flow, H = 1 m, nu = 0.01 m²/s, F = 1e-05 m/s²");
  EXPECT_EQ(flow_named("poiseuille", Settings({{"H", 1e-3}, {"nu", 0.0125}, {"F", -1.5e-5}})).case_name(),
            "poiseuille_nu=125e-4_F=-15e-6");
  EXPECT_THROW(flow_named("poiseuille", Settings({{"h", 1}})), std::invalid_argument);
  EXPECT_THROW(flow_named("poiseuille", Settings({{"H", -1}})), std::invalid_argument);
}

TEST(Flows, AreThoseOfTheCasesWhereNothingIsSet) {
  const Flow flow = flow_named("poiseuille");
  const auto scene = channel::driven_by(Uniform{{channel::drive, 0}});
  EXPECT_EQ(flow.filled.high, scene.filled.high);
  EXPECT_NEAR(flow.fluid.bulk_modulus, scene.fluid.bulk_modulus, 1e-12 * scene.fluid.bulk_modulus);
  EXPECT_EQ(flow.fluid.viscosity, scene.fluid.viscosity);
  EXPECT_EQ(flow.drive.amplitude, scene.body_force.per_mass);
}

TEST(Flows, OfCouetteMayHaveTheirLowerPlateSlideInstead) {
  const auto at = [](const std::map<std::string, double>& set, double y) {
    return flow_named("couette", Settings(set)).exact.front().with({})({0, y}, 0.1).x();
  };
  for (const double y : {0.0, 0.2e-3, 0.9e-3}) {
    EXPECT_NEAR(at({{"V", 0}, {"V_lower", 1e-4}}, y), at({}, 1e-3 - y), 1e-18) << y;
    EXPECT_NEAR(at({{"V_lower", 1e-4}}, y), at({}, y) + at({}, 1e-3 - y), 1e-18) << y;
  }
}

TEST(Flows, BetweenPlatesGoOnOddlyBehindBothHoweverFar) {
  for (const char* name : {"poiseuille", "couette", "oscillating_poiseuille"}) {
    Settings settings;
    if (name == std::string("couette")) settings = Settings({{"V", 3e-4}, {"V_lower", 1e-4}});
    const Flow flow = flow_named(name, settings);
    const double H = flow.across, t = flow.judged.times.front();
    const FieldTruth truth = flow.exact.front().with({});
    const auto v = [&](double y) { return truth({0, y}, t).x(); };
    const double at_floor = v(0), at_ceiling = v(H), scale = std::abs(v(H / 2)) + std::abs(at_ceiling);
    for (double away = 0.05 * H; away < 7 * H; away += 0.3 * H) {
      EXPECT_NEAR(v(away) + v(-away), 2 * at_floor, 1e-9 * scale) << name << ' ' << away / H;
      EXPECT_NEAR(v(H + away) + v(H - away), 2 * at_ceiling, 1e-9 * scale) << name << ' ' << away / H;
    }
  }
}

TEST(Flows, OfAWaveStartUnderAPressureThatDrivesNothingThroughTheFloor) {
  const Flow flow = flow_named("standing_wave", Settings({{"L", 2}, {"h", 0.3}, {"a", 0.01}, {"g", 5}}));
  const auto of_wave = [&](double x, double y) { return flow.start.pressure_at({x, y}) - 1000 * 5 * (0.3 - y); };
  for (const double x : {0.1, 0.7, 1.6}) {
    const double crest = 1000 * 5 * 0.01 * std::cos(std::numbers::pi * x);
    EXPECT_NEAR(of_wave(x, 0.28), crest, 0.06 * std::abs(crest)) << "below the surface that of its height";
    EXPECT_NEAR(of_wave(x, 1e-3), of_wave(x, 0), 1e-5 * std::abs(crest)) << "as high beside the floor";
  }
}

TEST(Scenes, SayInJsonWhatASolverNeeds) {
  const auto json = nlohmann::json::parse(scene_as_json(flow_named("stokes_second"), 1e-4));
  EXPECT_EQ(json["walls"][0]["condition"], "no slip");
  EXPECT_EQ(json["walls"][0]["velocity [m/s]"][0], 1e-3);
  EXPECT_NEAR(json["walls"][0]["angular frequency [1/s]"], 314.159, 1e-3);
  EXPECT_EQ(json["walls"][1]["condition"], "free slip");
  EXPECT_EQ(json["domain"]["periodic"], nlohmann::json({true, false}));
  EXPECT_EQ(json["fields"], nlohmann::json({"position", "velocity"}));
}

TEST(Scenes, GiveTimesAsTheyWereMeant) {
  EXPECT_EQ(0.05 * 1e-3 * 1e-3 / 1e-6, 0.05000000000000001) << "as a product comes out";
  EXPECT_EQ(nlohmann::json::parse(scene_as_json(flow_named("poiseuille"), 2.5e-5)).at("times [s]"),
            nlohmann::json({0.05, 0.1, 0.2, 1}));
  EXPECT_EQ(as_meant(1.0 / 3), 1.0 / 3);
}

TEST(Scenes, GiveOfAFreeSurfaceWhatIsFilledAndHowOftenToWrite) {
  const auto json = nlohmann::json::parse(scene_as_json(flow_named("dam_break"), 0.02));
  EXPECT_EQ(json["free surface"], true);
  EXPECT_EQ(json["body force"]["amplitude [m/s²]"], nlohmann::json({0.0, -9.8}));
  EXPECT_EQ(json["fluid"]["viscosity [Pa s]"], 0);
  EXPECT_EQ(json["walls"].size(), 3u);
  EXPECT_EQ(json["times from 0 on, every [s]"], 0.01);
  EXPECT_FALSE(nlohmann::json::parse(scene_as_json(flow_named("cavity"), 0.02))["free surface"]);
  const std::string words = scene_in_words(flow_named("elliptic_drop"), 0.1);
  EXPECT_TRUE(says(words, "316 particles with a spacing of 0.1 m")) << words;
}

}  // namespace
}  // namespace touchstone::vnv::doors

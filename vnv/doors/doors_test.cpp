#include "reference/poiseuille.hpp"
#include "solvers/lattice.hpp"
#include "vnv/doors/judge.hpp"
#include "vnv/doors/scene.hpp"
#include "vnv/files/whole_file.hpp"
#include "vnv/flows/driven_channel.hpp"
#include "vnv/programs/scratch_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

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

bool says(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

TEST_F(Doors, FindTheErrorThatWasPutIn) {
  const Record record = judged("poiseuille", {poiseuille(20, 0.03)}).record;
  ASSERT_EQ(record.values.size(), 4u) << "L2 and Linf, per particle and of row means";
  for (const Value& value : record.values) EXPECT_NEAR(value.value, 3, 1e-9) << value.quantity.name;
  EXPECT_TRUE(record.verdicts.empty()) << "nothing is claimed of one resolution";
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

TEST_F(Doors, ReadOtherUnitsFromHeadingsOrAsTheUserSays) {
  const double in_mm = judged("poiseuille", {poiseuille(20, 0.03, 1e-3, "mm")}).record.values[0].value;
  EXPECT_NEAR(in_mm, 3, 1e-9);
  Mapping mapping;
  mapping.units = {{"length", "um"}};
  EXPECT_NEAR(judged("poiseuille", {poiseuille(20, 0.03, 1e-6, "any")}, mapping).record.values[0].value, 3, 1e-9);
  EXPECT_TRUE(says(refusal("poiseuille", poiseuille(20, 0, 1e-3, "m")), "they fit times 0.001: --unit length=mm?"));
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
  for (const std::string& name : flow_names()) {
    const Flow flow = flow_named(name);
    const std::filesystem::path file = write(name + ".csv", particles_as_csv(flow, flow.across / 20));
    Mapping at_start;
    at_start.time = 0;
    const Judgement judgement = judged(name, {file}, at_start);
    for (const Value& value : judgement.record.values)
      EXPECT_LT(value.value, 1e-10) << name << ": " << value.quantity.name;
    EXPECT_NE(judgement.record.values.empty(), judgement.not_judged.empty()) << name << ": fluid at rest has no scale";
  }
}

TEST_F(Doors, LeaveUnjudgedWhatNoFieldIsThereFor) {
  const Judgement judgement =
      judged("taylor_green", {write("a.csv", "x,y,vx,vy\n0.1,0.1,0,0\n0.9,0.1,0,0\n0.1,0.9,0,0\n0.9,0.9,0,0\n")});
  ASSERT_EQ(judgement.not_judged.size(), 1u);
  EXPECT_EQ(judgement.not_judged[0], "no pressure in the files: what is measured of it is not judged");
}

TEST_F(Doors, RefuseInOneLineWhatIsNoSuchFlow) {
  const std::string rows = "0.0001,0.0001,0,0\n0.0004,0.0001,0,0\n0.0001,0.0009,0,0\n0.0004,0.0009,0,0\n";
  EXPECT_TRUE(says(refusal("poiseuille", write("a.csv", "x,y,vx,vy\n" + rows + "0.1,0.0001,nan,0\n")),
                   "row 5: vx, vy = nan, expected a finite number"));
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
  EXPECT_TRUE(says(refusal("no_flow", poiseuille(4)), "no flow 'no_flow', expected one of: couette"));
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

TEST(Scenes, SayInJsonWhatASolverNeeds) {
  const auto json = nlohmann::json::parse(scene_as_json(flow_named("stokes_second"), 1e-4));
  EXPECT_EQ(json["walls"][0]["condition"], "no slip");
  EXPECT_EQ(json["walls"][0]["velocity [m/s]"][0], 1e-3);
  EXPECT_NEAR(json["walls"][0]["angular frequency [1/s]"], 314.159, 1e-3);
  EXPECT_EQ(json["walls"][1]["condition"], "free slip");
  EXPECT_EQ(json["domain"]["periodic"], nlohmann::json({true, false}));
  EXPECT_EQ(json["fields"], nlohmann::json({"position", "velocity"}));
}

}  // namespace
}  // namespace touchstone::vnv::doors

#include "vnv/flows/formulas/flow_file.hpp"

#include "vnv/files/data_folder.hpp"
#include "vnv/files/whole_file.hpp"
#include "vnv/flows/formulas/formulas.hpp"
#include "vnv/programs/scratch_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace touchstone::vnv {
namespace {

/// A flow that decays in a periodic square, without what its fields are.
constexpr std::string_view in_square = R"toml(times = [0.1, 1]
[parameters]
L = 1
U = 1
Re = 100
rho = 1000
omega = 5
ripple = 0.02
[domain]
x = [0, "L"]
y = [0, "L"]
periodic = ["x", "y"]
[fluid]
density = "rho"
viscosity = "nu"
[let]
nu = "U*L/Re"
k = "2*pi/L"
gone = "exp(-2*nu*k^2*t)"
)toml";

constexpr std::string_view taylor_green = R"toml([exact]
v_x = "-U*cos(k*x)*sin(k*y)*gone"
v_y = "U*sin(k*x)*cos(k*y)*gone"
p = "-rho*U^2/4*(cos(2*k*x) + cos(2*k*y))*gone^2"
)toml";

constexpr std::string_view between_plates = R"toml(times = [2.5e-3, 0.01]
[parameters]
H = 1e-3
L = 1e-3
V = 1e-3
nu = 1e-6
period = 0.02
[domain]
x = [0, "L"]
y = [0, "H"]
periodic = ["x"]
across = "H"
[fluid]
density = 1000
[exact]
v_y = 0
)toml";

class FlowsInFiles : public testing::Test {
 protected:
  Flow flow(const std::string& text, Settings settings = Settings(), const std::string& name = "mine") const {
    files::write_whole(folder / (name + ".toml"), text);
    return read_flow(folder / (name + ".toml"), std::move(settings));
  }
  std::string refusal(const std::string& text) const {
    try {
      flow(text);
    } catch (const std::exception& error) {  // of this file, or of a table
      const std::string what = error.what();
      const std::size_t at = what.find("mine.toml");
      return at == what.npos ? what : what.substr(at);
    }
    return "read without complaint";
  }
  static std::string with(std::string text, const std::string& part, const std::string& becomes) {
    return text.replace(text.find(part), part.size(), becomes);
  }

  /// The largest difference of two velocities over the largest one, at many places and the times of a flow.
  static double difference(const Flow& one, const VelocityTruth& other) {
    const VelocityTruth velocity = one.velocity();
    double worst = 0, largest = 0;
    for (const double t : one.judged.times)
      for (int k = 0; k < 400; ++k) {
        const Vec2 part(std::fmod(0.618034 * k, 1), (k + 0.5) / 400);
        const Vec2 x = one.filled.low + one.filled.size().cwiseProduct(part);
        worst = std::max(worst, (velocity(x, t) - other(x, t)).norm());
        largest = std::max(largest, other(x, t).norm());
      }
    return worst / largest;
  }

  const programs::ScratchFolder folder;
};

TEST_F(FlowsInFiles, AreThoseThatAreBuiltIn) {
  constexpr double rounding = 1e-13;
  EXPECT_LT(difference(flow(std::string(in_square) + std::string(taylor_green)), flow_named("taylor_green").velocity()),
            rounding);
  EXPECT_LT(difference(flow(std::string(in_square) + "[exact]\nv_x = \"U*sin(k*y)*exp(-nu*k^2*t)\"\nv_y = 0\n"),
                       flow_named("shear_wave").velocity()),
            rounding);
  EXPECT_LT(difference(flow(std::string(in_square) + R"toml(a = "1 + sin(omega*t)/2"
R = "1 + ripple*cos(k*x)*cos(k*y)"
[exact]
v_x = "a*U*(0.3 - cos(k*x)*sin(k*y))/R"
v_y = "a*U*(0.2 + sin(k*x)*cos(k*y))/R"
)toml"),
                       flow_named("manufactured").velocity()),
            rounding);
  const std::string plates(between_plates);
  EXPECT_LT(difference(flow(plates + "v_x = \"V*erfc(y/sqrt(4*nu*t))\"\n"), flow_named("stokes_first").velocity()),
            rounding);
  EXPECT_LT(difference(flow(plates + "v_x = \"V*exp(-d*y)*cos(w*t - d*y)\"\n[let]\nw = \"2*pi/period\"\nd = "
                                     "\"sqrt(w/(2*nu))\"\n"),
                       flow_named("stokes_second").velocity()),
            rounding);
}

TEST_F(FlowsInFiles, HaveThePressureOfTheirFormula) {
  const Flow mine = flow(std::string(in_square) + std::string(taylor_green)), built_in = flow_named("taylor_green");
  const Vec2 x(0.2, 0.35);
  EXPECT_NEAR(mine.pressure()(x, 0.1), built_in.pressure()(x, 0.1), 1e-10);
  EXPECT_EQ(mine.measured.size(), built_in.measured.size()) << "judged alike";
  EXPECT_EQ(mine.start.pressure_at(x), mine.pressure()(x, 0));
}

TEST_F(FlowsInFiles, HaveParametersThatAUserSetsAndThatMayBeWrong) {
  const std::string text =
      with(with(std::string(in_square) + std::string(taylor_green), "Re = 100",
                R"(Re = {value = "U*L*100", unit = "-", words = "Reynolds number", may_be_wrong = true})"),
           "U = 1", R"(U = {value = 1, unit = "m/s", may_be_wrong = "force"})");
  const Flow twice = flow(text, Settings({{"U", 2}}));
  EXPECT_EQ(twice["Re"], 200) << "follows from those before it";
  EXPECT_EQ(twice.case_name(), "mine_U=2");
  ASSERT_EQ(twice.exact[0].causes.size(), 2u);
  EXPECT_EQ(twice.exact[0].causes[0], Cause::force);
  EXPECT_EQ(twice.exact[0].parameters, std::vector<std::string>{"Re"});
  Changes by;
  by(cause_of_parameter(0)) = -0.5;
  const Flow thicker = flow(text, Settings({{"U", 2}, {"Re", 100}}));
  const Vec2 x(0.1, 0.2);
  EXPECT_LT((twice.exact[0].with(by)(x, 0.5) - thicker.velocity()(x, 0.5)).norm(), 1e-15);
  EXPECT_THROW(flow(text, Settings({{"nu", 1}})), std::invalid_argument) << "follows from parameters and is none";
}

TEST_F(FlowsInFiles, ThatNameAnEquationSolveIt) {
  const std::string solved = "equation = \"navier-stokes\"\n" + std::string(in_square) + std::string(taylor_green);
  EXPECT_NE(flow(solved).residual.find("The formulas solve the Navier-Stokes equations"), std::string::npos);
  EXPECT_NE(refusal(with(solved, "exp(-2*nu", "exp(-1.9*nu")).find("the residual of the momentum equation is 0.00"),
            std::string::npos);
  EXPECT_NE(refusal(with(solved, "-U*cos(k*x)", "U*cos(k*x)")).find("continuity equation"), std::string::npos);
  EXPECT_NE(refusal(with(with(solved, "exp(-2*nu", "exp(-1*nu"), "p = ", "# p = "))
                .find("the residual of the vorticity equation is 0.5"),
            std::string::npos);
  EXPECT_NE(refusal(with(solved, "navier-stokes", "euler"))
                .find("mine.toml:1: equation = 'euler', expected \"navier-stokes\""),
            std::string::npos)
      << refusal(with(solved, "navier-stokes", "euler"));
}

TEST_F(FlowsInFiles, OfOthersSolveTheEquationsThatTheyAreKnownFor) {
  const Flow lamb_oseen = flow_of("lamb_oseen");
  EXPECT_EQ(lamb_oseen.name, "lamb_oseen");
  EXPECT_EQ(lamb_oseen.exact[0].causes, (std::vector{cause_of_parameter(0), Cause::viscosity}));
  const Flow kovasznay = flow_of("kovasznay", Settings({{"L", 2}, {"U", 3}}));
  EXPECT_EQ(kovasznay.across, 2);
  EXPECT_NE(kovasznay.residual, "");
  const Flow driven = flow("equation = \"navier-stokes\"\n" +
                           with(std::string(between_plates), "density = 1000",
                                "density = 1000\nviscosity = \"nu\"\n[force]\nb_x = \"2*nu*V/H^2\"\nb_y = 0") +
                           "p = 0\nv_x = \"V*y/H*(1 - y/H)\"\n");
  EXPECT_DOUBLE_EQ(driven.drive.amplitude.x(), 2e-3);
}

TEST_F(FlowsInFiles, WithAForceThatDependsOnThePlaceSayItToAProgram) {
  const Flow forced =
      flow(std::string(in_square) + std::string(taylor_green) + "[force]\nb_x = \"U^2/L*sin(k*y)*cos(t)\"\nb_y = 0\n");
  ASSERT_TRUE(forced.drive.at);
  EXPECT_EQ(forced.drive.formula.back(), "b_y = 0");
  EXPECT_NEAR(forced.drive.at({0.3, 0.25}, 0).x(), 1, 1e-15);
  ASSERT_EQ(forced.drive.examples.size(), 3u);
}

TEST_F(FlowsInFiles, SayWhereTheyAreWrongAndWhatWasExpected) {
  const std::string good = std::string(in_square) + std::string(taylor_green);
  ASSERT_EQ(refusal(good), "read without complaint");
  for (const auto& [part, becomes, expected] : {
           std::tuple("sin(k*y)*gone", "sin(k*y)*gon",
                      "mine.toml:21:29: v_x = \"-U*cos(k*x)*sin(k*y)*gon\": Unexpected token \"gon\""),
           {"cos(k*y)*gone\"", "cos(k*y*gone\"", "mine.toml:22:"},
           {"rho = 1000", "t = 1000", "mine.toml:6: the name 't', expected letters"},
           {"rho = 1000", "sin = 1000", "mine.toml:6: the name 'sin'"},
           {"rho = 1000", "k = 1000", "mine.toml:18: the name 'k' stands twice"},
           {"rho = 1000", "rho = \"x\"", "mine.toml:6: rho = \"x\", expected a finite number, the same everywhere"},
           {"rho = 1000", "rho = \"1/0\"", "mine.toml:6: rho = \"1/0\" is inf, expected a finite number"},
           {"rho = 1000", "rho = {value = 0, may_be_wrong = true}",
            "may_be_wrong = true, expected a parameter that is not 0"},
           {"rho = 1000", "rho = {value = 1, may_be_wrong = \"mass\"}",
            "may_be_wrong = 'mass', expected true, false, \"viscosity\""},
           {"density = \"rho\"", "density = \"-rho\"",
            "mine.toml:14: fluid.density = '-rho', expected more than 0 (it is -1000)"},
           {"density = \"rho\"", "", "no key 'density' of fluid, expected one such as density = 1000"},
           {"y = [0, \"L\"]", "y = [\"L\", 0]",
            "mine.toml:11: domain.y = [ 'L', 0 ], expected low below high (they are 1 and 0)"},
           {"y = [0, \"L\"]", "y = 1", "mine.toml:11: domain.y = 1, expected two numbers or formulas"},
           {"\"x\", \"y\"]", "\"z\"]", "expected [\"x\"], [\"y\"] or [\"x\", \"y\"]"},
           {"times = [0.1, 1]", "times = [1, 0.1]",
            "], expected increasing ones above 0 [s]"},
           {"times = [0.1, 1]", "", "no key 'times', expected one such as times = [0.5, 1]"},
           {"times = [0.1, 1]", "times = [1]\nschema = \"touchstone flow 2\"", "the only version known here"},
           {"times = [0.1, 1]", "times = [1]\ncommand = \"rm\"",
            "mine.toml:2: unknown key 'command', expected one of:"},
           {"p = ", "q = ", "unknown key 'q' of exact"},
           {"v_x = \"-U", "v_x = \"-sqrt(-1)*U", "the exact velocity at (0.37, 0.41) m and 0.1 s is (nan, "},
           {"v_x = \"-U", "v_x = \"\"#", "mine.toml:21"},
           {"v_x = \"-U", "v_x = true#", "exact.v_x = true, expected a number or a formula"},
       }) {
    const std::string found = refusal(with(good, part, becomes));
    EXPECT_NE(found.find(expected), std::string::npos) << becomes << ": " << found;
    EXPECT_EQ(found.find('\n'), std::string::npos) << found;
  }
  for (const char* known : {"poiseuille", "lamb_oseen"})
    EXPECT_THROW(flow(good, Settings(), known), std::invalid_argument) << "that is another flow";
  EXPECT_THROW(flow_of("pipe"), std::invalid_argument);
}

TEST_F(FlowsInFiles, KnowTheFunctionsOfMathematicalPhysics) {
  const auto value = [](const std::string& text) {
    return formulas::Formulas({{"f", text}}, {"f"}, {{"a", 2.5}})(0.7, 0, 0)[0];
  };
  EXPECT_DOUBLE_EQ(value("erf(x) + erfc(x)"), 1);
  EXPECT_DOUBLE_EQ(value("j0(a)"), -0.048383776468197996);  // Abramowitz & Stegun 1972, table 9.1
  EXPECT_DOUBLE_EQ(value("j1(a)"), 0.49709410246427406);
  EXPECT_NEAR(value("jn(0, a) + jn(2, a) - 2*jn(1, a)/a"), 0, 1e-15);
  EXPECT_NEAR(value("j1(a)*y0(a) - j0(a)*y1(a) - 2/(pi*a)"), 0, 1e-15) << "Wronskian";
  EXPECT_NEAR(value("i0(a)*k1(a) + i1(a)*k0(a) - 1/a"), 0, 1e-15);
  EXPECT_TRUE(std::isnan(value("k0(-1)"))) << "and the program goes on";
  EXPECT_TRUE(std::isnan(value("jn(0.5, 1)")));
  EXPECT_DOUBLE_EQ(value("x < 0.5 ? 1 : 2"), 2);
}

TEST_F(FlowsInFiles, TakeColumnsOfTablesAsFunctions) {
  std::string table = "y [m],v [m/s],w\n";
  for (int k = 0; k <= 40; ++k) table += fmt::format("{},{},0\n", k / 40.0, std::sin(std::numbers::pi * k / 40));
  files::write_whole(folder / "profile.csv", table);
  const std::string text = with(std::string(in_square), "[let]", R"toml([tables]
u = {file = "profile.csv", of = "y [m]", value = "v [m/s]"}
[exact]
v_x = "U*u(y)"
v_y = 0
[let])toml");
  const Flow tabulated = flow(text);
  for (const double y : {0.0, 0.11, 0.5, 0.987, 1.0})
    EXPECT_NEAR(tabulated.velocity()({0.3, y}, 0.1).x(), std::sin(std::numbers::pi * y), 1e-6);
  EXPECT_TRUE(std::isnan(tabulated.velocity()({0.3, 1.01}, 0.1).x())) << "nothing is known there";
  EXPECT_NE(
      refusal(with(text, "profile.csv", "../profile.csv")).find("expected one in the folder of this file or below"),
      std::string::npos);
  EXPECT_NE(refusal(with(text, "v [m/s]", "u [m/s]")).find("no column 'u [m/s]', expected one of: y [m], v [m/s], w"),
            std::string::npos);
  files::write_whole(folder / "profile.csv", "y [m],v [m/s]\n0,0\n1,1\n0.5,1\n");
  EXPECT_NE(refusal(text).find("profile.csv:4: y [m] = 0.5, expected more than 1 above it"), std::string::npos);
}

TEST_F(FlowsInFiles, MakeALadderOfClaimsOfTheirOwn) {
  const Flow claimed =
      flow(std::string(in_square) + std::string(taylor_green) +
           "[claims]\norder_at_least = 1.9\nat_most = 0.5\nfrom_across = 40\nauthor = \"our scheme\"\n");
  ASSERT_EQ(claimed.judged.claims.size(), 1u);
  EXPECT_EQ(claimed.judged.claims[0].lower, 1.9);
  EXPECT_EQ(claimed.judged.claims[0].author.words, "baseline: our scheme");
  ASSERT_EQ(claimed.of_resolved.size(), 1u);
  EXPECT_EQ(claimed.resolved, 40);
}

}  // namespace
}  // namespace touchstone::vnv

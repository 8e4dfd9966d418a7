#include "vnv/command/commands.hpp"
#include "vnv/files/whole_file.hpp"
#include "vnv/programs/scratch_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace touchstone::vnv::command {
namespace order_test {

class OrderOfATable : public testing::Test {
 protected:
  /// What `vnv order` prints of a table, and its exit status.
  std::string said(const std::string& table, std::optional<double> surely_above = std::nullopt, bool are_values = false,
                   const SaidOfTable& of_table = {}) {
    files::write_whole(file, table);
    testing::internal::CaptureStdout();
    std::string refusal;
    try {
      status =
          order({}, {.file = file.string(), .table = of_table, .are_values = are_values, .surely_above = surely_above});
    } catch (const std::invalid_argument& error) {
      refusal = error.what();
    }
    return testing::internal::GetCapturedStdout() + refusal;
  }
  const programs::ScratchFolder folder;
  const std::filesystem::path file = folder.path() / "errors.csv";
  int status = -1;
};

TEST_F(OrderOfATable, IsObservedOfEachColumnInAnyOrderOfTheRows) {
  const std::string words = said("spacing,L2,Linf\n0.1,1e-2,0.1\n0.4,16e-2,0.4\n0.2,4e-2,0.2\n", 0.9);
  EXPECT_NE(words.find("L2: observed order 2 +- "), std::string::npos) << words;
  EXPECT_NE(words.find("Linf: observed order 1 +- "), std::string::npos) << words;
  EXPECT_NE(words.find("between neighbours: 2, 2"), std::string::npos) << words;
  EXPECT_EQ(status, all_holds);
}

TEST_F(OrderOfATable, IsNotSurelyAboveALimitThatItsIntervalReaches) {
  said("spacing,L2\n0.1,1e-2\n0.2,5e-2\n0.4,16e-2\n", 1.9);
  EXPECT_EQ(status, something_fails);
  said("spacing,L2\n0.1,1e-2\n0.2,5e-2\n0.4,16e-2\n");
  EXPECT_EQ(status, all_holds) << "nothing was asked";
}

/// A layout of somebody's table, the column that is judged, and its order.
struct Layout {
  const char* table;
  const char* column;
  double order;
  SaidOfTable said{};
};

const std::vector<Layout> layouts{
    {"N,L2,H1\n2,0.202511,1.00388\n4,0.0510494,0.502255\n8,0.0128262,0.251625\n16,0.00321117,0.125813\n", "L2", 1.993},
    {"cells,u_error,p_error\n20,3.10e-2,4.0e-2\n60,1.79e-2,4.45e-3\n180,1.036e-2,4.94e-4\n540,5.99e-3,5.49e-5\n",
     "u_error", 0.499},
    {"particles,L2\n400,0.25\n1600,0.0625\n6400,0.015625\n", "L2", 2},
    {"particles,L2\n1000,0.4\n8000,0.2\n64000,0.1\n", "L2", 1, {.dimension = 3}},
    {"  nx    dx    error\n 10  1e-1  1e-2\n 20  5e-2  25e-4\n 40  2.5e-2  6.25e-4\n", "error", 2},
    {"h    | Error | Running EOC  \n-----+-------+-------\n0.25 | 1.6   |      \n0.125| 0.4 | 2\n0.0625 | 0.1 | 2\n",
     "Error", 2},
    {"| h | L2 error | order |\n|---|:-:|--:|\n| 0.4 | 4 | - |\n| 0.2 | 2 | 1.0 |\n| 0.1 | 1 | 1.0 |\n", "L2 error", 1},
    {"# dx [m]\tL2 [%]\tCPU time [s]\n0.4\t16\t1\n0.2\t4\t8\n0.1\t1\t64\n", "L2 [%]", 2},
    {"Δx;L1;L∞\n0,4;16;4\n0,2;4;2\n0,1;1;1\n", "L∞", 1},
    {"cycle cells dofs L2\n0 16 25 8e-2\n1 64 81 2.469e-2\n2 256 289 6.92e-3\n", "L2", 2, {.resolution = "dofs"}},
    {"h  L2 error  rate\n0.4 16\n0.2 4 2.0\n0.1 1 2.0\n", "L2 error", 2},
    {"scheme,spacing,L2\nWCSPH,0.4,16\nWCSPH,0.2,4\nWCSPH,0.1,1\n", "L2", 2},
    {"nx, L2\n\n10, 1.6D-01\n20, 0.4D-01\n40, 0.1D-01\n# made by hand\n", "L2", 2},
    {"$h/H$ & $L_2$ \\\\\n0.4 & 16 \\\\\n0.2 & 4 \\\\\n0.1 & 1 \\\\\n", "$L_2$", 2},
    {"0.4 16\n0.2 4\n0.1 1\n", "column 2", 2, {.told_by = "spacing"}},
    {"resolution,L2\n10,4\n20,2\n40,1\n", "L2", 1, {.told_by = "across"}},
    {"1/h,L2\n10,4\n20,2\n40,1\n", "L2", 1},
    {"H/dx,L2\n10,16\n20,4\n40,1\n", "L2", 2},
    {"h/dp,D/dp [-],L2\n1.2,10,16\n1.3,20,4\n1.4,40,1\n", "L2", 2},
    {"$L_0/h$ & L2 \\\\\n10 & 16 \\\\\n20 & 4 \\\\\n40 & 1 \\\\\n", "L2", 2},
    {"Δx/H,L2\n0.4,16\n0.2,4\n0.1,1\n", "L2", 2},
    {"h/H,L2\n0.4,16\n0.2,4\n0.1,1\n", "L2", 2},
    {"cells,L2\n1000,16\n8000,4\n64000,1\n", "L2", 2, {.dimension = 3}},
    {"cycle | # cells | # dofs | L2\n0 | 4 | 9 | 16\n1 | 16 | 25 | 4\n2 | 64 | 81 | 1\n", "L2", 2},
    {"nx,nz,H,U,L2\n10,1,3,2,16\n20,1,3,2,4\n40,1,3,2,1\n", "L2", 2},
    {"N,dx,L2\n100,0.1,16\n400,0.05,4\n1600,0.025,1\n", "L2", 2},
    {"N,L2\n10000,16\n40000,4\n160000,1\n", "L2", 1, {.told_by = "across"}},
    {"\xEF\xBB\xBFM,L2\n10,16\n20,4\n40,1\n", "L2", 2, {.resolution = "M", .told_by = "across"}},
    {"\"N\", \"L2, velocity\"\n10,16\n20,4\n40,1\n", "L2, velocity", 2},
    {"dt,error\n0.4,16\n0.2,4\n0.1,1\n", "error", 2},
    {"grid size,L2\n0.4,16\n0.2,4\n0.1,1\n", "L2", 2},
    {"element size [m],L2\n0.4,16\n0.2,4\n0.1,1\n", "L2", 2},
    {"inter-particle distance,L2\n0.4,16\n0.2,4\n0.1,1\n", "L2", 2},
    {"elements,L2\n1000,16\n8000,4\n64000,1\n", "L2", 2, {.dimension = 3}},
    {"total cells,L2\n1000,16\n8000,4\n64000,1\n", "L2", 2, {.dimension = 3}},
    {"vertices,L2\n100,16\n400,4\n1600,1\n", "L2", 2},
    {"# nodes,L2\n100,16\n400,4\n1600,1\n", "L2", 2, {.dimension = 2}},
};

TEST_F(OrderOfATable, KnowsTheResolutionByItsHeadingInManyLayouts) {
  for (const auto& [table, column, expected, with] : layouts) {
    said(table, {}, false, with);
    const OrderTable read = order_table(file, with);
    const auto at = std::ranges::find(read.columns, column, &TableColumn::name);
    ASSERT_NE(at, read.columns.end()) << table;
    const double ratio = at->values.front() / at->values.back(),
                 of_spacing = read.spacings.front() / read.spacings.back();
    EXPECT_NEAR(std::log(ratio) / std::log(of_spacing), expected, 0.01 * expected) << table;
    EXPECT_EQ(status, all_holds) << table;
  }
}

TEST_F(OrderOfATable, LeavesAloneWhatIsNoError) {
  const std::string words = said("run,N,L2,L2 order,CPU [s]\na,10,4,-,1\nb,20,2,1,2\nc,40,1,1,4\n");
  EXPECT_NE(words.find("\nleft alone: run, L2 order, CPU [s]\nL2: observed order 1 +- "), std::string::npos) << words;
  EXPECT_NE(
      said("N,error of the order,decay rate error\n10,4,4\n20,2,2\n40,1,1\n").find("left alone: error of the order\n"),
      std::string::npos);
}

TEST_F(OrderOfATable, LeavesAloneParametersCostsAndOrdersByTheirValuesToo) {
  const std::string words = said(
      "h,Re,h/dx,threads,Elapsed,L2,p\n0.4,100,1.2,1,5,16,nan\n0.2,100,1.3,2,9,4,2.0\n0.1,100,1.4,4,30,1,2.0\n", 1.5);
  EXPECT_NE(words.find("left alone: h/dx, threads, Elapsed, Re (constant), p (orders of L2)\nL2: observed order 2"),
            std::string::npos)
      << words;
  EXPECT_EQ(status, all_holds);
  EXPECT_NE(said("h,u,p\n0.4,16,4\n0.2,4,2\n0.1,1,1\n").find("p: observed order 1 "), std::string::npos) << "pressure";
  EXPECT_EQ(said("N,Cd,Cl\n20,1.125,0.3\n40,1.03125,0.15\n80,1.0078125,0.075\n", {}, true).find("left alone"),
            std::string::npos);
}

TEST_F(OrderOfATable, TakesAnErrorWhateverTimeOrTemperatureItsHeadingSpeaksOf) {
  for (const char* heading : {"L2 at t=1", "L2(t=0.5)", "t=0.1", "u (t = 1e-1)", "L2_T", "L2 t", "e_t", "e_T", "L∞ T",
                              "$L_2$ T", "L2 run 1", "error at time 2", "order 1 scheme", "L2 order 2 scheme"}) {
    const std::string words = said(fmt::format("h,{}\n0.4,16\n0.2,4\n0.1,1\n", heading));
    EXPECT_NE(words.find(fmt::format("{}: observed order 2 ", heading)), std::string::npos) << words;
  }
  for (const char* heading : {"t", "T", "time [s]", "CPU time (t=1)", "L2 order", "L2 order (t=1)", "order of L2 t",
                              "solver time", "E_t", "order", "order 1"})
    EXPECT_NE(said(fmt::format("h,{}\n0.4,16\n0.2,4\n0.1,1\n", heading)).find("no column of errors"), std::string::npos)
        << heading;
}

TEST_F(OrderOfATable, TakesTimesForValuesUnlessTheyStandAlone) {
  const auto of = [&](const char* heading) {
    return said(fmt::format("h,{}\n0.4,1.16\n0.2,1.04\n0.1,1.01\n", heading), {}, true);
  };
  for (const char* heading : {"reattachment time", "front t", "T", "T [s]", "period", "t=1", "order 2 scheme"})
    EXPECT_NE(of(heading).find("observed order 2,"), std::string::npos) << of(heading);
  for (const char* heading : {"time", "t [s]", "CPU time", "solver time", "time step 1", "steps", "run", "Cd order"})
    EXPECT_NE(of(heading).find("no column of errors"), std::string::npos) << of(heading);
}

TEST_F(OrderOfATable, BelowAHalfIsAboveALimitThatItsIntervalDoesNotReach) {
  const char* slow = "h,L2\n.1,1e-2\n.05,7.5e-3\n.025,5.625e-3\n.0125,4.22e-3\n";
  const std::string above = said(slow, 0.3);
  EXPECT_NE(above.find("stalled (within 0.5 of 0)\n"), std::string::npos) << above;
  EXPECT_NE(above.find("\nall orders are surely above 0.3, the 95 % interval included\n"), std::string::npos) << above;
  EXPECT_EQ(status, all_holds);
  EXPECT_NE(
      said(slow, 0.45).find("not all orders are surely above 0.45, the 95 % interval included: L2 may be 0.4146\n"),
      std::string::npos);
  EXPECT_EQ(status, something_fails);
}

TEST_F(OrderOfATable, SaysWhyNotAllAreAboveALimit) {
  EXPECT_NE(said("h,L2\n0.1,0.031\n0.05,0.0085\n0.025,0.002875\n0.0125,0.00146875\n0.00625,0.00111719\n"
                 "0.003125,0.0010293\n",
                 0.3)
                .find("included: L2 stalled at a floor, not trusted\n"),
            std::string::npos);
  EXPECT_NE(said("h,L2,e\n0.4,-16,0\n0.2,4,0\n0.1,-1,0\n", 0.3).find("included: L2 not trusted; e no order\n"),
            std::string::npos);
  EXPECT_NE(said("h,L2\n0.2,4\n0.1,1\n", 0.3).find("included: L2 inconclusive\n"), std::string::npos);
  EXPECT_NE(said("h,L2\n0.4,1\n0.2,1.01\n0.1,0.95\n0.05,0.96\n", -1).find("included: L2 not trusted\n"),
            std::string::npos);
  EXPECT_NE(said("h,Cd\n0.1,1\n0.05,1.2\n0.025,1.1\n", 0.3, true).find("above 0.3: Cd not trusted\n"),
            std::string::npos);
}

TEST_F(OrderOfATable, DoesNotTakeAnErrorThatStandsStillForAParameter) {
  EXPECT_NE(said("h,L2,L1 norm\n0.4,16,5\n0.2,4,5\n0.1,1,5\n", 1.5).find("L1 norm: observed order 0"),
            std::string::npos);
  EXPECT_EQ(status, something_fails);
}

TEST_F(OrderOfATable, SaysHowItTookTheResolution) {
  EXPECT_NE(said("N,L2\n10,4\n20,2\n").find("spacing: 1/N, along a side; if it counts all, --dimension\n"),
            std::string::npos);
  EXPECT_NE(said("1/h,L2\n10,4\n20,2\n").find("spacing: h\n"), std::string::npos);
  EXPECT_NE(said("H/dx,L2\n10,4\n20,2\n").find("spacing: 1/(H/dx)\n"), std::string::npos);
  EXPECT_NE(said("dofs,cells,L2\n25,16,4\n81,64,1\n").find("spacing: dofs^(-1/2), as they fill 2 dimensions\n"),
            std::string::npos);
  EXPECT_NE(said("nx,L2\n10,4\n20,2\n", {}, false, {.dimension = 3}).find("1/nx; --dimension is of no effect\n"),
            std::string::npos);
}

TEST_F(OrderOfATable, AsksWhereTheResolutionIsNotKnown) {
  EXPECT_NE(said("0.1 1\n0.2 2\n").find("which of its columns, column 1, column 2, tells the resolution"),
            std::string::npos);
  EXPECT_NE(said("M,L2\n1,2\n2,1\n").find("--told-by spacing, across"), std::string::npos);
  EXPECT_NE(said("h,nx,L2\n0.1,10,4\n0.05,30,2\n").find("columns h and nx tell different resolutions"),
            std::string::npos);
  EXPECT_NE(said("h/dx,L2\n1.2,4\n1.5,2\n").find("which of its columns, h/dx, L2, tells"), std::string::npos);
  EXPECT_NE(said("cells,L2\n10000,4\n40000,2\n").find("cells = 40000, along a side or of all?"), std::string::npos);
  EXPECT_NE(said("N,L2\n1,2\n2,1\n", {}, false, {.resolution = "n"}).find("no column 'n', expected one of: N, L2"),
            std::string::npos);
}

TEST_F(OrderOfATable, IsRefusedOfWhatIsNoLadder) {
  EXPECT_NE(said("spacing\n0.1\n0.2\n").find("no row of numbers"), std::string::npos);
  EXPECT_EQ(said("h,\x1b[2J\n0.1,1\n0.2,\x1b[2J\n").find('\x1b'), std::string::npos) << "a terminal obeys it";
  EXPECT_NE(said("spacing,CPU time\n0.1,1\n0.2,1\n").find("no column of errors"), std::string::npos);
  EXPECT_NE(said("spacing,L2\n-0.1,1\n0.2,2\n").find("row 1: spacing = -0.1, expected a positive number"),
            std::string::npos);
  EXPECT_NE(said("spacing,L2\n0,1\n0.2,2\n").find("row 1: spacing = 0, expected a positive number"), std::string::npos);
  EXPECT_NE(said("spacing,L2\n0.1,1\n").find("one resolution makes no order"), std::string::npos);
  EXPECT_NE(said("spacing,L2\n0.1,1\n0.1,2\n").find("rows 1 and 2: spacing = 0.1 twice"), std::string::npos);
  EXPECT_NE(said("spacing,L2\n0.1,1\n0.2,2\n0.3,4,5\n").find("errors.csv:4: 3 cells, expected 2"), std::string::npos);
  EXPECT_NE(said("spacing,L2\n0.1,1\n0.2,diverged\n").find("errors.csv:3: '0.2,diverged', expected a row of numbers"),
            std::string::npos);
}

TEST_F(OrderOfATable, IsNotTrustedOfErrorsThatRiseAndFall) {
  const std::string words = said("h,L2\n0.8,64\n0.4,1\n0.2,4\n0.1,0.1\n", 0.1);
  EXPECT_NE(words.find("not trusted: the errors do not fall"), std::string::npos) << words;
  EXPECT_EQ(status, something_fails);
}

TEST_F(OrderOfATable, IsNoneOfErrorsThatAreZeroOrNoNumbers) {
  const std::string zero = said("h,L2,Linf\n0.4,16,0\n0.2,4,0\n0.1,1,0\n");
  EXPECT_NE(zero.find("Linf: zero at each resolution, exact to rounding: no order\n"), std::string::npos) << zero;
  EXPECT_EQ(status, all_holds);
  EXPECT_NE(said("h,L2\n0.4,16\n0.2,4\n0.1,0\n", 1).find("L2: row 3 is exactly zero"), std::string::npos);
  EXPECT_EQ(status, something_fails);
  for (const bool are_values : {false, true})
    for (const char* odd : {"nan", "inf"}) {
      const std::string words = said(fmt::format("h,L2,Linf\n0.4,16,4\n0.2,{},2\n0.1,1,1\n", odd), {}, are_values);
      EXPECT_NE(words.find(fmt::format("L2: row 2 is {}, expected a finite number", odd)), std::string::npos) << words;
      EXPECT_NE(words.find("Linf"), std::string::npos) << words;
      EXPECT_EQ(status, something_fails);
    }
}

TEST_F(OrderOfATable, OfSignedErrorsIsThatOfTheirMagnitudes) {
  const std::string words = said("h,error\n0.4,-16\n0.2,-4\n0.1,-1\n", 1.5);
  EXPECT_NE(words.find("error: observed order 2 "), std::string::npos) << words;
  EXPECT_NE(words.find("  of the magnitudes of signed errors\n"), std::string::npos) << words;
  EXPECT_EQ(status, all_holds);
  EXPECT_NE(said("h,error\n0.4,-16\n0.2,4\n0.1,-1\n", 1.5).find("not trusted: the errors change sign"),
            std::string::npos);
  EXPECT_EQ(status, something_fails);
}

TEST_F(OrderOfATable, IsAsymptoticAboveAFloorNotOfErrorsThatFallToIt) {
  const std::string stalled =
      said("h,L2\n0.1,0.031\n0.05,0.0085\n0.025,0.002875\n0.0125,0.00146875\n0.00625,0.00111719\n0.003125,0.0010293\n");
  EXPECT_NE(stalled.find("stalled\n  above a floor of 0.001"), std::string::npos) << stalled;
  EXPECT_EQ(stalled.find("asymptotic"), std::string::npos) << stalled;
  const std::string falls = said("h,L2\n0.4,0.481\n0.2,0.121\n0.1,0.031\n0.05,0.0085\n0.025,0.002875\n");
  EXPECT_NE(falls.find("converging\n  above a floor of 0.001 +- "), std::string::npos) << falls;
  EXPECT_NE(falls.find(", asymptotic\n  between"), std::string::npos) << falls;
}

TEST_F(OrderOfATable, OfValuesThatTellNoneLeavesThe95PercentIntervalOfTheSources) {
  EXPECT_NE(said("h,Cd\n0.1,1\n0.05,1.2\n0.025,1.1\n", {}, true)
                .find("numerical uncertainty 0.6 (54.5 %) at 95 %: 3 times the range"),
            std::string::npos);
  EXPECT_NE(said("h,Cd\n0.1,1\n0.05,0.5\n0.025,0.499\n", {}, true).find("numerical uncertainty 0.1 (20.1 %) at 95 %"),
            std::string::npos);
}

TEST_F(OrderOfATable, OfValuesIsToldWithTheirExtrapolationAndTheGridConvergenceIndex) {
  const std::string words = said("spacing,drag\n1,1.1\n4,2.6\n2,1.4\n", 1.9, true);
  EXPECT_NE(words.find("drag at spacings 4, 2, 1: observed order 2, extrapolated to 1, "
                       "grid convergence index 0.125 (11.4 %)"),
            std::string::npos)
      << words;
  EXPECT_EQ(status, all_holds);
  EXPECT_NE(said("N,Cd\n20,1.125\n40,1.03125\n80,1.0078125\n", {}, true)
                .find("extrapolated to 1, grid convergence index 0.00977 (0.969 %)"),
            std::string::npos);
  EXPECT_NE(said("spacing,drag\n1,1\n2,3\n4,2\n", 1, true).find("oscillates"), std::string::npos);
  EXPECT_EQ(status, something_fails);
  EXPECT_NE(said("spacing,drag\n1,1\n2,3\n", {}, true).find("2 resolutions, expected at least 3"), std::string::npos);
}

TEST_F(OrderOfATable, OfValuesIsNotTrustedFarAboveTheFormalOne) {
  const std::string words = said("h,drag\n0.1,1\n0.05,0.5\n0.025,0.49\n", 1, true);
  EXPECT_NE(words.find("observed order 5.644, above the formal order 2 (--formal-order) and not trusted"),
            std::string::npos)
      << words;
  EXPECT_EQ(words.find("grid convergence index 0.0002"), std::string::npos);
  EXPECT_EQ(status, something_fails);
}

}  // namespace order_test
}  // namespace touchstone::vnv::command

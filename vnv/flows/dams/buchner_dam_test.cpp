#include "vnv/flows/dams/buchner_dam.hpp"

#include "vnv/files/tables.hpp"
#include "vnv/measures/impact.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace touchstone::vnv::open_dam {
namespace {

double value_of(const std::vector<Value>& all, const std::string& name) {
  for (const Value& value : all)
    if (value.quantity.name == name) return value.value;
  return not_a_number;
}

constexpr std::size_t mass = 3, inside = 4, level_h2 = 8, level_h1 = 9, pressure = 10, fitted = 11, columns = 12;

std::vector<double> row(const DamFront& dam) {
  std::vector<double> values(columns, 0.0);
  values[mass] = dam.density * dam.column_length * dam.column_height;
  values[inside] = 1;
  return values;
}

/// What the comparison finds of a run that reads what was measured, but so much earlier, of T_H, and with pressures on
/// the disc times a factor at some T_H.
std::vector<Value> found_of_measured(
    double earlier, const std::function<double(double)>& times = [](double) { return 1.0; }) {
  const auto experiment = [](const char* name) { return data_folder() / "experiments" / name; };
  const DataTable table = read_table(experiment("zhou_1999_levels.csv"));
  const Series h2 = series_of(table.only("gauge", "h2"), "T_H [-]", "h [m]"),
               h1 = series_of(table.only("gauge", "h1"), "T_H [-]", "h [m]"),
               p = series_of(read_table(experiment("buchner_2002_pressure.csv"))
                                 .only("series", "trixi"),
                             "T_H [-]", "P1 [-]");
  const double unit = std::sqrt(0.6 / 9.81);
  Run run;
  run.summary = {.level = "20 across", .spacing = 0.03, .end_time = 2, .finished = true};
  for (int k = 0; k <= 4500; ++k) {  // until all data have ended
    const double T = 2e-3 * k, then = T + earlier;
    std::vector<double> values = row(buchner);
    const auto at = [&](const Series& series) {
      return std::isnan(value_at(series, then)) ? 0 : value_at(series, then);
    };
    values[level_h2] = at(h2);
    values[level_h1] = at(h1);
    values[pressure] = values[fitted] = 1000 * 9.81 * 0.6 * at(p) * times(T);
    run.history.time.push_back(T * unit);
    run.history.values.push_back(values);
  }
  return beside_buchner("", "").measurements[0]({.name = "20 across", .spacing = 0.03}, run);
}

TEST(OpenDam, FindsAPlantedClockAndPutsItRight) {
  for (const double earlier : {-0.08, 0.0, 0.08}) {
    const std::vector<Value> found = found_of_measured(earlier);
    EXPECT_NEAR(value_of(found, "clock shift by h2, T_H, at most 0.1"), earlier, 3e-3);
    EXPECT_NEAR(value_of(found, "clock shift by the rise of Buchner, T_H, at most 0.3"), earlier, 3e-3);
    EXPECT_LT(value_of(found, levels_rms.name), 5e-3);
    EXPECT_LT(value_of(found, "RMS error of p/(rho g H), rise to T_H = 5.5, clock of the rise"), 0.01);
    EXPECT_NEAR(value_of(found, "first peak, over the measured"), 1, 0.01);
    EXPECT_NEAR(value_of(found, "second peak, over the measured"), 1, 0.01);
    EXPECT_NEAR(value_of(found, plateau.name), 1, 0.005);
  }
}

TEST(OpenDam, TellsOfAnImpactEachPartByItsOwnTimes) {
  const double rise = value_of(found_of_measured(0), "rise of the pressure, T_H");
  const auto half_as_much_more = [&](double from, double to) {
    return found_of_measured(0, [=](double T) { return T >= rise + from && T <= rise + to ? 1.5 : 1.0; });
  };
  struct Part {
    std::string name;
    double from, to;  // of T_H after the rise
  };
  const std::vector<Part> parts{{"first peak, over the measured", 0, 1},
                                {"impulse, 1 of T_H after the rise, over the measured", 0, 1},
                                {plateau.name, 1, 2},
                                {"second peak, over the measured", 2.5, 4.5}};
  for (const auto& [from, to] : {std::pair(0.01, 1.0), {1.0, 2.0}, {2.0, 2.49}, {2.51, 4.5}}) {
    const std::vector<Value> found = half_as_much_more(from, to);
    for (const Part& part : parts)
      EXPECT_NEAR(value_of(found, part.name), part.from < to && from < part.to ? 1.5 : 1, 0.02)
          << part.name << " with more from " << from;
  }
}

TEST(OpenDam, TakesForTheWayFromGaugeToWallTheTimesOfOneExperiment) {
  const auto measured = [](const char* file) {
    return read_table(data_folder() / "experiments" / file);
  };
  const Series h2 = series_of(
                   measured("zhou_1999_levels.csv").only("gauge", "h2"),
                   "T_H [-]", "h [m]"),
               p = series_of(measured("zhou_1999_pressure.csv"), "T_H [-]",
                             "P2 [-]");
  const double way = impacts::first_above(p, 0.2) - impacts::first_above(h2, 0.02);
  for (const double earlier : {0.0, 0.08}) {
    const std::vector<Value> found = found_of_measured(earlier);
    EXPECT_NEAR(value_of(found, travel.name) * way,
                value_of(found, "rise of the pressure, T_H") - value_of(found, "arrival T_H at h2"), 1e-9);
  }
}

TEST(OpenDam, HidesNoMoreThanTheDoubtAboutTheOrigin) {
  const std::vector<Value> found = found_of_measured(0.5);
  EXPECT_NEAR(value_of(found, "clock shift that h2 needs, T_H"), 0.5, 3e-3);
  EXPECT_EQ(value_of(found, "clock shift by h2, T_H, at most 0.1"), 0.1);
  EXPECT_EQ(value_of(found, "clock shift by the rise of Buchner, T_H, at most 0.3"), 0.3);
  EXPECT_GT(value_of(found, levels_rms.name), 0.02);
  EXPECT_GT(value_of(found, "RMS error of p/(rho g H), rise to T_H = 5.5, clock of the rise"), 0.05);
}

TEST(OpenDam, ShiftsNoClockWithoutBothEvents) {
  EXPECT_TRUE(std::isnan(clock_shift(1, not_a_number, 0.1).applied));
  EXPECT_EQ(clock_shift(1, 3, 0.1).applied, -0.1);
}

/// What is found of a block of water that reaches as far as Martin & Moyce measured, but so much earlier, of T.
std::vector<Value> found_of_front(double earlier) {
  const DamFront dam = column(0.06, 0.06, 0.36);
  const DataTable table =
      read_table(data_folder() / "experiments" / "martin_moyce_1952_front_square.csv")
          .only("series", "table");
  const FrontHistory front{table.numbers("T [-]"), table.numbers("L [-]")};
  constexpr double spacing = 0.003;
  Run run;
  run.summary = {.level = "20 across", .spacing = spacing, .end_time = 2, .finished = true};
  run.history = {{0}, {row(dam)}};
  for (double T = 0; T < 7; T += 0.05) {
    const double then = T + earlier, last = front.T.back(),
                 L = then < last ? front_at(front, then) : front.L.back() + 1.42 * (then - last),
                 length = dam.column_length * std::clamp(L, 0.5, 6.0);
    const Index across = std::lround(length / spacing), n = 3 * across;
    Samples s{T / dam.scaled_time(1),     Vectors(2, n),
              Vectors::Zero(2, n),        Scalars::Constant(n, 1000 * length / static_cast<double>(across) * spacing),
              Scalars::Constant(n, 1000), Scalars::Zero(n)};
    for (Index p = 0; p < n; ++p)
      s.x.col(p) = Vec2((static_cast<double>(p % across) + 0.5) * length / static_cast<double>(across),
                        (static_cast<double>(p / across) + 0.5) * spacing);
    run.samples.push_back(s);
  }
  return beside_fronts("", "", dam, 6.3).measurements[0]({.name = "20 across", .spacing = spacing}, run);
}

TEST(OpenDam, FindsThePlantedClockOfAFrontAndNoMoreThanItsBound) {
  const std::string against = "Martin & Moyce 1952, " + DamFront::of_thin_slab;
  for (const double earlier : {-0.2, 0.1, 0.5}) {
    const std::vector<Value> found = found_of_front(earlier);
    EXPECT_NEAR(value_of(found, "best time shift in T against " + against), std::min(earlier, 0.3), 0.01);
    EXPECT_NEAR(value_of(found, DamFront::rms_at_best_shift_of(DamFront::of_thin_slab, "Martin & Moyce 1952").name),
                earlier > 0.3 ? 0.2 * 1.42 : 0, 0.02);
    EXPECT_NEAR(value_of(found, DamFront::speed_error_of(DamFront::of_thin_slab, "Martin & Moyce 1952").name), 0, 3);
  }
}

}  // namespace
}  // namespace touchstone::vnv::open_dam

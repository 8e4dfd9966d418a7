#include "vnv/flows/dams/gated_dam_ensemble.hpp"
#include "vnv/flows/dams/gated_dam_validation.hpp"
#include "vnv/judge/input_uncertainty.hpp"
#include "vnv/record/record.hpp"

#include <gtest/gtest.h>

namespace touchstone::vnv::gated_dam {
namespace {

/// Water at rest, 0.2 m deep, from wall to wall.
Samples lake(double spacing) {
  const int columns = static_cast<int>(std::round(tank_length / spacing)),
            rows = static_cast<int>(std::round(0.2 / spacing));
  const double width = tank_length / columns;
  const Index n = columns * rows;
  Samples s{0,
            Vectors(2, n),
            Vectors::Zero(2, n),
            Scalars::Constant(n, 997 * width * spacing),
            Scalars::Constant(n, 997),
            Scalars(n)};
  for (Index p = 0; p < n; ++p) {
    s.x.col(p) =
        Vec2((static_cast<double>(p % columns) + 0.5) * width, (static_cast<double>(p / columns) + 0.5) * spacing);
    s.pressure[p] = 997 * 9.81 * (0.2 - s.x(1, p));
  }
  return s;
}

TEST(GatedDam, ReadsWaterAtRestAsItIs) {
  const std::vector<double> row = monitored.evaluate(lake(0.01));
  ASSERT_EQ(row.size(), monitored.quantities.size());
  EXPECT_EQ(row[column::kinetic], 0);
  EXPECT_NEAR(row[column::potential], 997 * 9.81 * tank_length * 0.2 * 0.1, 1e-6);
  EXPECT_EQ(row[column::elastic], 0);
  EXPECT_NEAR(row[column::front_percentile], tank_length, 0.011);
  for (std::size_t k = 0; k < gauges.size(); ++k) EXPECT_NEAR(row[column::level + 3 * k], 0.2, 1e-3);
  for (std::size_t k = 0; k < sensors.size(); ++k) {
    EXPECT_NEAR(row[column::fit + 3 * k], 997 * 9.81 * (0.2 - sensors[k]), 1e-3);
    EXPECT_NEAR(row[column::fit + 3 * k + 1] - row[column::fit + 3 * k + 2], 997 * 9.81 * 2 * sensor_uncertainty,
                k ? 1e-3 : 3);
    EXPECT_NEAR(row[column::patch + 3 * k], 997 * 9.81 * (0.2 - sensors[k]), 60);
  }
}

TEST(GatedDam, CountsTheEnergyOfCompression) {
  Samples compressed = lake(0.01);
  compressed.density *= 1.01;
  const double volume = compressed.mass.sum() / 997;  // at rest
  // p from 0 to 7 K 0.01 as the volume shrinks by 0.0099
  EXPECT_NEAR(monitored.evaluate(compressed)[column::elastic], 7 * 0.36e6 * 0.01 * 0.0099 / 2 * volume,
              0.03 * 125 * volume);
}

TEST(GatedDam, ReadsGaugesAndSensorsAsFarOffAsTheirTableSays) {
  const auto uncertain = read_inputs(data_folder() / "experiments" / "lobovsky_2014_inputs_300.csv");
  EXPECT_EQ(input_named(place_of_gauges, uncertain).half_width, gauge_uncertainty);
  EXPECT_EQ(input_named(height_of_sensors, uncertain).half_width, sensor_uncertainty);
  EXPECT_EQ(input_named(clock_of_pressures, uncertain).half_width, clock_uncertainty);
}

TEST(GatedDam, TakesItsInputsFromTheTableOfTheirUncertainties) {
  for (const Experiment* experiment : {&with_300, &with_600}) {
    const Inputs& inputs = experiment->inputs;
    const auto uncertain = read_inputs(data_folder() / "experiments" / experiment->inputs_file);
    EXPECT_EQ(input_named("gate speed", uncertain).value, inputs.gate_speed);
    EXPECT_EQ(input_named("gate acceleration", uncertain).value, inputs.gate_acceleration);
    EXPECT_EQ(input_named("column height", uncertain).value, inputs.height);
    EXPECT_EQ(input_named("density", uncertain).value, inputs.density);
    EXPECT_EQ(input_named("gravity", uncertain).value, inputs.gravity);
    for (const Observable& one : experiment->observables()) EXPECT_TRUE(std::isfinite(one.measured));
  }
}

TEST(GatedDam, HasAGateThatLeavesTheWaterAtItsMeanSpeedHoweverItComesToIt) {
  const double left = filled_300.height / filled_300.gate_speed;
  for (const double acceleration : {0.0, 0.5, 1.0}) {
    Inputs inputs = filled_300;
    inputs.gate_acceleration = acceleration;
    const Wall gate = collapse(inputs).walls.back();
    EXPECT_TRUE(gate.is_beside({0.6, 0.3}, 0.999 * left)) << acceleration;
    EXPECT_FALSE(gate.is_beside({0.6, 0.3}, 1.001 * left)) << acceleration;
    const double half_way = filled_300.height * (0.5 - 0.25 * acceleration);  // at half that time
    EXPECT_TRUE(gate.is_beside({0.6, half_way + 1e-6}, left / 2)) << acceleration;
    EXPECT_FALSE(gate.is_beside({0.6, half_way - 1e-6}, left / 2)) << acceleration;
  }
}

TEST(GatedDam, HasObservablesThatTheExperimentItselfMeets) {
  const Observed first = measured_300(1), second = measured_300(2);
  for (const Observable& one : observables_300()) {
    EXPECT_TRUE(std::isfinite(one.measured)) << one.quantity.name;
    if (one.clock == clock_of_pressures || one.quantity.name.ends_with("at P2")) continue;  // of the band
    const double low = std::min(one.of(first), one.of(second)), high = std::max(one.of(first), one.of(second));
    const double slack = std::isnan(one.standard) ? 0.2 * one.measured : 2 * one.standard;
    EXPECT_LE(low - slack, one.measured) << one.quantity.name;
    EXPECT_GE(high + slack, one.measured) << one.quantity.name;
  }
}

/// A run in which all that is measured of the front is 1 + `error` times as far.
Run run_with(const std::string& level, double spacing, double error) {
  const Observed measured = measured_300();
  Run run;
  run.summary = {.level = level, .spacing = spacing, .end_time = 1.3, .finished = true};
  for (std::size_t k = 0; k < measured.front.time.size(); ++k) {
    std::vector<double> row(column::count, 0.0);
    row[column::front_of_film] = column_length + (1 + error) * measured.front.value[k] * filled_300.height;
    run.history.time.push_back(measured.front.time[k] * filled_300.unit_of_time());
    run.history.values.push_back(row);
  }
  return run;
}

TEST(Validation, FindsAnErrorOfTheModelAndWhatResolutionLeavesOpen) {
  Method named{.name = "made_up"};
  const Method method = validated(with_300, {[&](const auto&) { return named; }});
  Results results{method, Suite::validation, {}};
  for (const Level& level : method.levels)  // of first order: 4 to 1/4 % too far, and 10 % in any case
    results.runs.push_back(run_with(level.name, level.spacing, 0.1 + 0.01 * level.spacing / (0.3 / 80)));
  const ValidatedObservable front = judgements(results, with_300)[2];
  ASSERT_EQ(front.observable.quantity.name, "front x/H at T_H = 2");
  const double D = front.observable.measured;
  EXPECT_NEAR(front.validation.error, 0.1025 * D, 1e-9);
  EXPECT_NEAR(front.validation.parts.numerical, 1.25 * 0.0025 * D / 1.15, 1e-9);
  EXPECT_EQ(front.validation.outcome, Validation::Outcome::model_error) << words(front.validation, "");
}

/// A run that has the level H2 of the experiment, and at P2 the median of the repeats, `times` as high and `late`
/// [T_H].
Run run_like_the_repeats(const std::string& level, double times, double late) {
  const Series pressure = band_of_P2()[1].second, of_level = measured_300().levels[1];
  Run run;
  run.summary = {.level = level, .spacing = 0.3 / 80, .end_time = 1.3, .finished = true};
  for (int k = 0; k <= 700; ++k) {
    const double T = 0.01 * k, p = value_at(pressure, T - late), h = value_at(of_level, T);
    std::vector<double> row(column::count, 0.0);
    row[column::fit + 3] = times * filled_300.unit_of_pressure() * (std::isnan(p) ? 0 : p);
    row[column::level + 3] = filled_300.height * (std::isnan(h) ? 0 : h);
    run.history.time.push_back(T * filled_300.unit_of_time());
    run.history.values.push_back(row);
  }
  return run;
}
std::map<std::string, double> ensemble_of_runs(double times, double late, double last = 1) {
  const Method method{.name = "made_up"};
  Results results{method, Suite::validation, {}};
  for (int start = 1; start <= 6; ++start)  // about the median
    results.runs.push_back(run_like_the_repeats(fmt::format("80 across, start {}", start),
                                                times * (1 + 0.005 * (start - 3.5)) * (start >= 5 ? last : 1), late));
  std::map<std::string, double> found;
  for (const Value& value : ensemble_values(results, {})) found[value.quantity.name] = value.value;
  return found;
}

TEST(AnEnsemble, ThatIsTheExperimentIsWithinItsBandAndNotUnlikeIt) {
  const auto alike = ensemble_of_runs(1, 0.1);
  EXPECT_NEAR(alike.at(median_inside_band.name), 1, 0.02);
  EXPECT_EQ(alike.at(unlike_repeats.name), 0);
  const auto higher = ensemble_of_runs(1.5, 0);
  EXPECT_LT(higher.at(median_inside_band.name), 0.2);
  EXPECT_GE(higher.at(unlike_repeats.name), 8);
  EXPECT_NEAR(ensemble_of_runs(1, 0.1, 100).at(median_inside_band.name), 1, 0.02)
      << "two starts far off leave the median where it is";
}

TEST(AnEnsemble, IsSetNoEarlierThanItsClockIsInDoubt) {
  const double uncertainty = clock_uncertainty / filled_300.unit_of_time();
  const auto late = run_like_the_repeats("", 1, 0.4), little = run_like_the_repeats("", 1, 0.1);
  const auto arrival = [](const Series& pressure) { return impact_on(pressure).arrival; };
  const double measured = arrival(band_of_P2()[1].second);
  EXPECT_NEAR(arrival(aligned_by_arrival(observed_in(little, filled_300).pressures[1])), measured, 1e-3);
  EXPECT_NEAR(arrival(aligned_by_arrival(observed_in(late, filled_300).pressures[1])), measured + 0.4 - uncertainty,
              0.01);
}

TEST(Validation, RunsSkinFrictionOfALaminarAndOfATurbulentPlate) {
  std::vector<double> coefficients;
  const auto smooth = [](const auto&) { return Method{.name = "made_up"}; };
  const auto rough = [&](const Scene<Tait, SkinFriction>& scene) {
    return Method{.name = "made_up", .run = [&, scene](const Level& level, const Schedule&) {
                    coefficients.push_back(scene.body_force.coefficient);
                    return run_with(level.name, level.spacing, 0);
                  }};
  };
  const Method method = validated(with_300, {smooth, rough}, {.of_across = {}, .varied = 2});
  Results results{method, Suite::validation, {}};
  for (const Level& level : method.levels)
    if (level.name.starts_with("skin friction")) results.runs.push_back(method.run(level, {}));
  EXPECT_EQ(coefficients, (std::vector{0.0006, 0.0006, 0.002, 0.002, 0.0036, 0.0036}));
  for (const double coefficient : friction_coefficients)
    EXPECT_EQ(runs_with_friction(results, coefficient).size(), 2) << coefficient;
  results.runs.front().summary.finished = false;
  EXPECT_TRUE(runs_with_friction(results, laminar_friction).empty());
}

TEST(Moves, AreConvergedIfAllThreeAreKnownAndSmall) {
  EXPECT_TRUE((Moves{.grid = 0.05, .modulus = -0.08, .sensor = 0.1}.converged()));
  EXPECT_FALSE((Moves{.grid = 0.05, .modulus = -0.08, .sensor = -0.11}.converged()));
  EXPECT_FALSE((Moves{.grid = 0.05, .sensor = 0.02}.converged()));
}

TEST(Validation, RunsNoLevelThatIsNotItsOwn) {
  const Method method = validated(with_300, {[](const auto&) { return Method{.name = "made_up"}; }});
  EXPECT_THROW(method.run({.name = "80 across", .spacing = 1}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace touchstone::vnv::gated_dam

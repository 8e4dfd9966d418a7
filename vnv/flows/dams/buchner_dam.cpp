#include "vnv/flows/dams/buchner_dam.hpp"

#include "vnv/files/tables.hpp"
#include "vnv/measures/impact.hpp"
#include "vnv/measures/wall_pressure.hpp"
#include "vnv/measures/water_level.hpp"
#include "vnv/record/record.hpp"

#include <fmt/format.h>

namespace touchstone::vnv::open_dam {
namespace {

// Columns after those of any column.
const std::size_t gauges_from = monitored_quantities().size(), pressure_from = gauges_from + 2;

constexpr std::array gauges{2.228, 2.725};         // m    h2 and h1, in the order in which they are wet
constexpr double disc = 0.09, disc_height = 0.16;  // m
const double unit_of_time = std::sqrt(buchner.column_height / buchner.gravity),    // s
    unit_of_pressure = buchner.density * buchner.gravity * buchner.column_height;  // Pa
constexpr double before_return = 5.5, at_the_end = 7.9;  // of T_H; the wave that comes back is at h1 at 5.7

std::vector<double> monitored_of_buchner(const Samples& samples) {
  std::vector<double> row = monitored(buchner, samples);
  const double spacing = std::sqrt(samples.mass.maxCoeff() / buchner.density), half_width = std::max(5e-3, spacing);
  for (const double gauge : gauges) {
    const Samples near = within(samples, gauge - 2 * spacing - half_width, gauge + 2 * spacing + half_width);
    row.push_back(near.size() == 0 ? 0 : water_level(near, gauge, half_width, spacing).volume);
  }
  const WallSensor sensor{buchner.tank_length, disc_height, disc};
  const Samples near = within(samples, sensor.wall - disc - 4 * spacing, sensor.wall + spacing);
  row.push_back(near.size() == 0 ? 0 : mean_wall_pressure(near, sensor, spacing));
  row.push_back(near.size() == 0 ? 0 : fitted_wall_pressure(near, sensor, spacing));
  return row;
}

/// h/H at both gauges and p/(rho g H) over T_H, computed or measured.
struct ObservedByBuchner {
  std::array<Series, gauges.size()> levels{};
  Series pressure{}, fitted{};
};

ObservedByBuchner observed_in(const Run& run) {
  ObservedByBuchner observed{.pressure = scaled(followed(run, pressure_from), unit_of_time, 0, unit_of_pressure),
                             .fitted = scaled(followed(run, pressure_from + 1), unit_of_time, 0, unit_of_pressure)};
  for (std::size_t k = 0; k < gauges.size(); ++k)
    observed.levels[k] = scaled(followed(run, gauges_from + k), unit_of_time, 0, buchner.column_height);
  return observed;
}

/// What was measured, and how much the origin of its clock is in doubt, of T_H.
struct Measured {
  ObservedByBuchner observed;
  double origin;
};

DataTable measured_table(const std::string& name) {
  DataTable table = read_table(data_folder() / "experiments" / name);
  require_geometry(table, "column_length", buchner.column_length, 1e-6);
  require_geometry(table, "column_height", buchner.column_height, 1e-6);
  require_geometry(table, "tank_length", buchner.tank_length, 1e-6);
  return table;
}

DataTable pressure_table(const std::string& name) {
  DataTable table = measured_table(name);
  require_geometry(table, "sensor_height", disc_height, 1e-6);
  require_geometry(table, "sensor_diameter", disc, 1e-6);
  return table;
}

Measured measured_by_zhou() {
  const DataTable levels = measured_table("zhou_1999_levels.csv"),
                  pressure = pressure_table("zhou_1999_pressure.csv");
  Measured found{{.pressure = series_of(pressure, "T_H [-]", "P2 [-]")},
                 levels.provenance().uncertainty.at("T_H.origin").value};
  constexpr std::array names{"h2", "h1"};
  for (std::size_t k = 0; k < gauges.size(); ++k) {
    require_geometry(levels, std::string(names[k]) + "_place", gauges[k], 1e-6);
    found.observed.levels[k] =
        scaled(series_of(levels.only("gauge", names[k]), "T_H [-]", "h [m]"), 1, 0, buchner.column_height);
  }
  return found;
}

Measured measured_by_buchner() {
  const DataTable table = pressure_table("buchner_2002_pressure.csv");
  return {{.pressure = series_of(table.only("series", "trixi"), "T_H [-]", "P1 [-]")},
          table.provenance().uncertainty.at("T_H.origin").value};
}

/// When a gauge is wet: a dry one reads 5 mm, and is known to 12.
double wet(const Series& level) { return impacts::first_above(level, 0.02 / buchner.column_height); }

/// The largest sample between two times; not a number where the series does not reach.
double largest(const Series& series, double from, double to) {
  return series.time.front() <= from && series.time.back() >= to ? impacts::largest(series, from, to) : not_a_number;
}

/// What is told of an impact on the disc, T_H after its rise; the wave that comes back falls on it between 2.5 and 4.5.
struct ImpactOnDisc {
  double first_peak, impulse, plateau, second_peak;
};
ImpactOnDisc impact_on(const Series& pressure, double rise) {
  return {largest(pressure, rise, rise + 1), time_integral(pressure, rise, rise + 1),
          time_mean(pressure, rise + 1, rise + 2), largest(pressure, rise + 2.5, rise + 4.5)};
}

std::vector<Value> compared_with_buchner(const Level& level, const Run& run) {
  std::vector<Value> found = conservation_errors(buchner, level, run);
  if (found.empty()) return found;
  const auto add = [&](const Quantity& quantity, double value) {
    found.push_back({level.name, level.spacing, run.summary.end_time, quantity, value});
  };
  const auto rms = [](const std::string& name) { return Quantity{name, "", Kind::error}; };
  const ObservedByBuchner ours = observed_in(run);
  const Measured zhou = measured_by_zhou(), disc_of_buchner = measured_by_buchner();
  // Measured pressures rise from 0 to 0.5 within 0.15, ours slowly. The read-out of Zhou, De Kat & Buchner has noise up
  // to 0.16.
  const double rise = impacts::first_above(ours.pressure, 0.05),
               rise_of_zhou = impacts::first_above(zhou.observed.pressure, 0.2),
               rise_of_buchner = impacts::first_above(disc_of_buchner.observed.pressure, 0.05);
  const ImpactOnDisc impact = impact_on(ours.pressure, rise), fitted = impact_on(ours.fitted, rise),
                     measured = impact_on(disc_of_buchner.observed.pressure, rise_of_buchner);
  const double h2 = wet(ours.levels[0]), measured_h2 = wet(zhou.observed.levels[0]);

  add({"arrival T_H at h2"}, h2);
  add({"arrival T_H at h1"}, wet(ours.levels[1]));
  add({"rise of the pressure, T_H"}, rise);
  const ClockShift by_level = clock_shift(measured_h2, h2, zhou.origin),
                   by_rise = clock_shift(rise_of_buchner, rise, disc_of_buchner.origin);
  add({"clock shift that h2 needs, T_H"}, by_level.needed);
  add({"clock shift by h2, T_H, at most 0.1"}, by_level.applied);
  add({"clock shift that the rise of Buchner needs, T_H"}, by_rise.needed);
  add({"clock shift by the rise of Buchner, T_H, at most 0.3"}, by_rise.applied);
  add(travel, (rise - h2) / (rise_of_zhou - measured_h2));

  const auto rms_of_levels = [&](double until) {
    std::vector<double> all;
    for (std::size_t k = 0; k < gauges.size(); ++k)
      std::ranges::copy(differences(shifted(ours.levels[k], by_level.applied), zhou.observed.levels[k],
                                    wet(zhou.observed.levels[k]), until),
                        std::back_inserter(all));
    return root_mean_square(all);
  };
  add(levels_rms, rms_of_levels(before_return));
  add(rms("RMS error of levels h/H, T_H to 7.9, clock of h2"), rms_of_levels(at_the_end));
  const auto rms_of_pressure = [&](double until) {
    return root_mean_square(differences(shifted(ours.pressure, by_rise.applied), disc_of_buchner.observed.pressure,
                                        rise_of_buchner, until));
  };
  add(rms("RMS error of p/(rho g H), rise to T_H = 5.5, clock of the rise"), rms_of_pressure(before_return));
  add(rms("RMS error of p/(rho g H), rise to the end of the data, clock of the rise"), rms_of_pressure(at_the_end));
  add({"first peak, over the measured"}, impact.first_peak / measured.first_peak);
  add({"first peak, by a fit at the wall, over the measured"}, fitted.first_peak / measured.first_peak);
  add({"impulse, 1 of T_H after the rise, over the measured"}, impact.impulse / measured.impulse);
  add(plateau, impact.plateau / measured.plateau);
  add({"second peak, over the measured"}, impact.second_peak / measured.second_peak);
  return found;
}

Plot over_time(const Figure& frame, const std::function<Series(const ObservedByBuchner&)>& of,
               const std::vector<Curve>& measured) {
  return [=](const Results& results, Record& record) {
    record.figures.push_back(frame);
    if (const Run* run = finest(results)) {
      const Series ours = of(observed_in(*run));
      record.curves.push_back(
          {frame.id, results.method.name + " " + run->summary.level, Role::ours, ours.time, ours.value, false});
    }
    record.curves.insert(record.curves.end(), measured.begin(), measured.end());
  };
}

std::vector<Plot> beside_what_buchner_measured() {
  const Measured zhou = measured_by_zhou(), disc_of_buchner = measured_by_buchner();
  const auto measured = [](const std::string& figure, const std::string& label, const Series& series, Role role) {
    return Curve{figure, label, role, series.time, series.value, true};
  };
  const Axis time{"T_H = t sqrt(g/H)", 1, false, 0, 8};
  std::vector<Plot> plots;
  constexpr std::array names{"h2", "h1"};
  for (std::size_t k = 0; k < gauges.size(); ++k) {
    const std::string id = std::string("level_") + names[k];
    plots.push_back(
        over_time({id,
                   fmt::format("Water level at {}, {:g} m from the back wall", names[k], gauges[k]),
                   "Ours as volume over width. Without time shift; the time origin of the experiment is uncertain by "
                   "0.1.",
                   time,
                   {"h/H", 1, false, 0, 1.2}},
                  [k](const ObservedByBuchner& observed) { return observed.levels[k]; },
                  {measured(id, "Zhou, De Kat & Buchner 1999", zhou.observed.levels[k], Role::experiment)}));
  }
  plots.push_back(over_time(
      {"pressure",
       "Pressure on the far wall, 0.16 m above the floor",
       "Mean over a height of 90 mm, ours sampled every ms. Without time shift; the time origin of Buchner is "
       "uncertain by 0.3, that of Zhou, De Kat & Buchner by 0.1; both are read-outs of one event.",
       {"T_H = t sqrt(g/H)", 1, false, 2, 8},
       {"p/(rho g H)", 1, false, -0.2, 1.5}},
      [](const ObservedByBuchner& observed) { return observed.pressure; },
      {measured("pressure", "Buchner 2002", disc_of_buchner.observed.pressure, Role::experiment),
       measured("pressure", "Zhou, De Kat & Buchner 1999", zhou.observed.pressure, Role::published)}));
  return plots;
}

}  // namespace

ClockShift clock_shift(double measured, double ours, double most) {
  const double needed = measured - ours;
  return {needed, std::clamp(needed, -most, most)};
}

Case beside_buchner(std::string title, std::string description) {
  Case declared = to_the_end(std::move(title), std::move(description), buchner);
  std::vector<Quantity> names = monitored_quantities();
  names.insert(
      names.end(),
      {{"level h2", "m"}, {"level h1", "m"}, {"pressure, mean over the disc", "Pa"}, {"pressure, affine fit", "Pa"}});
  declared.monitor = {.interval = sampled_every, .evaluate = monitored_of_buchner, .quantities = names};
  declared.measurements = {compared_with_buchner};
  declared.plots = beside_what_buchner_measured();
  return declared;
}

}  // namespace touchstone::vnv::open_dam

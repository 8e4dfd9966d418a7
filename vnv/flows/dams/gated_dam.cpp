#include "vnv/flows/dams/gated_dam.hpp"

#include "solvers/walls/free_slip.hpp"
#include "vnv/files/tables.hpp"
#include "vnv/flows/dams/front_comparison.hpp"
#include "vnv/judge/validation.hpp"
#include "vnv/measures/front.hpp"
#include "vnv/measures/impact.hpp"
#include "vnv/measures/wall_pressure.hpp"
#include "vnv/measures/water_level.hpp"
#include "vnv/record/record.hpp"

#include <fmt/format.h>

namespace touchstone::vnv::gated_dam {
namespace {

constexpr double until_return_wave = 5;  // of T_H, until which two runs of the experiment agree

/// Energies by the nominal density, gravity and bulk modulus, also of runs that vary them.
std::vector<double> evaluate(const Samples& samples) {
  const double spacing = std::sqrt(samples.mass.maxCoeff() / filled_300.density);
  std::vector<double> row(column::count);
  std::ranges::copy(
      energies(samples, {.density = filled_300.density, .bulk_modulus = filled_300.bulk_modulus}, filled_300.gravity),
      row.begin() + column::kinetic);
  row[column::front_slab] = half_full_slab(samples, 2 * spacing);
  row[column::front_percentile] = percentile_front(samples) + spacing / 2;
  row[column::front_of_film] = half_full_slab(samples, 2 * capillary_length);
  constexpr std::array sides{0.0, -1.0, 1.0};
  const double gauge = std::max(5e-3, spacing), wall_strip = sensor_diameter + 4 * spacing;
  for (std::size_t k = 0; k < gauges.size(); ++k) {
    const Samples near = within(samples, gauges[k] - 2 * gauge - spacing, gauges[k] + 2 * gauge + spacing);
    for (std::size_t side = 0; side < sides.size(); ++side)
      row[column::level + 3 * k + side] =
          near.size() == 0 ? 0 : water_level(near, gauges[k] + sides[side] * gauge_uncertainty, gauge, spacing).volume;
  }
  const Samples near = within(samples, tank_length - wall_strip, tank_length + spacing);
  for (std::size_t k = 0; k < sensors.size(); ++k)
    for (std::size_t side = 0; side < sides.size(); ++side) {
      const WallSensor sensor{tank_length, sensors[k] + sides[side] * sensor_uncertainty, sensor_diameter};
      row[column::patch + 3 * k + side] = near.size() == 0 ? 0 : mean_wall_pressure(near, sensor, spacing);
      row[column::fit + 3 * k + side] = near.size() == 0 ? 0 : fitted_wall_pressure(near, sensor, spacing);
    }
  return row;
}

std::vector<Quantity> names() {
  std::vector<Quantity> all = quantities_of_energies;
  for (const char* by :
       {"half-full slab of two spacings", "99.5th percentile", "half-full slab of two capillary lengths"})
    all.push_back({fmt::format("front, {}", by), "m"});
  constexpr std::array at{"", ", 1 mm before", ", 1 mm behind"}, height{"", ", 0.5 mm lower", ", 0.5 mm higher"};
  for (std::size_t k = 0; k < gauges.size(); ++k)
    for (const char* where : at) all.push_back({fmt::format("level H{}{}", k + 1, where), "m"});
  for (const char* by : {"mean over a patch", "affine fit"})
    for (std::size_t k = 0; k < sensors.size(); ++k)
      for (const char* where : height) all.push_back({fmt::format("pressure P{}{}, {}", k + 1, where, by), "Pa"});
  return all;
}

DataTable experiment(const std::string& name) {
  DataTable table = read_table(data_folder() / "experiments" / name);
  require_geometry(table, "column_height", filled_300.height, 1e-6);
  require_geometry(table, "tank_length", tank_length, 1e-6);
  return table;
}
DataTable front_table() { return experiment("lobovsky_2014_front_300.csv"); }
/// Of the filling of 0.6 m, x/H from the gate over T_H, which is T of this table.
DataTable front_table_600() {
  DataTable table = read_table(data_folder() / "experiments" / "lobovsky_2014_front_600.csv");
  require_geometry(table, "column_height", filled_600.height, 1e-6);
  return table;
}
Series front_of_600(const DataTable& table) {
  Series front = series_of(table, "T [-]", "L [-]");
  for (double& x : front.value) x -= 1;
  return front;
}
DataTable level_table() { return experiment("lobovsky_2014_levels_300.csv"); }
DataTable event_table() { return experiment("lobovsky_2014_pressure_event_300.csv"); }
DataTable band_table() { return experiment("lobovsky_2014_pressure_band_300.csv"); }

/// RMS difference of two series at the times of the measured one, within a range of T_H.
double rms_between(const Series& ours, const Series& measured, double from, double to) {
  return root_mean_square(differences(ours, measured, from, to));
}

/// A series that is sampled more often at some times than at others, at 361 times as far apart.
Series evenly(const Series& series, double from, double to) {
  Series all;
  for (int k = 0; k <= 360; ++k) {
    all.time.push_back(from + (to - from) * k / 360);
    all.value.push_back(value_at(series, all.time.back()));
  }
  return all;
}

/// dx/dT_H by a straight line.
double speed(const Series& front, double from, double to) {
  return slope_of("our", {front.time, front.value}, {from, to});
}

double speed_of_front(const Observed& observed) { return speed(observed.front, 1, 1.58); }

/// x/H at some T_H, and the speed. There is one curve of each filling: its repeatability is that between fillings, its
/// frames are half of 1/300 s apart.
std::vector<Observable> observables_of_front(const Observed& measured, const std::vector<double>& times,
                                             double repeat) {
  std::vector<Observable> all;
  for (const double T : times) {
    const auto of = [T](const Observed& observed) { return value_at(observed.front, T); };
    all.push_back({{fmt::format("front x/H at T_H = {:g}", T)},
                   of,
                   of(measured),
                   repeat,
                   "RMS difference between fillings of 300 and 600 mm",
                   0.1,
                   clock_of_front});
  }
  all.push_back({{"front speed dx/dT_H over T_H 1 to 1.58, by H"},
                 speed_of_front,
                 speed_of_front(measured),
                 not_a_number,
                 "one curve",
                 0.1});
  return all;
}

/// T_H until which the measured front is judged: then it nears the wall.
constexpr double front_until = 2.4;

}  // namespace

const Monitor monitored{.interval = sampled_every, .evaluate = evaluate, .quantities = names()};

Scene<Tait, Uniform> collapse(const Inputs& inputs) {
  const Tait water{.density = inputs.density, .bulk_modulus = inputs.bulk_modulus};
  Wall gate = right_at(inputs.length, free_slip());
  gate.extent = [inputs](double time) { return Range{inputs.gate_edge(time), 1e3}; };
  return {
      .domain = {.box = {.high = {tank_length, 20 * inputs.height}}},
      .fluid = water,
      .filled = {.high = {inputs.length, inputs.height}},
      .walls = {floor_at(0, free_slip()), left_at(0, free_slip()), right_at(tank_length, free_slip()), gate},
      .body_force = {{0, -inputs.gravity}},
      .start = {.pressure = [=](const Vec2& x) { return inputs.density * inputs.gravity * (inputs.height - x.y()); }}};
}

Observed observed_in(const Run& run, const Inputs& inputs, const ReadOut& read_out) {
  const double unit = inputs.unit_of_time();
  Observed observed{.front = scaled(followed(run, read_out.front), unit, column_length, inputs.height)};
  for (std::size_t k = 0; k < gauges.size(); ++k)
    observed.levels[k] = scaled(followed(run, column::level + 3 * k + read_out.place), unit, 0, inputs.height);
  for (std::size_t k = 0; k < sensors.size(); ++k)
    observed.pressures[k] =
        scaled(followed(run, read_out.pressures + 3 * k + read_out.place), unit, 0, inputs.unit_of_pressure());
  return observed;
}

Observed measured_300(int run) {
  const DataTable levels = level_table(), event = event_table();
  Observed observed{.front = series_of(front_table(), "T_H [-]", "X_H [-]")};
  for (std::size_t k = 0; k < gauges.size(); ++k)
    observed.levels[k] = series_of(levels, "T_H [-]", fmt::format("H{}_run_{} [-]", k + 1, k == 0 ? 1 : run));
  for (std::size_t k = 0; k < sensors.size(); ++k)
    observed.pressures[k] = series_of(event, "T_H [-]", fmt::format("P{} [-]", k + 1));
  return observed;
}

std::vector<std::pair<std::string, Series>> band_of_P2() {
  const DataTable band = band_table();
  return {{"100 repeats, 2.5 %", series_of(band, "T_H [-]", "p2_5 [-]")},
          {"100 repeats, median", series_of(band, "T_H [-]", "median [-]")},
          {"100 repeats, 97.5 %", series_of(band, "T_H [-]", "p97_5 [-]")}};
}

std::vector<std::vector<double>> peaks_of_repeats() {
  const DataTable peaks = read_table(data_folder() / "experiments" / "lobovsky_2014_peaks_300.csv");
  const double mbar = 100 / filled_300.unit_of_pressure();
  std::vector<std::vector<double>> all;
  for (std::size_t k = 0; k < 3; ++k)
    all.push_back({mbar * peaks.numbers("p2_5 [mbar]")[k], mbar * peaks.numbers("median [mbar]")[k],
                   mbar * peaks.numbers("p97_5 [mbar]")[k]});
  return all;
}

Impact impact_on(const Series& pressure) {
  return impact_of(pressure, {.threshold = 0.1,
                              .peak_within = 1,
                              .plateau_from = 1,
                              .plateau_to = 2,
                              .arrival_fraction = 0.2,
                              .impulse_over = 0.1 / filled_300.unit_of_time()});
}

Series aligned_by_arrival(const Series& pressure) {
  static const double measured = impact_on(band_of_P2()[1].second).arrival;
  const double bound = clock_uncertainty / filled_300.unit_of_time(), shift = measured - impact_on(pressure).arrival;
  return std::isnan(shift) ? pressure : shifted(pressure, std::clamp(shift, -bound, bound));
}

std::vector<Observable> observables_300() {
  const Observed first = measured_300(1), second = measured_300(2);
  const DataTable band = band_table(), front = front_table();
  std::vector<Observable> all;

  const double front_repeat = 2 * front.provenance().uncertainty.at("L.repeat").value;  // x/H is 2 L
  all = observables_of_front(first, {1.0, 1.5, 2.0, 2.4}, front_repeat);
  for (std::size_t k = 1; k < gauges.size(); ++k) {
    const double station = (gauges[k] - column_length) / filled_300.height;
    const auto of = [station](const Observed& observed) { return impacts::first_above(observed.front, station); };
    all.push_back({{fmt::format("passing time T_H of the front at H{}", k + 1)},
                   of,
                   of(first),
                   front_repeat / speed_of_front(first),
                   "repeatability of the front by its speed",
                   0.1,
                   clock_of_front});
  }

  // Of two runs the difference by sqrt(2) is the standard deviation of one; D, their mean, has it by sqrt(2) again.
  for (std::size_t k = 0; k < gauges.size(); ++k)
    for (const auto& [begin, end] : std::vector<std::pair<double, double>>{{2.5, 3.5}, {3.5, 4.5}, {4.5, 5}}) {
      const auto of = [=, from = begin, to = end](const Observed& observed) {
        return time_mean(observed.levels[k], from, to);
      };
      const double one = of(first), two = of(second);
      all.push_back({{fmt::format("level h/H at H{}, mean over T_H {:g} to {:g}", k + 1, begin, end)},
                     of,
                     (one + two) / 2,
                     k == 0 ? not_a_number : std::max(std::abs(one - two) / 2, 0.0025),
                     k == 0 ? "one run" : "two runs, and a pixel of the video",
                     0.05,
                     clock_of_front,
                     place_of_gauges});
    }

  const DataTable peaks = read_table(data_folder() / "experiments" / "lobovsky_2014_peaks_300.csv");
  const double mbar = 100 / filled_300.unit_of_pressure();
  const auto of_band = [&](const char* column) { return impact_on(series_of(band, "T_H [-]", column)); };
  const Impact low = of_band("p2_5 [-]"), middle = of_band("median [-]"), high = of_band("p97_5 [-]");
  for (std::size_t k = 0; k < sensors.size(); ++k) {
    const auto on = [k](const Observed& observed) { return impact_on(observed.pressures[k]); };
    const auto add = [&](const std::string& name, const std::function<double(const Observed&)>& of, double measured,
                         double standard, const std::string& basis, double useful, const std::string& clock = {}) {
      all.push_back(
          {{fmt::format("{} at P{}", name, k + 1)}, of, measured, standard, basis, useful, clock, height_of_sensors});
    };
    const bool has_band = k == 1;
    const auto add_integral = [&](const std::string& name, double Impact::*number) {
      add(
          name, [=](const Observed& observed) { return on(observed).*number; }, (has_band ? middle : on(first)).*number,
          has_band ? standard_of_95_percent(low.*number, high.*number) : not_a_number,
          has_band ? "percentiles of the band over 100 repeats" : "one event", 0.2);
    };
    const double peak = mbar * peaks.numbers("median [mbar]")[k],
                 of_peaks =
                     mbar * standard_of_95_percent(peaks.numbers("p2_5 [mbar]")[k], peaks.numbers("p97_5 [mbar]")[k]);
    const std::string by_repeats = "percentiles over 100 repeats";
    if (k < 3)
      add(
          "first peak p/(rho g H)", [=](const Observed& observed) { return on(observed).peak; }, peak, of_peaks,
          by_repeats, 0.5);
    else  // the second wave is the higher one
      add(
          "largest p/(rho g H) until T_H = 7",
          [k](const Observed& observed) { return impacts::largest(observed.pressures[k], 0, 7); }, peak, of_peaks,
          by_repeats, 0.5);
    if (has_band)  // what rises sooner has the higher percentile
      add(
          "arrival T_H", [=](const Observed& observed) { return on(observed).arrival; }, middle.arrival,
          standard_of_95_percent(high.arrival, low.arrival), "percentiles of the band over 100 repeats", 0.2,
          clock_of_pressures);
    add_integral("impulse over 100 ms by rho g H sqrt(H/g)", &Impact::impulse);
    add_integral("plateau p/(rho g H), 1 to 2 of T_H after arrival", &Impact::plateau);
  }
  return all;
}

std::vector<Observable> observables_600() {
  const DataTable table = front_table_600();
  return observables_of_front({.front = front_of_600(table)}, {0.5, 0.75, 1.0, 1.25, 1.5},
                              table.provenance().uncertainty.at("L.repeat").value);
}

std::vector<Value> compared(const Inputs& inputs, const Level& level, const Run& run) {
  std::vector<Value> found;
  if (!run.summary.finished) return found;
  const auto add = [&](const Quantity& quantity, double value) {
    found.push_back({level.name, level.spacing, run.summary.end_time, quantity, value});
  };
  add(energy_made, largest_rise_of_energy(run, column::kinetic, inputs.fall()));
  const Observed ours = observed_in(run, inputs);
  if (inputs.height != filled_300.height) {
    const Series front = front_of_600(front_table_600());
    add(front_rms, rms_between(ours.front, front, 0.2, 1.5));
    add(front_speed_error, 100 * (speed(ours.front, 1, 1.58) / speed(front, 1, 1.58) - 1));
    return found;
  }
  const Observed first = measured_300(1), second = measured_300(2);
  add(front_rms, rms_between(ours.front, first.front, 0, front_until));
  add(front_speed_error, 100 * (speed(ours.front, 1, 1.58) / speed(first.front, 1, 1.58) - 1));
  std::vector<double> before;
  for (std::size_t k = 1; k < gauges.size(); ++k)
    for (const Observed* observed : {&first, &second}) {
      const double arrival = impacts::first_above(first.front, (gauges[k] - column_length) / inputs.height) + 0.1;
      before.push_back(rms_between(ours.levels[k], observed->levels[k], arrival, until_return_wave));
    }
  add(levels_rms, root_mean_square(before));
  const auto band = band_of_P2();
  const Series at_P2 = aligned_by_arrival(ours.pressures[1]);
  add(pressure_rms, rms_between(at_P2, evenly(band[1].second, 2.4, 6), 2.4, 6));
  add(inside_band, fraction_inside(at_P2, band.front().second, band.back().second, 2.4, 6));
  add({"arrival T_H at P2"}, impact_on(ours.pressures[1]).arrival);
  for (std::size_t k = 0; k < sensors.size(); ++k) {
    const Impact impact = impact_on(ours.pressures[k]);
    const std::string at = fmt::format(" at P{}", k + 1);
    if (k < 3) add({"first peak p/(rho g H)" + at}, impact.peak);
    add({"impulse over 100 ms by rho g H sqrt(H/g)" + at}, impact.impulse);
    add({"plateau p/(rho g H)" + at}, impact.plateau);
  }
  const Impact by_mean = impact_on(observed_in(run, inputs, {.pressures = column::patch}).pressures[1]);
  add({"first peak p/(rho g H) at P2, mean over a patch"}, by_mean.peak);
  add({"impulse over 100 ms by rho g H sqrt(H/g) at P2, mean over a patch"}, by_mean.impulse);
  return found;
}

}  // namespace touchstone::vnv::gated_dam

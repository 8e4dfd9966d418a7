#include "vnv/flows/dams/gated_dam_figures.hpp"

#include "vnv/flows/dams/dam_front.hpp"
#include "vnv/measures/plots/snapshots.hpp"
#include "vnv/record/record.hpp"

#include <fmt/format.h>

namespace touchstone::vnv::gated_dam {
namespace {

const double until = 2 / filled_300.unit_of_time();  // of T_H, as long as runs last

Curve curve(const std::string& figure, const std::string& label, Role role, const Series& series, bool points = false) {
  return {figure, label, role, series.time, series.value, points};
}

std::string label_of(const Results& results, const Run& run) { return results.method.name + " " + run.summary.level; }

/// A figure of one of the series that were seen: ours, and the experiment's.
Plot observed_over_time(const Figure& frame, const std::function<Series(const Observed&)>& of,
                        const std::vector<Curve>& experiment) {
  return [=](const Results& results, Record& record) {
    record.figures.push_back(frame);
    if (const Run* run = finest(results))
      record.curves.push_back(curve(frame.id, label_of(results, *run), Role::ours, of(observed_in(*run, filled_300))));
    record.curves.insert(record.curves.end(), experiment.begin(), experiment.end());
  };
}

Plot all_of(const std::vector<Plot>& plots) {
  return [=](const Results& results, Record& record) {
    for (const Plot& plot : plots) plot(results, record);
  };
}

}  // namespace

Plot front_over_time() {
  const std::string id = "front";
  const auto front = [](const Observed& observed) { return observed.front; };
  return observed_over_time(
      {id,
       "Front over time",
       "Distance from the gate over H, front as a half-full slab of two spacings, without time shift: time counts from "
       "the first motion of the gate.",
       {"T_H = t sqrt(g/H)", 1, false, 0, 3},
       {"x/H", 1, false, 0, 3.5}},
      front, {curve(id, "Lobovský et al. 2014", Role::experiment, front(measured_300()), true)});
}

Plot levels_over_time() {
  std::vector<Plot> plots;
  for (std::size_t k = 0; k < gauges.size(); ++k) {
    const std::string id = fmt::format("level_H{}", k + 1);
    const auto level = [k](const Observed& observed) { return observed.levels[k]; };
    std::vector<Curve> measured{
        curve(id, "Lobovský et al. 2014, run 1", Role::experiment, level(measured_300(1)), true)};
    if (k > 0)
      measured.push_back(curve(id, "Lobovský et al. 2014, run 2", Role::published, level(measured_300(2)), true));
    plots.push_back(observed_over_time({id,
                                        fmt::format("Water level at H{}, {:g} m from the back wall", k + 1, gauges[k]),
                                        "Ours as volume over width, which holes and spray do not disturb.",
                                        {"T_H = t sqrt(g/H)", 1, false, 0, until},
                                        {"h/H", 1, false, 0, 1.15}},
                                       level, measured));
  }
  return all_of(plots);
}

Plot pressures_over_time() {
  std::vector<Plot> plots;
  const std::array<double, sensors.size()> most{4, 3, 3, 2};
  for (std::size_t k = 0; k < sensors.size(); ++k) {
    const std::string id = fmt::format("pressure_P{}", k + 1);
    const auto pressure = [k](const Observed& observed) { return observed.pressures[k]; };
    std::vector<Curve> measured{
        curve(id, "Lobovský et al. 2014, one event", Role::experiment, pressure(measured_300()))};
    if (k == 1)
      for (const auto& [label, series] : band_of_P2()) measured.push_back(curve(id, label, Role::guide, series));
    plots.push_back(observed_over_time(
        {id,
         fmt::format("Pressure at P{}, {:g} mm above the floor", k + 1, 1e3 * sensors[k]),
         "Ours by an affine fit evaluated at the wall, sampled every ms; without time shift, though the time origins "
         "are uncertain by 0.15.",
         {"T_H = t sqrt(g/H)", 1, false, 2, 8},
         {"p/(rho g H)", 1, false, -0.5, most[k]}},
        pressure, measured));
  }
  return all_of(plots);
}

Plot energies_over_time() {
  return [](const Results& results, Record& record) {
    const std::string id = "energy";
    record.figures.push_back(
        {id,
         "Energy over time",
         "Energy of the water, less that of the same water lying flat in the tank, relative to what it loses until it "
         "does.",
         {"T_H = t sqrt(g/H)", 1, false, 0, until},
         {"energy over the fall", 1, false, 0, 1.1}});
    const Run* run = finest(results);
    if (!run) return;
    const double fall = filled_300.fall(), unit = filled_300.unit_of_time();
    Series kinetic = followed(*run, column::kinetic), potential = followed(*run, column::potential),
           elastic = followed(*run, column::elastic);
    const double flat = potential.value.front() - fall;
    Series total = kinetic;
    for (std::size_t k = 0; k < total.time.size(); ++k) {
      total.time[k] = kinetic.time[k] = potential.time[k] = kinetic.time[k] / unit;
      potential.value[k] = (potential.value[k] - flat) / fall;
      kinetic.value[k] /= fall;
      total.value[k] = kinetic.value[k] + potential.value[k] + elastic.value[k] / fall;
    }
    const std::string name = label_of(results, *run);
    record.curves.push_back(curve(id, name + ", total", Role::ours, total));
    record.curves.push_back(curve(id, name + ", kinetic", Role::ours, kinetic));
    record.curves.push_back(curve(id, name + ", potential", Role::ours, potential));
  };
}

Plot particles_coloured_by_pressure(std::vector<std::string> methods, std::vector<double> times) {
  return [=](const Results& results, Record& record) {
    const Run* run = finest(results);
    if (!run || std::ranges::find(methods, results.method.name) == methods.end()) return;
    snapshots(
        {"snapshots",
         "Particles, coloured by pressure",
         "Finest level that was run: the front below the gate, at the wall and running up it, and the returning wave. "
         "Isolines every 0.5 kPa.",
         {"x [m]", 1, false, 0, tank_length},
         {"y [m]", 1, false, 0, 1},
         {"p [kPa]", 1e-3, false, 0, 4},
         false,
         0.5},
        {run->summary.level}, times)(results, record);
  };
}

}  // namespace touchstone::vnv::gated_dam

#include "vnv/flows/dams/open_dam.hpp"

#include "solvers/walls/free_slip.hpp"
#include "vnv/record/record.hpp"

namespace touchstone::vnv::open_dam {

std::vector<double> monitored(const DamFront& dam, const Samples& samples) {
  std::vector<double> row = dam.monitored(samples);
  std::ranges::copy(energies(samples, water_of(dam.column_height), dam.gravity), std::back_inserter(row));
  return row;
}

std::vector<Quantity> monitored_quantities() {
  std::vector<Quantity> names = DamFront::quantities;
  names.insert(names.end(), quantities_of_energies.begin(), quantities_of_energies.end());
  return names;
}

std::vector<Value> conservation_errors(const DamFront& dam, const Level& level, const Run& run) {
  std::vector<Value> found = dam.kept(level, run);
  if (!found.empty())
    found.push_back({level.name, level.spacing, run.summary.end_time, energy_made,
                     largest_rise_of_energy(run, DamFront::quantities.size(), dam.fall())});
  return found;
}

Case to_the_end(std::string title, std::string description, const DamFront& dam) {
  return {
      .title = std::move(title),
      .description = std::move(description),
      .times = {end_of_impact},
      .measurements = {},
      .claims = {between(dam.mass_change, -1e-12, 1e-12, theory("particle masses are constant; rounding of the sum")),
                 between(dam.lost, 0, 0, theory("water does not cross walls")), makes_no_energy()},
      .methods = {}};
}

Scene<Tait, Uniform> collapse(const DamFront& dam) {
  const Tait water = water_of(dam.column_height);
  return {
      .domain = {.box = {.high = {dam.tank_length, dam.tank_height}}},
      .fluid = water,
      .filled = {.high = {dam.column_length, dam.column_height}},
      .walls = {floor_at(0, free_slip()), left_at(0, free_slip()), right_at(dam.tank_length, free_slip())},
      .body_force = {{0, -dam.gravity}},
      .start = {.pressure = [=](const Vec2& x) { return water.density * dam.gravity * (dam.column_height - x.y()); }}};
}

Case beside_fronts(std::string title, std::string description, const DamFront& dam, double until) {
  Case declared = to_the_end(std::move(title), std::move(description), dam);
  constexpr double frame_every = 8e-3;  // s  a tenth of T in a column of Martin & Moyce
  const double most = until + 0.3 + dam.scaled_time(frame_every);
  declared.times.clear();
  for (int k = 0; dam.scaled_time(k * frame_every) <= most; ++k) declared.times.push_back(k * frame_every);
  declared.times.push_back(end_of_impact);
  declared.monitor = {.interval = sampled_every,
                      .evaluate = [=](const Samples& samples) { return monitored(dam, samples); },
                      .quantities = monitored_quantities()};
  declared.measurements = {[=](const Level& level, const Run& run) {
    std::vector<Value> found = conservation_errors(dam, level, run);
    if (run.summary.end_time < end_of_impact) return found;
    for (const Value& value : dam.against_experiments(level, run)) {
      const auto is_of = [&](const std::string& what) { return value.quantity.name.ends_with(what); };
      if (is_of(dam.of_thin_slab) || is_of("99.5th percentile") || is_of(dam.of_residual_height))
        found.push_back(value);
    }
    return found;
  }};
  declared.claims.push_back(
      at_most(dam.speed_of(dam.of_thin_slab), 2,
              literature("Ritter 1892, for shallow water without friction; no theorem binds a jet")));
  const double last = dam.tank_length / dam.column_length;
  declared.plots = {
      dam.history({"front",
                   "Front over time",
                   "Front as a half-full slab of two spacings, without time shift; the time origins of the experiments "
                   "are uncertain by 0.3.",
                   {"time T", 1, false, 0, 4},
                   {"front L", 1, false, 1, last}},
                  {}),
      dam.residual_heights(
          {"residual_height",
           "Residual height of the column",
           "Mean over a tenth of the column's length at the back wall, without time shift. Late in MPM runs it "
           "stagnates where one or two upright rows of particles are left there, each of which fills 10 spacings / l0 "
           "of that width.",
           {"time T", 1, false, 0, until},
           {"height over h0", 1, false, 0, 1.1}})};
  return declared;
}

}  // namespace touchstone::vnv::open_dam

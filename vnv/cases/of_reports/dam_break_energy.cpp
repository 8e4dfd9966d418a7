/// Where the energy of a dam break goes: what each part of a method adds to it, found from its own forces in each step.

#include "vnv/flows/dams/gated_dam.hpp"
#include "vnv/methods/energy_budgets.hpp"
#include "vnv/record/record.hpp"

#include <fmt/format.h>

#include <numeric>

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::gated_dam;

namespace {

/// The column of Lobovský et al. (2014), 0.3 m high, released at once: a gate takes no energy, but MPM's plain
/// reference has none.
const Scene<Tait, Uniform> scene = without_gates(collapse(filled_300));

const std::size_t first_part = quantities_of_energies.size(), parts = parts_of_energy.size() - 1;

std::string name_of(std::size_t part) { return parts_of_energy[part].name.substr(std::string("energy by ").size()); }
Quantity over_fall(const Quantity& part) { return {part.name + " over the fall", "%"}; }
const Quantity residual{"largest energy that no part accounts for, over the fall", "", Kind::invariant,
                        Better::smaller};

double percent_of_fall(double energy) { return 100 * energy / filled_300.fall(); }

/// By all parts together.
double total(const std::vector<double>& row) {
  return std::accumulate(row.begin() + static_cast<std::ptrdiff_t>(first_part), row.end(), 0.0);
}

/// At the end, of each part, in percent of the fall.
std::vector<Value> at_end(const Results& results, const Record&) {
  std::vector<Value> found;
  for (const Run& run : results.runs) {
    if (!run.summary.finished) continue;
    const auto add = [&](const Quantity& quantity, double value) {
      found.push_back({run.summary.level, run.summary.spacing, end_of_impact, quantity, value});
    };
    for (std::size_t part = 0; part < parts; ++part)
      add(over_fall(parts_of_energy[part]), percent_of_fall(run.history.values.back()[first_part + part]));
    double largest = 0;
    for (const std::vector<double>& row : run.history.values) largest = std::max(largest, std::abs(row.back()));
    add(residual, largest / filled_300.fall());
    add(energy_made, largest_rise_of_energy(run, 0, filled_300.fall()));
  }
  return found;
}

/// What each part of each method has added, before the impact, after it and at the end.
void tabulate(const Results& results, Record& record) {
  Table table{
      "parts_of_energy",
      "What each part of a method adds to the energy",
      "Energy added since the start, in per cent of the potential energy that the column loses until it lies flat. "
      "Pressure and gravity: their work on the motion plus the change of elastic or potential energy that balances it. "
      "Density smoothing: diffusion in SPH, the transfer over the nodes in MPM. Walls: contact in SPH, the reaction of "
      "nodes on walls in MPM. Transfer: between particles and nodes.",
      {"method", "level", "t [s]"},
      {}};
  for (std::size_t part = 0; part < parts; ++part) table.columns.push_back(name_of(part));
  table.columns.push_back("total");
  for (const Run& run : results.runs)
    for (const double time : {0.4, 0.8, 1.2, 2.0})
      for (std::size_t k = 0; k < run.history.time.size(); ++k) {
        if (std::abs(run.history.time[k] - time) > sampled_every / 2) continue;
        const std::vector<double>& row = run.history.values[k];
        std::vector<Cell> cells{results.method.name, run.summary.level, time};
        for (std::size_t part = 0; part < parts; ++part) {
          const double value = percent_of_fall(row[first_part + part]);
          cells.push_back(std::abs(value) < 1e-6 ? Cell("") : Cell(value));
        }
        cells.push_back(percent_of_fall(total(row)));
        table.rows.push_back(std::move(cells));
      }
  record.tables.push_back(std::move(table));
}

/// The energy lost over time, of all methods in one figure; and its parts, of a method.
void draw(const Results& results, Record& record) {
  const Axis time{"t [s]", 1, false, 0, end_of_impact};
  const std::string name = results.method.name, id = "parts_" + name;
  record.figures.push_back({"lost",
                            "Energy over time",
                            "Kinetic, potential and elastic energy together, less those at the start.",
                            time,
                            {"change of energy over the fall [%]", 1}});
  if (results.runs.empty()) return;
  record.figures.push_back(
      {id,
       fmt::format("Energy over time by part, {}", name),
       "What each part of the method has added since the start; those that added nothing are left out.",
       time,
       {"energy added over the fall [%]", 1}});
  const Run& run = results.runs.back();
  const auto curve = [&](const std::string& figure, const std::string& label, const auto& of) {
    Curve found{figure, label, Role::ours, run.history.time, {}, false};
    for (const std::vector<double>& row : run.history.values) found.y.push_back(percent_of_fall(of(row)));
    record.curves.push_back(std::move(found));
  };
  curve("lost", fmt::format("{} {}", name, run.summary.level), total);
  for (std::size_t part = 0; part < parts; ++part) {
    const auto of_part = [=](const std::vector<double>& row) { return row[first_part + part]; };
    if (std::ranges::any_of(run.history.values,
                            [&](const auto& row) { return std::abs(percent_of_fall(of_part(row))) > 0.01; }))
      curve(id, name_of(part), of_part);
  }
}

std::vector<Method> methods() {
  std::vector<Method> all;
  for (const Method& method : methods_with_energy_budget(scene, sampled_every)) {
    all.push_back(with_ladder(levels_across(filled_300.height, {{20, 0, end_of_impact, end_of_impact}}), method));
    std::vector<Claim>& claims = all.back().claims;
    if (!method.as_printed) claims.push_back(makes_no_energy());
    if (method.family == Family::sph)
      claims.push_back(at_most(over_fall(energy_by_viscosity), 0, theory("artificial viscosity opposes approach")));
  }
  return all;
}

}  // namespace

Case vnv::the_case() {
  std::vector<Quantity> quantities = quantities_of_energies;
  quantities.insert(quantities.end(), parts_of_energy.begin(), parts_of_energy.end());
  return {
      .title = "Energy of a dam break",
      .description =
          "The column of Lobovský et al. (2014), 0.6 m long and 0.3 m high, is released instantaneously in a tank 1.61 "
          "m long and computed to 2 s. In each step, the work of each part of a method is found from its own forces "
          "and displacements: pressure, gravity, viscosity, walls; so is what changes the energy without a force: "
          "diffusion of density, transfers between particles and nodes, shifting. Together they equal the change of "
          "the energy, up to rounding.",
      .times = {end_of_impact},
      .monitor = {.interval = sampled_every,
                  .evaluate = [](const Samples& s) { return energies(s, scene.fluid, filled_300.gravity); },
                  .quantities = quantities},
      .measurements = {},
      .findings = {at_end},
      .claims = {at_most(residual, 1e-10, theory("work is force times displacement, in each step"))},
      .methods = methods(),
      .plots = {tabulate, draw}};
}

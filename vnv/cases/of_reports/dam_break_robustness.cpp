/// Which methods run a dam break through the impact on the far wall to 2 s: four columns, from disturbed starts, at up
/// to 160 particles over the height.

#include "vnv/flows/dams/gated_dam.hpp"
#include "vnv/flows/dams/open_dam.hpp"
#include "vnv/methods/free_surface_methods.hpp"
#include "vnv/record/record.hpp"
#include "vnv/studies/disturbed.hpp"

#include <fmt/format.h>

#include <memory>

using namespace touchstone;
using namespace touchstone::vnv;

namespace {

constexpr double jitter = 0.01;  // of the spacing

/// A column of water, with its gate where it has one.
struct Column {
  std::string name;
  double height;  // m
  double fall;    // J/m  what it loses until it lies flat
  Scene<Tait, Uniform> scene;
};

Column behind_gate(const std::string& name, const gated_dam::Inputs& inputs) {
  return {name, inputs.height, inputs.fall(), gated_dam::collapse(inputs)};
}
Column released(const std::string& name, double length, double height, double tank) {
  const DamFront dam = open_dam::column(length, height, tank);
  const double fall = dam.density * dam.gravity * length * height * height / 2 * (1 - length / tank);
  return {name, height, fall, open_dam::collapse(dam)};
}

const std::vector<Column>& columns() {
  static const std::vector<Column> all{
      behind_gate("600 x 300 mm", gated_dam::filled_300), behind_gate("600 x 600 mm", gated_dam::filled_600),
      released("57 x 57 mm", 0.05715, 0.05715, 6 * 0.05715), released("146 x 292 mm", 0.146, 0.292, 5 * 0.146)};
  return all;
}

/// So many particles over the height, from so many starts, of which a night runs the first few.
struct Starts {
  int across, all, nightly;
};

struct Member {
  const Column* column;
  Starts starts;
  int start;

  std::string name() const { return fmt::format("{}, {} across, start {}", column->name, starts.across, start); }
};

/// A method from all starts of all columns; `method_on(scene)` makes it.
Method from_all_starts(const std::vector<Starts>& all_starts, bool with_gate, bool may_diverge,
                       const std::function<Method(const Scene<Tait, Uniform>&)>& method_on) {
  Method method = method_on(columns().front().scene);
  if (!with_gate) method.description += " The method has no gate: each column is released instantaneously.";
  const auto members = std::make_shared<std::vector<Member>>();
  for (const Column& column : columns())
    for (const Starts& starts : all_starts)
      for (int start = 1; start <= starts.all; ++start) {
        members->push_back({&column, starts, start});
        method.levels.push_back({.name = members->back().name(),
                                 .spacing = column.height / starts.across,
                                 .cell = 2 * column.height / starts.across,
                                 .nightly = start <= starts.nightly ? end_of_impact : 0,
                                 .validation = end_of_impact,
                                 .may_diverge = may_diverge});
      }
  method.run = [=](const Level& level, Schedule when) {
    const Member& member = *std::ranges::find(*members, level.name, &Member::name);
    const Column& column = *member.column;
    Scene<Tait, Uniform> scene = with_gate ? column.scene : without_gates(column.scene);
    scene.start.places = [by = jitter * level.spacing, seed = static_cast<unsigned>(member.start)](
                             const Vectors& lattice) { return disturbed(lattice, by, seed); };
    when.monitor.evaluate = [&](const Samples& samples) {
      std::vector<double> parts;
      for (const double energy : energies(samples, scene.fluid, -scene.body_force.per_mass.y()))
        parts.push_back(energy / column.fall);
      return parts;
    };
    return method_on(scene).run(level, when);
  };
  return method;
}

const Quantity ended{"runs that ended before 2 s", "", Kind::count, Better::smaller};
const Quantity first_end{"earliest end of a run", "s", Kind::value, Better::larger};
const Quantity most_energy_made{energy_made.name + ", of all runs", "", Kind::invariant, Better::smaller};

/// What came of the runs whose levels begin so.
struct Group {
  double starts = 0, reached = 0, first_end = end_of_impact, most_energy_made = 0;

  Group(const Results& results, std::string_view name) {
    for (const Run& run : results.runs) {
      if (!run.summary.level.starts_with(name)) continue;
      ++starts;
      reached += run.summary.finished;
      first_end = std::min(first_end, run.summary.end_time);
      if (run.summary.finished) most_energy_made = std::max(most_energy_made, largest_rise_of_energy(run, 0, 1));
    }
  }
};

std::vector<Value> of_all_runs(const Results& results, const Record&) {
  const Group all(results, "");
  return {{"", not_a_number, end_of_impact, ended, all.starts - all.reached},
          {"", not_a_number, end_of_impact, first_end, all.first_end},
          {"", not_a_number, end_of_impact, most_energy_made, all.most_energy_made}};
}

/// Each column and resolution in a row.
void tabulate(const Results& results, Record& record) {
  Table table{"robustness",
              "Runs to 2 s",
              "Starts differ by a hundredth of a spacing. Energy made: the largest rise of the sum of kinetic, "
              "potential and elastic energy, relative to the potential energy that the column loses until it lies "
              "flat, among the runs that reached 2 s.",
              {"method", "column", "across", "starts", "reached 2 s", "earliest end [s]", "most energy made [%]"},
              {}};
  for (const Column& column : columns())
    for (const int across : {20, 40, 80, 160}) {
      const Group one(results, fmt::format("{}, {} across, ", column.name, across));
      if (one.starts == 0) continue;
      table.rows.push_back({results.method.name, column.name, static_cast<double>(across), one.starts, one.reached,
                            one.reached < one.starts ? Cell(one.first_end) : Cell(""),
                            one.reached > 0 ? Cell(100 * one.most_energy_made) : Cell("")});
    }
  record.tables.push_back(std::move(table));
}

/// From so many starts, with what is claimed of the energy that its runs make.
Method lives(const std::vector<Starts>& starts, bool with_gate, Claim of_energy,
             const std::function<Method(const Scene<Tait, Uniform>&)>& method_on) {
  Method method = from_all_starts(starts, with_gate, false, method_on);
  method.claims = {at_most(ended, 0, theory("water neither crosses walls nor vanishes")), std::move(of_energy)};
  return method;
}

/// Runs that take longer than all others of their method, so that a suite can be interrupted between the two and
/// divided among machines.
Method by_itself(const std::string& suffix, Method method) {
  method.name += suffix;
  return method;
}

const Claim makes_no_energy = at_most(most_energy_made, 0.01, theory("gravity is the only source of energy"));

/// The methods as printed may end early and make energy.
Method as_printed(const std::vector<Starts>& starts, std::vector<Claim> claims,
                  const std::function<Method(const Scene<Tait, Uniform>&)>& method_on) {
  Method method = from_all_starts(starts, false, true, method_on);
  method.claims = std::move(claims);
  return method;
}

std::vector<Method> methods() {
  const std::vector<Starts> of_mpm{{20, 16, 4}, {40, 16, 1}, {80, 4, 0}, {160, 1, 0}},
      of_sph{{20, 16, 1}, {40, 16, 0}, {80, 4, 0}}, of_sph_finest{{160, 1, 0}},
      of_printed_sph{{20, 16, 1}, {40, 16, 0}};
  const auto delta = [](const auto& s) { return sph_delta(s, sampled_every); };
  const auto shifted = [](const auto& s) { return sph_shifted(s, sampled_every); };
  const auto corrected = [](const auto& s) { return sph_corrected(s, sampled_every); };
  return {
      lives(of_mpm, true, makes_no_energy, [](const auto& s) { return mpm_apic(s, sampled_every); }),
      lives(of_mpm, true, makes_no_energy, [](const auto& s) { return mpm_xpic(s, sampled_every); }),
      lives(of_mpm, false, makes_no_energy, [](const auto& s) { return mpm_affine(s, sampled_every, 0.4); }),
      lives(of_sph, true, makes_no_energy, delta),
      by_itself("_160", lives(of_sph_finest, true, makes_no_energy, delta)),
      lives(of_sph, true, makes_no_energy, shifted),
      by_itself("_160", lives(of_sph_finest, true, makes_no_energy, shifted)),
      lives(of_sph, true, makes_no_energy, corrected),
      by_itself("_160", lives(of_sph_finest, true, makes_no_energy, corrected)),
      as_printed(
          of_mpm,
          {at_least(first_end, 0.25, baseline("0.277 s in 148 runs, 16 of which ended early")),
           at_most(ended, 30, baseline("14 and 16 of 148 runs")),
           at_most(
               most_energy_made, 0.8,
               baseline("0.51 and 0.63 by builds that round differently; from more starts, 422 runs, 0.63 and 0.65: "
                        "cell crossings with linear hats"))},
          [](const auto& s) { return mpm_as_printed(s, sampled_every, 0.2); }),
      as_printed(of_printed_sph,
                 {at_most(ended, 8, baseline("3 of 128 runs when first measured, through the walls of its tall jets")),
                  at_most(most_energy_made, 0.2, baseline("0.14 in 128 runs when first measured"))},
                 [](const auto& s) { return sph_as_printed(s, sampled_every, 0.25); })};
}

}  // namespace

Case vnv::the_case() {
  return {
      .title = "Robustness of dam breaks",
      .description =
          "Four columns of water collapse, meet the far wall and slosh back, to 2 s: those of Lobovský et al. (2014), 600 x 300 mm and 600 x 600 mm behind a "
          "gate, and those of Martin & Moyce (1952) and Koshizuka & Oka (1995), 57 x 57 mm and 146 x 292 mm, released "
          "instantaneously. Each method is run from several starts, whose particles are displaced by up to a hundredth "
          "of the spacing. No run may diverge, lose a particle or gain energy; the methods as printed may, but claims "
          "limit how early and by how much.",
      .times = {end_of_impact},
      .monitor = {.interval = sampled_every,
                  .quantities = {{"kinetic energy over the fall"},
                                 {"potential energy over the fall"},
                                 {"elastic energy over the fall"}}},
      .measurements = {},
      .findings = {of_all_runs},
      .methods = methods(),
      .plots = {tabulate}};
}

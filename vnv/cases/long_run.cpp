/// A rotating drop over a hundred thousand steps: conservation, and motion invisible to the grid.

#include "vnv/measures/decay.hpp"
#include "vnv/measures/hidden_motion.hpp"
#include "vnv/measures/plots/over_time.hpp"
#include "vnv/methods/free_surface_methods.hpp"
#include "vnv/studies/starts.hpp"

using namespace touchstone;
using namespace touchstone::vnv;

namespace {

using Water = Scene<Newtonian, Uniform>;

constexpr double spacing = 0.02, cell = 2 * spacing, R = 0.2, c = 40;  // m, m, m, m/s
constexpr double turning = 0.001 * c / R;                              // 1/s  its edge moves at a thousandth of c
constexpr double output_interval = 0.01;                               // s
const Vec2 centre(2, 2);

const Water scene{
    .domain = {.box = {.high = {4, 4}}},
    .fluid = {{.density = 1000, .bulk_modulus = 1000 * c * c / 7}, 1e-6},
    .filled = {.low = centre - Vec2(R, R), .high = centre + Vec2(R, R)},
    .body_force = {{0, 0}},
    .start = {.velocity = [](const Vec2& x) { return Vec2(-turning * (x - centre).y(), turning * (x - centre).x()); },
              .places = within(R, {centre})},
};

const Quantity steps_taken{"steps completed", "", Kind::count},
    energy_change{"relative change of kinetic energy", "%", Kind::invariant},
    momentum_change{"relative change of angular momentum", "%", Kind::invariant};

enum Column { energy, momentum, hidden, closest };

/// Kinetic energy [J/m], angular momentum [kg m/s], fraction of hidden motion, closest pair in spacings.
std::vector<double> monitored(const Samples& s) {
  return {kinetic_energy(s), angular_momentum(s, centre), hidden_motion(s, 1.6 * spacing), closest_pair(s) / spacing};
}

std::vector<Value> drifts(const Level& level, const Run& run) {
  const auto& rows = run.history.values;
  const Value steps{level.name, level.spacing, run.summary.end_time, steps_taken, double(run.summary.cost.steps)};
  if (!run.summary.finished || rows.empty()) return {steps};
  const auto change = [&](Column what) { return 100 * (rows.back()[what] / rows.front()[what] - 1); };
  double most_hidden = 0, closest_ever = rows.front()[closest];
  for (const std::vector<double>& row : rows) {
    most_hidden = std::max(most_hidden, 100 * row[hidden]);
    closest_ever = std::min(closest_ever, row[closest]);
  }
  const auto value_of = [&](const Quantity& quantity, double value) {
    return Value{level.name, level.spacing, run.summary.end_time, quantity, value};
  };
  return {steps, value_of(energy_change, change(energy)), value_of(momentum_change, change(momentum)),
          value_of({"largest rms residual velocity of a local linear fit over rms velocity", "%", Kind::error},
                   most_hidden),
          value_of({"smallest pair distance over spacing"}, closest_ever)};
}

const std::string short_run = "10000 steps", long_run = "100000 steps";

/// So many steps of the method's own choice.
Method for_long(Method method, std::vector<Claim> claims, bool may_diverge = false) {
  Level level{.name = short_run, .spacing = spacing, .cell = cell, .may_diverge = may_diverge};
  const double dt = method.time_step(level);
  level.acceptance = 10'000 * dt;
  method.levels = {level};
  level.name = long_run;
  level.acceptance = 0;
  level.nightly = 100'000 * dt;
  method.levels.push_back(level);
  method.claims = std::move(claims);
  method.tolerance = {0.5, "a drop under tension is chaotic after a few rotations",
                      1e-11};  // 10000 steps that each round the angular momentum to 16 digits: 1e-12 to 1e-10 %
  return method;
}

const Claim gains_nothing =
    at_most(energy_change, 1, theory("the only source of energy is the tension that tears it apart"));
Claim keeps_turning(double percent) {
  return between(momentum_change, -percent, percent,
                 theory("affine velocities, and forces along the line between two particles, conserve angular "
                        "momentum"));
}

}  // namespace

Case vnv::the_case() {
  return {
      .title = "Long-time rotation of a drop",
      .description =
          "A circular drop of 0.2 m radius, ten particles along the radius, rotates as a rigid body in empty space, "
          "its edge moving at a thousandth of the speed of sound, for 10000 steps, 100000 in the nightly suite. No "
          "force acts on it: its angular momentum is conserved, and its energy up to a viscous loss that is negligible "
          "over this time. Its rotation puts it under tension. Motion invisible to the grid, modes in the null space "
          "of the particle-to-grid transfer of a material point method, is measured as the residual of a linear fit "
          "around each particle. SPH particles that pair come closer than half a spacing.",
      .times = {},
      .monitor = {.interval = 0.05,
                  .evaluate = monitored,
                  .quantities = {{"kinetic energy", "J/m"},
                                 {"angular momentum", "kg m/s"},
                                 {"fraction of hidden motion"},
                                 {"closest pair over spacing"}}},
      .measurements = {drifts},
      .methods = {for_long(mpm_as_printed(scene, output_interval, 0.4), {gains_nothing}),
                  for_long(mpm_affine(scene, output_interval, 0.4), {gains_nothing, keeps_turning(0.1)}),
                  for_long(mpm_apic(scene, output_interval), {gains_nothing, keeps_turning(0.1)}),
                  for_long(mpm_xpic(scene, output_interval), {gains_nothing}),
                  for_long(sph_as_printed(scene, output_interval, 0.2), {gains_nothing, keeps_turning(0.01)}),
                  for_long(sph_delta(scene, output_interval), {gains_nothing, keeps_turning(0.01)}),
                  for_long(
                      sph_corrected(scene, output_interval),
                      {at_least(steps_taken, 1000, baseline("disintegrated after 26900 steps when first measured"))},
                      true)},
      .plots = {kinetic_energy_over_time(energy, {short_run, long_run}),
                over_time("momentum", "Angular momentum", "About the initial centre of the drop.",
                          {"angular momentum [kg m/s]"}, momentum, {short_run, long_run}),
                over_time("hidden", "Motion invisible to the grid",
                          "Rms residual of a linear velocity fit around each particle, over the rms velocity.",
                          {.label = "fraction of rms velocity", .logarithmic = true}, hidden, {short_run, long_run}),
                over_time("closest", "Smallest pair distance", "", {"distance / spacing"}, closest,
                          {short_run, long_run})},
      .label = "stability",
  };
}

/// A standing gravity wave of small amplitude: its period and its viscous decay.

#include "vnv/flows/gravity_wave.hpp"
#include "vnv/measures/swing.hpp"
#include "vnv/plots/along_ladders.hpp"
#include "vnv/plots/over_time.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::gravity_wave;

namespace {

constexpr double end = 4;  // s

/// Wave amplitude: the first moment of the particles' heights along it, over that of the exact wave at the
/// start.
std::vector<double> monitored(const Samples& s) {
  const Scalars heights = s.x.row(1).transpose(),
                wave = (2 * std::numbers::pi / L * s.x.row(0).transpose().array()).cos();
  return {(s.mass * heights * wave).sum()};
}

const Quantity period_error{"relative error of the period", "%", Kind::deviation},
    decay_error{"relative error of the decay rate", "%", Kind::deviation};

std::vector<Value> errors_of_swing(const Level& level, const Run& run) {
  if (!run.summary.finished) return {};
  std::vector<double> heights;
  for (const std::vector<double>& seen : run.history.seen) heights.push_back(seen[0]);
  const Swing swing = fit_swing(run.history.time, heights, exact.omega());
  return {{level.name, level.spacing, end, period_error, 100 * (exact.omega() / swing.omega - 1)},
          {level.name, level.spacing, end, decay_error, 100 * (swing.decay / exact.decay_rate() - 1)}};
}

const std::vector<Level> levels = levels_across(L, {{50, end, 0, end}, {100, 0, 0, end}, {150, 0, 0, end}});

/// From so many particles to a wave on.
std::vector<Claim> swings_right(const std::vector<std::string>& names) {
  std::vector<Claim> all;
  for (const std::string& level : names) {
    all.push_back(between(period_error, -1, 1, theory("the wave is linear to k² a² / 8 = 0.2 %")).on(level));
    all.push_back(
        between(decay_error, -10, 10, theory("decay of a potential flow, to first order in nu k² / omega")).on(level));
  }
  return all;
}

/// Each up to the levels worth their cost: 150 across takes the more expensive methods three to ten minutes each, 100
/// across takes those on B-splines one or more. XPIC, the most expensive, runs in the nightly suite only; acceptance
/// tests it in the drop.
std::vector<Method> methods_up_levels() {
  Level at_night = levels[0];
  at_night.acceptance = 0;
  std::vector<Method> methods = with_ladder(
      levels, methods_on(scene),
      {{"mpm_affine", swings_right({"100 across", "150 across"})}, {"sph_delta", swings_right({"50 across"})}});
  for (Method& method : methods)
    if (method.name == "mpm_xpic")
      method = with_ladder({at_night}, method, method.claims);
    else if (method.name == "mpm_apic")
      method = with_ladder({levels[0]}, method, method.claims);
    else if (method.relative_cost > 1)
      method = with_ladder({levels[0], levels[1]}, method, method.claims);
  return methods;
}

}  // namespace

Case vnv::the_case() {
  return {
      .title = "Standing gravity wave",
      .description =
          "Water 0.5 m deep, 1 m from crest to crest, starts at rest with a surface elevation of 2 cm and oscillates for five "
          "periods; a viscosity of 2e-3 m²/s reduces the amplitude by a tenth in each. The oracle is the linear wave (Lamb 1932): "
          "period from the dispersion relation, decay rate 2 nu k² from the potential flow. Period and decay rate are those of the "
          "damped oscillation fitted to the first moment of the particle heights.",
      .times = {end},
      .watch = {.every = 0.02, .see = monitored, .quantities = {{"first moment of the particle heights", "kg"}}},
      .measurements = {errors_of_swing},
      .methods = methods_up_levels(),
      .plots = {over_time("swing", "First moment of the particle heights",
                          "Mass times height times the cosine of the wave, summed over all particles.",
                          {"moment [kg m / m]"}, 0, {"100 across"})}};
}

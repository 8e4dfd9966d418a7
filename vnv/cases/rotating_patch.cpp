/// Rotating square patch [Colagrossi 2005]: conservation under tension.

#include "vnv/flows/patch.hpp"
#include "vnv/measures/plots/over_time.hpp"
#include "vnv/measures/plots/snapshots.hpp"
#include "vnv/studies/starts.hpp"

#include <fmt/format.h>

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::patch;

namespace {

constexpr double end = 1;  // s

const std::string with_disorder = ", disturbed";
bool is_disturbed(const Level& level) { return level.name.ends_with(with_disorder); }

/// On the lattice that the sides follow, which keeps the symmetry of a square whatever a method does, or on one whose
/// particles are moved by up to a tenth of a spacing.
Scene<Tait> scene_of(const Level& level) {
  Scene<Tait> seen = scene();
  if (is_disturbed(level))
    seen.start.places = [by = level.spacing / 10](const Vectors& lattice) { return disturbed(lattice, by); };
  return seen;
}

std::vector<Level> levels() {
  std::vector<Level> all = levels_across(L, {{20, end, 0, end}, {40, end, 0, end}, {80, 0, 0, end}});
  all.push_back(all[1]);
  all.back().name += with_disorder;
  return all;
}

Claim keeps_momentum() { return at_most(drift, 1e-9, theory("no external force")); }

/// A method, which `make` makes for a scene, on its ladder and once from a disturbed lattice.
template <class Make>
Method rotating(const Make& make, std::vector<Claim> claims = {}) {
  claims.push_back(at_most(asymmetry, 1, theory("fourfold symmetry")).on("40 across" + with_disorder));
  Method method = with_ladder(levels(), make(scene_of({})), std::move(claims));
  method.ladders[0].levels.pop_back();
  method.run = [=](const Level& level, const Schedule& when) { return make(scene_of(level)).run(level, when); };
  return method;
}

}  // namespace

Case vnv::the_case() {
  const Flow flow = flow_named("rotating_patch");
  return {
      .title = flow.title(),
      .description = flow.judged.description +
                     " Arms grow from its corners, and its pressure, negative apart from acoustic ripples, exposes the "
                     "tensile instability of particle methods (Le Touzé et al. 2013). One run starts from a disturbed "
                     "lattice, which lacks the symmetry from the start. The Mach number of the corners is 1/28.",
      .times = flow.judged.times,
      .monitor = monitored(L),
      .measurements = {conservation_errors(exact, is_disturbed), roughness_of_pressure(exact)},
      .methods = {rotating(printed, {keeps_momentum()}), rotating(apic, {keeps_momentum()}),
                  rotating(delta,
                           {keeps_momentum(), at_most(angular_momentum_error, 1e-9,
                                                      theory("forces act along the line between two particles"))}),
                  rotating(shifted, {keeps_momentum()})},
      .plots = {snapshots({"patch",
                           "Patch, coloured by pressure",
                           "40 particles across; pressures beyond the colour scale are clipped.",
                           {"x [m]"},
                           {"y [m]"},
                           {"p [Pa]", 1, false, -200, 50}},
                          {"40 across"}, {0.5, end}),
                over_time("energy", "Kinetic energy over time",
                          fmt::format("Initially {:.2f} J per metre of depth.", exact.kinetic_energy()),
                          {"kinetic energy [J/m]"}, energy, {"40 across"}),
                exact_over_time(
                    "energy", [](double) { return exact.kinetic_energy(); }, end),
                over_time("middle", "Central pressure",
                          "Mean within a tenth of a side. Exact is the pressure at the start.", {"p [Pa]"}, middle,
                          {"40 across"}),
                exact_over_time(
                    "middle", [](double) { return exact.p(0, 0); }, 0.05)},
      .priced_as = "elliptic_drop"};
}

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

std::vector<Level> levels() {
  std::vector<Level> all = levels_across(L, {{20, end, 0, end}, {40, end, 0, end}, {80, 0, 0, end}});
  all.push_back(all[1]);
  all.back().name += with_disorder;
  return all;
}

/// The methods on their ladder, and once from a lattice whose particles are moved by up to a tenth of a spacing: the
/// one that the sides follow keeps the symmetry of a square whatever a method does.
std::vector<Method> methods_also_disturbed(const Scene<Tait>& scene) {
  std::vector<Method> methods = methods_on(scene);
  for (std::size_t k = 0; k < methods.size(); ++k) {
    Method& method = methods[k];
    std::vector<Claim> claims = {at_most(drift, 1e-9, theory("no external force"))};
    if (method.name == "sph_delta")
      claims.push_back(
          at_most(angular_momentum_error, 1e-9, theory("forces act along the line between two particles")));
    claims.push_back(at_most(asymmetry, 1, theory("fourfold symmetry")).on("40 across" + with_disorder));
    method = with_ladder(levels(), method, claims);
    method.ladders[0].levels.pop_back();
    method.run = [=, on_lattice = method.run](const Level& level, const Schedule& when) {
      if (!is_disturbed(level)) return on_lattice(level, when);
      Scene<Tait> seen = scene;
      seen.start.places = [by = level.spacing / 10](const Vectors& lattice) { return disturbed(lattice, by); };
      return methods_on(seen)[k].run(level, when);
    };
  }
  return methods;
}

}  // namespace

Case vnv::the_case() {
  const Flow flow = flow_named("rotating_patch");
  const auto exact = flow.oracle<reference::RotatingPatch>();
  return {
      .title = flow.title(),
      .description = flow.judged.description +
                     " Arms grow from its corners, and its pressure, negative apart from acoustic ripples, exposes the "
                     "tensile instability of particle methods (Le Touzé et al. 2013). One run starts from a disturbed "
                     "lattice, which lacks the symmetry from the start. The Mach number of the corners is 1/28.",
      .times = flow.judged.times,
      .monitor = flow.judged.monitor,
      .measurements = {conservation_errors(exact, is_disturbed), roughness_of_pressure(exact)},
      .methods = methods_also_disturbed(scene_of<Tait>(flow)),
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
                exact_over_time("energy", [=](double) { return exact.kinetic_energy(); }, end),
                over_time("middle", "Central pressure",
                          "Mean within a tenth of a side. Exact is the pressure at the start.", {"p [Pa]"}, middle,
                          {"40 across"}),
                exact_over_time("middle", [=](double) { return exact.p(0, 0); }, 0.05)},
      .priced_as = "elliptic_drop"};
}

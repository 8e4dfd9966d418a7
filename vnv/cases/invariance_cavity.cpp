/// A lid-driven cavity under symmetry transformations: walls all around.

#include "solvers/walls/no_slip.hpp"
#include "vnv/flows/lid_driven.hpp"
#include "vnv/measures/decay.hpp"
#include "vnv/studies/views.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::lid_driven;

namespace {

constexpr double end = 1;  // s

const SeveralViews in_views = several_views({views::mirrored_about_x(cavity.side / 2)}, cavity.side / 24, end,
                                            {"kinetic energy over that of a box moving at the lid speed", "%"});

Scene<Newtonian> scene_in(const View& view) {
  auto seen = scene_of<Newtonian>(flow_named("cavity"));
  seen.walls.back() = ceiling_at(cavity.side, no_slip(view.turned * Vec2(cavity.lid_speed, 0)));
  seen.start.places = view.rearranged;
  return seen;
}

}  // namespace

Case vnv::the_case() {
  const double rho = flow_named("cavity").fluid.density;
  const double of_lid = rho * std::pow(cavity.side * cavity.lid_speed, 2) / 2;  // J/m
  return in_views.declared(
      "Invariance: lid-driven cavity",
      "A lid-driven cavity, Reynolds number 100 and Mach number 0.2, 24 particles across, under symmetry "
      "transformations: mirrored, so that the lid slides to the left; from a disturbed lattice; with renumbered "
      "particles. The invariant is the kinetic energy after 1 s, before particles mix: later, runs that differ by "
      "rounding diverge. The equations are invariant. Every method claims invariance under reflection and renumbering.",
      kinetic_energy_over(of_lid / 100, in_views.error), in_views.methods(scene_in, methods_on),
      "Mirrored: the lid slides to the left.");
}

/// A rotating square patch under symmetry transformations: a free surface with corners, under tension.

#include "vnv/flows/patch.hpp"
#include "vnv/measures/decay.hpp"
#include "vnv/studies/views.hpp"

#include <numbers>

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::patch;

namespace {

constexpr double end = 0.3;  // s

/// The lattice turns with the patch, so that its sides stay even.
View turned_with_its_lattice() {
  View view = views::turned(Eigen::Rotation2Dd(std::numbers::pi / 6).toRotationMatrix());
  view.rearranged = [by = view.turned](const Vectors& lattice) -> Vectors { return by * lattice; };
  return view;
}

const View turned = turned_with_its_lattice();

const SeveralViews in_views = several_views({views::mirrored_about_x(0), views::carried_along({0.5, 0.3}), turned},
                                            L / 24, end, {"kinetic energy over that of a rigidly rotating square"});

auto scene_in(const View& view) { return view.scene(scene_of<Tait>(flow_named("rotating_patch"))); }

}  // namespace

Case vnv::the_case() {
  const auto exact = flow_named("rotating_patch").oracle<reference::RotatingPatch>();
  Case declared = in_views.declared(
      "Invariance: rotating patch",
      "A rotating square patch with a free surface, 24 particles across, under symmetry transformations: mirrored, so "
      "that it rotates the other way; carried along at (0.5, 0.3) m/s; turned by 30 degrees with its lattice; from a "
      "disturbed lattice; with particles renumbered. The invariant is the kinetic energy after 0.3 s, in the moving "
      "frame. The equations are invariant. Every method claims invariance under reflection and renumbering; SPH, which "
      "has no grid, also rotational invariance and, without shifting, Galilean invariance: the shifting length depends "
      "on velocities in the rest frame.",

      kinetic_energy_over(exact.kinetic_energy(), in_views.error),
      in_views.methods(scene_in, methods_on, {"sph_delta"}),
      "Carried along: a uniform velocity of (0.5, 0.3) m/s is added. Turned: rotated by 30 degrees, lattice included.");
  for (Method& method : declared.methods)
    if (method.family == Family::sph)
      method.claims.push_back(in_views.unchanged(turned, "without a grid there is no preferred direction"));
  return declared;
}

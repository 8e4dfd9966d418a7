/// A stretching drop under symmetry transformations: a free surface all around.

#include "vnv/flows/drop.hpp"
#include "vnv/studies/views.hpp"

#include <numbers>

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::drop;

namespace {

/// About the line x = y: the drop is stretched along y.
const View mirrored = views::mirrored(Mat2{{0, 1}, {1, 0}}, Vec2::Zero());
const View turned = views::turned(Eigen::Rotation2Dd(std::numbers::pi / 6).toRotationMatrix());

const SeveralViews in_views =
    several_views({mirrored, views::carried_along({0.3, 0.2}), turned}, 2 * R / 30, end, axes_error);

auto scene_in(const View& view) { return view.scene(scene_of<Tait>(flow_named("elliptic_drop"))); }

}  // namespace

Case vnv::the_case() {
  const Flow flow = flow_named("elliptic_drop");
  Case declared = in_views.declared(
      "Invariance: stretching drop",
      "A circular drop of an inviscid fluid is stretched to twice its length, 30 particles across, under symmetry "
      "transformations: mirrored, so that it is stretched along y; carried along at (0.3, 0.2) m/s; rotated by 30 "
      "degrees; from a disturbed lattice; with renumbered particles. The equations are invariant. Every method claims "
      "invariance under reflection and renumbering; SPH, which has no grid, also Galilean invariance. Rotated, the "
      "drop is not stretched along rows of particles.",
      error_of_axes(flow.oracle<reference::EllipticDrop>()),
      in_views.methods(scene_in, methods_on, {"sph", "sph_corrected"}),
      "Carried along: a uniform velocity of (0.3, 0.2) m/s is added. Turned: rotated by 30 degrees.");
  declared.monitor = flow.judged.monitor;
  return declared;
}

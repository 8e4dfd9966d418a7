/// A stretching drop that is mirrored, carried along, turned, on a disturbed lattice and with particles numbered anew:
/// a free surface all around.

#include "vnv/flows/drop.hpp"
#include "vnv/studies/views.hpp"

#include <numbers>

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::drop;

namespace {

constexpr double spacing_of_all = 2 * R / 30;  // m

/// About the line x = y: the drop is stretched along y.
const View mirrored = views::mirrored(Mat2{{0, 1}, {1, 0}}, Vec2::Zero());
const View turned = views::turned(Eigen::Rotation2Dd(std::numbers::pi / 6).toRotationMatrix());

const SeveralViews in_views{.views = {views::plain(), mirrored, views::carried_along({0.3, 0.2}), turned,
                                      views::on_disturbed_lattice(0.1 * spacing_of_all), views::numbered_anew()},
                            .spacing = spacing_of_all,
                            .cell = 2 * spacing_of_all,
                            .end = end,
                            .error = axes_error};

Scene<Tait> scene_of(const View& view) {
  Scene<Tait> seen = scene();
  seen.start = {.velocity = [=](const Vec2& x) { return view.velocity(velocity, x, 0); },
                .pressure = [=](const Vec2& x) { return view.pressure(pressure, x, 0); },
                .places = [=](const Vectors& lattice) { return view.places_on(within(lattice)); }};
  return seen;
}

}  // namespace

Case vnv::the_case() {
  Case declared = in_views.declared(
      error_of_axes, in_views.methods(scene_of, methods_on, {"sph", "sph_corrected"}),
      "Carried along: a uniform velocity of (0.3, 0.2) m/s is added. Turned: rotated by 30 degrees. Disturbed "
      "lattice: each particle starts up to a tenth of a spacing off its place.");
  declared.title = "Invariance: stretching drop";
  declared.description =
      "A circular drop of an inviscid fluid is stretched to twice its length, 30 particles across, under symmetry transformations: "
      "mirrored, so that it is stretched along y; carried along at (0.3, 0.2) m/s; rotated by 30 degrees; from a "
      "disturbed lattice; with renumbered particles. The equations are invariant. Every method claims the "
      "mirror image and the renumbering; SPH, which has no grid, also Galilean invariance. Rotated, "
      "the drop is not stretched along rows of particles.";
  declared.watch = watch_axes();
  return declared;
}

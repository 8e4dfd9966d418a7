/// A rotating square patch that is mirrored, carried along, turned, on a disturbed lattice and with particles numbered
/// anew: a free surface with corners, under tension.

#include "vnv/flows/patch.hpp"
#include "vnv/measures/decay.hpp"
#include "vnv/studies/views.hpp"

#include <numbers>

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::patch;

namespace {

constexpr double end = 0.3;                // s
constexpr double spacing_of_all = L / 24;  // m

/// The lattice turns with the patch, so that its sides stay even.
View turned_with_its_lattice() {
  View view = views::turned(Eigen::Rotation2Dd(std::numbers::pi / 6).toRotationMatrix());
  view.rearranged = [by = view.turned](const Vectors& lattice) -> Vectors { return by * lattice; };
  return view;
}

const View turned = turned_with_its_lattice();

const SeveralViews in_views{
    .views = {views::plain(), views::mirrored_about_x(0), views::carried_along({0.5, 0.3}), turned,
              views::on_disturbed_lattice(0.1 * spacing_of_all), views::numbered_anew()},
    .spacing = spacing_of_all,
    .cell = 2 * spacing_of_all,
    .end = end,
    .error = {"kinetic energy over that of a rigidly rotating square"}};

Scene<Tait> scene_of(const View& view) {
  Scene<Tait> seen = scene();
  seen.start = {.velocity = [=](const Vec2& x) { return view.velocity(velocity, x, 0); },
                .pressure = [=](const Vec2& x) { return view.pressure(pressure, x, 0); },
                .places = view.rearranged};
  return seen;
}

std::vector<Method> methods_on(const Scene<Tait>& seen) {
  return {printed(seen), apic(seen), delta(seen), shifted(seen)};
}

}  // namespace

Case vnv::the_case() {
  Case declared = in_views.declared(
      kinetic_energy_over(exact.kinetic_energy(), in_views.error),
      in_views.methods(scene_of, methods_on, {"sph_delta"}),
      "Carried along: all moves with (0.5, 0.3) m/s besides. Turned: by 30 degrees, and the lattice with the patch. "
      "Disturbed lattice: each particle starts up to a tenth of a spacing off its place.");
  for (Method& method : declared.methods)
    if (method.name.starts_with("sph"))
      method.claims.push_back(in_views.unchanged(turned, "without a grid there are no directions"));
  declared.title = "Invariance: a rotating patch";
  declared.description =
      "A square patch that rotates in nothing, 24 particles across, seen in other ways: mirrored, so that it turns the other "
      "way; carried along at (0.5, 0.3) m/s; turned by 30 degrees with its lattice; from a disturbed lattice; with particles "
      "numbered anew. What should be the same is its kinetic energy after 0.3 s, for one who moves along. Physics knows no "
      "difference. Every method claims the mirror image and the numbers; SPH, which knows no grid, also the view of one who is "
      "turned, and without shifting that of one who is carried along: how far it shifts depends on speeds as they are at "
      "rest.";
  return declared;
}

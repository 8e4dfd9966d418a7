/// A standing gravity wave that is carried along, on a disturbed lattice and with particles numbered anew: gravity, a
/// free surface and a floor. Its mirror image is the wave itself.

#include "vnv/flows/gravity_wave.hpp"
#include "vnv/studies/views.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::gravity_wave;

namespace {

constexpr double end = 0.6;                // s  three quarters of a period: the wave is fastest
constexpr double spacing_of_all = L / 40;  // m

const SeveralViews in_views{.views = {views::plain(), views::carried_along({0.5, 0}),
                                      views::on_disturbed_lattice(0.1 * spacing_of_all), views::numbered_anew()},
                            .spacing = spacing_of_all,
                            .cell = 2 * spacing_of_all,
                            .end = end,
                            .error = l2_velocity};

Scene<Newtonian, Uniform> scene_of(const View& view) {
  Scene<Newtonian, Uniform> seen = scene;
  seen.start.velocity = [=](const Vec2&) { return view.carried; };
  seen.start.places = [=](const Vectors& lattice) { return view.places_on(heaped(lattice)); };
  return seen;
}

}  // namespace

Case vnv::the_case() {
  Case declared =
      in_views.declared(velocity_errors([](const Vec2& x, double t) -> Vec2 {
                          return {exact.v_x(x.x(), x.y(), t), exact.v_y(x.x(), x.y(), t)};
                        }),
                        in_views.methods(scene_of, methods_on),
                        "Carried along: all moves with 0.5 m/s besides. Disturbed lattice: each particle starts "
                        "up to a tenth of a spacing off its place.");
  declared.title = "Invariance: a gravity wave";
  declared.description =
      "A standing gravity wave of small amplitude, 40 particles to its length, seen in other ways: carried along "
      "at 0.5 m/s; from a disturbed lattice; with particles numbered anew. Physics knows no difference. Every "
      "method claims the numbers. None claims more: the particles that make the floor of SPH are no even floor to "
      "slide along.";
  return declared;
}

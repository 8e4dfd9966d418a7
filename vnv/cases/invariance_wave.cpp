/// A standing gravity wave under symmetry transformations: gravity, a free surface and a floor. Its mirror image is the
/// wave itself.

#include "vnv/flows/gravity_wave.hpp"
#include "vnv/studies/views.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::gravity_wave;

namespace {

constexpr double end = 0.6;  // s  three quarters of a period: the wave is fastest

const SeveralViews in_views = several_views({views::carried_along({0.5, 0})}, published.L / 40, end, l2_velocity);

auto scene_in(const View& view) { return view.scene(scene_of<Newtonian, Uniform>(flow_named("standing_wave"))); }

std::vector<Method> methods_on(const Scene<Newtonian, Uniform>& seen) {
  return free_surface_methods(seen, output_interval);
}

}  // namespace

Case vnv::the_case() {
  const auto wave = flow_named("standing_wave").oracle<reference::StandingWave>();
  const VelocityTruth exact = [wave](const Vec2& x, double t) -> Vec2 {
    return {wave.v_x(x.x(), x.y(), t), wave.v_y(x.x(), x.y(), t)};
  };
  return in_views.declared(
      "Invariance: standing gravity wave",
      "A standing gravity wave of small amplitude, 40 particles per wavelength, under symmetry transformations: in a "
      "frame moving at 0.5 m/s; from a disturbed lattice; with renumbered particles. The equations are invariant. "
      "Every method claims invariance under renumbering. None claims more: the boundary particles of SPH do not make a "
      "perfectly smooth bottom.",
      velocity_errors(exact), in_views.methods(scene_in, methods_on),
      "Carried along: a uniform velocity of 0.5 m/s is added.");
}

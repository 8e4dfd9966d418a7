/// Water at rest under symmetry transformations: gravity, a free surface and a floor. Its mirror image is the water
/// itself.

#include "vnv/flows/water_at_rest.hpp"
#include "vnv/studies/views.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::water_at_rest;

namespace {

constexpr double end = 1;  // s

const SeveralViews in_views = several_views({views::carried_along({0.5, 0})}, depth / 20, end, l2_p);

auto scene_in(const View& view) { return view.scene(scene_of<Tait, Uniform>(flow_named("hydrostatic"))); }

}  // namespace

Case vnv::the_case() {
  const auto water = flow_named("hydrostatic").oracle<reference::Hydrostatic>();
  return in_views.declared(
      "Invariance: hydrostatic equilibrium",
      "Water 1 m deep under gravity, 20 particles over the depth, under symmetry transformations: in a frame moving at "
      "0.5 m/s; from a disturbed lattice; with renumbered particles. The equations are invariant. Every method claims "
      "invariance under renumbering. None claims more: the boundary particles of SPH do not make a perfectly smooth "
      "bottom, and water whose particles are not in rows is not in equilibrium.",
      norms_of("p, per particle", pressures, pressure_of(water)), in_views.methods(scene_in, methods_on),
      "Carried along: a uniform velocity of 0.5 m/s is added.");
}

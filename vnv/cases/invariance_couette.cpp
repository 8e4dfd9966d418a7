/// Start-up of plane Couette flow under symmetry transformations: walls that move, and both at once.

#include "solvers/walls/no_slip.hpp"
#include "vnv/flows/channels/channel_flow.hpp"
#include "vnv/studies/views.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::channel;

namespace {

constexpr double sliding = 1 * mm, end = 0.1;  // m/s, s

const SeveralViews in_views =
    several_views({views::mirrored_about_y(H / 2), views::carried_along({2 * sliding, 0})}, H / 16, end, l2);

Scene<Newtonian> scene_in(const View& view) {
  const auto plate = [&](double y) {
    const VelocityTruth of_plates = [](const Vec2& x, double) -> Vec2 { return {x.y() > H / 2 ? sliding : 0, 0}; };
    return no_slip(view.velocity(of_plates, {0, y}, 0));
  };
  return {.domain = {.box = gap, .periodic_x = true},
          .fluid = water,
          .filled = gap,
          .walls = {floor_at(0, plate(0)), ceiling_at(H, plate(H))},
          .start = {.velocity = [=](const Vec2&) { return view.carried; }, .places = view.rearranged}};
}

/// The methods along the channel; the regularised one by the step that its baselines were accepted with.
std::vector<Method> methods_at_given_steps(const Scene<Newtonian>& seen) {
  std::vector<Method> all = methods_along(seen);
  for (Method& method : all)
    if (method.name == "sph_regularised") {
      method.run = sph_with_transport_velocity(seen);
      method.time_step = nullptr;
    }
  return all;
}

}  // namespace

Case vnv::the_case() {
  const Flow flow = flow_named("couette", Settings({{"V", sliding}}));
  return in_views.declared(
      "Invariance: Couette flow",
      "Start-up of plane Couette flow, one plate sliding at 1 mm/s, 16 particles across, under symmetry transformations: "
      "mirrored, so that the lower plate slides; carried along at 2 mm/s with both plates; from a disturbed "
      "lattice; with renumbered particles. The equations are invariant. Every method claims invariance under "
      "reflection and renumbering. None claims more: the wall particles of SPH stand still even where the wall moves, "
      "so that the lattice of the fluid moves past them.",
      norms_of("v_x, per particle", by_particles, flow.along_x()), in_views.methods(scene_in, methods_at_given_steps),
      "Carried along: a uniform velocity of 2 mm/s is added.");
}

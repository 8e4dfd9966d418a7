#pragma once
/// Flows in a square that repeats along both axes, under symmetry transformations, by six methods.

#include "vnv/flows/flow.hpp"
#include "vnv/flows/squares/square.hpp"
#include "vnv/studies/views.hpp"

namespace touchstone::vnv::square {

/// By the angle of the direction (2, 1), 26.6 degrees: the only one below 30 degrees for which a square of less than
/// ten periods repeats.
inline Mat2 oblique() { return (Mat2() << 2, -1, 1, 2).finished() / std::sqrt(5); }

/// The views, and what methods claim of them.
inline const std::string the_views =
    "mirrored, in a moving frame, rotated, from a disturbed lattice, with renumbered particles. ";
inline const std::string claimed_of_views =
    "The equations are invariant. A method claims what follows from its discretisation: every method invariance under "
    "reflection and renumbering; SPH, which has no grid, also Galilean invariance, except with the transport velocity, "
    "whose drift carries momentum as seen in the rest frame. None is isotropic or independent of the lattice: for "
    "these the table shows the loss of accuracy.";

/// At `end` [s], with 34 particles across a side: of these 2.236 times as many are a whole number, and so are
/// those of the cells.
template <class Force = NoForce>
Case in_several_views(
    std::string title, const std::string& description, const Flow& flow, double end,
    const std::function<Force(const View&)>& force_in = [](const View&) { return Force{}; }) {
  constexpr double spacing = side / 34;
  const View turned = views::turned(oblique());
  const SeveralViews flows =
      several_views({views::mirrored_about_x(0), views::carried_along({1, 0.5}), turned}, spacing, end, l2_velocity);
  const auto scene_in = [=](const View& view) -> Scene<Newtonian, Force> {
    const double period = view.name == turned.name ? std::sqrt(5) * side : side;
    const Box repeated{.high = {period, period}};
    return {.domain = {.box = repeated, .periodic_x = true, .periodic_y = true},
            .fluid = flow.fluid,
            .filled = repeated,
            .body_force = force_in(view),
            .start = view.start(flow.start)};
  };
  return flows.declared(
      std::move(title), description + claimed_of_views, velocity_errors(flow.velocity()),
      flows.methods(scene_in, methods_on<Force>, {"sph", "sph_second_order"}),
      "Carried along: a uniform velocity of (1, 0.5) m/s is added. Turned: rotated by 26.6 degrees relative to the "
      "lattice.");
}

}  // namespace touchstone::vnv::square

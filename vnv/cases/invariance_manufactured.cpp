/// The manufactured solution under symmetry transformations, and its body force with it: every term of the equations
/// takes part.

#include "vnv/flows/manufactured.hpp"
#include "vnv/flows/squares/square_views.hpp"

using namespace touchstone;
using namespace touchstone::vnv;

Case vnv::the_case() {
  const Flow flow = flow_named("manufactured");
  const auto force_in = [force = flow.drive.at](const View& view) -> ForceField {
    return {[=](const Vec2& x, double t) -> Vec2 { return view.turned * force(view.place_in_plain_flow(x, t), t); }};
  };
  Case declared = square::in_several_views<ForceField>(
      "Invariance: manufactured solution",
      "The manufactured solution, 34 particles across a period, under symmetry transformations that include the body force that "
      "sustains it: " +
          square::the_views,
      flow, manufactured::end, force_in);
  for (Method& method : declared.methods)
    if (method.name == "sph_transport_velocity") method.claims.push_back(manufactured::parted_by_transport);
  return declared;
}

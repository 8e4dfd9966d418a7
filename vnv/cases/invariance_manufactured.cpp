/// The manufactured solution under symmetry transformations, and its body force with it: every term of the equations
/// takes part.

#include "vnv/flows/manufactured.hpp"
#include "vnv/flows/square_views.hpp"

using namespace touchstone;
using namespace touchstone::vnv;

Case vnv::the_case() {
  Case declared = square::in_several_views(
      square::PlaneFlow<ForceField>{manufactured::fluid, manufactured::velocity, manufactured::pressure,
                                    [](const View& view) { return ForceField{manufactured::Sustaining{view}}; }},
      manufactured::end);
  for (Method& method : declared.methods)
    if (method.name == "sph_transport_velocity") method.claims.push_back(manufactured::parted_by_transport);
  declared.title = "Invariance: manufactured solution";
  declared.description =
      "The manufactured solution, 34 particles across a period, under symmetry transformations that include the body force that "
      "sustains it: mirrored, in a moving frame, rotated, from a disturbed lattice, with renumbered particles. " +
      square::claimed_of_views;
  return declared;
}

/// Taylor-Green vortices under symmetry transformations.

#include "vnv/flows/square_views.hpp"
#include "vnv/flows/taylor_green.hpp"

using namespace touchstone;
using namespace touchstone::vnv;

Case vnv::the_case() {
  const taylor_green::Flow flow{.reynolds = 100, .sound_speed = 10};
  Case declared = square::in_several_views(square::PlaneFlow<>{flow.fluid(), flow.velocity(), flow.pressure()}, 0.2);
  declared.title = "Invariance: Taylor-Green vortices";
  declared.description =
      "Taylor-Green vortices, Reynolds number 100 and Mach number 0.1, 34 particles per period, under symmetry transformations: "
      "mirrored, in a moving frame, rotated, from a disturbed lattice, with renumbered particles. " +
      square::claimed_of_views;
  return declared;
}

/// A decaying shear wave under symmetry transformations: on its lattice rows of particles slip past each other, turned
/// they do not.

#include "vnv/flows/squares/square_views.hpp"

using namespace touchstone;
using namespace touchstone::vnv;

Case vnv::the_case() {
  return square::in_several_views(
      "Invariance: shear wave",
      "A decaying shear wave, Reynolds number 100 and Mach number 0.1, 34 particles per wavelength, under symmetry transformations: " +
          square::the_views +
          "On the original lattice rows of particles slip past each other; on the rotated one they do not. ",
      flow_named("shear_wave"), 0.2);
}

/// A decaying wave of shear that is mirrored, carried along, turned, on a disturbed lattice and with particles numbered
/// anew: on its lattice rows of particles slip past each other, turned they do not.

#include "reference/shear_wave.hpp"
#include "vnv/flows/square_views.hpp"

using namespace touchstone;
using namespace touchstone::vnv;

namespace {

constexpr double U = 1, c = 10, rho = 1000, Re = 100;  // m/s, m/s, kg/m³, -
constexpr Newtonian fluid{{.density = rho, .bulk_modulus = rho * c * c / 7}, rho* U* square::side / Re};
const reference::ShearWave exact{.L = square::side, .U = U, .nu = fluid.kinematic_viscosity()};

}  // namespace

Case vnv::the_case() {
  Case declared = square::in_several_views(square::PlaneFlow<>{.fluid = fluid,
                                                               .velocity = [](const Vec2& x, double t) -> Vec2 {
                                                                 return {exact(x.y(), t), 0};
                                                               },
                                                               .pressure = [](const Vec2&, double) { return 0.0; }},
                                           0.2);
  declared.title = "Invariance: shear wave";
  declared.description =
      "A decaying shear wave, Reynolds number 100 and Mach number 0.1, 34 particles per wavelength, under symmetry transformations: "
      "mirrored, in a moving frame, rotated, from a disturbed lattice, with renumbered particles. On the original lattice rows of "
      "particles slip past each other; on the rotated one they do not. " +
      square::claimed_of_views;
  return declared;
}

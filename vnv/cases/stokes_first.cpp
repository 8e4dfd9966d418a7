/// Stokes' first problem: a plate below a fluid at rest slides from t = 0, and the boundary layer grows into the fluid.

#include "reference/stokes.hpp"
#include "solvers/walls/free_slip.hpp"
#include "solvers/walls/no_slip.hpp"
#include "vnv/flows/channel_flow.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::channel;

namespace {

constexpr double V = 1 * mm;  // m/s

/// At the end the layer is a tenth of the gap thick: at the ceiling the oracle is 1e-12 of the plate velocity.
const Scene<Newtonian> scene = between_plates(gap, water, no_slip({V, 0}), free_slip());
constexpr double early = 2.5e-3, end = 10e-3;  // s

const reference::StokesFirst exact{.V = V, .nu = water.kinematic_viscosity()};

}  // namespace

Case vnv::the_case() {
  return flow_along(
      {.title = "Stokes' first problem",
       .description =
           "A plate below water at rest slides at 1 mm/s from t = 0. The oracle is Stokes' (1851), erfc(y / 2 sqrt(nu t)); the "
           "layer is 0.1 mm thick at the end, a tenth of the depth, so that the free-slip ceiling is "
           "outside the boundary layer."},
      scene, {early, end}, exact, {40, 48, 56, 80, 112});
}

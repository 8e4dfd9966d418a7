/// Stokes' second problem: a plate below a fluid oscillates in its own plane, and the motion decays with height.

#include "reference/stokes.hpp"
#include "solvers/walls/free_slip.hpp"
#include "solvers/walls/oscillating.hpp"
#include "vnv/flows/channel_flow.hpp"

#include <numbers>

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::channel;

namespace {

constexpr double V = 1 * mm;      // m/s
constexpr double period = 20e-3;  // s  the layer is 0.08 mm thick: 4e-6 of the motion is left at the ceiling
constexpr double omega = 2 * std::numbers::pi / period;

const reference::StokesSecond exact{.V = V, .omega = omega, .nu = water.kinematic_viscosity()};

const Scene<Newtonian> scene =
    between_plates(gap, water, oscillating({V, 0}, omega), free_slip(), NoForce{}, start_of(exact));

}  // namespace

Case vnv::the_case() {
  return flow_along(
      {.title = "Stokes' second problem",
       .description =
           "A plate below water oscillates in its own plane with an amplitude of 1 mm/s and a period of 20 ms; water far above is at rest. The oracle is "
           "Stokes' (1851) for a plate that has always oscillated, whose velocity at t = 0 is the initial state; the Stokes layer is 0.08 mm thick, a "
           "twelfth of the depth."},
      scene, {period / 4, 3 * period / 4}, exact, {40, 48, 56, 80, 112});
}

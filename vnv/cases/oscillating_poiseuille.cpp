/// Oscillating plane Poiseuille flow: Womersley flow between plates.

#include "reference/oscillating_poiseuille.hpp"
#include "solvers/forces/force_field.hpp"
#include "solvers/forces/oscillating.hpp"
#include "solvers/walls/no_slip.hpp"
#include "vnv/flows/channel_flow.hpp"

#include <numbers>

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::channel;

namespace {

constexpr double F = 40 * mm;      // m/s²
constexpr double period = 100e-3;  // s  the Womersley number, of half the gap, is 4
constexpr double omega = 2 * std::numbers::pi / period;

const reference::OscillatingPoiseuille exact{.H = H, .F = F, .omega = omega, .nu = water.kinematic_viscosity()};

const Scene<Newtonian, ForceField> scene =
    between_plates(gap, water, no_slip(), no_slip(), ForceField{Oscillating{{F, 0}, omega}}, start_of(exact));

}  // namespace

Case vnv::the_case() {
  return flow_along(
      {.title = "Oscillating Poiseuille flow",
       .description =
           "A body force along a channel of 1 mm oscillates with an amplitude of 40 mm/s² at 10 Hz; the Womersley number "
           "based on half the gap is 4, so that the near-wall flow leads the core in phase. The oracle is the plane form of "
           "Womersley's (1955) solution for a force that has always oscillated; its velocity at t = 0 is the initial state."},
      scene, {period / 4, 3 * period / 4}, exact, {20, 28, 40, 56, 80});
}

/// Plane Poiseuille flow whose force swings: Womersley's flow in the plane.

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

const Scene<Newtonian, ForceField> scene{
    .domain = {.box = gap, .periodic_x = true},
    .fluid = water,
    .filled = gap,
    .walls = {floor_at(0, no_slip()), ceiling_at(H, no_slip())},
    .body_force = {Oscillating{{F, 0}, omega}},
    .start = {.velocity = [](const Vec2& x) -> Vec2 {
      return {exact(x.y(), 0), 0};
    }},
};

}  // namespace

Case vnv::the_case() {
  Case declared = flow_along(scene, {period / 4, 3 * period / 4}, exact, {20, 28, 40, 56, 80});
  declared.title = "Oscillating Poiseuille flow";
  declared.description =
      "A force along a channel of 1 mm swings with up to 40 mm/s², ten times a second; the Womersley number of half the gap is "
      "4, so that water at the walls turns before that in the middle. The oracle is Womersley's (1955) in the plane, for a "
      "force that has swung for ever; its motion at t = 0 is the start.";
  return declared;
}

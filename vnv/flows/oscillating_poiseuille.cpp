/// Oscillating plane Poiseuille flow: Womersley flow between plates.

#include "reference/oscillating_poiseuille.hpp"
#include "solvers/walls/no_slip.hpp"
#include "vnv/flows/channels/plates.hpp"

namespace touchstone::vnv::flows {

Flow oscillating_poiseuille(Settings& set) {
  const Plates plates(set);
  const double F = set("F", 40 * mm, "m/s²", "amplitude of the body force along x, per mass");
  const Oscillation force(set, 0.1, "of the body force");
  Flow flow = plates.flow(
      "Oscillating Poiseuille flow",
      "A body force along a channel oscillates as cos(2 pi t / period). The oracle is the plane form of Womersley's "
      "(1955) solution for a force that has always oscillated; its velocity at t = 0 is the initial state.",
      force.times(), no_slip(), no_slip(),
      [=](const Changes& by) {
        return reference::OscillatingPoiseuille{
            .H = plates.H(by), .F = F * (1 + by(Cause::force)), .omega = force.omega(), .nu = plates.nu(by)};
      },
      of_two_plates_and_force);
  flow.drive = {{F, 0}, force.omega()};
  flow.exact[0].period = force.period;
  return flow;
}

}  // namespace touchstone::vnv::flows

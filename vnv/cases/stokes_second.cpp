/// Stokes' second problem (vnv/flows/stokes_second.cpp) by six methods.

#include "vnv/flows/channels/channel_flow.hpp"

touchstone::vnv::Case touchstone::vnv::the_case() {
  return channel::flow_along(
      flow_named("stokes_second"), {40, 48, 56, 80, 112},
      "The layer is 0.08 mm thick, a twelfth of the depth: 4e-6 of the motion is left at the ceiling.");
}

/// Stokes' first problem (vnv/flows/stokes_first.cpp) by six methods.

#include "vnv/flows/channels/channel_flow.hpp"

touchstone::vnv::Case touchstone::vnv::the_case() {
  return channel::flow_along(
      flow_named("stokes_first"), {40, 48, 56, 80, 112},
      "The layer is a tenth of the gap thick at the end; at the ceiling the oracle is 1e-12 of the plate's velocity.");
}

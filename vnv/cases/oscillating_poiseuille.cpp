/// Oscillating plane Poiseuille flow (vnv/flows/oscillating_poiseuille.cpp) by six methods.

#include "vnv/flows/channels/channel_flow.hpp"

touchstone::vnv::Case touchstone::vnv::the_case() {
  return channel::flow_along(
      flow_named("oscillating_poiseuille"), {20, 28, 40, 56, 80},
      "The Womersley number, based on half the gap, is 4, so that the near-wall flow leads the core in "
      "phase.");
}

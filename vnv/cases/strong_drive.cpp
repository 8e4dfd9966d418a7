/// Poiseuille flow with a hundredfold body force, Reynolds number 100, Mach number 0.1.

#include "vnv/flows/channels/driven_channel.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::channel;

Case vnv::the_case() {
  constexpr double end = 0.5;  // s
  Case declared = forty_across(flow_named("poiseuille", Settings({{"F", 100 * drive}})), {0.05, end}, dt, 2 * dt);
  declared.title = "Poiseuille flow with a hundredfold body force";
  declared.description =
      "Poiseuille flow with a body force of 0.8 m/s², a hundred times the paper's: steady velocity 0.1 m/s, "
      "Reynolds number 100, Mach number 0.1. Expected: every method as accurate as with the paper's force; particle rows "
      "slide past each other at a hundred times the speed. The oracle is the exact series.";
  const Author twice = baseline("twice the error with the paper's bulk modulus and force");
  const Author papers = literature("Sun et al., table 3, S1, for the paper's force");
  declared.methods[0].claims = {at_most(l2_rows, 0.17, twice)};
  declared.methods[1].claims = {at_most(l2_rows, 4.39, papers).on("S1").at(end)};
  declared.methods[2].claims = {at_most(l2_rows, 0.34, twice)};
  return declared;
}

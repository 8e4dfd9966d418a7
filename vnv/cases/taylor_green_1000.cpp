/// Decaying Taylor-Green vortices at Re = 1000 [Taylor 1923]: ten times less viscosity than in
/// `taylor_green` to hide what a method damps of its own.

#include "vnv/flows/taylor_green.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::taylor_green;

Case vnv::the_case() {
  Case declared = taylor_green::declared(flow_named("taylor_green", Settings({{"Re", 1000}, {"c", 40}})),
                                         {{50, early, 0, end}, {70, 0, 0, end}, {100, 0, 0, end}, {140, 0, 0, early}});
  declared.description += " The kinetic energy decays by 4 % in half a second: numerical dissipation is visible.";
  return declared;
}

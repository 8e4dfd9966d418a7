/// Taylor-Green vortices under symmetry transformations.

#include "vnv/flows/squares/square_views.hpp"

using namespace touchstone;
using namespace touchstone::vnv;

Case vnv::the_case() {
  return square::in_several_views(
      "Invariance: Taylor-Green vortices",
      "Taylor-Green vortices, Reynolds number 100 and Mach number 0.1, 34 particles per period, under symmetry transformations: " +
          square::the_views,
      flow_named("taylor_green", Settings({{"c", 10}})), 0.2);
}

/// Decaying Taylor-Green vortices at Re = 1000 [Taylor 1923]: ten times less viscosity than in
/// `taylor_green` to hide what a method damps of its own.

#include "vnv/flows/taylor_green.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::square;

namespace {

constexpr double early = 0.1, end = 0.5;  // s
constexpr taylor_green::Flow flow{.reynolds = 1000, .sound_speed = 40};
const Scene<Newtonian> scene = flow.scene();

const std::vector<Level> finely =
    levels_across(side, {{50, early, 0, end}, {70, 0, 0, end}, {100, 0, 0, end}, {140, 0, 0, early}});
const std::vector<Level> coarsely = levels_across(side, {{50, early, 0, end}, {100, 0, 0, end}});

}  // namespace

Case vnv::the_case() {
  Case declared = taylor_green::declared(flow, early, end, 50);
  declared.title = "Taylor-Green vortices at Re = 1000";
  declared.description =
      "Four vortices in a periodic square of 1 m decay; maximum initial speed 1 m/s, Mach number 1/40. The oracle is "
      "Taylor's solution for an incompressible fluid. The kinetic energy decays by 4 % in half a second: numerical dissipation "
      "is visible.";
  declared.methods = {with_ladder(coarsely, mpm_as_printed(scene, output_interval)),
                      with_ladder(coarsely, mpm_affine(scene, output_interval)),
                      with_ladder(finely, mpm_least_squares(scene, output_interval)),
                      with_ladder(coarsely, sph_as_printed(scene, output_interval)),
                      with_ladder(coarsely, sph_transport_velocity(scene, output_interval)),
                      with_ladder(finely, sph_second_order(scene, output_interval))};
  return declared;
}

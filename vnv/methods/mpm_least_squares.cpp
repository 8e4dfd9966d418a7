#include "solvers/mpm/least_squares/least_squares.hpp"
#include "vnv/methods/scenes.hpp"

namespace touchstone::vnv {

Simulation mpm_least_squares_solver(const auto& scene, const Level& level, double time_step) {
  return mpm::least_squares(scene, {.cell = level.cell, .spacing = level.spacing, .time_step = time_step});
}

Method mpm_least_squares(const auto& scene, double output_interval, double courant) {
  return keeping_courant_number(
      courant, output_interval, scene, mpm_least_squares_solver,
      {.name = "mpm_least_squares",
       .family = Family::mpm,
       .description =
           "Material point method by least squares: nodal values from quadratic fits to the particles, the equations "
           "are solved by central differences on the nodes, particles are remeshed onto their lattice before its "
           "strain reaches a quarter; third-order Adams-Bashforth, four particles in a cell."});
}

#define TOUCHSTONE_COMPILE(...)                                                           \
  template Simulation mpm_least_squares_solver(const __VA_ARGS__&, const Level&, double); \
  template Method mpm_least_squares(const __VA_ARGS__&, double, double);
TOUCHSTONE_VISCOUS_SCENES(TOUCHSTONE_COMPILE)

}  // namespace touchstone::vnv

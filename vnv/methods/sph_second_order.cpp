#include "solvers/sph/kernels/wendland_c2.hpp"
#include "solvers/sph/second_order/second_order.hpp"
#include "vnv/methods/scenes.hpp"

namespace touchstone::vnv {

Simulation sph_second_order_solver(const auto& scene, const Level& level, double time_step) {
  return sph::second_order<sph::WendlandC2>(
      scene,
      {.spacing = level.spacing, .smoothing_length = level.smoothing_or(1.3 * level.spacing), .time_step = time_step});
}

Method sph_second_order(const auto& scene, double output_interval, double courant) {
  return keeping_courant_number(
      courant, output_interval, scene, sph_second_order_solver,
      {.name = "sph_second_order",
       .family = Family::sph,
       .description =
           "Smoothed particle hydrodynamics of second order: quadratic fits to velocity and pressure around each "
           "particle, particle shifting down the concentration gradient, third-order Adams-Bashforth, Wendland's C2 "
           "kernel with h = 1.3 spacings.",
       .relative_cost = 2,
       .kernel_support = sph::WendlandC2::support});
}

#define TOUCHSTONE_COMPILE(...)                                                          \
  template Simulation sph_second_order_solver(const __VA_ARGS__&, const Level&, double); \
  template Method sph_second_order(const __VA_ARGS__&, double, double);
TOUCHSTONE_VISCOUS_SCENES(TOUCHSTONE_COMPILE)

}  // namespace touchstone::vnv

#include "solvers/walls/navier_slip.hpp"

#include "solvers/fluids/newtonian.hpp"
#include "solvers/sph/free_surface/free_surface.hpp"
#include "solvers/sph/kernels/quintic_spline.hpp"
#include "solvers/sph/kernels/wendland_c2.hpp"
#include "solvers/sph/second_order/second_order.hpp"
#include "solvers/sph/terms/morris_viscosity.hpp"
#include "solvers/sph/terms/pressure_difference.hpp"
#include "solvers/sph/transport_velocity/transport_velocity.hpp"
#include "solvers/walls/no_slip.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace touchstone::sph {
namespace {

constexpr double H = 1, V = 1, b = 0.3, spacing = 0.05;  // m, m/s, m, m

/// Viscous fluid at rest between a floor over which it slips and a lid that moves.
Scene<Newtonian> couette() {
  return {.domain = {.box = {.high = {0.4, H}}, .periodic_x = true},
          .fluid = {{.density = 1000, .bulk_modulus = 14300}, 1000},
          .filled = {.high = {0.4, H}},
          .walls = {floor_at(0, navier_slip(b)), ceiling_at(H, no_slip({V, 0}))}};
}

/// The largest error of the steady profile V (y + b) / (H + b), over V, once the start has died away by 1e-5.
template <class Simulation>
double error_of(Simulation simulation) {
  while (simulation.time() < 2) simulation.step();
  const Samples s = simulation.samples();
  const Scalars exact = V * (s.x.row(1).transpose().array() + b) / (H + b);
  return (s.v.row(0).transpose().array() - exact).abs().maxCoeff() / V;
}

Settings settings(double h) { return {.spacing = spacing, .smoothing_length = h, .time_step = 2.5e-4}; }
const auto terms = momentum(PressureDifference{}, MorrisViscosity{.mu = 1000});

TEST(NavierSlip, GivesCouetteFlowItsSlipLengthExactlyWhereGhostsExtrapolate) {
  EXPECT_LT(error_of(second_order<WendlandC2>(couette(), settings(1.3 * spacing))), 1e-4);
}

TEST(NavierSlip, GivesCouetteFlowItsSlipLengthNearlyWhereGhostsMirrorTheMean) {
  EXPECT_LT(error_of(transport_velocity<QuinticSpline>(couette(), settings(spacing), terms)), 0.02);
  EXPECT_LT(error_of(free_surface<QuinticSpline>(couette(), settings(spacing), terms, Parts{})), 0.02);
}

TEST(NavierSlip, RefusesALengthThatIsNotPositive) {
  for (const double length : {0.0, -1.0, std::numeric_limits<double>::infinity()})
    EXPECT_THROW(navier_slip(length), std::invalid_argument);
}

}  // namespace
}  // namespace touchstone::sph

/// A square patch of fluid that starts in rigid rotation, with a free surface all around [Colagrossi 2005].

#include "vnv/flows/flow.hpp"
#include "vnv/flows/patch.hpp"
#include "vnv/measures/decay.hpp"
#include "vnv/measures/roughness.hpp"

namespace touchstone::vnv::flows {
namespace {

// With turn = omega t; as far as it is known, to turn = 1.
const Quantity corner_missed{"farthest that a corner is from its free path, over 1.5 + 3.5 (omega t)² spacings", "",
                             Kind::error},
    beyond_corners{"farthest particle beyond the free paths of the corners", "spacings"},
    second_moment{"second moment over that at the start, less the converged 1 + 0.15 (omega t)² + 0.07 (omega t)⁴", "",
                  Kind::deviation},
    turning{"angular momentum over the exact"}, moving{"kinetic energy over that at the start"};

/// What is known of the shape of a rotating patch. Its corners, at which both sides are without pressure, move freely:
/// each is where its first velocity has taken it. How it spreads is taken from four of our own methods, which agree at
/// 40 across within 0.013 at turn = 1.
std::vector<Value> shape_of(const reference::RotatingPatch& patch, const Level& level, const Samples& s) {
  const double half = patch.L / 2, turn = patch.omega * s.time;
  if (turn > 1 + time_tolerance) return {};
  double farthest = 0;
  for (const auto& [x, y] :
       {std::pair(half, half), std::pair(-half, half), std::pair(half, -half), std::pair(-half, -half)})
    farthest = std::max(farthest, (s.x.colwise() - Vec2(x + turn * y, y - turn * x)).colwise().norm().minCoeff());
  const double reach = half * std::sqrt(2 * (1 + turn * turn)), beyond = s.x.colwise().norm().maxCoeff() - reach,
               moment = (s.mass * s.x.colwise().squaredNorm().transpose().array()).sum() / s.mass.sum(),
               converged = 1 + 0.15 * turn * turn + 0.07 * std::pow(turn, 4);
  const auto value = [&](const Quantity& quantity, double found) {
    return Value{level.name, level.spacing, s.time, quantity, found};
  };
  return {value(corner_missed, farthest / level.spacing / (1.5 + 3.5 * turn * turn)),
          value(beyond_corners, beyond / level.spacing),
          value(second_moment, moment / (patch.L * patch.L / 6) - converged)};
}

std::vector<Value> against_first_motion(const reference::RotatingPatch& patch, const Level& level, const Samples& s) {
  const double mass = s.mass.sum(), unit = mass * patch.omega * patch.L * patch.L;
  const auto value = [&](const Quantity& quantity, double found) {
    return Value{level.name, level.spacing, s.time, quantity, found};
  };
  return {value(turning, -angular_momentum(s) / (unit / 6)),
          value(moving, kinetic_energy(s) / (unit * patch.omega / 12))};
}

}  // namespace

Flow rotating_patch(Settings& set) {
  using namespace patch;
  const double side = set.positive("L", L, "m", "side of the square");
  const double spin = set.positive("omega", omega, "1/s", "angular velocity at the start, clockwise");
  const double density = set.positive("rho", rho0, "kg/m³", "density at zero pressure");
  const double sound_speed = set.positive("c", c, "m/s", "speed of sound at zero pressure");
  const reference::RotatingPatch patch{.L = side, .omega = spin, .rho = density};
  Flow flow;
  set_scene(flow, scene_with(patch, sound_speed));
  flow.across = side;
  flow.judged.title = "Rotating square patch";
  flow.judged.description =
      "A square patch of an inviscid fluid starts in rigid rotation, with a free surface all around (Colagrossi 2005). Momentum, "
      "angular momentum and the symmetry of a square are conserved; kinetic energy too, in the incompressible limit.";
  flow.judged.times = {0.5 / spin, 1 / spin};
  flow.judged.monitor = monitored(side);
  flow.judged.monitor.interval /= spin;
  flow.judged.claims = {at_most(drift, 1e-6, theory("no external force; files in single precision")),
                        between(asymmetry, -1, 1, theory("fourfold symmetry"))};
  flow.judged.claims.insert(
      flow.judged.claims.end(),
      {at_most(corner_missed, 1,
               theory("a corner without pressure moves freely; our own methods trail by 4.5 spacings "
                      "at most at omega t = 1, whatever the spacing")),
       at_most(beyond_corners, 1, theory("a corner without pressure moves freely, and nothing is farther out")),
       between(turning, 0.95, 1.05, theory("no external torque")),
       between(moving, 0.85, 1.02, theory("nothing drives it; our own methods lose up to 6 % at 20 across"))});
  // Twice the integral of Prandtl's stress function over a square of side 1 [Timoshenko & Goodier: 0.1406 / 4].
  const Quantity mean{"mean pressure over that at the start, -0.0703 rho omega² L²"};
  flow.aside = {between(mean, 0.2, 2.5,
                        theory("what turns pulls inwards; of our own methods it is 0.6 to 1.2 times that "
                               "until omega t = 1"))};
  const auto spreads = [](double most) {
    return between(second_moment, -most, most,
                   baseline("four of our own methods differ by 0.013 at 40 across, and are up to 0.12 behind at 20"));
  };
  flow.of_resolved = {at_most(angular_momentum_error, 1, theory("no external torque")), spreads(0.05)};
  flow.of_coarse = [=](double across) { return std::vector{spreads(0.02 + 2.4 / across)}; };
  flow.resolved = 40;
  flow.measured = {
      {{"velocity"},
       conservation_errors(patch, [](const Level&) { return true; }),
       Span{0, 1 / spin, 2},
       "what is conserved"},
      {{}, [patch](const Level& level, const Run& run) { return shape_of(patch, level, run.samples.back()); }},
      {{"velocity"},
       [patch](const Level& level, const Run& run) { return against_first_motion(patch, level, run.samples.back()); }},
      {{"pressure"}, roughness_of_pressure(patch)},
      {{"pressure"}, central_pressure(patch)},
      {{"pressure"}, mean_pressure(mean, -0.07029 * patch.rho * patch.omega * patch.omega * patch.L * patch.L)}};
  return flow;
}

}  // namespace touchstone::vnv::flows

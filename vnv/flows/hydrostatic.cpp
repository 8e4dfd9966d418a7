/// Water at rest under gravity between a floor and a free surface.

#include "solvers/walls/free_slip.hpp"
#include "vnv/flows/water_at_rest.hpp"
#include "vnv/measures/decay.hpp"

namespace touchstone::vnv::flows {
namespace {

/// As deep as the water of uniform density would be of that depth.
reference::Hydrostatic equilibrium(const Tait& fluid, double g, double depth) {
  reference::Hydrostatic water{
      .rho0 = fluid.density, .K = fluid.bulk_modulus, .g = g, .h = depth, .gamma = Tait::gamma};
  double low = 0.9 * depth, high = depth;
  for (int k = 0; k < 60; ++k) {
    water.h = (low + high) / 2;
    (water.mass() < water.rho0 * depth ? low : high) = water.h;
  }
  water.h = (low + high) / 2;
  return water;
}

/// The height above which so much mass [kg/m²] lies in equilibrium: p = g mass.
double height_below(double mass, const reference::Hydrostatic& water) {
  const double power = water.gamma / (water.gamma - 1), rise = std::expm1(std::log1p(water.g * mass / water.K) / power);
  return water.h - power * water.K * rise / (water.rho0 * water.g);
}

}  // namespace

Flow hydrostatic(Settings& set) {
  using namespace water_at_rest;
  const double depth = set.positive("h", water_at_rest::depth, "m",
                                    "depth that the water would have if it were uncompressed");
  const double width = set.positive("L", 0.5, "m", "length of the periodic box");
  const double g = set.positive("g", water_at_rest::g, "m/s²", "gravity, down");
  Flow flow;
  flow.fluid = fluid_of(set, 1000, water_at_rest::c);
  const double rho = flow.fluid.density;
  const reference::Hydrostatic water = equilibrium(flow.fluid, g, depth);
  flow.exact_solution = water;
  flow.domain = {.box = {.high = {width, 1.2 * depth}}, .periodic_x = true};
  flow.filled = {.high = {width, depth}};
  flow.shape = "rows of a lattice, each moved to the height at which it has its equilibrium column of water above it,";
  flow.walls = {floor_at(0, free_slip())};
  flow.drive.amplitude = {0, -g};
  flow.start = {.pressure = [water](const Vec2& x) { return water.p(std::min(x.y(), water.h)); },
                .places =
                    [=](const Vectors& lattice) {
                      Vectors places = lattice;
                      for (double& y : places.row(1).reshaped()) y = height_below(rho * (depth - y), water);
                      return places;
                    }};
  flow.region = [domain = flow.domain, h = water.h](double) {
    return Region{.domain = domain, .box = {.low = domain.box.low, .high = {domain.box.high.x(), h}}};
  };
  flow.across = depth;
  flow.judged.title = "Hydrostatic equilibrium";
  flow.judged.description =
      "Water rests under gravity between a bottom wall and a free surface, periodic along x. The oracle is the "
      "equilibrium of Tait's law. Any motion is spurious.";
  flow.judged.times = {settled, 2, 10};
  flow.judged.monitor = {
      .interval = 0.05,
      .evaluate = [g](const Samples& s) -> std::vector<double> {
        return {kinetic_energy(s) / (g * (s.mass * s.x.row(1).transpose().array()).sum()), s.x.row(1).maxCoeff()};
      },
      .quantities = {{"kinetic over potential energy"}, {"height of the highest particle", "m"}}};
  const Quantity speed{"root mean square of the speed over sqrt(g h)", "%", Kind::error};
  flow.judged.claims = {is_consistent(l2_p)};
  flow.aside = {has_its_pressure(), at_most(speed, 10, theory("water at rest stays at rest"))};
  flow.of_resolved = {
      at_most(displacement, 1, theory("water at rest stays at rest; a surface is resolved to half a spacing"))};
  flow.resolved = 40;
  flow.exact = {{.field = "pressure",
                 .norms = {l2_p.name, "Linf p, per particle"},
                 .causes = {Cause::gravity},
                 .with = [=, fluid = flow.fluid](const Changes& by) -> FieldTruth {
                   const auto heavier = equilibrium(fluid, g * by.factor(Cause::gravity), depth);
                   return [truth = pressure_of(heavier)](const Vec2& x, double t) { return Vec2(truth(x.y(), t), 0); };
                 }}};
  const double unit = rho * depth * width * g * depth / 2;  // J/m
  flow.measured = {
      {{"pressure"}, norms_of("p, per particle", pressures, pressure_of(water))},
      {{"pressure"}, part_of_exact_pressure(flow.pressure(), false)},
      {{"velocity"},
       of_each_sample(speed, [=](const Samples& s) { return 100 * std::sqrt(kinetic_energy(s) / unit); })},
      {{"velocity"}, spurious_motion(depth), Span{0, settled, 3}, "rest"}};
  return flow;
}

}  // namespace touchstone::vnv::flows

/// Water at rest under gravity between a floor and a free surface.

#include "vnv/flows/flow.hpp"
#include "vnv/flows/water_at_rest.hpp"

namespace touchstone::vnv::flows {

Flow hydrostatic(Settings& set) {
  using namespace water_at_rest;
  Water water;
  water.depth = set.positive("h", water.depth, "m", "depth that the water would have if it were uncompressed");
  water.width = set.positive("L", water.width, "m", "length of the periodic box");
  water.g = set.positive("g", water.g, "m/s²", "gravity, down");
  water.rho0 = set.positive("rho", water.rho0, "kg/m³", "density at zero pressure");
  water.c = set.positive("c", water.c, "m/s", "speed of sound at zero pressure");
  Flow flow;
  set_scene(flow, scene_with(water));
  flow.shape = "rows of a lattice, each moved to the height at which it has its equilibrium column of water above it,";
  flow.region = [domain = flow.domain, h = water.exact().h](double) {
    return Region{.domain = domain, .box = {.low = domain.box.low, .high = {domain.box.high.x(), h}}};
  };
  flow.across = water.depth;
  flow.judged.title = "Hydrostatic equilibrium";
  flow.judged.description =
      "Water rests under gravity between a bottom wall and a free surface, periodic along x. The oracle is the equilibrium of "
      "Tait's law. Any motion is spurious.";
  flow.judged.times = {settled, 2, 10};
  flow.judged.monitor = monitored(water.g);
  const Quantity speed{"root mean square of the speed over sqrt(g h)", "%", Kind::error};
  flow.judged.claims = {is_consistent(l2_p)};
  flow.aside = {has_its_pressure(), at_most(speed, 10, theory("water at rest stays at rest"))};
  flow.of_resolved = {
      at_most(displacement, 1, theory("water at rest stays at rest; a surface is resolved to half a spacing"))};
  flow.resolved = 40;
  flow.exact = {{.field = "pressure",
                 .norms = {l2_p.name, "Linf p, per particle"},
                 .causes = {Cause::gravity},
                 .with = [water](const Changes& by) -> FieldTruth {
                   Water other = water;
                   other.g *= by.factor(Cause::gravity);
                   return [truth = pressure_of(other.exact())](const Vec2& x, double t) {
                     return Vec2(truth(x.y(), t), 0);
                   };
                 }}};
  const auto root_of_energy =
      kinetic_energy_over(water.rho0 * water.depth * water.width * water.g * water.depth / 2, speed);
  flow.measured = {
      {{"pressure"}, norms_of("p, per particle", pressures, pressure_of(water.exact()))},
      {{"pressure"},
       part_of_exact_pressure([truth = pressure_of(water.exact())](const Vec2& x, double t) { return truth(x.y(), t); },
                              false)},
      {{"velocity"},
       [=](const Level& level, const Run& run) {
         std::vector<Value> found = root_of_energy(level, run);
         for (Value& value : found) value.value = 100 * std::sqrt(value.value);
         return found;
       }},
      {{"velocity"}, spurious_motion(water.depth), Span{0, settled, 3}, "rest"}};
  return flow;
}

}  // namespace touchstone::vnv::flows

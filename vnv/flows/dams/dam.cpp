#include "vnv/flows/dams/dam.hpp"

#include "solvers/stepping/energy_budget.hpp"
#include "vnv/measures/decay.hpp"

namespace touchstone::vnv {

Series followed(const Run& run, std::size_t column) {
  Series series{run.history.time, {}};
  for (const std::vector<double>& row : run.history.values) series.value.push_back(row[column]);
  return series;
}

Samples within(const Samples& samples, double low, double high) {
  std::vector<Eigen::Index> inside;
  for (Eigen::Index p = 0; p < samples.size(); ++p)
    if (samples.x(0, p) > low && samples.x(0, p) < high) inside.push_back(p);
  return {samples.time,         samples.x(Eigen::all, inside), samples.v(Eigen::all, inside),
          samples.mass(inside), samples.density(inside),       samples.pressure(inside)};
}

std::vector<double> energies(const Samples& samples, const Tait& water, double gravity) {
  const auto elastic = [&](double density) { return elastic_energy(water, density); };
  return {kinetic_energy(samples), gravity * (samples.mass * samples.x.row(1).transpose().array()).sum(),
          (samples.mass * samples.density.unaryExpr(elastic)).sum()};
}

double largest_rise_of_energy(const Run& run, std::size_t kinetic, double fall) {
  double least = INFINITY, rise = 0;
  for (const std::vector<double>& row : run.history.values) {
    const double total = row[kinetic] + row[kinetic + 1] + row[kinetic + 2];
    least = std::min(least, total);
    rise = std::max(rise, total - least);
  }
  return rise / fall;
}

Scene<Tait, Uniform> without_gates(Scene<Tait, Uniform> scene) {
  std::erase_if(scene.walls, [](const Wall& wall) { return wall.is_partial(); });
  return scene;
}

Scene<Tait, SkinFriction> with_friction(const Scene<Tait, Uniform>& scene, SkinFriction friction) {
  friction.gravity = scene.body_force.per_mass;
  return {scene.domain, scene.fluid, scene.filled, scene.walls, friction, scene.start};
}

}  // namespace touchstone::vnv

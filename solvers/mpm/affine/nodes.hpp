#pragma once
#include "solvers/mpm/nodes_of_cells.hpp"
#include "solvers/mpm/printed/nodes.hpp"

namespace touchstone::mpm {

/// The nodes of the affine method: what cells give is mass and momentum, per mass of a particle.
class AffineNodes : public CentreNodes {
 public:
  AffineNodes(const Grid& grid, int block_width)
      : CentreNodes(grid, block_width, 3), mass(places()), momentum(places()), velocity(places()) {}

  Field<double> mass;    // particles
  NodeVectors momentum;  // m/s
  NodeVectors velocity;  // m/s

  /// Adds up what the nodes were given; `push` is a change of velocity [m/s] that all of them feel.
  void collect(const Vec2& push, int threads) {
    for_near(near(), threads, [&](int node) {
      const Lanes m = given(0, node);
      store(m, &mass[node]);
      store(Lanes(given(1, node) + push.x() * m), &momentum.x[node]);
      store(Lanes(given(2, node) + push.y() * m), &momentum.y[node]);
    });
  }

  void find_velocities(int threads) {
    for_near(near(), threads, [&](int node) {
      const Lanes m = load<Lanes>(&mass[node]);
      const auto moves = m > fill<Lanes>(Nodes::least_mass);
      const Lanes per_mass = moves ? 1 / (moves ? m : fill<Lanes>(1)) : Lanes{};
      store(Lanes(per_mass * load<Lanes>(&momentum.x[node])), &velocity.x[node]);
      store(Lanes(per_mass * load<Lanes>(&momentum.y[node])), &velocity.y[node]);
    });
  }
};

}  // namespace touchstone::mpm

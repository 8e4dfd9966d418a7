#pragma once
/// Ghost particles: layers of fixed particles behind the walls that carry the fluid on, with the velocity that the wall
/// mirrors. Shao et al. 2012; Adami, Hu & Adams 2012; Sun et al. 2.3.

#include "solvers/lattice.hpp"
#include "solvers/sph/neighbours.hpp"

#include <utility>

namespace touchstone::sph {

/// Where the boundary particles stand.
struct BoundaryLayout {
  struct Ghost {
    Vec2 x;
    std::vector<int> behind;  // the walls that it is behind: two in a corner
  };
  std::vector<Ghost> ghosts;   // those of gates last
  std::size_t of_gates = 0;    // how many of them, each behind one gate and nothing else
  std::vector<Vec2> on_walls;  // those of constant x first
  std::size_t on_upright = 0;  // how many of them are on walls of constant x
};

/// Refuses a wall with an extent, for methods that know none: std::invalid_argument with one line.
inline void require_across_the_domain(const std::vector<Wall>& walls) {
  for (const Wall& wall : walls)
    if (wall.is_partial())
      throw std::invalid_argument(fmt::format("sph: wall at {} = {} m has an extent, expected one across the domain",
                                              "xy"[wall.axis], wall.position));
}

/// Ghosts on the continued lattice of the fluid, `layers` deep behind each wall across the domain, corners included.
inline BoundaryLayout lay_out_ghosts_of_faces(const Domain& domain, const std::vector<Wall>& walls, double spacing,
                                              int layers) {
  const Lattice cells = lattice(domain.box, spacing);
  std::array<long, 2> before = {0, 0}, beyond = {0, 0};
  for (const Wall& wall : walls) {
    if (wall.is_partial()) continue;
    const double face = (wall.inward > 0 ? domain.box.low : domain.box.high)[wall.axis];
    if (std::abs(wall.position - face) > 1e-9 * domain.box.size()[wall.axis])
      throw std::invalid_argument(fmt::format("sph: wall at {} = {} m, expected on the face of the domain at {} m",
                                              "xy"[wall.axis], wall.position, face));
    (wall.inward > 0 ? before : beyond)[wall.axis] = layers;
  }

  BoundaryLayout layout;
  for (long row = -before[1]; row < cells.rows + beyond[1]; ++row)
    for (long column = -before[0]; column < cells.columns + beyond[0]; ++column) {
      BoundaryLayout::Ghost ghost{cells.place(column, row), {}};
      for (std::size_t w = 0; w < walls.size(); ++w)
        if (!walls[w].is_partial() && walls[w].distance(ghost.x) < 0) ghost.behind.push_back(static_cast<int>(w));
      if (!ghost.behind.empty()) layout.ghosts.push_back(std::move(ghost));
    }
  return layout;
}

inline BoundaryLayout lay_out_ghosts(const Domain& domain, const std::vector<Wall>& walls, double spacing, int layers) {
  require_across_the_domain(walls);
  return lay_out_ghosts_of_faces(domain, walls, spacing, layers);
}

/// The same, and behind the whole line of each wall with an extent, a gate inside the domain. Throws
/// std::invalid_argument with one line for one that stands elsewhere, or along a periodic axis, whose ghosts would have
/// images.
inline BoundaryLayout lay_out_ghosts_and_gates(const Domain& domain, const std::vector<Wall>& walls, double spacing,
                                               int layers) {
  BoundaryLayout layout = lay_out_ghosts_of_faces(domain, walls, spacing, layers);
  const Lattice cells = lattice(domain.box, spacing);
  const std::size_t of_faces = layout.ghosts.size();
  for (std::size_t w = 0; w < walls.size(); ++w) {
    const Wall& gate = walls[w];
    const int axis = gate.axis;
    if (!gate.is_partial()) continue;
    if (!(gate.position > domain.box.low[axis] && gate.position < domain.box.high[axis]))
      throw std::invalid_argument(fmt::format("sph: gate at {} = {} m, expected inside the domain, {} to {} m",
                                              "xy"[axis], gate.position, domain.box.low[axis], domain.box.high[axis]));
    if (domain.periodic(1 - axis))
      throw std::invalid_argument(
          fmt::format("sph: gate at {} = {} m, expected none along a periodic axis", "xy"[axis], gate.position));
    for (long k = 0; k < (axis == 0 ? cells.rows : cells.columns); ++k)
      for (int layer = 0; layer < layers; ++layer) {
        Vec2 x = cells.place(k, k);
        x[axis] = gate.position - gate.inward * (layer + 0.5) * cells.step[axis];
        layout.ghosts.push_back({x, {static_cast<int>(w)}});
      }
  }
  layout.of_gates = layout.ghosts.size() - of_faces;
  return layout;
}

/// Ghosts, and a row of particles on each wall at the spacing of the fluid.
inline BoundaryLayout lay_out_ghosts_and_walls(const Domain& domain, const std::vector<Wall>& walls, double spacing,
                                               int layers) {
  BoundaryLayout layout = lay_out_ghosts(domain, walls, spacing, layers);
  const Lattice cells = lattice(domain.box, spacing);
  for (const int axis : {0, 1}) {
    for (const Wall& wall : walls)
      for (long k = 0; wall.axis == axis && k < (axis == 0 ? cells.rows : cells.columns); ++k) {
        Vec2 x = cells.place(k, k);
        x[axis] = wall.position;
        layout.on_walls.push_back(x);
      }
    if (axis == 0) layout.on_upright = layout.on_walls.size();
  }
  return layout;
}

}  // namespace touchstone::sph

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
  std::vector<Ghost> ghosts;
  std::vector<Vec2> on_walls;  // those of constant x first
  std::size_t on_upright = 0;  // how many of them are on walls of constant x
};

/// Ghosts on the continued lattice of the fluid, `layers` deep behind each wall, corners included.
inline BoundaryLayout lay_out_ghosts(const Domain& domain, const std::vector<Wall>& walls, double spacing, int layers) {
  const Lattice cells = lattice(domain.box, spacing);
  std::array<long, 2> before = {0, 0}, beyond = {0, 0};
  for (const Wall& wall : walls) {
    if (wall.is_partial())
      throw std::invalid_argument(fmt::format("sph: wall at {} = {} m has an extent, expected one across the domain",
                                              "xy"[wall.axis], wall.position));
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
        if (walls[w].distance(ghost.x) < 0) ghost.behind.push_back(static_cast<int>(w));
      if (!ghost.behind.empty()) layout.ghosts.push_back(std::move(ghost));
    }
  return layout;
}

/// The same, and a row of particles on each wall at the spacing of the fluid.
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

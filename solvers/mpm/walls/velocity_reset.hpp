#pragma once
#include "solvers/mpm/walls/node_at_wall.hpp"

namespace touchstone::mpm {

/// The wall sets the node's velocity, and whatever that takes is felt by the particles as an acceleration, every step:
/// v = W(v_i'), a = (v - v_i) / dt. The usual reading of "the boundary condition is imposed on the nodes".
///
/// Expected of first order: the reset pulls the particles beside the wall to its velocity, wherever they are in their
/// cell. Poiseuille flow at 1 s in 40 cells, L2: 3.95 % with 1 particle per cell, 1.14 % with 4, 3.22 % in 20 cells
/// with 4; with 4 per cell Linf halves with the cell (9.8, 5.0, 2.5 %), and L2, in which few particles are wrong, falls
/// faster.
///
/// With one particle per cell, at its centre, a node sees the mean of the rows on either side. The reset gives the row
/// beside a wall the wall's own velocity, half a cell too soon, and every other row is then off by as much to the other
/// side: a pattern of rows that no node sees and no viscosity damps. Couette flow at 1 s in 40 cells is wrong by
/// V / 80 = 1.25 % of V in each row, alternately, 2.17 % in L2, at time steps of 5, 2.5 and 1 us alike; in 20 cells by
/// twice and in 80 by half as much. With 4 per cell the pattern is gone: 0.36 %.
struct VelocityReset {
  static void hold(const Wall& wall, NodeAtWall& node) { node.after = wall.at_wall(node.after, node.end); }
};

}  // namespace touchstone::mpm

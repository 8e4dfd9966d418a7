#pragma once
#include "solvers/walls/wall.hpp"

namespace touchstone::mpm {

/// A wall node over one step. A wall treatment sets its velocities at both ends of the step; the node moves with
/// `after` and the particles feel the acceleration (after - before) / dt.
struct NodeAtWall {
  Vec2 before, after;  // m/s
  double start, end;   // s
  bool first_step;
  Vec2 of_scene = Vec2::Zero();  // m/s  of the fluid here as the scene starts, which a wall may jump to its own
};

/// How a wall's answer reaches the particles: sets the velocities of a node.
using WallTreatment = void (*)(const Wall&, NodeAtWall&);

}  // namespace touchstone::mpm

#pragma once
/// Where an error lies that nothing explains.

#include "solvers/scene.hpp"

#include <string>
#include <vector>

namespace touchstone::vnv::doors {

/// A part of the fluid and its part of a squared error, in any unit.
struct Located {
  Vec2 x;
  double volume, squared;
};

/// "87 % of its square lies within 2 spacings of the lower wall, in 10 % of the fluid"; or that it is spread. Of walls,
/// free surface, corners, seams of a periodic box and the core, that in which most lies for its volume: the part times
/// the logarithm of how much denser it lies there, as a divergence of Kullback and Leibler adds it.
std::string where_it_lies(const std::vector<Located>& all, const Domain& domain, double spacing);

}  // namespace touchstone::vnv::doors

#pragma once
#include "solvers/walls/wall.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace touchstone::mpm {

/// The node along an axis that alone carries what is on a line of the grid, where a wall stands. Throws
/// std::invalid_argument if there is none: with wider shapes than hats inside the domain or on a periodic boundary.
template <class Along>
int node_alone_at(int line, const Along& along, const Wall& wall) {
  const auto near = along.near(line);
  const auto alone = std::find(near.weight.begin(), near.weight.end(), 1.0);
  if (alone == near.weight.end())
    throw std::invalid_argument(
        fmt::format("mpm: wall at {} = {:g} m, expected at an edge of the domain that is not periodic: this shape has "
                    "no node of its own elsewhere",
                    wall.axis == 0 ? "x" : "y", wall.position));
  return near.first + static_cast<int>(alone - near.weight.begin());
}

}  // namespace touchstone::mpm

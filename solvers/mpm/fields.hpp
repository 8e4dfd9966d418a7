#pragma once
#include "solvers/fields.hpp"
#include "solvers/mpm/cell_lanes.hpp"

#include <vector>

namespace touchstone::mpm {

/// One number per slot or per node, aligned as registers like it.
template <class Number>
using Field = std::vector<Number, Eigen::aligned_allocator<Number>>;

}  // namespace touchstone::mpm

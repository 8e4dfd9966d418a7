#pragma once
#include "solvers/fields.hpp"
#include "solvers/mpm/cell_lanes.hpp"

#include <array>
#include <vector>

namespace touchstone::mpm {

/// One number per slot or per node, aligned as registers like it.
template <class Number>
using Field = std::vector<Number, Eigen::aligned_allocator<Number>>;

/// One number for each column of nodes near a cell, and for each row; or for each function of X, and for each of Y.
template <class Real, int count>
using Square = std::array<std::array<Real, count>, count>;
template <class Real>
using ThreeByThree = Square<Real, 3>;

}  // namespace touchstone::mpm

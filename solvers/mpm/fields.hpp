#pragma once
#include "solvers/fields.hpp"
#include "solvers/mpm/lanes.hpp"

namespace touchstone::mpm {

/// One number per slot or per node.
template <class Number>
using Field = Eigen::Array<Number, Eigen::Dynamic, 1>;

}  // namespace touchstone::mpm

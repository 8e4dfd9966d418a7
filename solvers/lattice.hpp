#pragma once
/// Where particles stand before anything has moved.

#include "solvers/scene.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <string_view>

namespace touchstone {

/// Refuses a parameter that is not a positive number: std::invalid_argument with one line.
inline void require_positive(std::string_view owner, std::string_view name, double value) {
  if (!(value > 0) || !std::isfinite(value))
    throw std::invalid_argument(fmt::format("{}: {} = {}, wanted a positive number", owner, name, value));
}

/// Points in the middle of the cells of a regular lattice over a box.
struct Lattice {
  Vectors x;         // m
  double cell_area;  // m²
};

/// The lattice whose spacing comes nearest to the one asked for [m] and that fits the box exactly; row by row from the
/// low corner. Refuses a spacing larger than the box.
inline Lattice lattice_over(const Box& box, double spacing) {
  require_positive("lattice", "spacing [m]", spacing);
  const Vec2 size = box.size();
  const long columns = std::lround(size.x() / spacing), rows = std::lround(size.y() / spacing);
  if (columns < 1 || rows < 1)
    throw std::invalid_argument(fmt::format("lattice: spacing = {} m, wanted at most the filled box of {} m x {} m",
                                            spacing, size.x(), size.y()));
  const Vec2 step(size.x() / static_cast<double>(columns), size.y() / static_cast<double>(rows));
  Lattice lattice{Vectors(2, columns * rows), step.prod()};
  for (long row = 0; row < rows; ++row)
    for (long column = 0; column < columns; ++column)
      lattice.x.col(row * columns + column) =
          box.low + step.cwiseProduct(Vec2(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5));
  return lattice;
}

}  // namespace touchstone

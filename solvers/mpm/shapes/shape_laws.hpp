#pragma once
/// What every shape function of the background grid must obey, checked when its header is compiled.

namespace touchstone::mpm {

/// True if the weights of a cell's nodes sum to one, carry a linear field over exactly, have slopes that sum to zero
/// and give a linear field the slope 1; asked at places across the cell. `X` runs from 0 to 1 over the cell and node
/// `i` of a shape stands at `Shape::place(i)`.
template <class Shape>
constexpr bool obeys_shape_laws() {
  for (double X : {0.0, 0.125, 0.5, 0.875, 1.0}) {
    double unity = 0, place = 0, slopes = 0, slope_of_place = 0;
    for (int i = 0; i < Shape::nodes; ++i) {
      unity += Shape::weight(i, X);
      place += Shape::weight(i, X) * Shape::place(i);
      slopes += Shape::slope(i, X);
      slope_of_place += Shape::slope(i, X) * Shape::place(i);
    }
    if (unity != 1 || place != X || slopes != 0 || slope_of_place != 1) return false;  // exact: places are dyadic
  }
  return true;
}

}  // namespace touchstone::mpm

#pragma once
/// What every shape function of the background grid must obey, checked when its header is compiled.

#include <array>
#include <cstddef>

namespace touchstone::mpm {

/// By how much, at most, weights miss each of their laws: they sum to one and carry a linear field over; their slopes
/// sum to zero and give a linear field the slope 1; none is negative.
struct ShapeErrors {
  double unity = 0, place = 0, slopes = 0, slope_of_place = 0, negative = 0;
  bool edges = false;  // whether a node at an edge shares it with others, so that a wall cannot hold the fluid there

  /// Of the nodes that a place touches: weights, slopes [per cell] and how far the nodes are from the place [cells].
  template <std::size_t n>
  constexpr void add(const std::array<double, n>& weight, const std::array<double, n>& slope,
                     const std::array<double, n>& arm) {
    double of_unity = -1, of_place = 0, of_slopes = 0, of_slope_of_place = -1;
    for (std::size_t a = 0; a < n; ++a) {
      of_unity += weight[a];
      of_place += weight[a] * arm[a];
      of_slopes += slope[a];
      of_slope_of_place += slope[a] * arm[a];
      raise(negative, weight[a] < 0 ? weight[a] : 0);
    }
    raise(unity, of_unity);
    raise(place, of_place);
    raise(slopes, of_slopes);
    raise(slope_of_place, of_slope_of_place);
  }

 private:
  static constexpr void raise(double& most, double error) {
    const double size = error < 0 ? -error : error;
    if (!(size <= most)) most = size;
  }
};

/// How far a law may be missed: not at all where all numbers are dyadic.
struct Exactly {
  static constexpr double tolerance = 0;
};
struct ButForRounding {
  static constexpr double tolerance = 1e-14;
};

/// True, or no compilation: the message names the law, and the compiler's note below it the error and what is allowed.
/// `errors_of_shape` captures nothing: its result is a constant.
template <class Met, class ErrorsOfShape>
consteval bool are_met(ErrorsOfShape errors_of_shape) {
  constexpr ShapeErrors errors = errors_of_shape();
  constexpr double tolerance = Met::tolerance;
  static_assert(errors.unity <= tolerance, "partition of unity: weights sum to 1");
  static_assert(errors.place <= tolerance, "linear fields: weights times places sum to the place");
  static_assert(errors.slopes <= tolerance, "partition of unity: slopes sum to 0");
  static_assert(errors.slope_of_place <= tolerance, "linear fields: slopes times places sum to 1");
  static_assert(errors.negative <= tolerance, "weights: none is negative");
  static_assert(!errors.edges, "edges: the last node alone has weight there");
  return true;
}

/// Across a cell, for a shape that is the same in every cell: `X` runs from 0 to 1 over the cell and node `i` of a
/// shape stands at `Shape::place(i)`.
template <class Shape>
constexpr ShapeErrors errors_in_a_cell() {
  ShapeErrors errors;
  for (const double X : {0.0, 0.125, 0.5, 0.875, 1.0}) {
    std::array<double, Shape::nodes> weight{}, slope{}, arm{};
    for (int a = 0; a < Shape::nodes; ++a) {
      weight[a] = Shape::weight(a, X);
      slope[a] = Shape::slope(a, X);
      arm[a] = Shape::place(a) - X;
    }
    errors.add(weight, slope, arm);
  }
  return errors;
}

/// Closes the header of a shape: static_assert(obeys_shape_laws<Shape>()).
template <class Shape>
consteval bool obeys_shape_laws() {
  return are_met<Exactly>([] { return errors_in_a_cell<Shape>(); });
}

}  // namespace touchstone::mpm

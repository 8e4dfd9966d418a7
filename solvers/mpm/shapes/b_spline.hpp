#pragma once
#include "solvers/mpm/shapes/along_axis.hpp"

namespace touchstone::mpm {

/// B-splines of a degree with knots where cells meet (de Boor, A Practical Guide to Splines (1978), chapters 9 and 10;
/// for the material point method Steffen, Kirby & Berzins 2008).
///
/// At an edge that is no periodic boundary the knot is repeated (an open knot vector): splines are cut off there
/// without losing unity or linear fields, and the last one alone is left at the edge, where a wall takes hold of it.
/// Along a periodic axis all splines are the same. A node stands at the mean of the inner knots of its spline
/// (Greville's abscissa).
template <int degree>
struct BSpline {
  static_assert(degree >= 1);

  class Along {
   public:
    static constexpr int width = degree + 1;

    constexpr explicit Along(const GridAxis& axis) : axis_(axis) {}

    constexpr int nodes() const { return axis_.periodic ? axis_.cells : axis_.cells + degree; }
    /// Of a node, counted from the low edge [cells].
    constexpr double place(int node) const {
      double sum = 0;
      for (int k = node - degree + 1; k <= node; ++k) sum += knot(k);
      return sum / degree;
    }

    /// By the recurrence of de Boor and Cox; the splines of cell k are those of the nodes k to k + degree.
    constexpr NearNodes<width> near(double x) const {
      const int cell = cell_at(x, axis_);
      NearNodes<width> found;
      found.first = cell;
      std::array<double, width> lower{1};  // splines of the degree below
      for (int d = 1; d <= degree; ++d) {
        if (d == degree) found.slope = slopes(cell, lower);
        std::array<double, width> raised{};
        for (int a = 1; a <= d; ++a) {
          const double from = knot(cell - d + a), to = knot(cell + a);
          raised[a] += (x - from) / (to - from) * lower[a - 1];
          raised[a - 1] += (to - x) / (to - from) * lower[a - 1];
        }
        lower = raised;
      }
      found.weight = lower;
      for (int a = 0; a < width; ++a) found.arm[a] = place(cell + a) - x;
      return found;
    }

   private:
    /// Of the spline of node i the knots i - degree to i + 1.
    constexpr double knot(int k) const {
      if (axis_.periodic) return k;
      return k < 0 ? 0 : k < axis_.cells ? k : axis_.cells;
    }

    constexpr std::array<double, width> slopes(int cell, const std::array<double, width>& lower) const {
      std::array<double, width> slope{};
      for (int a = 1; a <= degree; ++a) {
        const double rise = degree / (knot(cell + a) - knot(cell - degree + a)) * lower[a - 1];
        slope[a] += rise;
        slope[a - 1] -= rise;
      }
      return slope;
    }

    GridAxis axis_;
  };
};

static_assert(obeys_laws_along<BSpline<1>, Exactly>([] {
  return GridAxis{.cells = 3, .periodic = false, .reach = 0};
}));
static_assert(obeys_laws_along<BSpline<2>, Exactly>([] {
  return GridAxis{.cells = 5, .periodic = false, .reach = 0};
}));
static_assert(obeys_laws_along<BSpline<2>, Exactly>([] { return GridAxis{.cells = 5, .periodic = true, .reach = 0}; }));
static_assert(obeys_laws_along<BSpline<2>, Exactly>([] {
  return GridAxis{.cells = 1, .periodic = false, .reach = 0};
}));
static_assert(obeys_laws_along<BSpline<3>, ButForRounding>([] {
  return GridAxis{.cells = 6, .periodic = false, .reach = 0};
}));
static_assert(obeys_laws_along<BSpline<3>, ButForRounding>([] {
  return GridAxis{.cells = 6, .periodic = true, .reach = 0};
}));
static_assert(obeys_laws_along<BSpline<3>, ButForRounding>([] {
  return GridAxis{.cells = 2, .periodic = false, .reach = 0};
}));

}  // namespace touchstone::mpm

#pragma once
#include "solvers/mpm/shapes/along_axis.hpp"
#include "solvers/mpm/shapes/linear_hat.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace touchstone::mpm {

/// Generalised interpolation with particles that stay upright squares (uniform GIMP; Bardenhagen & Kober, CMES 5
/// (2004), 477-496): a weight is the mean of a hat over the particle, whose side is the spacing at the start.
///
/// Beside an edge that is no periodic boundary a particle may reach over it. There the hats of the last cell are
/// continued as straight lines, and the mean of a straight line over the particle is its value in the middle: GIMP
/// turns into hats, and unity and linear fields are kept.
struct Gimp {
  class Along {
   public:
    static constexpr int width = 3;

    /// Throws std::invalid_argument for particles that are points or larger than a cell.
    constexpr explicit Along(const GridAxis& axis) : axis_(axis) {
      if (!(axis.reach > 0 && axis.reach <= 0.5))
        throw std::invalid_argument(
            fmt::format("mpm: GIMP with particles {:g} cells wide, expected a spacing above 0 and of at most a cell",
                        2 * axis.reach));
      if (axis.cells < 2) throw std::invalid_argument("mpm: GIMP on one cell, expected at least two along each axis");
    }

    constexpr int nodes() const { return axis_.periodic ? axis_.cells : axis_.cells + 1; }
    constexpr double place(int node) const { return node; }  // cells  from the low edge

    constexpr NearNodes<width> near(double x) const {
      const double from = x - axis_.reach, to = x + axis_.reach;
      if (!axis_.periodic && from < 0) return hats(x, 0, 0);
      if (!axis_.periodic && to > axis_.cells) return hats(x, axis_.cells - 2, 1);
      NearNodes<width> found;
      found.first = floor_of(from);
      if (!axis_.periodic && found.first > axis_.cells - 2) found.first = axis_.cells - 2;  // ends at the edge
      for (int a = 0; a < width; ++a) {
        const double node = found.first + a;
        found.weight[a] = (integral(to - node) - integral(from - node)) / (to - from);
        found.slope[a] = (hat(to - node) - hat(from - node)) / (to - from);
        found.arm[a] = node - x;
      }
      return found;
    }

   private:
    static constexpr double hat(double x) { return x < -1 || x > 1 ? 0 : x < 0 ? 1 + x : 1 - x; }
    /// Of the hat, from its left end.
    static constexpr double integral(double x) {
      return x < -1 ? 0 : x < 0 ? (1 + x) * (1 + x) / 2 : x < 1 ? 1 - (1 - x) * (1 - x) / 2 : 1;
    }

    /// The hats of the nodes `left` and left + 1 of three.
    static constexpr NearNodes<width> hats(double x, int first, int left) {
      NearNodes<width> found;
      found.first = first;
      const double X = x - (first + left);
      for (int i = 0; i < LinearHat::nodes; ++i) {
        found.weight[left + i] = LinearHat::weight(i, X);
        found.slope[left + i] = LinearHat::slope(i, X);
      }
      for (int a = 0; a < width; ++a) found.arm[a] = first + a - x;
      return found;
    }

    GridAxis axis_;
  };
};

static_assert(obeys_laws_along<LinearHat, Exactly>([] { return GridAxis{.cells = 3, .periodic = false, .reach = 0}; }));
static_assert(obeys_laws_along<Gimp, Exactly>([] { return GridAxis{.cells = 4, .periodic = false, .reach = 0.25}; }));
static_assert(obeys_laws_along<Gimp, Exactly>([] { return GridAxis{.cells = 4, .periodic = true, .reach = 0.25}; }));
static_assert(obeys_laws_along<Gimp, Exactly>([] { return GridAxis{.cells = 2, .periodic = false, .reach = 0.5}; }));
static_assert(obeys_laws_along<Gimp, ButForRounding>([] {
  return GridAxis{.cells = 4, .periodic = true, .reach = 1.0 / 6};
}));

}  // namespace touchstone::mpm

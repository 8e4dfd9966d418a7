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
    throw std::invalid_argument(fmt::format("{}: {} = {}, expected a positive number", owner, name, value));
}

/// Refuses water outside the domain: std::invalid_argument with one line.
inline void require_inside(const Box& filled, const Box& domain) {
  if (domain.contains(filled.low) && domain.contains(filled.high)) return;
  throw std::invalid_argument(fmt::format(
      "scene: filled box ({:g}, {:g}) to ({:g}, {:g}) m, expected inside the domain ({:g}, {:g}) to ({:g}, {:g}) m",
      filled.low.x(), filled.low.y(), filled.high.x(), filled.high.y(), domain.low.x(), domain.low.y(), domain.high.x(),
      domain.high.y()));
}

/// Refuses water that does not fill the domain: std::invalid_argument with one line.
inline void require_filled(std::string_view owner, const Box& filled, const Box& domain) {
  const double off = 1e-9 * domain.size().norm();
  if ((filled.low - domain.low).norm() < off && (filled.high - domain.high).norm() < off) return;
  throw std::invalid_argument(fmt::format(
      "{}: filled box ({:g}, {:g}) to ({:g}, {:g}) m, expected all of the domain ({:g}, {:g}) to ({:g}, {:g}) m: this "
      "method knows no free surface",
      owner, filled.low.x(), filled.low.y(), filled.high.x(), filled.high.y(), domain.low.x(), domain.low.y(),
      domain.high.x(), domain.high.y()));
}

/// The cells of a regular lattice that fits a box exactly.
struct Lattice {
  Vec2 low;   // m
  Vec2 step;  // m  sides of a cell
  long columns, rows;

  /// The centre of a cell [m], also of one outside the box.
  Vec2 place(long column, long row) const {
    return low + step.cwiseProduct(Vec2(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5));
  }
  /// All centres in the box [m], along x, then along y.
  Vectors places() const {
    Vectors all(2, columns * rows);
    for (long k = 0; k < columns * rows; ++k) all.col(k) = place(k % columns, k / columns);
    return all;
  }
  double volume() const { return step.prod(); }  // m²  of a cell
};

/// The square lattice of a spacing [m], stretched by at most half a spacing in all so as to fit the box.
/// Throws std::invalid_argument for a spacing that is not positive, larger than the box, or too small to count with.
inline Lattice lattice(const Box& box, double spacing) {
  require_positive("lattice", "spacing [m]", spacing);
  constexpr double most = 1e9;  // so that particles can be counted in an int
  const Vec2 size = box.size(), counts = (size / spacing).array().round();
  if (!((spacing <= size.array() * (1 + 1e-9)).all() && counts.prod() <= most))  // but for rounding
    throw std::invalid_argument(fmt::format(
        "lattice: spacing = {:g} m, expected at most the box of {:g} m x {:g} m, and at most {:g} particles", spacing,
        size.x(), size.y(), most));
  return {box.low, size.cwiseQuotient(counts), std::lround(counts.x()), std::lround(counts.y())};
}

/// The same over water that has to be inside the domain.
inline Lattice lattice(const Box& filled, double spacing, const Box& domain) {
  require_inside(filled, domain);
  return lattice(filled, spacing);
}

/// Where particles start: on a lattice, or where the scene puts them instead. Throws std::invalid_argument for none, or
/// for one outside the domain.
inline Vectors places_in(const Box& domain, const Start& start, const Lattice& lattice) {
  Vectors all = start.places_on(lattice.places());
  if (all.cols() == 0) throw std::invalid_argument("scene: no particle to start with, expected at least one");
  for (Eigen::Index p = 0; p < all.cols(); ++p)
    if (!domain.contains(all.col(p)))
      throw std::invalid_argument(fmt::format(
          "scene: particle {} starts at ({:g}, {:g}) m, expected inside the domain ({:g}, {:g}) to ({:g}, {:g}) m", p,
          all(0, p), all(1, p), domain.low.x(), domain.low.y(), domain.high.x(), domain.high.y()));
  return all;
}

}  // namespace touchstone

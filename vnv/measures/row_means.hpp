#pragma once
#include "vnv/measures/profile.hpp"

#include <fmt/format.h>

#include <cmath>
#include <compare>
#include <map>
#include <stdexcept>
#include <utility>

namespace touchstone::vnv {

namespace rows {

struct RowSum {
  double count = 0, y = 0, value = 0;  // sums over the members
};

/// Puts a row at no place above all others; as a key, not a number must be equal to itself.
struct Below {
  bool operator()(double a, double b) const { return std::weak_order(a, b) < 0; }
};
using Rows = std::map<double, RowSum, Below>;

/// The particles with k height <= y < (k + 1) height [m] are row k.
inline Rows parted(const ParticleField& field, double height, const Samples& samples) {
  Rows rows;
  for (Eigen::Index p = 0; p < samples.size(); ++p) {
    const double y = samples.x(1, p);
    auto& row = rows[std::floor(y / height)];
    row.count += 1;
    row.y += y;
    row.value += field(samples, p);
  }
  return rows;
}

inline Profile means(const Rows& rows) {
  Profile profile;
  for (const auto& [number, row] : rows) {
    profile.at.push_back(row.y / row.count);
    profile.value.push_back(row.value / row.count);
    profile.weight.push_back(1);
  }
  return profile;
}

}  // namespace rows

/// The mean of a field over each row of particles, upwards, as the profiles of Sun et al. average particles of equal y.
///
/// Row k holds the particles with k row_height <= y < (k + 1) row_height [m], above a wall at y = 0, and stands at the
/// mean y of its members; every row has the same weight, however many it holds, and a row without particles is left
/// out. With the initial spacing for the height, a lattice that starts half a spacing from the wall has its rows in the
/// middle of theirs, and each particle may drift by half a spacing before it counts in the next. Particles in disorder
/// have no rows of their own; these still part them evenly, where parting at gaps in y would find one row.
///
/// A value that is not a number makes the mean of its row not a number; particles at such a y are a row at no number.
/// Throws std::invalid_argument for a height that is not positive and finite.
inline Measure row_means(ParticleField field, double row_height) {
  if (!(row_height > 0 && std::isfinite(row_height)))
    throw std::invalid_argument(
        fmt::format("row_means: row height = {} m, expected a positive finite height", row_height));
  return [field = std::move(field), row_height](const Samples& samples) {
    return rows::means(rows::parted(field, row_height, samples));
  };
}

/// As row_means; but where lines of equal y hold two particles or more, as those of a mesh, each line is a row: heights
/// that are no multiple of the distance of lines would part them unevenly.
inline Measure means_of_lines(ParticleField field, double row_height) {
  constexpr double as_equal = 1e-6;  // row heights
  return [field, of_rows = row_means(field, row_height), row_height](const Samples& samples) {
    const rows::Rows lines = rows::parted(field, as_equal * row_height, samples);
    return 2 * lines.size() <= static_cast<std::size_t>(samples.size()) ? rows::means(lines) : of_rows(samples);
  };
}

}  // namespace touchstone::vnv

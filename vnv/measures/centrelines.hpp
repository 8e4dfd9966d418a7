#pragma once
/// Velocities on the centrelines of a lid-driven square cavity, against published ones.

#include "solvers/quadratic_fit.hpp"
#include "vnv/case.hpp"
#include "vnv/files/tables.hpp"
#include "vnv/judge/norms.hpp"
#include "vnv/measures/profile.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <vector>

namespace touchstone::vnv {

/// A field at a place [m]: that of the polynomial of second degree which fits the particles closer than `reach` [m]
/// best, weighted by (1 - r² / reach²)². Not a number, or not meaningful, for fewer than six of them.
inline double fitted_at(const Samples& samples, const Field& field, const Vec2& place, double reach) {
  using Fit = QuadraticFit<double, 1>;
  Fit::Sums sums{};
  for (Eigen::Index p = 0; p < samples.size(); ++p) {
    const Vec2 way = (samples.x.col(p) - place) / reach;
    const double left = 1 - way.squaredNorm();
    if (left <= 0) continue;
    const Fit::Sums terms = Fit::terms(left * left, way.x(), way.y(), {field(samples, p)});
    for (std::size_t s = 0; s < Fit::count; ++s) sums[s] += terms[s];
  }
  return Fit::of(sums)[0][0];
}

/// The velocity across a centreline of a cavity, as it was published; equally long lists.
struct Centreline {
  enum Direction { horizontal, vertical };
  Direction direction;           // v_y on the horizontal one, v_x on the vertical one
  std::vector<double> at;        // -  places along it, by the side of the cavity, walls left out
  std::vector<double> velocity;  // -  by the speed of the lid
};

/// A norm of the error on a centreline, "L2" or "Linf", in per cent of the lid's speed.
inline Quantity norm_of(std::string_view norm, Centreline::Direction direction) {
  return {fmt::format("{} {}", norm,
                      direction == Centreline::vertical ? "v_x, vertical centreline" : "v_y, horizontal centreline"),
          "%", Kind::norm};
}

/// What Ghia, Ghia & Shin (1982) print for a Reynolds number, without its doubtful entries. Throws BadData where they
/// have none.
inline Centreline ghia_centreline(const std::filesystem::path& data, Centreline::Direction direction, int Re) {
  const bool is_vertical = direction == Centreline::vertical;
  const std::string at = is_vertical ? "y [-]" : "x [-]", velocity = is_vertical ? "u [-]" : "v [-]";
  const DataTable table =
      read_table(
          data / "papers" / (is_vertical ? "ghia_1982_vertical_centreline.csv" : "ghia_1982_horizontal_centreline.csv"),
          {"Re", at, velocity, "entry"})
          .only("Re", std::to_string(Re))
          .only("entry", "sound");
  Centreline line{direction, {}, {}};
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const double place = table.numbers(at)[k];
    if (place == 0 || place == 1) continue;  // held by the wall
    line.at.push_back(place);
    line.velocity.push_back(table.numbers(velocity)[k]);
  }
  return line;
}

/// A square cavity with one corner at the origin, and how finely it is read.
struct Cavity {
  double side;       // m
  double lid_speed;  // m/s

  /// The velocity at one place of a centreline, by the speed of the lid, from the particles within two and a half
  /// spacings [m]: twenty of them, eight at a wall.
  double velocity_at(const Samples& samples, Centreline::Direction direction, double at, double spacing) const {
    const bool is_vertical = direction == Centreline::vertical;
    const Vec2 place = side * (is_vertical ? Vec2(0.5, at) : Vec2(at, 0.5));
    return fitted_at(samples, is_vertical ? velocity_x : velocity_y, place, 2.5 * spacing) / lid_speed;
  }

  /// The same at every place of a line.
  std::vector<double> along(const Samples& samples, const Centreline& line, double spacing) const {
    std::vector<double> found;
    for (const double at : line.at) found.push_back(velocity_at(samples, line.direction, at, spacing));
    return found;
  }

  /// L2 and Linf of a line at the end of a run, in per cent of the lid's speed: "L2 v_x, vertical centreline [%]".
  std::vector<Value> compare(const Level& level, const Run& run, const Centreline& line) const {
    if (!run.summary.finished) return {};
    // Norms are relative to the truth: with one that is the lid's speed everywhere they are relative to it.
    std::vector<double> found = along(run.samples.back(), line, level.spacing);
    const std::vector<double> lid(found.size(), 1), equal = lid;
    for (std::size_t k = 0; k < found.size(); ++k) found[k] += lid[k] - line.velocity[k];
    const auto error = [&](const char* norm, double value) {
      return Value{level.name, level.spacing, run.summary.end_time, norm_of(norm, line.direction), 100 * value};
    };
    return {error("L2", relative_l2(found, lid, equal)), error("Linf", relative_linf(found, lid))};
  }
};

}  // namespace touchstone::vnv

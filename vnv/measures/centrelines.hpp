#pragma once
/// Velocities on the centrelines of a lid-driven square cavity, against published ones.

#include "vnv/case.hpp"
#include "vnv/measures/profile.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::vnv {

/// A field at a place [m]: that of the polynomial of second degree which fits the particles closer than `reach` [m]
/// best, weighted by (1 - r² / reach²)². Where these do not settle a polynomial, as on flat or graded cells, the
/// particles in an ellipse that reaches from two and a half to six of the local gaps along x and along y take their place. Not a
/// number where those do not settle one either.
double fitted_at(const Samples& samples, const ParticleField& field, const Vec2& place, double reach);

/// The velocity across a centreline of a cavity, as it was published; equally long lists.
struct Centreline {
  enum Direction { horizontal, vertical };
  Direction direction;           // v_y on the horizontal one, v_x on the vertical one
  std::vector<double> at;        // -  places along it, by the side of the cavity, walls left out
  std::vector<double> velocity;  // -  by the speed of the lid
};

/// A norm of the error on a centreline, "L2" or "Linf", in per cent of the lid's speed.
Quantity norm_of(std::string_view norm, Centreline::Direction direction);

/// What Ghia, Ghia & Shin (1982) print for a Reynolds number, without its doubtful entries. Throws BadData where they
/// have none.
Centreline ghia_centreline(const std::filesystem::path& data, Centreline::Direction direction, int Re);

/// A square cavity with one corner at the origin, and how finely it is read.
struct Cavity {
  double side;       // m
  double lid_speed;  // m/s
  double span = 0;   // s  before the end of a run, over which its velocities are averaged

  /// The velocity at one place of a centreline, by the speed of the lid, from the particles within two and a half
  /// spacings [m]: twenty of them, eight at a wall.
  double velocity_at(const Samples& samples, Centreline::Direction direction, double at, double spacing) const;

  /// The mean of such velocities over the samples of the last `span` of a run: where particles mix, those of one
  /// instant fluctuate about a steady flow.
  double mean_velocity_at(const Run& run, Centreline::Direction direction, double at, double spacing) const;

  /// L2 and Linf of these means along a line, in per cent of the lid's speed: "L2 v_x, vertical centreline [%]".
  std::vector<Value> compare(const Level& level, const Run& run, const Centreline& line) const;
};

}  // namespace touchstone::vnv

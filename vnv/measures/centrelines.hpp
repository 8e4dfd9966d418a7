#pragma once
/// Velocities on the centrelines of a lid-driven square cavity, against the steady flow as it was computed to
/// convergence and as it was published.

#include "vnv/case.hpp"
#include "vnv/measures/profile.hpp"

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::vnv {

/// A field at a place [m]: that of the polynomial of second degree which fits the particles closer than `reach` [m]
/// best, weighted by (1 - r² / reach²)². Where these do not settle a polynomial, as on flat or graded cells, the
/// particles in an ellipse that reaches from two and a half to six of the local gaps along x and along y take their
/// place. Not a number where those do not settle one either.
double fitted_at(const Samples& samples, const ParticleField& field, const Vec2& place, double reach);

/// The velocity across a centreline of a cavity, as it was published or computed; equally long lists.
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

/// The velocity along a centreline of the steady flow, converged: the polynomial through the places of Chebyshev in
/// data/computed/cavity_profiles.csv (barycentric: Berrut & Trefethen 2004).
class ConvergedProfile {
 public:
  /// Throws BadData where there is none for a Reynolds number.
  ConvergedProfile(const std::filesystem::path& data, Centreline::Direction direction, int Re);

  double operator()(double at) const;
  double half_width() const { return half_width_; }  // -  by which it may be off

 private:
  std::vector<double> at_, velocity_;
  double half_width_;
};

/// The same at the places of Ghia, Ghia & Shin (1982), so that errors are comparable with those that others quote.
Centreline converged_centreline(const std::filesystem::path& data, Centreline::Direction direction, int Re);

/// What is extreme on a centreline: the fluid flows back below the middle, up along the wall that the lid leaves, and
/// down along the one that it slides to.
struct Extremum {
  std::string name;  // "smallest v_x"
  Centreline::Direction direction;
  double sign;  // -1 for the smallest velocity, 1 for the largest
};
const std::array<Extremum, 3>& extrema();

/// A velocity by the speed of the lid, and where it is, by the side of the cavity.
struct Peak {
  double velocity, at;
};
/// The peak of a profile, at least so far from both walls: the vertex of the parabola through the best of its places,
/// which are a 200th apart, and its neighbours. Not a number where one of the velocities is none.
Peak peak_of(const std::function<double(double at)>& profile, const Extremum& which, double nearest = 0.02);
/// That of the steady flow, from data/computed/cavity_extrema.csv. Throws BadData where there is none.
Peak converged_peak(const std::filesystem::path& data, const Extremum& which, int Re);

/// How far the velocity of a peak is off, in per cent of the lid's speed, and its place, in per cent of the side.
Quantity error_of(const Extremum& which);
Quantity shift_of(const Extremum& which);

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

  /// Error and shift of the peak of these means: "error of the smallest v_x [%]", "shift of the smallest v_x [%]".
  std::vector<Value> compare(const Level& level, const Run& run, const Extremum& which, const Peak& exact) const;
};

}  // namespace touchstone::vnv

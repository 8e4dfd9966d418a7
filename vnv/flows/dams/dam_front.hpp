#pragma once
/// The front of a dam break: what is followed, how it is compared with the experiment, and how it is drawn.

#include "vnv/flows/dams/dam.hpp"
#include "vnv/flows/dams/front_comparison.hpp"
#include "vnv/measures/front.hpp"

namespace touchstone::vnv {

/// The run with the least spacing, or null, also where nothing of it was monitored.
const Run* finest(const Results& results);

/// A column of water at the left end of a tank, and how its front is read.
struct DamFront {
  double column_length, column_height;  // m  l0, h0
  double tank_length, tank_height;      // m
  double density;                       // kg/m³
  double gravity;                       // m/s²
  double slab = not_a_number;           // m  side of the slab that has to be half full; not a number: two spacings

  // Quantities of the comparison with Lobovský et al. (2014).
  inline static const Quantity rms{"RMS error of L for T in [1, 1.5], without time shift", "", Kind::error};
  inline static const Quantity rms_of_percentile{"RMS error of L, without time shift, front as 99.5th percentile", "",
                                                 Kind::error};
  inline static const Quantity slope_error{
      "relative error of the front speed dL/dT from T = 1 to 1.58 or impact (measured 1.34)", "%", Kind::deviation};

  /// Of the front by an operator, in `against_experiments`, or of the residual height; the slab follows the spacing.
  inline static const std::string of_thin_slab = "half-full slab of two spacings",
                                  of_residual_height = "residual height over h0, at the back wall";
  static Quantity speed_of(const std::string& front);
  static Quantity speed_error_of(const std::string& front, const std::string& experiment);
  static Quantity rms_of(const std::string& front, const std::string& experiment);
  static Quantity rms_at_best_shift_of(const std::string& front, const std::string& experiment);

  // Of all runs.
  inline static const Quantity mass_change{"relative mass error", "", Kind::invariant};
  inline static const Quantity lost{"particles lost or outside the domain", "", Kind::count, Better::smaller};

  double fall() const { return fall_of(density, gravity, column_length, column_height, tank_length); }
  double scaled_time(double t) const { return t * std::sqrt(gravity * column_height) / column_length; }  // (39)

  /// The three fronts as L (38), half-full slab first, then 99.5th percentile, then farthest particle; then the mass
  /// [kg/m] and the number of particles in the tank.
  std::vector<double> monitored(const Samples& samples) const;
  inline static const std::vector<Quantity> quantities{{"front L, half-full slab"},
                                                       {"front L, 99.5th percentile"},
                                                       {"front L, farthest particle"},
                                                       {"mass", "kg/m"},
                                                       {"particles in the tank"}};

  /// The front as L by five operators, of which two follow the spacing [m], for which a slab of one height would be too
  /// thin or too thick; and the residual height of the column at the back wall, over h0.
  std::vector<Value> positions(const Level& level, const Samples& samples) const;

  /// Each of them over time against each experiment with a column of this aspect, from when the gate is open until the
  /// front is near the far wall: the RMS error with clocks as they are and with the time shift that fits best, that
  /// shift, at most the doubt about the experiment's origin of time, and the slope of our front, also over theirs.
  std::vector<Value> against_experiments(const Level& level, const Run& run) const;

  /// How far the front, as a half-full slab of two spacings or as 99.5th percentile, whichever is further, is at the
  /// least ahead of the slowest experiment with a column of this aspect, whose clock is as late as such a clock may be;
  /// at the times of the samples with T from 1 until that front is two slabs from the far wall. Nothing without such a
  /// time or experiment. Water that does not run is behind at any spacing.
  std::vector<Value> lead(const Level& level, const Run& run) const;
  inline static const Quantity least_lead{"least lead of front L over the slowest experiment, its clock 0.3 late"};

  /// How far that front is at the most from the experiment whose clock starts with the gate, Lobovský et al. (2014) or
  /// Koshizuka & Oka (1995), at the times of the samples with T in [1, 1.5] until the measured one is near the far
  /// wall.
  std::vector<Value> off(const Level& level, const Run& run) const;
  inline static const Quantity largest_error{"largest error of front L for T in [1, 1.5], without time shift", "",
                                             Kind::error};

  /// Mass and number of particles, of a run with `monitored`.
  std::vector<Value> kept(const Level& level, const Run& run) const;

  /// Fronts of a run with `monitored` against that of Lobovský et al. (2014).
  std::vector<Value> against_lobovsky(const Level& level, const Run& run) const;

  /// Both.
  std::vector<Value> compare(const Level& level, const Run& run) const;

  /// L over T for the levels named, or the finest if none is, with the experiments that had a column of this aspect and
  /// Ritter's bound, up to where `frame`, which has to say so, ends in L.
  Plot history(Figure frame, std::vector<std::string> levels) const;

  /// The residual height at the back wall, over h0, of the finest level at the times of the samples, with experiments.
  Plot residual_heights(Figure frame) const;

  /// Table 5 of Sun et al. beside ours, with time per step and memory.
  Plot models() const;
};

}  // namespace touchstone::vnv

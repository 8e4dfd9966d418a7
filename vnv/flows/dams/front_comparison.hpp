#pragma once
/// A computed dam-break front against a measured one.

#include <string>
#include <string_view>
#include <vector>

namespace touchstone::vnv {

/// A front over time, in the numbers of Sun et al.; equally long lists.
struct FrontHistory {
  std::vector<double> T;  // -  (39) t sqrt(g h0) / l0, rising
  std::vector<double> L;  // -  (38) l / l0
};

/// From `low` to `high`, both included, of T or of a shift of T.
struct Window {
  double low, high;
};

struct FrontComparison {
  double rms;                // -  of L, ours less measured, clocks as they are
  double best_shift;         // -  of T; positive: ours started too early and is drawn later by this much
  double rms_at_best_shift;  // -  of L
  double slope;              // -  dL/dT, ours
  double measured_slope;     // -  dL/dT
};

/// Compares the two with and without a shift of our clock, since the origin of time of an experiment is that of its
/// gate, and by slopes, which need no origin.
///
/// The rms is over the measured points in `rms_window`; ours is interpolated linearly at their times. A shift s is
/// added to all our T; the best is sought in `bounds`, by a scan in 60 steps and Brent's minimiser [GSL] around its
/// best point. A best shift at an end of `bounds` says that the range was too narrow. Each slope is a least-squares
/// line through the series' own points in `slope_window`.
///
/// An L that is not a number in use gives numbers that are not. Throws std::invalid_argument for a series of fewer than
/// two points, lists of unequal length, times that are not finite and rising, or a window whose low is above its high;
/// and std::domain_error where a series does not cover a window, ours also with every shift, or has too few points in
/// it.
FrontComparison compare_fronts(const FrontHistory& ours, const FrontHistory& measured, const Window& rms_window,
                               const Window& slope_window, const Window& bounds);

/// The slope dL/dT of a least-squares line through a front's points in a window. Throws as `compare_fronts`.
double slope_of(std::string_view whose, const FrontHistory& front, const Window& window);

/// L of a front at T, linear between its points, of which there are at least two, and beyond them as between the last.
double front_at(const FrontHistory& front, double T);

}  // namespace touchstone::vnv

#pragma once
/// What an error costs: of runs that each have an error and a CPU time, which are worth making, and what a given error
/// takes. (Work-precision diagrams: Hairer, Nørsett & Wanner, Solving Ordinary Differential Equations I, 1993, II.10.)

#include "vnv/record/record.hpp"

#include <string>
#include <vector>

namespace touchstone::vnv {

/// The points that none beats in both error and time, cheapest first; their errors fall. A point counts as better than
/// a cheaper one if its error is smaller by more than `gain`, a fraction of it: without a gain a run of half the step
/// and the same error but for the fifth digit would stand on every front. A point whose error or time is not positive
/// and finite is left out.
std::vector<WorkPoint> pareto_front(std::vector<WorkPoint> points, double gain = 0);

/// What a dearer run must gain to be worth making.
inline constexpr double worthwhile = 0.05;

/// The CPU time to an error.
struct TimeToError {
  double cpu = not_a_number;                             // s  not a number: the error is not reached
  double lowest = not_a_number, highest = not_a_number;  // s
  bool at_most = false;                                  // the cheapest run is better already: `cpu` is its time

  bool is_reached() const { return cpu > 0; }
};

/// Interpolated on logarithmic axes along the front of runs worth making. The interval reaches from the fastest repeat
/// of the neighbour that is not good enough to the slowest of the neighbour that is: no law between them is assumed.
TimeToError time_to_error(const std::vector<WorkPoint>& points, double target);

/// The points of one series.
std::vector<WorkPoint> of_series(const std::vector<WorkPoint>& points, const std::string& series);

/// The names of all series, the one that reaches the target soonest first; those that do not reach it follow by the
/// smallest error that they reach.
std::vector<std::string> ranking(const std::vector<WorkPoint>& points, double target);

/// The smallest CPU time per step [s] of the points with so many particles; not a number if there are none.
double time_per_step(const std::vector<WorkPoint>& points, double particles);

}  // namespace touchstone::vnv

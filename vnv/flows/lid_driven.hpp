#pragma once
/// What cases of a lid-driven cavity share (vnv/flows/cavity.cpp).

#include "vnv/flows/flow.hpp"
#include "vnv/measures/centrelines.hpp"
#include "vnv/measures/plots/along_ladders.hpp"
#include "vnv/methods/methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace touchstone::vnv::lid_driven {

inline constexpr double output_interval = 0.25;  // s  holds a whole number of steps

/// A Reynolds number of the tables, and when its flow is steady.
struct Tabulated {
  int Re;
  double end;  // s

  std::string at(int particles) const { return fmt::format("Re {}, {} across", Re, particles); }
};
inline constexpr std::array tabulated{Tabulated{100, 12}, Tabulated{400, 30}, Tabulated{1000, 35}};

/// For so long before its end a flow is to be steady [s], and its velocities are averaged: particles of second-order
/// SPH mix, and fluctuate about the flow. With 100 across at Re 1000 v_x is 0.5 to 3 % off Ghia et al. at one instant,
/// and of the means of three runs 0.7 to 1.0 %; with 50 across at Re 400, four runs whose steps differ by up to 3 %
/// have rates of change of their energy with a standard deviation of 0.13 %/s over 3 s, of 0.05 over 5.
inline constexpr double steady_for = 5;
inline constexpr Cavity cavity{.side = 1, .lid_speed = 1, .span = steady_for};

/// Off the steady flow: profiles, and with fifty across or more peaks, which are points: with fewer, particles that mix
/// move them farther than is worth telling.
inline std::vector<Value> against_converged(const Level& level, const Run& run, const Cavity& box, int Re) {
  std::vector<Value> errors;
  for (const auto direction : {Centreline::vertical, Centreline::horizontal})
    std::ranges::copy(box.compare(level, run, converged_centreline(data_folder(), direction, Re)),
                      std::back_inserter(errors));
  if (box.side / level.spacing < 50 * (1 - 1e-6)) return errors;
  for (const Extremum& which : extrema())
    std::ranges::copy(box.compare(level, run, which, converged_peak(data_folder(), which, Re)),
                      std::back_inserter(errors));
  return errors;
}

/// Both components at most so far from the steady flow, in per cent of the lid's speed; on a level, or on all.
inline std::vector<Claim> within(double percent, const Author& author, const std::string& level = "") {
  return {at_most(norm_of("L2", Centreline::vertical), percent, author).on(level),
          at_most(norm_of("L2", Centreline::horizontal), percent, author).on(level)};
}
/// Its peaks at most so far from those of the steady flow, in per cent of the lid's speed, and their places, in per
/// cent of the side.
inline std::vector<Claim> peaks_within(double percent, double percent_of_side, const Author& author,
                                       const std::string& level = "") {
  std::vector<Claim> claims;
  for (const Extremum& which : extrema()) {
    claims.push_back(at_most(error_of(which), percent, author).on(level));
    claims.push_back(at_most(shift_of(which), percent_of_side, author).on(level));
  }
  return claims;
}
/// Both agree with the profiles and peaks in data/computed to more digits than any method here has.
inline const Author converged = literature("Botella & Peyret 1998; Marchi, Suero & Araki 2009");

/// What an error costs, by the component along the lid.
inline Plot work() { return work_precision(norm_of("L2", Centreline::vertical)); }

/// The methods that run it.
inline std::vector<Method> methods_on(const Scene<Newtonian>& scene) {
  return {mpm_affine(scene, output_interval), mpm_least_squares(scene, output_interval, 0.5),
          sph_second_order(scene, output_interval, 0.45)};
}

}  // namespace touchstone::vnv::lid_driven

#pragma once
/// How many times as long one program takes as another, from runs in turn.
///
/// Two programs are run in pairs, before-after after-before ..., so that what slows the machine for a while slows both.
/// Of each pair the logarithm of the ratio counts. Estimate, interval and probability are those of Wilcoxon's
/// signed-rank test (Hollander & Wolfe, Nonparametric Statistical Methods, 1999, section 3.1 to 3.3), exact for any
/// noise that strikes both sides alike: if nothing changed, each logarithm is as likely to be positive as negative. A
/// neighbour who slows some runs by a lot moves their ranks, and those by no more than others'.

#include "vnv/record/record.hpp"

#include <vector>

namespace touchstone::gate {

/// Logarithms of after over before, pair by pair; pairs without two positive finite times are left out.
std::vector<double> log_ratios(const std::vector<double>& before, const std::vector<double>& after);

/// A ratio of times with its 95 % interval.
struct Ratio {
  long pairs = 0;
  double estimate = vnv::not_a_number;                             // Hodges & Lehmann's
  double lowest = vnv::not_a_number, highest = vnv::not_a_number;  // not numbers below `least_pairs`
};

/// Fewer pairs have no interval of 95 %: all alike by chance happens once in 2^5 times on either side.
inline constexpr long least_pairs = 6;

Ratio ratio_of(const std::vector<double>& log_ratios);

/// The one-sided p-value: how often chance alone makes the logarithms of equal programs so positive. Exact up to ties.
double p_value(const std::vector<double>& log_ratios);

}  // namespace touchstone::gate

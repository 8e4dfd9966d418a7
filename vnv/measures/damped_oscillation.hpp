#pragma once
/// A damped oscillation: its period and its decay, from what was monitored.

#include "vnv/record/quantity.hpp"

#include <vector>

namespace touchstone::vnv {

/// exp(-decay t) (p cos(omega t) + q sin(omega t)) + rest, fitted to values over time.
struct DampedOscillation {
  double omega = not_a_number, decay = not_a_number;  // 1/s
  double at_start = not_a_number;                     // p
};

/// By least squares: p, q and the rest are linear, omega and decay are searched for from `omega_near` [1/s] and from no
/// decay by the simplex of Nelder & Mead [GSL, Multidimensional Minimization]. Not numbers for fewer than six values,
/// for one that is not finite, or where the search finds no end.
DampedOscillation fit_damped_oscillation(const std::vector<double>& times, const std::vector<double>& values,
                                         double omega_near);

}  // namespace touchstone::vnv

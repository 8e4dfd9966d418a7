#pragma once
#include "vnv/record/quantity.hpp"

#include <optional>
#include <vector>

namespace touchstone::vnv {

/// e(h) = floor + c (h / h_finest)^order, with 95 % intervals by Student's t.
struct ErrorLaw {
  double order = not_a_number, order_half_width = not_a_number;
  double floor = not_a_number, floor_half_width = not_a_number;  // in the unit of the errors
  double squares = not_a_number;                                 // sum of (log of error over law)²
};

/// The law of least squares in log e, as errors scatter by a fraction of themselves: a trust-region search [GSL,
/// Nonlinear Least-Squares Fitting] from several starts. Nothing for fewer than four levels, for an error that is no
/// positive number, or where no start leads to a law. Spacings [m] are positive and fall.
std::optional<ErrorLaw> fit_law_with_floor(const std::vector<double>& spacings, const std::vector<double>& errors);

}  // namespace touchstone::vnv

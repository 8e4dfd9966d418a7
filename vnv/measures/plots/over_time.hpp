#pragma once
#include "vnv/case.hpp"
#include "vnv/record/record.hpp"

#include <functional>
#include <string>
#include <vector>

namespace touchstone::vnv {

/// What was monitored in a `column` over time, one curve per level named (those that were run).
Plot over_time(std::string id, std::string title, std::string caption, Axis quantity, std::size_t column,
               std::vector<std::string> levels);

/// Kinetic energy, monitored in a `column`.
Plot kinetic_energy_over_time(std::size_t column, std::vector<std::string> levels);

/// An exact line from t = 0 to `until` [s].
Plot exact_over_time(std::string figure, std::function<double(double t)> truth, double until);

}  // namespace touchstone::vnv

#pragma once
/// How numbers, limits, outcomes and trends are written: numbers with four significant digits, never a bare "nan" that
/// could be overlooked.

#include "vnv/record/record.hpp"

#include <optional>
#include <string>

namespace touchstone::reports {

/// As plain text: "0.0159", "1.2e-07", "nan"; the other is empty for what is not a number.
std::string plain(double value, int digits = 4);
std::string plain_or_empty(double value, int digits = 4);

/// As in print: "0.0159", "1.2 × 10^-7", "200 000"; pages raise the exponent.
std::string printed(double value, int digits = 4);

/// "1.59 %": as in print, with its unit.
std::string valued(double value, const std::string& unit);

/// The same with two digits, all that a time, a floor or an interpolated error is worth.
std::string rounded(double value, const std::string& unit);

/// "23 %" of a fraction of 0.23.
std::string in_percent(double fraction);

/// With groups of three digits.
std::string printed(long count);

/// A limit as plain text: "<= 0.07", ">= 0.8", "in [1.9, 2.1]"; empty if nothing is claimed.
std::string limit(std::optional<double> lower, std::optional<double> upper);
/// The same with the signs of print.
std::string printed_limit(std::optional<double> lower, std::optional<double> upper);

/// "L2 v_x [%]"; without brackets if the unit is empty.
std::string with_unit(const std::string& quantity, const std::string& unit);

/// "2.02 ± 0.12", as plain text; without an interval that knows no bounds.
std::string with_interval(double value, double half_width);

/// The word for an enumerator; of an outcome or a trend also the class by which the style sheet knows its colour.
std::string word(auto value) { return std::string(vnv::word_of(value)); }

/// "↘ converging": where the errors go as the spacing decreases.
std::string sign_and_word(vnv::Trend trend);

/// "1 claim", "2 claims".
std::string counted(long count, const std::string& noun);

}  // namespace touchstone::reports

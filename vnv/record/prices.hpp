#pragma once
/// What each method of a flow pays for an error, by the study of error against run time, and which is the default.

#include "vnv/record/record.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace touchstone::vnv {

/// Of one method of a flow to one error.
struct Price {
  std::string case_name;    // "poiseuille_run_time"
  std::string quantity;     // the error, with its unit
  double target;            // in that unit
  double ranked_by;         // the target by which the flow's methods are ranked
  std::string method;       // "mpm"
  bool as_printed = false;  // one of the two methods of Sun et al.
  double cpu;               // s  not a number where the error is not reached
  double smallest;          // error that the method reached

  bool operator==(const Price&) const = default;
};

/// Of all methods measured here, of each diagram of a case; `records` are its methods.
std::vector<Price> prices_of(const std::vector<Record>& records);

/// As a table of data (data/README.md), and read from one. Reading throws BadData.
std::string csv_of(const std::vector<Price>& prices, const std::string& source);
std::vector<Price> read_prices(const std::filesystem::path& file);

/// The prices for one target, cheapest first; then what does not reach it, by smallest error.
std::vector<Price> ranked(std::vector<Price> prices, double target);

/// A method that differs by less from the cheapest is as cheap: timings are not known better.
inline constexpr double as_cheap = 1.25;

struct DefaultMethod {
  std::string method, reason;
};
/// The default of a flow, from its prices: the cheapest to the target by which it is ranked, and of those that are as
/// cheap the one that reaches the smallest error; where none gets there, the one with the smallest error. Nothing
/// without prices.
std::optional<DefaultMethod> default_method(const std::vector<Price>& of_flow);

}  // namespace touchstone::vnv

#pragma once
/// How much a simulated value is in doubt because its inputs are: ASME V&V 20-2009, section 3, by local sensitivities.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::vnv {

/// What a simulation takes from an experiment, and how well it is known.
struct UncertainInput {
  std::string name;
  double value;       // in its own unit, as is the half width
  double half_width;  // any value within it is as likely, unless it is a standard deviation
  bool is_deviation = false;
  std::string unit{}, basis{};  // whence the half width: a source, or "estimate: why"

  /// The standard uncertainty: the half width of a rectangular distribution by sqrt(3), or the standard deviation.
  double standard() const;
};

/// The inputs of a table such as data/experiments/lobovsky_2014_inputs_300.csv. Throws BadData, also for a distribution
/// that is neither "rectangular" nor "normal", and for a half width that is not positive.
std::vector<UncertainInput> read_inputs(const std::filesystem::path& file);

/// The input of that name; throws std::invalid_argument with the names that there are.
const UncertainInput& input_named(std::string_view name, const std::vector<UncertainInput>& inputs);

/// What a run with another value of one input gave.
struct AtInput {
  double input, value;
};

/// What one input adds to the uncertainty of a value.
struct Sensitivity {
  std::string input;
  double slope;  // dS/dX, in the unit of the value by that of the input
  double part;   // |dS/dX| u_X, in the unit of the value
};

/// By the central difference of two runs, usually at the ends of the half width: closer ends are lost in the noise of
/// an impact, farther ones in its curvature. Throws std::invalid_argument unless the input of `low` is less than
/// `high`'s.
Sensitivity sensitivity(const UncertainInput& input, const AtInput& low, const AtInput& high);

/// u_input, the root of the sum of squares of the parts: for inputs that are in doubt independently of each other. Not
/// a number where a part is none, or without any.
double input_uncertainty(const std::vector<Sensitivity>& parts);

}  // namespace touchstone::vnv

#pragma once
/// Whether a simulation agrees with an experiment, as far as both are known: ASME V&V 20-2009, Standard for
/// Verification and Validation in Computational Fluid Dynamics and Heat Transfer; Oberkampf & Roy, Verification and
/// Validation in Scientific Computing (2010), chapter 12.

#include "vnv/record/quantity.hpp"

#include <limits>
#include <string>
#include <string_view>

namespace touchstone::vnv {

/// The parts of the validation uncertainty, each a standard uncertainty in the unit of the value; one that is not a
/// number is unknown.
struct ValidationParts {
  double numerical = not_a_number;  // u_num, of the simulation at its resolution (`numerical_uncertainty`)
  double input = not_a_number;      // u_input, of what it takes from the experiment (`input_uncertainty`)
  double data = not_a_number;       // u_D, of the measured value, its sensor, read-out and repeats
};

/// What simulated and measured value say of the model.
struct Validation {
  enum class Outcome {
    agrees,         // |E| <= k u_val: an error of the model, if any, is hidden by what is not known
    model_error,    // |E| > k u_val: the error of the model lies within E ± k u_val
    too_uncertain,  // |E| <= k u_val, and k u_val is more than is of use
    unknown,        // a value is no finite number, or no uncertainty is known
  };
  Outcome outcome;
  double error;        // E = S - D, simulated less measured
  double uncertainty;  // u_val = sqrt(u_num² + u_input² + u_D²), of the parts that are known
  double coverage;     // k
  double useful;       // k u_val up to which agreement says something
  ValidationParts parts;

  double expanded() const { return coverage * uncertainty; }
};

/// The standard compares E with u_val itself and leaves to the analyst what an interval of a stated probability is to
/// be multiplied by (section 6). k = 2 is the usual one, for about 95 % if E is normally distributed; nearer to a
/// rectangular one it covers more.
///
/// Agreement within an uncertainty of more than `useful` says nothing; an error beyond k u_val stands out however large
/// that is. With a part unknown the verdict rests on the others, and u_val is too small: agreement would hold with it
/// too, a model error might not.
///
/// Throws std::invalid_argument for a part that is negative, or a coverage or useful bound that is not positive.
Validation validate(double simulated, double measured, const ValidationParts& parts,
                    double useful = std::numeric_limits<double>::infinity(), double coverage = 2);

/// A sentence for people: "agrees within 2 u_val: E = 0.03 m, 2 u_val = 0.05 m (u_num 0.02, u_input 0.01, u_D 0.01)".
/// What is unknown is said.
std::string words(const Validation& validation, std::string_view unit);

/// The standard uncertainty behind percentiles 2.5 % and 97.5 % over repeats: a quarter of their distance, but for
/// 1.96 instead of 2, if the repeats are normally distributed. It is that of one run; of the median of many it is less.
double standard_of_95_percent(double low, double high);

}  // namespace touchstone::vnv

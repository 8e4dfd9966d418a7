#include "vnv/judge/validation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace touchstone::vnv {
namespace {

using Outcome = Validation::Outcome;

std::array<std::pair<std::string_view, double>, 3> named(const ValidationParts& parts) {
  return {{{"u_num", parts.numerical}, {"u_input", parts.input}, {"u_D", parts.data}}};
}

std::vector<std::string_view> unknown(const ValidationParts& parts) {
  std::vector<std::string_view> names;
  for (const auto& [name, part] : named(parts))
    if (std::isnan(part)) names.push_back(name);
  return names;
}

Outcome outcome_of(const Validation& found) {
  if (!std::isfinite(found.error) || unknown(found.parts).size() == named(found.parts).size()) return Outcome::unknown;
  if (std::abs(found.error) > found.expanded()) return Outcome::model_error;
  return found.expanded() <= found.useful && std::isfinite(found.expanded()) ? Outcome::agrees : Outcome::too_uncertain;
}

std::string with_unit(double value, std::string_view unit) {
  return fmt::format("{:.3g}{}{}", value, unit.empty() ? "" : " ", unit);
}

}  // namespace

Validation validate(double simulated, double measured, const ValidationParts& parts, double useful, double coverage) {
  double squares = 0;
  for (const auto& [name, part] : named(parts)) {
    if (part < 0)
      throw std::invalid_argument(fmt::format("validation: {} = {}, expected no negative number", name, part));
    if (!std::isnan(part)) squares += part * part;
  }
  if (!(useful > 0 && coverage > 0))
    throw std::invalid_argument(
        fmt::format("validation: useful bound {}, coverage {}, expected positive numbers", useful, coverage));
  Validation found{Outcome::unknown, simulated - measured, std::sqrt(squares), coverage, useful, parts};
  found.outcome = outcome_of(found);
  return found;
}

std::string words(const Validation& found, std::string_view unit) {
  const std::string k = fmt::format("{:g} u_val", found.coverage), E = "E = " + with_unit(found.error, unit),
                    interval = with_unit(found.expanded(), unit);
  const std::vector<std::string_view> missing = unknown(found.parts);
  std::string said;
  switch (found.outcome) {
    case Outcome::agrees:
      said = fmt::format("agrees within {}: {}, {} = {}", k, E, k, interval);
      break;
    case Outcome::model_error:
      said = fmt::format("model error {:.3g} ± {}", found.error, interval);
      break;
    case Outcome::too_uncertain:
      said = fmt::format("uncertainty too large to judge: {}, {} = {}, useful up to {}", E, k, interval,
                         with_unit(found.useful, unit));
      break;
    case Outcome::unknown:
      return fmt::format("cannot be judged: {}{}", E, std::isfinite(found.error) ? ", no uncertainty is known" : "");
  }
  std::vector<std::string> known;
  for (const auto& [name, part] : named(found.parts))
    if (!std::isnan(part)) known.push_back(fmt::format("{} {:.3g}", name, part));
  said += fmt::format(" ({})", fmt::join(known, ", "));
  if (missing.empty()) return said;
  return said + fmt::format("; {} {} unknown, so u_val is a lower bound", fmt::join(missing, " and "),
                            missing.size() == 1 ? "is" : "are");
}

double standard_of_95_percent(double low, double high) {
  constexpr double normal = 1.959964;  // standard deviations from the mean to the 97.5 % percentile
  return (high - low) / (2 * normal);
}

}  // namespace touchstone::vnv

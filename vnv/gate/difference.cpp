#include "vnv/gate/difference.hpp"

#include <fmt/format.h>

#include <cmath>

namespace touchstone::gate {

std::string_view name_of(Kind kind) {
  switch (kind) {
    case Kind::run:
      return "run";
    case Kind::claim:
      return "claim";
    case Kind::error:
      return "error";
    case Kind::order:
      return "order";
    case Kind::stability:
      return "stability";
    case Kind::cost:
      return "cost";
    case Kind::other:
      break;
  }
  return "other";
}

std::string_view name_of(Change change) {
  switch (change) {
    case Change::same:
      return "same";
    case Change::better:
      return "better";
    case Change::inconclusive:
      return "inconclusive";
    case Change::worse:
      return "worse";
    case Change::unjudged:
      break;
  }
  return "unjudged";
}

std::string sentence_of(const Difference& d) {
  const std::string rung = d.rung.empty() ? "" : " " + d.rung;
  const std::string time = std::isnan(d.time) ? "" : fmt::format(" at {:.4g} s", d.time);
  const bool has_values = d.kind != Kind::run && d.kind != Kind::claim;
  const std::string values = has_values ? fmt::format(": {:.6g} before, {:.6g} after", d.before, d.after) : "";
  return fmt::format("{}.{}{}: {}{}{}: {}: {}", d.case_name, d.method, rung, d.quantity, time, values,
                     name_of(d.change), d.why);
}

}  // namespace touchstone::gate

#include "vnv/gate/difference.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace touchstone::gate {

std::string_view name_of(Kind kind) {
  constexpr std::array names{"run", "claim", "error", "order", "stability", "other", "cost"};
  return names[static_cast<std::size_t>(kind)];
}

Kind kind_of(vnv::Kind quantity) {
  using Of = vnv::Kind;
  switch (quantity) {
    case Of::norm:
    case Of::error:
    case Of::deviation:
    case Of::invariant:
      return Kind::error;
    case Of::stability_limit:
      return Kind::stability;
    case Of::order:
      return Kind::order;
    default:
      return Kind::other;
  }
}

std::string_view name_of(Change change) {
  constexpr std::array names{"unjudged", "same", "better", "inconclusive", "worse"};
  return names[static_cast<std::size_t>(change)];
}

std::string sentence_of(const Difference& d) {
  const std::string level = d.level.empty() ? "" : " " + d.level;
  const std::string time = std::isnan(d.time) ? "" : fmt::format(" at {:.4g} s", d.time);
  const bool has_values = d.kind != Kind::run && d.kind != Kind::claim;
  const std::string values = has_values ? fmt::format(": {:.6g} before, {:.6g} after", d.before, d.after) : "";
  return fmt::format("{}.{}{}: {}{}{}: {}: {}", d.case_name, d.method, level, d.quantity, time, values,
                     name_of(d.change), d.why);
}

}  // namespace touchstone::gate

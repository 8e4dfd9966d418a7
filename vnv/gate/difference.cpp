#include "vnv/gate/difference.hpp"

#include <fmt/format.h>

#include <cmath>

namespace touchstone::gate {

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

Difference of_whole_method(std::string case_name, std::string method, Change change) {
  return {.case_name = std::move(case_name),
          .method = std::move(method),
          .quantity = "method",
          .kind = Kind::run,
          .change = change,
          .why = change == Change::worse ? gone : added};
}

std::string sentence_of(const Difference& d) {
  const std::string level = d.level.empty() ? "" : " " + d.level;
  const std::string time = std::isnan(d.time) ? "" : fmt::format(" at {:.4g} s", d.time);
  const bool has_values = d.kind != Kind::run && d.kind != Kind::claim;
  const std::string values = has_values ? fmt::format(": {:.6g} before, {:.6g} after", d.before, d.after) : "";
  return fmt::format("{}.{}{}: {}{}{}: {}: {}", d.case_name, d.method, level, d.quantity, time, values,
                     word_of(d.change), d.why);
}

}  // namespace touchstone::gate

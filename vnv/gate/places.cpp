#include "vnv/gate/places.hpp"

#include <cmath>

namespace touchstone::gate {

bool is_same_value(const vnv::Value& a, const vnv::Value& b) {
  return a.level == b.level && a.quantity.name == b.quantity.name && a.quantity.unit == b.quantity.unit &&
         vnv::same_time(a.time, b.time);
}

std::optional<double> tolerance_of(const vnv::Value& error, const vnv::Record& record) {
  std::optional<double> tolerance;
  for (const vnv::Verdict& v : record.verdicts) {
    if (!v.author.starts_with("baseline") || !v.lower || !v.upper || !std::isfinite(*v.upper - *v.lower)) continue;
    if (v.level != error.level || v.quantity != error.quantity.name || !vnv::same_time(v.time, error.time)) continue;
    const double half = (*v.upper - *v.lower) / 2;
    if (!tolerance || half < *tolerance) tolerance = half;
  }
  return tolerance;
}

}  // namespace touchstone::gate

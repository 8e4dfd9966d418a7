#include "vnv/gate/places.hpp"

#include <algorithm>
#include <cmath>

namespace touchstone::gate {

bool same_time(double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
  return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
}

const vnv::Value* find_value(const vnv::Record& record, const vnv::Value& other) {
  const auto found = std::ranges::find_if(record.values, [&](const vnv::Value& error) {
    return error.level == other.level && error.quantity.heading() == other.quantity.heading() &&
           same_time(error.time, other.time);
  });
  return found == record.values.end() ? nullptr : &*found;
}

std::optional<double> room_of(const vnv::Value& error, const vnv::Record& record) {
  std::optional<double> room;
  for (const vnv::Verdict& v : record.verdicts) {
    if (!v.author.starts_with("baseline") || !v.lower || !v.upper || !std::isfinite(*v.upper - *v.lower)) continue;
    if (v.level != error.level || v.quantity != error.quantity.name || !same_time(v.time, error.time)) continue;
    const double half = (*v.upper - *v.lower) / 2;
    if (!room || half < *room) room = half;
  }
  return room;
}

}  // namespace touchstone::gate

#include "vnv/gate/places.hpp"

#include "vnv/record/quantity.hpp"

#include <algorithm>
#include <cmath>

namespace touchstone::gate {

bool same_time(double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
  return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
}

const vnv::Error* find_error(const vnv::Record& record, const vnv::Error& other) {
  const auto found = std::ranges::find_if(record.errors, [&](const vnv::Error& error) {
    return error.level == other.level && error.quantity == other.quantity && same_time(error.time, other.time);
  });
  return found == record.errors.end() ? nullptr : &*found;
}

std::optional<double> room_of(const vnv::Error& error, const vnv::Record& record) {
  const std::string name = vnv::name_and_unit(error.quantity).first;
  std::optional<double> room;
  for (const vnv::Verdict& v : record.verdicts) {
    if (!v.author.starts_with("baseline") || !v.lower || !v.upper || !std::isfinite(*v.upper - *v.lower)) continue;
    if (v.level != error.level || v.quantity != name || !same_time(v.time, error.time)) continue;
    const double half = (*v.upper - *v.lower) / 2;
    if (!room || half < *room) room = half;
  }
  return room;
}

}  // namespace touchstone::gate

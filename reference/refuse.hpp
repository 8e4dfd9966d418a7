#pragma once
/// How the oracles refuse what they are not defined for: one std::domain_error of one line.

#include <fmt/format.h>

#include <cmath>
#include <initializer_list>
#include <stdexcept>
#include <string_view>

namespace touchstone::reference {

[[noreturn]] inline void refuse(std::string_view where, std::string_view what, double value,
                                std::string_view expected) {
  throw std::domain_error(fmt::format("{}: {} = {}, expected {}", where, what, value, expected));
}

/// A number of an oracle by its name and unit, "H [m]".
struct Named {
  std::string_view what;
  double value;
};

inline void require_finite(std::string_view where, std::initializer_list<Named> all) {
  for (const auto& [what, value] : all)
    if (!std::isfinite(value)) refuse(where, what, value, "a finite number");
}

inline void require_positive(std::string_view where, std::initializer_list<Named> all) {
  for (const auto& [what, value] : all)
    if (!(std::isfinite(value) && value > 0)) refuse(where, what, value, "a finite number above 0");
}

inline void require_time(std::string_view where, double t) {
  if (!(std::isfinite(t) && t >= 0)) refuse(where, "t [s]", t, "a finite time, not negative");
}

/// A height above a plate at y = 0.
inline void require_height(std::string_view where, double y) {
  if (!(std::isfinite(y) && y >= 0)) refuse(where, "y [m]", y, "a finite height, not negative");
}

}  // namespace touchstone::reference

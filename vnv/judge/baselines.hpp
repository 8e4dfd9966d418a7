#pragma once
/// Baselines: the values that were last accepted, with the two limits that a new value must keep.

#include "vnv/record/acceptance.hpp"
#include "vnv/record/quantity.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::vnv {

/// One accepted value. Limits are two-sided: lower <= value <= upper, all three finite and in the quantity's own unit.
struct Baseline {
  std::string method;    // "mpm"
  std::string level;     // "M2"; may be empty where a quantity belongs to a whole ladder
  double time;           // s; not a number where a quantity belongs to no time
  std::string quantity;  // "L2 v_x, row means"
  double value, lower, upper;
  std::string basis;  // why the limits are as wide as they are
};

struct Baselines {
  Acceptance acceptance;
  std::vector<Baseline> rows;

  /// The baseline at this place, or null; it lives as long as this. Times agree to nine digits, since a run may reach
  /// 0.1 s in many steps; two that are not numbers agree.
  const Baseline* find(std::string_view method, std::string_view level, double time, std::string_view quantity) const;
};

/// The baselines of a case, or nothing if nothing was accepted yet (no such file). Throws BadData for a file that is
/// not what `write_baselines` writes, a value outside its limits, or two values at one place.
std::optional<Baselines> read_baselines(const std::filesystem::path& file);

/// Writes the file whole or not at all, rows sorted and numbers as short as they can be read back without loss: equal
/// values give equal bytes. Throws BadData for whatever could not be read back; then the old file stands.
void write_baselines(const std::filesystem::path& file, std::vector<Baseline> rows, const Acceptance& acceptance);

}  // namespace touchstone::vnv

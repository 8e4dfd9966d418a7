#include "vnv/gate/meaning.hpp"

#include "vnv/record/quantity.hpp"

#include <algorithm>
#include <array>

namespace touchstone::gate {
namespace {

constexpr auto errors = std::to_array<std::string_view>({"L1", "L2", "Linf", "RMS", "error", "roughness"});
constexpr auto limits = std::to_array<std::string_view>({"critical time step", "largest stable", "share of the map"});
constexpr auto off_zero =
    std::to_array<std::string_view>({"less the exact", "less the measured", ", less 1", ", change"});
constexpr auto of_machines = std::to_array<std::string_view>(
    {"CPU", "memory", "time of", "time per", "time with", "timed", "side by side", "quartiles", "right-hand side"});

bool begins_with_one_of(const auto& words, std::string_view name) {
  return std::ranges::any_of(words, [&](std::string_view word) { return name.starts_with(word); });
}
bool has_one_of(const auto& words, std::string_view name) {
  return std::ranges::any_of(words, [&](std::string_view word) { return name.find(word) != name.npos; });
}

bool is_by_theory_or_literature(const vnv::Verdict& verdict) {
  return verdict.author.starts_with("theory") || verdict.author.starts_with("literature");
}

}  // namespace

Meaning meaning_of(std::string_view quantity) {
  if (begins_with_one_of(limits, quantity)) return {Kind::stability, Direction::larger};
  if (has_one_of(of_machines, quantity)) return {Kind::other, Direction::unknown, true};
  if (has_one_of(off_zero, quantity)) return {Kind::error, Direction::towards_zero};
  if (begins_with_one_of(errors, quantity)) return {Kind::error, Direction::smaller};
  return {};
}

Direction direction_by_claims(const vnv::Record& record, const std::string& quantity) {
  const std::string name = vnv::name_and_unit(quantity).first;
  bool smaller = false, larger = false;
  for (const vnv::Verdict& verdict : record.verdicts)
    if (verdict.quantity == name && is_by_theory_or_literature(verdict)) {
      smaller |= verdict.upper && !verdict.lower;
      larger |= verdict.lower && !verdict.upper;
    }
  if (smaller == larger) return Direction::unknown;
  return smaller ? Direction::smaller : Direction::larger;
}

}  // namespace touchstone::gate

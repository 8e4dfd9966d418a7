#pragma once
/// A claim says what a method achieves, on whose word; a verdict says whether it does.

#include "vnv/record/observed_order.hpp"
#include "vnv/record/verdict.hpp"

#include <string>
#include <string_view>
#include <utility>

namespace touchstone::vnv {

/// Who set a limit: `theory`, `literature` or `baseline`, and where it stands.
struct Author {
  std::string words;
};
inline Author theory(std::string_view source) { return {"theory: " + std::string(source)}; }
inline Author baseline(std::string_view source) { return {"baseline: " + std::string(source)}; }
inline Author literature(std::string_view source) { return {"literature: " + std::string(source)}; }

/// A quantity lies between limits, in its unit.
struct Claim {
  Quantity quantity;
  std::optional<double> lower, upper;
  Author author;
  std::string level = "";                             // where it holds; empty: on every level
  double time = not_a_number;                         // s  when it holds; not a number: at every time
  std::string ladder = "";                            // for an observed order: over which levels
  std::optional<double> surely_above = std::nullopt;  // for an observed order: where its interval has to begin
  long least_levels = 2;                              // for an observed order: suites that run fewer are not asked
  std::optional<double> formal_order = std::nullopt;  // that of the method's discretisation, where theory knows it

  Claim on(std::string_view name) const { return with(&Claim::level, std::string(name)); }
  Claim at(double when) const { return with(&Claim::time, when); }
  Claim with_at_least_levels(long levels) const { return with(&Claim::least_levels, levels); }
  Claim of_formal_order(double p) const { return with(&Claim::formal_order, std::optional(p)); }
  Claim over(std::string_view its_ladder) const { return with(&Claim::ladder, std::string(its_ladder)); }
  /// Whether it speaks of a value; times agree to nine digits.
  bool covers(std::string_view its_level, double its_time) const;

  /// The same claim with another value in one place.
  template <class T>
  Claim with(T Claim::*place, T value) const {
    Claim claim = *this;
    claim.*place = std::move(value);
    return claim;
  }
};

inline Claim at_most(const Quantity& quantity, double limit, Author author) {
  return {quantity, std::nullopt, limit, std::move(author)};
}
inline Claim at_least(const Quantity& quantity, double limit, Author author) {
  return {quantity, limit, std::nullopt, std::move(author)};
}
inline Claim between(const Quantity& quantity, double low, double high, Author author) {
  return {quantity, low, high, std::move(author)};
}
/// The observed order of a quantity over a ladder. Judged only where its 95 % interval is narrower than 0.3 to each
/// side; else the verdict is inconclusive, which is no pass.
inline Claim order_between(std::string_view ladder, const Quantity& quantity, double low, double high, Author author) {
  return between(quantity, low, high, std::move(author)).over(ladder);
}

/// The claim of a method that it converges: its order, above a floor if one was found, is no less than `low`, and the
/// whole 95 % interval lies above `surely_above`; one that lies above `low`, too, may be wide. An inconclusive trend is
/// inconclusive here too; stalled or diverging errors fail.
inline Claim order_at_least(std::string_view ladder, const Quantity& quantity, double low, double surely_above,
                            Author author) {
  return at_least(quantity, low, std::move(author)).over(ladder).with(&Claim::surely_above, {surely_above});
}

/// Where a value was measured.
struct Place {
  std::string case_name, method, level;
  double spacing = not_a_number;  // m
  double time = not_a_number;     // s
};

/// Judges a value. Written so that a value that is not a number fails.
Verdict judge(const Claim& claim, const Place& place, double value);

/// What its verdicts are about: the quantity itself, or its observed order.
Quantity judged_quantity(const Claim& claim);

/// Judges an observed order.
Verdict judge(const Claim& claim, const Place& place, const ObservedOrder& order);

}  // namespace touchstone::vnv

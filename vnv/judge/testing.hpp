/// What properties are tested with: values drawn by rapidcheck, which looks for a counterexample and then for the
/// simplest one. They are the same each time; RC_PARAMS=seed=N in the environment draws others.
#pragma once

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <vector>

namespace touchstone::vnv {

inline const bool draws_the_same_each_time = setenv("RC_PARAMS", "seed=36 max_success=200", 0) == 0;

/// Evenly from `simplest` to the other end, in steps of 2^-20 of what lies between: between small integers no digit is
/// rounded.
inline rc::Gen<double> between(double simplest, double other) {
  constexpr int steps = 1 << 20;
  return rc::gen::map(rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, steps + 1)),
                      [=](int step) { return simplest + (other - simplest) * step / steps; });
}

inline double any_between(double simplest, double other) { return *between(simplest, other); }
/// From the first to the last.
inline std::size_t any_count(int first, int last) {
  return static_cast<std::size_t>(*rc::gen::resize(rc::kNominalSize, rc::gen::inRange(first, last + 1)));
}
inline std::vector<double> any_numbers(std::size_t count, double simplest, double other) {
  return *rc::gen::container<std::vector<double>>(count, between(simplest, other));
}
/// A unit, from 1 to ten to the power of so much or of so little.
inline double any_unit(double power) {
  return std::pow(10, any_between(0, 1) < 0.5 ? any_between(0, power) : -any_between(0, power));
}

/// False where one is no number.
inline bool is_near(double value, double expected, double tolerance) { return std::abs(value - expected) <= tolerance; }

}  // namespace touchstone::vnv

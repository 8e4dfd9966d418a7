#pragma once
/// Mistakes that are made or not: what is seen is the exact field with another sign, in another unit, place or time.

#include "vnv/flows/flow.hpp"

#include <functional>
#include <string>
#include <vector>

namespace touchstone::vnv::doors {

/// What is seen of the exact field at a place and a time.
using Shown = std::function<Vec2(const FieldTruth& truth, const Vec2& x, double t)>;

struct Mistake {
  std::string cause;     // "reversed"
  std::string unit{};    // of the value: "%", "times"
  double value = 1;      // in it
  std::string sentence;  // "the velocity has the wrong sign"
  double scale = 1;      // what is seen over what it should be; 0: nothing
  bool of_time = false;  // looked for however small the error is
  Shown seen{};          // before it is scaled; empty: the truth
};

/// Nothing but a factor is wrong: nothing is there, the sign is wrong, or a power of ten that is near what was found.
std::vector<Mistake> mistakes_of_scale(const Exact& exact, double found);

/// Mirrored, turned, with its components swapped or one of them reversed; shifted along a periodic axis by quarters of
/// the box; frozen at its start, its clock twice or half as fast, one output late or early at these times [s]; and the
/// flows that may have been computed instead.
std::vector<Mistake> mistakes_of_place_and_time(const Exact& exact, const Domain& domain,
                                                const std::vector<double>& times);

}  // namespace touchstone::vnv::doors

#pragma once
/// Difference: one thing that two builds were compared in, and which way it went.

#include "vnv/record/record.hpp"

#include <string>
#include <string_view>

namespace touchstone::gate {

/// What kind of thing is compared: that a run is there and ends, that a claim holds, or a value.
enum class Kind { run, claim, error, order, stability, other, cost };
constexpr auto words(Kind) {
  return std::to_array<std::string_view>({"run", "claim", "error", "order", "stability", "other", "cost"});
}
Kind kind_of(vnv::Kind quantity);

/// Which way it went. What is unjudged is reported and gates nothing: it is new, or of the machine.
enum class Change { unjudged, same, better, inconclusive, worse };  // a gate rises with it
constexpr auto words(Change) {
  return std::to_array<std::string_view>({"unjudged", "same", "better", "inconclusive", "worse"});
}
using vnv::word_of;

struct Difference {
  std::string case_name{}, method{}, level{};  // the level may be empty where a thing belongs to a whole ladder
  double time = vnv::not_a_number;             // s  not a number where it belongs to no time
  std::string quantity{};                      // heading, "L2 v_x, row means [%]"
  Kind kind = Kind::other;
  double before = vnv::not_a_number, after = vnv::not_a_number;  // in the unit of the quantity
  Change change = Change::unjudged;
  std::string why{};
};

inline constexpr const char *gone = "no longer there", *added = "new";

/// That a method is gone, which is worse, or was added.
Difference of_whole_method(std::string case_name, std::string method, Change change);

/// Whether two things that each belong to a method of a case belong to the same.
bool are_of_one_method(const auto& a, const auto& b) { return a.case_name == b.case_name && a.method == b.method; }

/// "poiseuille.mpm M2: L2 v_x [%] at 1 s: 0.0641 before, 0.0705 after: worse: by 10 %, 2 % are allowed"
std::string sentence_of(const Difference& difference);

}  // namespace touchstone::gate

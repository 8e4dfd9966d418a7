#pragma once
/// What the name of a quantity says of it: which kind it is and which way is better.

#include "vnv/gate/difference.hpp"

namespace touchstone::gate {

/// Which way a quantity gets better. Errors with a sign are better nearer to zero.
enum class Direction { unknown, smaller, larger, towards_zero };

struct Meaning {
  Kind kind = Kind::other;
  Direction direction = Direction::unknown;
  bool of_the_machine = false;  // a time or a memory: another run of the same program finds another value
};

/// By the words of the name alone: "L2 v_x [%]" is an error, "critical time step over (31) [-]" a limit of stability,
/// "period, less the exact [%]" better nearer to zero, "peak memory [GB]" the machine's.
Meaning meaning_of(std::string_view quantity);

/// Which way is better by the claims of theory and literature on a quantity: what has but an upper limit is better when
/// smaller, what has but a lower one when larger. Unknown where they disagree or claim neither.
Direction direction_by_claims(const vnv::Record& record, const std::string& quantity);

}  // namespace touchstone::gate

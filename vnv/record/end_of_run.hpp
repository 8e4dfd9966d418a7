#pragma once
/// The claim that is made of every run.

#include <string_view>

namespace touchstone::vnv {

/// The quantity of the claim that a run ends where it was meant to: 1, or 0 if it did not.
inline constexpr std::string_view end_time_reached = "end time reached";

}  // namespace touchstone::vnv

#pragma once
/// No body force: a method given this compiles no force into its step.

namespace touchstone {

struct NoForce {};

template <class Force>
inline constexpr bool is_present = true;
template <>
inline constexpr bool is_present<NoForce> = false;

}  // namespace touchstone

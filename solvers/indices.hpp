#pragma once
#include <utility>

namespace touchstone {

/// Calls f with the integer constants 0 to n - 1 as arguments.
template <int n, class F>
decltype(auto) with_indices(const F& f) {
  return [&]<int... i>(std::integer_sequence<int, i...>)->decltype(auto) {
    return f(std::integral_constant<int, i>{}...);
  }
  (std::make_integer_sequence<int, n>{});
}

/// Calls f(0) to f(n - 1), unrolled.
template <int n, class F>
void for_indices(const F& f) {
  with_indices<n>([&](auto... i) { (f(i), ...); });
}

}  // namespace touchstone

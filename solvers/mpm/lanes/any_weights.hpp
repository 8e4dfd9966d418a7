#pragma once
/// Weights of any shape within the cells of a block, one cell a lane: particles of all cells meet the nodes near theirs
/// side by side. What `quadratic_weights.hpp` does in powers of the place, for shapes that are no polynomials within a
/// cell, or others at edges.

#include "solvers/mpm/lanes/quadratic_weights.hpp"

namespace touchstone::mpm {

/// A number for each node near a place along an axis.
template <int touched>
struct AlongNodes : std::array<Lanes, touched> {};

/// Of the nodes near a place along an axis: weights, their slopes [per cell], and arms, from the place to the node
/// [cells].
template <int touched>
struct WeightsAlong {
  AlongNodes<touched> weights{}, slopes{}, arms{};

  const AlongNodes<touched>& slope() const { return slopes; }
  /// As `affine_slopes_of` has it.
  AlongNodes<touched> affine_slope() const {
    Lanes spread{};
    for_indices<touched>([&](auto a) { spread += weights[a] * arms[a] * arms[a]; });
    const auto is_spread = spread > fill<Lanes>(1e-12);
    const Lanes per_spread = 1 / (is_spread ? spread : fill<Lanes>(1));
    AlongNodes<touched> affine;
    for_indices<touched>([&](auto a) { affine[a] = is_spread ? per_spread * weights[a] * arms[a] : slopes[a]; });
    return affine;
  }
};

/// Of the nodes near a cell: what they get of its particles, or a field.
template <int touched>
struct NodesNear {
  Square<Lanes, touched> of{};  // by column and row
};

template <int touched>
const Square<Lanes, touched>& nodes_of(const NodesNear<touched>& sums) {
  return sums.of;
}
/// A field times factors along x and along y.
template <int touched>
Lanes product(const NodesNear<touched>& q, const AlongNodes<touched>& x, const AlongNodes<touched>& y) {
  Lanes sum{};
  for_indices<touched>([&](auto a) {
    Lanes along_y{};
    for_indices<touched>([&](auto b) { along_y += y[b] * q.of[a][b]; });
    sum += x[a] * along_y;
  });
  return sum;
}
template <int touched>
Lanes value_at(const NodesNear<touched>& q, const WeightsAlong<touched>& X, const WeightsAlong<touched>& Y) {
  return product(q, X.weights, Y.weights);
}
/// `bend_x` and `bend_y` are the slopes or affine slopes of X and Y.
template <int touched>
ValueAndSlopes value_and_slopes(const NodesNear<touched>& q, const WeightsAlong<touched>& X,
                                const WeightsAlong<touched>& Y, const AlongNodes<touched>& bend_x,
                                const AlongNodes<touched>& bend_y) {
  return {value_at(q, X, Y), product(q, bend_x, Y.weights), product(q, X.weights, bend_y)};
}

/// What a particle gives to the nodes along an axis besides its weight.
template <int touched>
struct WideExtra {
  AlongNodes<touched> of;
};
template <int touched>
WideExtra<touched> operator+(const WideExtra<touched>& one, const WideExtra<touched>& other) {
  WideExtra<touched> sum;
  for_indices<touched>([&](auto a) { sum.of[a] = one.of[a] + other.of[a]; });
  return sum;
}
template <int touched>
WideExtra<touched> operator+(const WideExtra<touched>& one, const NoExtra&) {
  return one;
}
/// Of an affine change over a cell: w_a (x_a - x) change.
template <class Along, int touched>
WideExtra<touched> affine_extra(const Along&, const WeightsAlong<touched>& at, const Lanes& change) {
  WideExtra<touched> extra;
  for_indices<touched>([&](auto a) { extra.of[a] = at.weights[a] * at.arms[a] * change; });
  return extra;
}
/// Of a flux: it meets the slopes of the weights.
template <int touched>
WideExtra<touched> flux_extra(const WeightsAlong<touched>& at, const Lanes& flux) {
  WideExtra<touched> extra;
  for_indices<touched>([&](auto a) { extra.of[a] = at.slopes[a] * flux; });
  return extra;
}

// Adds what a particle gives, of q alone, of extras alone, or of all at once.

template <int touched>
void add_product(NodesNear<touched>& sums, const AlongNodes<touched>& x, const AlongNodes<touched>& y) {
  for_indices<touched>([&](auto a) { for_indices<touched>([&](auto b) { sums.of[a][b] += x[a] * y[b]; }); });
}
template <int touched>
void add_along_x(NodesNear<touched>& sums, const WideExtra<touched>& x, const WeightsAlong<touched>& Y) {
  add_product(sums, x.of, Y.weights);
}
template <int touched>
void add_along_y(NodesNear<touched>& sums, const WeightsAlong<touched>& X, const WideExtra<touched>& y) {
  add_product(sums, X.weights, y.of);
}
template <int touched>
void add_along_x(NodesNear<touched>&, const NoExtra&, const WeightsAlong<touched>&) {}
template <int touched>
void add_along_y(NodesNear<touched>&, const WeightsAlong<touched>&, const NoExtra&) {}
template <int touched>
void add(NodesNear<touched>& sums, const WeightsAlong<touched>& X, const WeightsAlong<touched>& Y, const Lanes& q) {
  AlongNodes<touched> x;
  for_indices<touched>([&](auto a) { x[a] = q * X.weights[a]; });
  add_product(sums, x, Y.weights);
}
template <int touched>
void add(NodesNear<touched>& sums, const WeightsAlong<touched>& X, const WeightsAlong<touched>& Y, const Lanes& q,
         const WideExtra<touched>& x, const WideExtra<touched>& y) {
  AlongNodes<touched> with_q;
  for_indices<touched>([&](auto a) { with_q[a] = q * X.weights[a] + x.of[a]; });
  add_product(sums, with_q, Y.weights);
  add_along_y(sums, X, y);
}

}  // namespace touchstone::mpm

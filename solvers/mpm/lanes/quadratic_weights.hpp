#pragma once
/// Quadratic B-splines within the cells of a block, one cell a lane, in powers of the place X, Y from 0 to 1: the
/// weights of the nodes left of, at and right of a cell are (1 - X)²/2, 1/2 + X - X² and X²/2. A cell is summed over
/// its particles in powers and meets its nodes once; a field of the nodes is laid out in powers once for all its
/// particles.

#include "solvers/mpm/nodes_of_cells.hpp"

namespace touchstone::mpm {

/// By power of X, or of Y.
using Powers = std::array<Lanes, 3>;
/// By power of X and of Y.
using PowersOfBoth = ThreeByThree<Lanes>;

/// Calls f(0), f(1), f(2), unrolled.
template <class F>
void for_three(const F& f) {
  for_indices<3>(f);
}

/// Of sums over particles of q, q X and q X², what the three nodes get.
inline Powers at_nodes(const Powers& q) {
  const Lanes half = 0.5 * q[0];
  return {half - q[1] + 0.5 * q[2], half + q[1] - q[2], 0.5 * q[2]};
}
/// The coefficients of a field that is so at the three nodes.
inline Powers of_nodes(const Powers& q) {
  const Lanes half = 0.5 * q[0];
  return {half + 0.5 * q[1], q[1] - q[0], half - q[1] + 0.5 * q[2]};
}

/// Has `change` work along Y, then along X.
template <class Change>
PowersOfBoth along_both(const PowersOfBoth& q, const Change& change) {
  PowersOfBoth half, whole;
  for_three([&](auto m) { half[m] = change(q[m]); });
  for_three([&](auto b) {
    const Powers along_x = change(Powers{half[0][b], half[1][b], half[2][b]});
    for_three([&](auto a) { whole[a][b] = along_x[a]; });
  });
  return whole;
}
inline PowersOfBoth nodes_of(const PowersOfBoth& sums) {
  return along_both(sums, [](const Powers& q) { return at_nodes(q); });
}
/// A field of the nodes around the cells whose first node is `node`; along each axis by `change`.
template <class Change>
PowersOfBoth laid_out(const CentreNodes& nodes, const Field<double>& field, int node, const Change& change) {
  PowersOfBoth q;
  for_three([&](auto a) { for_three([&](auto b) { q[a][b] = load<Lanes>(&field[node + b * nodes.stride + a]); }); });
  return along_both(q, change);
}
inline PowersOfBoth laid_out(const CentreNodes& nodes, const Field<double>& field, int node) {
  return laid_out(nodes, field, node, [](const Powers& q) { return of_nodes(q); });
}

/// Sums over the particles of a block of q X^i Y^j, for i from `first` to `end` - 1 and j below powers_of_Y(i), which
/// does not grow with i; value(slot) is q.
template <int first, int end, auto powers_of_Y, class Particles, class Block, class Value>
auto sums_of_powers(const Particles& particles, const Block& block, const Value& value) {
  std::array<std::array<Lanes, powers_of_Y(first)>, end - first> sums{};
  for_particles_of(block, [&](int slot, const auto& write) {
    const Lanes X = load<Lanes>(&particles.X[slot]);
    std::array<Lanes, powers_of_Y(first)> y{fill<Lanes>(1), load<Lanes>(&particles.Y[slot])};
    for (int j = 2; j < powers_of_Y(first); ++j) y[j] = y[j / 2] * y[j - j / 2];
    Lanes x = write.present ? value(slot) : Lanes{};
    for_indices<end>([&](auto i) {
      if constexpr (i >= first)
        for_indices<powers_of_Y(i)>([&](auto j) { sums[i - first][j] += j == 0 ? x : x * y[j]; });
      x *= X;
    });
  });
  return sums;
}
inline Lanes one_each(int /*slot*/) { return fill<Lanes>(1); }

/// 1, X and X² at a place along an axis, and how X² changes: its slope, or its affine slope, what particles of the
/// affine method see of it (w_a (x_a - x) summed over the nodes, over the spread of these).
struct Monomials {
  Lanes X, XX;

  explicit Monomials(const Lanes& at) : X(at), XX(at * at) {}
  Lanes slope() const { return 2 * X; }
  Lanes of(const Powers& q) const { return q[0] + X * q[1] + XX * q[2]; }
};

/// Affine slope of X² and spread sum w_a (x_a - x)² [cells²] along an axis where splines are whole.
struct WholeSplines {
  static Monomials at(const Lanes& X) { return Monomials(X); }
  static Lanes affine_slope(const Monomials& at) { return at.XX * (6 - 4 * at.X); }
  static Lanes spread(const Monomials&) { return fill<Lanes>(0.25); }
};
/// The same where some are cut off at edges of the domain, as `BSpline` does it: 1 in the lanes of the first cell for
/// `low` and of the last for `high`, 0 in others.
struct CutSplines {
  Lanes low{}, high{};

  static Monomials at(const Lanes& X) { return Monomials(X); }
  Lanes affine_slope(const Monomials& at) const {
    const Lanes rest = 1 - at.X;
    return 2 * at.X * (low + (1 - low) * at.X) * (1 + 2 * rest - high * (rest - at.X)) / (1 + low * rest + high * at.X);
  }
  Lanes spread(const Monomials& at) const {
    const Lanes rest = 1 - at.X;
    return 0.25 * (1 - low * rest * rest - high * at.XX);
  }
};

/// Calls work(along_x, along_y) with the splines of a block.
template <class Block, class Work>
void with_splines(const Grid& grid, const Block& block, const Work& work) {
  constexpr int width = std::tuple_size_v<decltype(block.count)>;
  const auto at_edge = [](int begin, int end, int cells, bool periodic) {
    return !periodic && (begin == 0 || end >= cells);
  };
  if (!at_edge(block.column, block.column + width, grid.columns, grid.periodic_x) &&
      !at_edge(block.row, block.row + 1, grid.rows, grid.periodic_y))
    return work(WholeSplines{}, WholeSplines{});
  CutSplines x, y;
  for (int lane = 0; lane < width; ++lane) {
    x.low[lane] = !grid.periodic_x && block.column + lane == 0;
    x.high[lane] = !grid.periodic_x && block.column + lane == grid.columns - 1;
    y.low[lane] = !grid.periodic_y && block.row == 0;
    y.high[lane] = !grid.periodic_y && block.row == grid.rows - 1;
  }
  work(x, y);
}

/// A field at a place, and how it changes over a cell along x and along y.
struct ValueAndSlopes {
  Lanes value, along_x, along_y;
};
/// `bend_x` and `bend_y` are the slopes or affine slopes of X² and Y².
inline ValueAndSlopes value_and_slopes(const PowersOfBoth& q, const Monomials& X, const Monomials& Y,
                                       const Lanes& bend_x, const Lanes& bend_y) {
  Powers by_y, change;
  for_three([&](auto m) {
    by_y[m] = Y.of(q[m]);
    change[m] = q[m][1] + bend_y * q[m][2];
  });
  return {X.of(by_y), by_y[1] + bend_x * by_y[2], X.of(change)};
}
inline Lanes value_at(const PowersOfBoth& q, const Monomials& X, const Monomials& Y) {
  return X.of({Y.of(q[0]), Y.of(q[1]), Y.of(q[2])});
}

/// What a particle gives to sums of powers along an axis besides q, q X and q X².
struct Extra {
  Lanes to_X, to_XX;
};
/// Nothing.
struct NoExtra {};
inline Extra operator+(const Extra& a, const Extra& b) { return {a.to_X + b.to_X, a.to_XX + b.to_XX}; }
inline Extra operator+(const Extra& a, const NoExtra&) { return a; }

/// Of an affine change over a cell: w_a (x_a - x) change.
template <class Splines>
Extra affine_extra(const Splines& splines, const Monomials& at, const Lanes& change) {
  const Lanes spread = splines.spread(at) * change;
  return {spread, spread * splines.affine_slope(at)};
}
/// Of a flux: it meets the slopes of the weights.
inline Extra flux_extra(const Monomials& at, const Lanes& flux) { return {flux, flux * at.slope()}; }

/// Adds what a particle gives, of q alone, of extras alone, or of all at once.
inline void add(PowersOfBoth& sums, const Monomials& X, const Monomials& Y, const Lanes& q) {
  const Powers by_x{q, q * X.X, q * X.XX};
  for_three([&](auto m) {
    sums[m][0] += by_x[m];
    sums[m][1] += by_x[m] * Y.X;
    sums[m][2] += by_x[m] * Y.XX;
  });
}
inline void add_along_x(PowersOfBoth& sums, const Extra& x, const Monomials& Y) {
  const auto add_row = [&](Powers& row, const Lanes& extra) {
    row[0] += extra;
    row[1] += extra * Y.X;
    row[2] += extra * Y.XX;
  };
  add_row(sums[1], x.to_X);
  add_row(sums[2], x.to_XX);
}
inline void add_along_y(PowersOfBoth& sums, const Monomials& X, const Extra& y) {
  const auto add_row = [&](Powers& row, const Extra& extra) {
    row[1] += extra.to_X;
    row[2] += extra.to_XX;
  };
  add_row(sums[0], y);
  add_row(sums[1], {X.X * y.to_X, X.X * y.to_XX});
  add_row(sums[2], {X.XX * y.to_X, X.XX * y.to_XX});
}
inline void add_along_x(PowersOfBoth&, const NoExtra&, const Monomials&) {}
inline void add_along_y(PowersOfBoth&, const Monomials&, const NoExtra&) {}
inline void add(PowersOfBoth& sums, const Monomials& X, const Monomials& Y, const Lanes& q, const Extra& x,
                const Extra& y) {
  const Lanes to_X = q * X.X + x.to_X, to_XX = q * X.XX + x.to_XX;
  const auto add_row = [&](Powers& row, const Lanes& by_x) {
    row[0] += by_x;
    row[1] += by_x * Y.X;
    row[2] += by_x * Y.XX;
  };
  add_row(sums[0], q);
  add_row(sums[1], to_X);
  add_row(sums[2], to_XX);
  add_along_y(sums, X, y);
}

}  // namespace touchstone::mpm

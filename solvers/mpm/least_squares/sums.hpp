#pragma once
/// Sums over particles of their weights times q x^k y^l, as the fits need them. Within a cell the weight of each of the
/// nine nodes around it is a product of parabolas, so a cell is summed in powers of X and Y, the place from its own
/// node, once for all nine. Rows of cells then meet their nodes along x, and rows of nodes meet along y.

#include "solvers/mpm/least_squares/particles.hpp"
#include "solvers/mpm/splines/within.hpp"
#include "solvers/quadratic_fit.hpp"

namespace touchstone::mpm {

/// Which sums there are of a q of which nodes need all up to a degree in x and y.
template <int degree>
struct SumsUpTo {
  /// How many powers of Y go with X^i in a cell, and with x^k in a row of cells.
  static constexpr int in_cell(int i) { return degree + 3 - std::max(i - 2, 0); }
  static constexpr int in_row(int k) { return degree + 3 - k; }
  /// Where the first of these stands.
  static constexpr int place_in_cell(int i) { return i == 0 ? 0 : place_in_cell(i - 1) + in_cell(i - 1); }
  static constexpr int place_in_row(int k) { return k == 0 ? 0 : place_in_row(k - 1) + in_row(k - 1); }
  static constexpr int all_in_cell = place_in_cell(degree + 3), all_in_row = place_in_row(degree + 1);
};

/// Of sums of q X^i over three cells side by side, sum(-1, i) to sum(1, i), those of q x^k, with x from the node of the
/// one in the middle, times twice its weights: a factor of all weights changes no fit.
template <int last, class Sum>
std::array<Lanes, last + 1> around_node(const Sum& sum) {
  std::array<Lanes, last + 1> even, odd, all;
  for_indices<last + 1>([&](auto i) {
    const Lanes below = 0.25 * sum(-1, i) + (sum(-1, i + 2) + sum(-1, i + 1)),  // (1/2 + X)², x = X - 1
        above = 0.25 * sum(1, i) + (sum(1, i + 2) - sum(1, i + 1));             // (1/2 - X)², x = X + 1
    even[i] = above + below;
    odd[i] = above - below;
    all[i] = 1.5 * sum(0, i) - 2.0 * sum(0, i + 2);  // 2 (3/4 - X²)
  });
  constexpr double binomial[5][5] = {{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}, {1, 4, 6, 4, 1}};
  for_indices<last + 1>([&](auto k) {
    for_indices<k + 1>([&](auto i) { all[k] += binomial[k][i] * ((k - i) % 2 == 0 ? even[i] : odd[i]); });
  });
  return all;
}

/// Rows of cells, three at a time, as the nodes of the one in the middle see them.
class RowsOfCells {
 public:
  static constexpr int fields = 3;
  using Fit = QuadraticFit<Lanes, fields>;

  explicit RowsOfCells(const Grid& grid)
      : grid_(grid), stride_((grid.columns / lanes + 2) * lanes), cells_(stride_ * of_cell<fields + 1>) {
    seen_.fill(std::vector<Seen>(stride_ / lanes));
  }

  /// Sums the particles of a row, or of its image; one past an edge has none. It stands for those three above and
  /// below.
  [[gnu::flatten]] void sum(const FittedParticles& particles, double density, int row) {
    std::vector<Seen>& to = seen_[(row + 3) % 3];
    if (!grid_.periodic_y && (row < 0 || row >= grid_.rows)) return std::fill(to.begin(), to.end(), Seen{});
    row = (row + grid_.rows) % grid_.rows;
    const auto& blocks = particles.order.blocks();
    auto block = std::lower_bound(blocks.begin(), blocks.end(), row, [](const auto& b, int r) { return b.row < r; });
    for (int column = 0; column < grid_.columns; column += lanes) {
      if (block < blocks.end() && block->row == row && block->column == column)
        sum_cells(particles, density, *block++);
      else
        for (int k = 0; k < of_cell<fields + 1>; ++k) store(Lanes{}, &cells_[k * stride_ + column + 1]);
    }
    for (int k = 0; k < of_cell<fields + 1>; ++k) {
      double* const sums = &cells_[k * stride_];
      sums[0] = grid_.periodic_x ? sums[grid_.columns] : 0;
      sums[grid_.columns + 1] = grid_.periodic_x ? sums[1] : 0;
    }
    for_indices<fields + 1>([&](auto q) { meet_nodes<q>(to); });
  }

  /// What the nodes of a row have for their fits, a register of them, when it and both its neighbours are summed.
  Fit::Sums of_nodes(int row, int at) const {
    const std::array<const Seen*, 3> seen{&seen_[(row + 2) % 3][at], &seen_[row % 3][at], &seen_[(row + 1) % 3][at]};
    Fit::Sums sums;
    for_indices<fields + 1>([&](auto q) {
      constexpr std::size_t first = q == 0 ? 0 : Fit::moments + (q - 1) * Fit::monomials;
      for_indices<degree<q> + 1>([&](auto k) {
        const auto found = around_node<degree<q> - k>(
            [&](int cell, int j) { return (*seen[cell + 1])[of_row<q> + Needed<q>::place_in_row(k) + j]; });
        for_indices<degree<q> - k + 1>([&](auto l) { sums[first + (k + l) * (k + l + 1) / 2 + l] = found[l]; });
      });
    });
    return sums;
  }

 private:
  // The q: 1, and the fields. Where the sums of each stand, or how many those before it are.
  template <int q>
  static constexpr int degree = q == 0 ? 4 : 2;
  template <int q>
  using Needed = SumsUpTo<degree<q>>;
  template <int q>
  static constexpr int of_cell = q == 0 ? 0 : Needed<0>::all_in_cell + (q - 1) * Needed<1>::all_in_cell;
  template <int q>
  static constexpr int of_row = q == 0 ? 0 : Needed<0>::all_in_row + (q - 1) * Needed<1>::all_in_row;
  using Seen = std::array<Lanes, of_row<fields + 1>>;

  void sum_cells(const FittedParticles& particles, double density, const CellOrder<lanes>::Block& block) {
    const auto value_of = [](const Scalars& field) { return [&field](int slot) { return load<Lanes>(&field[slot]); }; };
    const auto one = [](int) { return fill<Lanes>(1); };
    sum_powers<0, 0, 3>(particles, block, one);  // in two parts, which registers can hold
    sum_powers<0, 3, 7>(particles, block, one);
    sum_powers<1, 0, 5>(particles, block, value_of(particles.vx));
    sum_powers<2, 0, 5>(particles, block, value_of(particles.vy));
    sum_powers<3, 0, 5>(particles, block, [&, rho = value_of(particles.rho)](int slot) { return rho(slot) - density; });
  }
  /// Sums over the particles of a block of q X^i Y^j, with i from `first` to `end` - 1.
  template <int q, int first, int end, class Value>
  void sum_powers(const FittedParticles& particles, const CellOrder<lanes>::Block& block, const Value& value) {
    using Of = Needed<q>;
    std::array<std::array<Lanes, Of::in_cell(first)>, end - first> sums{};
    for_particles_of(block, [&](int slot, const auto& write) {
      const Lanes X = load<Lanes>(&particles.X[slot]);
      std::array<Lanes, Of::in_cell(first)> y{fill<Lanes>(1), load<Lanes>(&particles.Y[slot])};
      for (int j = 2; j < Of::in_cell(first); ++j) y[j] = y[j / 2] * y[j - j / 2];
      Lanes x = write.present ? value(slot) : Lanes{};
      for_indices<end>([&](auto i) {
        if constexpr (i >= first)
          for_indices<Of::in_cell(i)>([&](auto j) { sums[i - first][j] += j == 0 ? x : x * y[j]; });
        x *= X;
      });
    });
    for_indices<end - first>([&](auto i) {
      for_indices<Of::in_cell(i + first)>([&](auto j) {
        store(sums[i][j], &cells_[(of_cell<q> + Of::place_in_cell(i + first) + j) * stride_ + block.column + 1]);
      });
    });
  }

  /// Along x.
  template <int q>
  void meet_nodes(std::vector<Seen>& to) const {
    for_indices<degree<q> + 3>([&](auto j) {
      constexpr int last = std::min(degree<q>, degree<q> + 2 - j);
      std::array<const double*, last + 3> sums;  // from the first cell on
      for (int i = 0; i < last + 3; ++i)
        sums[i] = &cells_[(of_cell<q> + Needed<q>::place_in_cell(i) + j) * stride_ + 1];
      for (int at = 0; at * lanes < grid_.columns; ++at) {
        const auto found =
            around_node<last>([&](int cell, int i) { return load<Lanes>(sums[i] + (at * lanes + cell)); });
        for_indices<last + 1>([&](auto k) { to[at][of_row<q> + Needed<q>::place_in_row(k) + j] = found[k]; });
      }
    });
  }

  Grid grid_;
  int stride_;
  Field<double> cells_;                    // of one row: each sum of all cells, between a ghost before and one behind
  std::array<std::vector<Seen>, 3> seen_;  // by register
};

}  // namespace touchstone::mpm

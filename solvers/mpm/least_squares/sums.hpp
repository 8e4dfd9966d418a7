#pragma once
/// Sums over particles of their weights times q x^k y^l, as the fits need them. Within a cell the weight of each of the
/// nine nodes around it is a product of parabolas, so a cell is summed in powers of X and Y, the place from its own
/// node, once for all nine. Rows of cells then meet their nodes along x, and rows of nodes meet along y.

#include "solvers/integrators/fluid_state.hpp"
#include "solvers/mpm/beginning.hpp"
#include "solvers/mpm/cell_lanes.hpp"
#include "solvers/mpm/cell_order.hpp"
#include "solvers/mpm/lanes/quadratic_weights.hpp"
#include "solvers/quadratic_fit.hpp"

namespace touchstone::mpm {

/// The state in the order of the cells around the nodes, as an integrator moves it. Slots without a particle are zero
/// throughout, and so are their rates.
struct FittedParticles : FluidState {
  Field<double> X, Y;  // cells  from the middle of its cell, where the node is
  Field<int> number;   // as seeded
  CellOrder<lanes> order{1, 1, {}};

  /// From the nodes along an axis, of a register of particles.
  Monomials place(int axis, int slot) const { return Monomials(load<Lanes>(&(axis == 0 ? X : Y)[slot])); }

  template <class F>
  void for_fields(const F& f) {
    for (Scalars* field :
         {&x, &y, &vx, &vy, &rho, &ax, &ay, &drho, &start.x, &start.y, &start.vx, &start.vy, &start.rho})
      f(*field);
    for (Scalars& field : past) f(field);
    f(X), f(Y), f(number);
  }

  /// Puts particles where they are listed; all else is zero.
  void lay_out(const Vectors& places, const Grid& grid) {
    const std::vector<int> cells = cells_of(places, grid);
    order = {grid.columns, grid.rows, cells};
    fluid = order.slots();
    for_fields([&]<class F>(F& field) {
      field.resize(fluid);
      std::fill_n(&field[0], fluid, 0);
    });
    std::vector<int> taken(grid.cells(), 0);
    for (int p = 0; p < places.cols(); ++p) {
      const int slot = order.slot(cells[p], taken[cells[p]]++);
      number[slot] = p;
      x[slot] = places(0, p);
      y[slot] = places(1, p);
    }
  }
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
      : grid_(grid), stride_((grid.columns / lanes + 2) * lanes), cells_(stride_ * all_of_cell) {
    along_x_.fill(std::vector<SumsAlongX>(stride_ / lanes));
  }

  /// Sums the particles of a row, or of its image; one past an edge has none. It stands for those three above and
  /// below.
  [[gnu::flatten]] void sum(const FittedParticles& particles, double density, int row) {
    std::vector<SumsAlongX>& to = along_x_[(row + 3) % 3];
    if (!grid_.periodic_y && (row < 0 || row >= grid_.rows)) return std::fill(to.begin(), to.end(), SumsAlongX{});
    row = (row + grid_.rows) % grid_.rows;
    const auto& blocks = particles.order.blocks();
    auto block = std::lower_bound(blocks.begin(), blocks.end(), row, [](const auto& b, int r) { return b.row < r; });
    for (int column = 0; column < grid_.columns; column += lanes) {
      if (block < blocks.end() && block->row == row && block->column == column)
        sum_cells(particles, density, *block++);
      else
        for (int k = 0; k < all_of_cell; ++k) store(Lanes{}, &cells_[k * stride_ + column + 1]);
    }
    for (int k = 0; k < all_of_cell; ++k) {
      double* const sums = &cells_[k * stride_];
      sums[0] = grid_.periodic_x ? sums[grid_.columns] : 0;
      sums[grid_.columns + 1] = grid_.periodic_x ? sums[1] : 0;
    }
    for_indices<fields + 1>([&](auto q) { meet_nodes<q>(to); });
  }

  /// What the nodes of a row have for their fits, a register of them, when it and both its neighbours are summed.
  Fit::Sums of_nodes(int row, int at) const {
    const std::array<const SumsAlongX*, 3> seen{&along_x_[(row + 2) % 3][at], &along_x_[row % 3][at],
                                                &along_x_[(row + 1) % 3][at]};
    Fit::Sums sums;
    for_indices<fields + 1>([&](auto q) {
      constexpr std::size_t first = q == 0 ? 0 : Fit::moments + (q - 1) * Fit::monomials;
      for_indices<degree<q> + 1>([&](auto k) {
        const auto found =
            around_node<degree<q> - k>([&](int cell, int j) { return (*seen[cell + 1])[of_row<q, k> + j]; });
        for_indices<degree<q> - k + 1>([&](auto l) { sums[first + (k + l) * (k + l + 1) / 2 + l] = found[l]; });
      });
    });
    return sums;
  }

 private:
  // Of q = 1, and of the fields: up to which degree in x and y nodes need sums, and so how many powers of Y go with X^i
  // in a cell; where those with X^i stand in a cell, and with x^k in a row.
  template <int q>
  static constexpr int degree = q == 0 ? 4 : 2;
  template <int q>
  static constexpr auto powers_of_Y = [](int i) { return degree<q> + 3 - std::max(i - 2, 0); };
  template <int q, int i>
  static constexpr int of_cell = q == 0 ? 7 * i : 49 + 25 * (q - 1) + 5 * i;
  template <int q, int k>
  static constexpr int of_row = q == 0 ? 7 * k : 35 + 15 * (q - 1) + 5 * k;
  static constexpr int all_of_cell = of_cell<fields + 1, 0>;
  using SumsAlongX = std::array<Lanes, of_row<fields + 1, 0>>;

  void sum_cells(const FittedParticles& particles, double density, const CellOrder<lanes>::Block& block) {
    const auto value_of = [](const Scalars& field) { return [&field](int slot) { return load<Lanes>(&field[slot]); }; };
    const auto excess = [&](int slot) -> Lanes { return load<Lanes>(&particles.rho[slot]) - density; };
    sum_powers<0, 0, 3>(particles, block, one_each);  // in two parts, which registers can hold
    sum_powers<0, 3, 7>(particles, block, one_each);
    sum_powers<1, 0, 5>(particles, block, value_of(particles.vx));
    sum_powers<2, 0, 5>(particles, block, value_of(particles.vy));
    sum_powers<3, 0, 5>(particles, block, excess);
  }
  template <int q, int first, int end, class Value>
  void sum_powers(const FittedParticles& particles, const CellOrder<lanes>::Block& block, const Value& value) {
    const auto sums = sums_of_powers<first, end, powers_of_Y<q>>(particles, block, value);
    double* to = &cells_[of_cell<q, first> * stride_ + block.column + 1];
    for_indices<end - first>([&](auto i) {
      for_indices<powers_of_Y<q>(0)>([&](auto j) {
        if constexpr (j < powers_of_Y<q>(i + first)) store(sums[i][j], to);
        to += stride_;
      });
    });
  }

  /// Along x.
  template <int q>
  void meet_nodes(std::vector<SumsAlongX>& to) const {
    for_indices<degree<q> + 3>([&](auto j) {
      constexpr int last = std::min(degree<q>, degree<q> + 2 - j);
      const double* const of_j = &cells_[(of_cell<q, 0> + j) * stride_ + 1];
      const Index next = (of_cell<q, 1> - of_cell<q, 0>)*stride_;
      for (int at = 0; at * lanes < grid_.columns; ++at) {
        const auto found =
            around_node<last>([&](int cell, int i) { return load<Lanes>(of_j + i * next + (at * lanes + cell)); });
        for_indices<last + 1>([&](auto k) { to[at][of_row<q, k> + j] = found[k]; });
      }
    });
  }

  Grid grid_;
  Index stride_;
  Field<double> cells_;                    // of one row: each sum of all cells, between a ghost before and one behind
  std::array<std::vector<SumsAlongX>, 3> along_x_;  // by register
};

}  // namespace touchstone::mpm

#pragma once
/// Nodes that know the fluid around them by polynomials of second degree.

#include "solvers/integrators/fluid_state.hpp"
#include "solvers/mpm/grid.hpp"
#include "solvers/quadratic_fit.hpp"
#include "solvers/threads.hpp"

namespace touchstone::mpm {

/// The node nearest to a place, and where the place is from there, in cells.
struct NearNode {
  int column, row;
  double X, Y;
};

/// A node on every corner of the grid's cells; across a periodic boundary the last is the first.
class FittedNodes {
 public:
  /// Fields that are fitted: velocity [m/s], and density less that at rest [kg/m³].
  enum Field { v_x, v_y, excess };
  static constexpr std::size_t fields = 3;
  using Fit = QuadraticFit<double, fields>;
  using Polynomials = std::array<Fit::Polynomial, fields>;  // in cells

  /// Throws std::invalid_argument for fewer than three nodes along an axis.
  explicit FittedNodes(const Grid& grid)
      : columns(grid.node_columns()),
        rows(grid.periodic_y ? grid.rows : grid.rows + 1),
        grid_(grid),
        sums_(static_cast<std::size_t>(columns) * rows),
        fit_(sums_.size()) {
    if (columns < 3 || rows < 3)
      throw std::invalid_argument(
          fmt::format("mpm: {} x {} nodes, expected at least 3 along each axis", columns, rows));
  }

  const int columns, rows;

  int count() const { return static_cast<int>(fit_.size()); }
  const Polynomials& fit(int node) const { return fit_[node]; }
  Polynomials& fit(int node) { return fit_[node]; }
  Vec2 velocity(int node) const { return {fit_[node][v_x][0], fit_[node][v_y][0]}; }
  void set_velocity(int node, const Vec2& v) {
    fit_[node][v_x][0] = v.x();
    fit_[node][v_y][0] = v.y();
  }

  bool has_column(int column) const { return grid_.periodic_x || (column >= 0 && column < columns); }
  bool has_row(int row) const { return grid_.periodic_y || (row >= 0 && row < rows); }
  /// A node by its place in the lattice, which may be a period beyond a boundary.
  int node_at(int column, int row) const { return (row + rows) % rows * columns + (column + columns) % columns; }

  NearNode near(double x, double y) const {
    const double u = (x - grid_.box.low.x()) / grid_.cell.x(), v = (y - grid_.box.low.y()) / grid_.cell.y();
    const int column = nearest(u, columns, grid_.periodic_x), row = nearest(v, rows, grid_.periodic_y);
    return {wrapped(column, columns), wrapped(row, rows), u - column, v - row};
  }

  /// Fits each node to the particles less than one and a half cells away, weighted by the quadratic B-spline. The sums
  /// of a node have one order, whatever the number of threads.
  void fit(const FluidState& all, double density, int threads) {
    sort_by_row(all, threads);
    share_out(threads, rows, [&](Index begin, Index end) {
      for (Index row = begin; row < end; ++row) {
        std::fill_n(&sums_[row * columns], columns, Fit::Sums{});
        for (const int up : {-1, 0, 1})
          if (has_row(static_cast<int>(row) - up)) add_to_row(all, density, static_cast<int>(row), up);
        for (Index node = row * columns; node < (row + 1) * columns; ++node) fit_[node] = Fit::of(sums_[node]);
      }
    });
  }

  /// The polynomials of the corners of a place's cell, joined by linear hats: exact for the second degree.
  std::array<double, fields> joined(const NearNode& from) const {
    const int left = lower(from.column, from.X, columns, grid_.periodic_x),
              low = lower(from.row, from.Y, rows, grid_.periodic_y);
    const double X = from.X + (from.column - left), Y = from.Y + (from.row - low);
    std::array<double, fields> sum{};
    for (const int up : {0, 1})
      for (const int right : {0, 1}) {
        const double hat = (right ? X : 1 - X) * (up ? Y : 1 - Y), x = X - right, y = Y - up;
        const Polynomials& c = fit_[node_at(left + right, low + up)];
        for (std::size_t f = 0; f < fields; ++f)
          sum[f] += hat * (c[f][0] + x * (c[f][1] + x * c[f][3] + y * c[f][4]) + y * (c[f][2] + y * c[f][5]));
      }
    return sum;
  }

  /// The parabolas through nine nodes near a place, for fields of the nodes: value(node) is an array.
  template <class Value>
  auto through_nodes(const NearNode& from, const Value& value) const {
    const int column = inner(from.column, columns, grid_.periodic_x), row = inner(from.row, rows, grid_.periodic_y);
    const auto along = [](double X) { return std::array{X * (X - 1) / 2, 1 - X * X, X * (X + 1) / 2}; };
    const auto across_x = along(from.X + (from.column - column)), across_y = along(from.Y + (from.row - row));
    std::remove_cvref_t<decltype(value(0))> sum{};
    for (int b = 0; b < 3; ++b)
      for (int a = 0; a < 3; ++a) {
        const auto& at = value(node_at(column + a - 1, row + b - 1));
        for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += across_x[a] * across_y[b] * at[k];
      }
    return sum;
  }

 private:
  static int wrapped(int k, int count) { return (k % count + count) % count; }
  static int nearest(double place, int count, bool periodic) {
    if (!(std::abs(place) < 1e9)) return 0;  // not a number: the caller will see that it is nowhere
    const int k = static_cast<int>(std::floor(place + 0.5));
    return periodic ? k : std::clamp(k, 0, count - 1);
  }
  /// The lower node of the cell on the side of X.
  static int lower(int k, double X, int count, bool periodic) {
    const int at = X < 0 ? k - 1 : k;
    return periodic ? at : std::clamp(at, 0, count - 2);
  }
  /// The node itself, or its neighbour if it has one on one side only.
  static int inner(int k, int count, bool periodic) { return periodic ? k : std::clamp(k, 1, count - 2); }

  static std::array<double, 3> spline(double X) {
    return {0.5 * (0.5 - X) * (0.5 - X), 0.75 - X * X, 0.5 * (0.5 + X) * (0.5 + X)};
  }

  /// Lists the particles by the row of their nearest node, each row in the order of the particles.
  void sort_by_row(const FluidState& all, int threads) {
    near_.resize(static_cast<std::size_t>(all.fluid));
    share_out_fields(threads, all.fluid, [&](Index begin, Index end) {
      for (Index i = begin; i < end; ++i) near_[i] = near(all.x[i], all.y[i]);
    });
    first_.assign(rows + 1, 0);
    for (const NearNode& node : near_) ++first_[node.row + 1];
    for (int row = 0; row < rows; ++row) first_[row + 1] += first_[row];
    order_.resize(near_.size());
    std::vector<int> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < near_.size(); ++i) order_[next[near_[i].row]++] = static_cast<int>(i);
  }

  /// Adds the particles whose nearest nodes are `up` rows below to a row of nodes.
  void add_to_row(const FluidState& all, double density, int row, int up) {
    const int from = wrapped(row - up, rows);
    for (int k = first_[from]; k < first_[from + 1]; ++k) {
      const int i = order_[k];
      const NearNode& at = near_[i];
      const double Y = at.Y - up, weight_y = spline(at.Y)[1 + up];
      const std::array<double, 3> weight_x = spline(at.X);
      const std::array<double, fields> values{all.vx[i], all.vy[i], all.rho[i] - density};
      for (const int right : {-1, 0, 1}) {
        if (!has_column(at.column + right)) continue;
        const auto added = Fit::terms(weight_x[1 + right] * weight_y, at.X - right, Y, values);
        Fit::Sums& sums = sums_[node_at(at.column + right, row)];
        for (std::size_t s = 0; s < Fit::count; ++s) sums[s] += added[s];
      }
    }
  }

  Grid grid_;
  std::vector<Fit::Sums> sums_;
  std::vector<Polynomials> fit_;
  std::vector<NearNode> near_;      // of each particle
  std::vector<int> first_, order_;  // where each row begins in the list of particles by rows
};

}  // namespace touchstone::mpm

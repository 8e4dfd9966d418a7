#include "reports/figures/isolines.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace touchstone::reports {
namespace {

constexpr double reach = 2;           // spacings, of the Gaussian
constexpr double least_weight = 1.2;  // of pi, the sum of weights amid a lattice
constexpr long most_nodes = 4'000'000;

/// The field at the nodes of a grid of one spacing, row by row.
struct Grid {
  double x, y, cell;  // of its first node
  long columns, rows;
  std::vector<double> weight, mean;

  bool is_known(long node) const { return weight[static_cast<std::size_t>(node)] >= least_weight; }
  double at(long node) const { return mean[static_cast<std::size_t>(node)]; }
};

bool is_finite(const vnv::Cloud& cloud, std::size_t p) {
  return std::isfinite(cloud.x[p]) && std::isfinite(cloud.y[p]) && std::isfinite(cloud.colour[p]);
}

Grid grid_over(const vnv::Cloud& cloud, double spacing) {
  double low_x = INFINITY, low_y = INFINITY, high_x = -INFINITY, high_y = -INFINITY;
  for (std::size_t p = 0; p < cloud.x.size(); ++p)
    if (is_finite(cloud, p)) {
      low_x = std::min(low_x, cloud.x[p]), high_x = std::max(high_x, cloud.x[p]);
      low_y = std::min(low_y, cloud.y[p]), high_y = std::max(high_y, cloud.y[p]);
    }
  Grid grid{low_x, low_y, spacing, 0, 0, {}, {}};
  const double columns = (high_x - low_x) / spacing + 1, rows = (high_y - low_y) / spacing + 1;
  if (!(columns >= 2 && rows >= 2 && columns * rows < most_nodes)) return grid;
  grid.columns = static_cast<long>(columns) + 1, grid.rows = static_cast<long>(rows) + 1;
  grid.weight.assign(static_cast<std::size_t>(grid.columns * grid.rows), 0);
  grid.mean = grid.weight;
  for (std::size_t p = 0; p < cloud.x.size(); ++p) {
    if (!is_finite(cloud, p)) continue;
    const double X = (cloud.x[p] - grid.x) / spacing, Y = (cloud.y[p] - grid.y) / spacing;
    const auto first = [](double at) { return std::max(0L, static_cast<long>(std::ceil(at - reach))); };
    const auto last = [](double at, long count) { return std::min(count - 1, static_cast<long>(at + reach)); };
    for (long row = first(Y); row <= last(Y, grid.rows); ++row)
      for (long column = first(X); column <= last(X, grid.columns); ++column) {
        const double dx = X - static_cast<double>(column), dy = Y - static_cast<double>(row);
        const double w = std::exp(-dx * dx - dy * dy);
        const auto node = static_cast<std::size_t>(row * grid.columns + column);
        grid.weight[node] += w;
        grid.mean[node] += w * cloud.colour[p];
      }
  }
  for (std::size_t node = 0; node < grid.mean.size(); ++node)
    if (grid.weight[node] > 0) grid.mean[node] /= grid.weight[node];
  return grid;
}

/// Within a cell, from edge to edge; both ways through a saddle part as its centre says.
void add_pieces(const Grid& grid, long column, long row, double level, std::vector<IsolinePiece>& pieces) {
  // Corners and edges in turn around the cell.
  const long first = row * grid.columns + column;
  const std::array<long, 4> corner{first, first + 1, first + grid.columns + 1, first + grid.columns};
  constexpr std::array<double, 4> dx{0, 1, 1, 0}, dy{0, 0, 1, 1};
  struct Crossing {
    double x, y;
    bool rises;  // around the cell
  };
  std::vector<Crossing> crossings;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t next = (k + 1) % 4;
    const double a = grid.at(corner[k]), b = grid.at(corner[next]);
    if ((a < level) == (b < level)) continue;
    const double s = (level - a) / (b - a);
    crossings.push_back({grid.x + grid.cell * (static_cast<double>(column) + std::lerp(dx[k], dx[next], s)),
                         grid.y + grid.cell * (static_cast<double>(row) + std::lerp(dy[k], dy[next], s)), a < b});
  }
  const auto join = [&](std::size_t a, std::size_t b) {
    pieces.push_back({crossings[a].x, crossings[a].y, crossings[b].x, crossings[b].y, level});
  };
  if (crossings.size() == 2) return join(0, 1);
  if (crossings.size() != 4) return;
  double centre = 0;
  for (const long node : corner) centre += grid.at(node) / 4;
  // A line cuts off each corner that is not of the centre's side: it lies between the crossings before and behind it.
  const bool with_next = (centre < level) == crossings[0].rises;
  join(0, with_next ? 1 : 3);
  join(with_next ? 2 : 1, with_next ? 3 : 2);
}

}  // namespace

std::vector<IsolinePiece> isolines(const vnv::Cloud& cloud, double distance, double spacing) {
  std::vector<IsolinePiece> pieces;
  if (!(distance > 0 && spacing > 0)) return pieces;
  const Grid grid = grid_over(cloud, spacing);
  for (long row = 0; row + 1 < grid.rows; ++row)
    for (long column = 0; column + 1 < grid.columns; ++column) {
      const long first = row * grid.columns + column;
      const std::array<long, 4> corner{first, first + 1, first + grid.columns, first + grid.columns + 1};
      if (!std::ranges::all_of(corner, [&](long node) { return grid.is_known(node); })) continue;
      double low = INFINITY, high = -INFINITY;
      for (const long node : corner) low = std::min(low, grid.at(node)), high = std::max(high, grid.at(node));
      if (!(high - low < 1000 * distance)) continue;
      for (double k = std::ceil(low / distance); k * distance <= high; ++k)
        if (k != 0) add_pieces(grid, column, row, k * distance, pieces);
    }
  return pieces;
}

}  // namespace touchstone::reports

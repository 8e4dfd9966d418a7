#pragma once
#include "solvers/mpm/grid.hpp"
#include "solvers/mpm/particles.hpp"
#include "solvers/stepping/diverged.hpp"

#include <limits>

namespace touchstone::mpm {

/// The cell, along a row or a column of them, of a place that is `within` [cells] from the low edge of cell `at`; makes
/// `within` its place in the cell returned, 0 to 1. Returns -1 for a place past the ends, and for what is not a number.
/// Edges belong to the cell on either side, as the shape does; what is past an end by rounding is on it.
template <class Number>
int cell_along(Number& within, int at, int cells, bool periodic) {
  if (within >= 0 && within <= 1) return at;
  if (!(std::abs(static_cast<double>(within)) < cells)) return -1;  // asked before it becomes an integer
  const int shift = static_cast<int>(std::floor(within));
  const int to = periodic ? (at + shift + cells) % cells : at + shift;
  if (to < 0 || to >= cells) {
    constexpr Number rounding = 16 * std::numeric_limits<Number>::epsilon();
    const Number end = to < 0 ? Number(0) : Number(1);
    if (!(std::abs(within - end) <= rounding)) return -1;
    within = end;
    return at;
  }
  within -= static_cast<Number>(shift);
  return to;
}

/// Whether a particle is in its cell, with a plausible density.
template <class Particles>
bool is_calm(const Particles& particles, int slot) {
  const auto between = [](double low, double number, double high) { return low <= number && number <= high; };
  return between(0, particles.X[slot], 1) && between(0, particles.Y[slot], 1) &&
         between(1 / most_density, 1 + particles.expansion[slot], 1 / least_density);
}

/// Settles a particle that may have left its cell: returns the cell it is in now, with its place within that one.
/// Throws Diverged, with the step and time [s] just reached, if it has left the domain or has no plausible density.
template <class Particles, class FluidLaw>
int settle(Particles& particles, int slot, int cell, const Grid& grid, const FluidLaw& fluid, long step, double time) {
  if (is_calm(particles, slot)) return cell;
  const Vec2 place = grid.place(cell, particles.X[slot], particles.Y[slot]);
  const auto fail = [&](std::string quantity, double value, std::string expected) {
    throw Diverged({.step = step,
                    .time = time,
                    .particle = particles.number[slot],
                    .place = place,
                    .quantity = std::move(quantity),
                    .value = value,
                    .expected = std::move(expected)});
  };
  const auto range = [](double low, double high) { return fmt::format("{:g} to {:g}", low, high); };

  const int column = cell_along(particles.X[slot], cell % grid.columns, grid.columns, grid.periodic_x);
  if (column < 0) fail("x [m]", place.x(), range(grid.box.low.x(), grid.box.high.x()));
  const int row = cell_along(particles.Y[slot], cell / grid.columns, grid.rows, grid.periodic_y);
  if (row < 0) fail("y [m]", place.y(), range(grid.box.low.y(), grid.box.high.y()));
  const double density = fluid.density / (1 + static_cast<double>(particles.expansion[slot]));
  const double least = least_density * fluid.density, most = most_density * fluid.density;
  if (!(least <= density && density <= most)) fail("density [kg/m³]", density, range(least, most));
  return grid.cell_at(column, row);
}

/// Carries the particles that left their cell to the one they are in, settle(slot, cell); visits only those that are
/// not calm. True if a block has come or has been emptied.
template <class Particles, class Settle>
bool keep_order(Particles& particles, const std::vector<LaneBits>& calm, const Settle& settle) {
  auto& order = particles.order;
  for (std::size_t index = 0; index < calm.size(); ++index) {
    if (calm[index] == (1u << order.width) - 1) continue;
    for (int lane = 0; lane < order.width; ++lane) {
      if (calm[index] >> lane & 1) continue;
      for (int k = 0; k < order.blocks()[index].count[lane];) {
        const auto& block = order.blocks()[index];
        const int slot = block.slot(lane, k), cell = order.cell(block, lane), to = settle(slot, cell);
        if (to == cell)
          ++k;
        else
          order.carry(particles, cell, k, to);  // which puts another in its place
      }
    }
  }
  if (!order.is_stale()) return false;
  order.list_occupied();
  return true;
}
}  // namespace touchstone::mpm

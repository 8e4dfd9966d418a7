/// vnv order: the observed order of convergence of any table of errors, or of values whose truth nobody knows.

#include "vnv/command/commands.hpp"
#include "vnv/doors/read/dataset.hpp"
#include "vnv/judge/grid_convergence.hpp"
#include "vnv/judge/order.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace touchstone::vnv::command {
namespace {

/// A column of a table by falling spacing, which its first column holds.
std::vector<AtSpacing> ladder_of(const doors::Array& spacings, const doors::Array& column) {
  std::vector<AtSpacing> ladder;
  for (std::size_t row = 0; row < spacings.values.size(); ++row)
    ladder.push_back({spacings.values[row], column.values[row]});
  std::ranges::sort(ladder, std::greater{}, &AtSpacing::spacing);
  return ladder;
}

ObservedOrder order_of(const std::vector<AtSpacing>& ladder) {
  std::vector<double> spacings, errors;
  for (const AtSpacing& level : ladder) {
    spacings.push_back(level.spacing);
    errors.push_back(level.value);
  }
  return observe_order(std::move(spacings), std::move(errors));
}

/// A line for each three neighbours, the finest last. Throws std::invalid_argument for fewer than three.
GridConvergence print_convergence(const std::string& name, const std::vector<AtSpacing>& ladder) {
  if (ladder.size() < 3)
    throw std::invalid_argument(
        fmt::format("{}: {} resolutions, expected at least 3 to extrapolate values", name, ladder.size()));
  GridConvergence found{};
  for (std::size_t k = 2; k < ladder.size(); ++k) {
    found = grid_convergence(ladder[k - 2], ladder[k - 1], ladder[k]);
    fmt::print("{} at spacings {:g}, {:g}, {:g}: ", name, ladder[k - 2].spacing, ladder[k - 1].spacing,
               ladder[k].spacing);
    switch (found.trend) {
      case GridConvergence::Trend::monotone:
        fmt::print(
            "observed order {:.4g}, extrapolated to {:.8g}, grid convergence index {:.3g}{}\n", found.order,
            found.extrapolated, found.index,
            ladder[k].value == 0 ? "" : fmt::format(" ({:.3g} %)", 100 * found.index / std::abs(ladder[k].value)));
        break;
      case GridConvergence::Trend::constant:
        fmt::print("does not change\n");
        break;
      case GridConvergence::Trend::oscillating:
        fmt::print("oscillates: no order, no extrapolation\n");
        break;
      case GridConvergence::Trend::diverging:
        fmt::print("does not converge\n");
        break;
    }
  }
  return found;
}

void print(const std::string& name, const ObservedOrder& order) {
  fmt::print("{}: observed order {:.4g} +- {:.2g} over {} resolutions, {}{}\n", name, order.order, order.half_width,
             order.errors.size(), name_of(order.trend), order.asymptotic ? ", asymptotic" : "");
  if (!std::isnan(order.floor))
    fmt::print("  above a floor of {:.4g} +- {:.2g}: {:.4g} +- {:.2g}\n", order.floor, order.floor_half_width,
               order.order_to_floor, order.order_to_floor_half_width);
  fmt::print("  between neighbours: {:.4g}\n", fmt::join(order.pairwise, ", "));
}

/// Whether the whole 95 % interval, above a floor if there is one, lies above a limit.
bool is_surely_above(const ObservedOrder& order, double limit) {
  const bool above_floor = !std::isnan(order.floor);
  const double middle = above_floor ? order.order_to_floor : order.order,
               half = above_floor ? order.order_to_floor_half_width : order.half_width;
  return order.trend == Trend::converging && middle - half > limit;
}

}  // namespace

int order(const Build&, const OrderOptions& options) {
  const std::vector<doors::Dataset> tables = doors::read_datasets(options.file);
  if (tables.size() != 1 || tables[0].arrays.size() < 2)
    throw std::invalid_argument(
        fmt::format("{}: expected one table, of a column of spacings and others of errors or values", options.file));
  const std::vector<doors::Array>& columns = tables[0].arrays;
  bool all_above = true;
  for (std::size_t k = 1; k < columns.size(); ++k) {
    const std::vector<AtSpacing> ladder = ladder_of(columns[0], columns[k]);
    if (options.are_values) {
      const double order = print_convergence(columns[k].name, ladder).order;
      all_above &= !options.surely_above || order > *options.surely_above;
      continue;
    }
    const ObservedOrder found = order_of(ladder);
    print(columns[k].name, found);
    all_above &= !options.surely_above || is_surely_above(found, *options.surely_above);
  }
  if (options.surely_above)
    fmt::print("{} above {:g}{}\n", all_above ? "all orders are" : "not all orders are", *options.surely_above,
               options.are_values ? "" : ", the 95 % interval included");
  return all_above ? all_holds : something_fails;
}

}  // namespace touchstone::vnv::command

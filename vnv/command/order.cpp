/// vnv order: the observed order of convergence of any table of errors.

#include "vnv/command/commands.hpp"
#include "vnv/doors/read/dataset.hpp"
#include "vnv/judge/order.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <stdexcept>

namespace touchstone::vnv::command {
namespace {

/// The rows of a table by falling spacing, which its first column holds.
ObservedOrder order_of(const doors::Array& spacings, const doors::Array& errors) {
  std::vector<std::size_t> rows(spacings.values.size());
  std::iota(rows.begin(), rows.end(), 0);
  std::ranges::sort(rows, std::greater{}, [&](std::size_t row) { return spacings.values[row]; });
  std::vector<double> falling, of_them;
  for (const std::size_t row : rows) {
    falling.push_back(spacings.values[row]);
    of_them.push_back(errors.values[row]);
  }
  return observe_order(std::move(falling), std::move(of_them));
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
        fmt::format("{}: expected one table, of a column of spacings and others of errors", options.file));
  const std::vector<doors::Array>& columns = tables[0].arrays;
  bool all_above = true;
  for (std::size_t k = 1; k < columns.size(); ++k) {
    const ObservedOrder found = order_of(columns[0], columns[k]);
    print(columns[k].name, found);
    all_above &= !options.surely_above || is_surely_above(found, *options.surely_above);
  }
  if (options.surely_above)
    fmt::print("{} above {:g}, the 95 % interval included\n", all_above ? "all orders are" : "not all orders are",
               *options.surely_above);
  return all_above ? all_holds : something_fails;
}

}  // namespace touchstone::vnv::command

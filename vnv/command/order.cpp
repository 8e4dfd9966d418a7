/// vnv order: the observed order of convergence of any table of errors, or of values whose truth nobody knows.

#include "vnv/command/commands.hpp"
#include "vnv/judge/grid_convergence.hpp"
#include "vnv/judge/order.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace touchstone::vnv::command {
namespace {

/// A column of a table by falling spacing.
std::vector<AtSpacing> ladder_of(const std::vector<double>& spacings, const std::vector<double>& values) {
  std::vector<AtSpacing> ladder;
  for (std::size_t row = 0; row < spacings.size(); ++row) ladder.push_back({spacings[row], values[row]});
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

/// A line for each three neighbours, the finest last, and whether its order can be believed: Eça & Hoekstra (2014)
/// trust one from 0.5 to about the formal one, of values that neither swing nor part. Throws std::invalid_argument for
/// fewer than three.
bool print_convergence(const std::string& name, const std::vector<AtSpacing>& ladder, double formal_order,
                       double& order) {
  if (ladder.size() < 3)
    throw std::invalid_argument(
        fmt::format("{}: {} resolutions, expected at least 3 to extrapolate values", name, ladder.size()));
  bool is_trusted = false;
  for (std::size_t k = 2; k < ladder.size(); ++k) {
    const AtSpacing& finest = ladder[k];
    const auto percent = [&](double part) {
      return finest.value == 0 ? "" : fmt::format(" ({:.3g} %)", 100 * part / std::abs(finest.value));
    };
    const GridConvergence found = grid_convergence(ladder[k - 2], ladder[k - 1], finest);
    is_trusted =
        found.trend == GridConvergence::Trend::monotone && found.order >= 0.5 && found.order <= 1.05 * formal_order;
    order = found.order;
    fmt::print("{} at spacings {:g}, {:g}, {:g}: ", name, ladder[k - 2].spacing, ladder[k - 1].spacing, finest.spacing);
    switch (found.trend) {
      case GridConvergence::Trend::monotone:
        fmt::print("observed order {:.4g}", found.order);
        if (is_trusted)
          fmt::print(", extrapolated to {:.8g}, grid convergence index {:.3g}{}", found.extrapolated, found.index,
                     percent(found.index));
        break;
      case GridConvergence::Trend::constant:
        fmt::print("does not change");
        is_trusted = true;
        break;
      case GridConvergence::Trend::oscillating:
        fmt::print("oscillates: no order, no extrapolation");
        break;
      case GridConvergence::Trend::diverging:
        fmt::print("does not converge");
        break;
    }
    if (!is_trusted) {
      const NumericalUncertainty u =
          numerical_uncertainty({ladder.begin(), ladder.begin() + static_cast<long>(k) + 1}, formal_order);
      fmt::print("{}; numerical uncertainty {:.3g}{} at 95 %: {}",
                 found.order > 1.05 * formal_order
                     ? fmt::format(", above the formal order {:g} (--formal-order) and not trusted", formal_order)
                     : "",
                 u.interval, percent(u.interval), u.basis);
    }
    fmt::print("\n");
  }
  return is_trusted;
}

bool falls_throughout(const ObservedOrder& order) {
  return std::ranges::all_of(order.pairwise, [](double pair) { return pair > 0; }) || order.trend == Trend::diverging ||
         order.trend == Trend::stalled;
}

/// Errors above a floor are asymptotic to it: the errors themselves are not, and their local orders fall.
void print(const std::string& name, const ObservedOrder& order, std::optional<double> formal_order) {
  const bool has_floor = !std::isnan(order.floor);
  const auto asymptotic = [&](bool above_floor) {
    return order.asymptotic && order.trend == Trend::converging && above_floor == has_floor ? ", asymptotic" : "";
  };
  fmt::print("{}: observed order {:.4g} +- {:.2g} over {} resolutions, {}{}{}\n", name, order.order, order.half_width,
             order.errors.size(), word_of(order.trend),
             order.trend == Trend::stalled && !has_floor ? " (within 0.5 of 0)" : "", asymptotic(false));
  if (has_floor)
    fmt::print("  above a floor of {:.4g} +- {:.2g}: {:.4g} +- {:.2g}{}\n", order.floor, order.floor_half_width,
               order.order_to_floor, order.order_to_floor_half_width, asymptotic(true));
  fmt::print("  between neighbours: {:.4g}\n", fmt::join(order.pairwise, ", "));
  if (!falls_throughout(order))
    fmt::print("  not trusted: the errors do not fall from each resolution to the next\n");
  else if (formal_order && order.order > 1.5 * *formal_order)
    fmt::print("  not trusted: far above the formal order {:g}\n", *formal_order);
}

/// Why an order is not surely above a limit by its whole 95 % interval, above a floor if there is one; empty if it is.
/// An order within 0.5 of 0, as of a jump, is stalled without a floor: its interval decides.
std::string why_not_above(const ObservedOrder& order, double limit) {
  const bool above_floor = !std::isnan(order.floor);
  const double middle = above_floor ? order.order_to_floor : order.order,
               half = above_floor ? order.order_to_floor_half_width : order.half_width;
  if (order.trend == Trend::stalled && above_floor) return "stalled at a floor, not trusted";
  if (order.trend != Trend::converging && order.trend != Trend::stalled) return std::string(word_of(order.trend));
  if (!(middle - half > limit)) return fmt::format("may be {:.4g}", middle - half);
  return std::ranges::all_of(order.pairwise, [](double pair) { return pair > 0; }) ? "" : "not trusted";
}

/// Prints what the errors of a column say. Returns why their order is not surely above a limit, if there is one.
std::string judge_errors(const TableColumn& column, const std::vector<double>& spacings, const OrderOptions& options) {
  std::vector<double> errors = column.values;
  if (const auto zero = std::ranges::find(errors, 0); zero != errors.end()) {
    const bool is_exact = std::ranges::all_of(errors, [](double error) { return error == 0; });
    fmt::print(
        "{}: {}: no order\n", column.name,
        is_exact ? "zero at each resolution, exact to rounding"
                 : fmt::format("row {} is exactly zero, through which no power law passes", zero - errors.begin() + 1));
    return options.surely_above ? "no order" : "";
  }
  const auto negative = std::ranges::count_if(errors, [](double error) { return error < 0; });
  const bool change_sign = negative > 0 && negative < std::ssize(errors);
  for (double& error : errors) error = std::abs(error);
  const ObservedOrder found = order_of(ladder_of(spacings, errors));
  print(column.name, found, options.formal_order);
  if (negative > 0) fmt::print("  of the magnitudes of signed errors\n");
  if (change_sign) fmt::print("  not trusted: the errors change sign\n");
  if (!options.surely_above) return "";
  return change_sign ? "not trusted" : why_not_above(found, *options.surely_above);
}

std::string judge_values(const TableColumn& column, const std::vector<double>& spacings, const OrderOptions& options) {
  double found = 0;
  const bool is_trusted =
      print_convergence(column.name, ladder_of(spacings, column.values), options.formal_order.value_or(2), found);
  if (!options.surely_above || (is_trusted && found > *options.surely_above)) return "";
  return is_trusted ? fmt::format("{:.4g}", found) : "not trusted";
}

}  // namespace

int order(const Build&, const OrderOptions& options) {
  const OrderTable table = order_table(options.file, options.table, options.are_values);
  fmt::print("spacing: {}\n", table.resolution);
  if (!table.left_alone.empty()) fmt::print("left alone: {}\n", fmt::join(table.left_alone, ", "));
  std::vector<std::string> not_above;
  for (const TableColumn& column : table.columns) {
    const auto odd = std::ranges::find_if_not(column.values, [](double value) { return std::isfinite(value); });
    if (odd != column.values.end()) {
      fmt::print("{}: row {} is {}, expected a finite number: no order\n", column.name, odd - column.values.begin() + 1,
                 *odd);
      not_above.push_back(column.name + " no order");
    } else {
      const std::string why = (options.are_values ? judge_values : judge_errors)(column, table.spacings, options);
      if (!why.empty()) not_above.push_back(column.name + " " + why);
    }
  }
  if (options.surely_above)
    fmt::print("{} surely above {:g}{}{}{}\n", not_above.empty() ? "all orders are" : "not all orders are",
               *options.surely_above, options.are_values ? "" : ", the 95 % interval included",
               not_above.empty() ? "" : ": ", fmt::join(not_above, "; "));
  return not_above.empty() ? all_holds : something_fails;
}

}  // namespace touchstone::vnv::command

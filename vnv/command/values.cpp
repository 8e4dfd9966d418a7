#include "vnv/command/values.hpp"

#include "vnv/doors/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace touchstone::vnv::command {
namespace {

/// What was measured of a quantity at a time, or at many, by level.
struct Row {
  std::string heading, time;
  std::map<std::string, std::vector<const Value*>> of_level{};
};

/// A row for each quantity and time; one for all times of a quantity that is followed over more than a few.
std::vector<Row> rows_of(const Record& record) {
  constexpr std::size_t few = 6;
  std::vector<std::string> headings;
  std::map<std::string, std::map<double, std::vector<const Value*>>> found;  // by heading and time
  for (const Value& v : record.values) {
    auto& of_it = found[v.quantity.heading()];
    if (of_it.empty()) headings.push_back(v.quantity.heading());
    of_it[v.time].push_back(&v);
  }
  std::vector<Row> rows;
  for (const std::string& heading : headings) {
    const auto& of_it = found[heading];
    const bool is_followed = of_it.size() > few;
    if (is_followed)
      rows.push_back({heading, fmt::format("{:g} to {:g}", of_it.begin()->first, of_it.rbegin()->first)});
    for (const auto& [time, values] : of_it) {
      if (!is_followed) rows.push_back({heading, fmt::format("{:g}", time)});
      for (const Value* v : values) rows.back().of_level[v->level].push_back(v);
    }
  }
  return rows;
}

/// "0.48", "0.91 to 1.02"
std::string in_cell(const std::vector<const Value*>& values) {
  const auto [least, most] = std::ranges::minmax(values, {}, [](const Value* v) { return v->value; });
  for (const Value* v : values)
    if (std::isnan(v->value)) return "nan";
  return values.size() == 1 ? fmt::format("{:.6g}", values[0]->value)
                            : fmt::format("{:.4g} to {:.4g}", least->value, most->value);
}

}  // namespace

void print_values(const Record& record) {
  std::vector<std::string> levels;
  for (const Value& v : record.values)
    if (std::ranges::find(levels, v.level) == levels.end()) levels.push_back(v.level);
  const std::vector<Row> rows = rows_of(record);
  std::size_t wide = 8;
  for (const Row& row : rows) wide = std::max(wide, row.heading.size());
  fmt::print("\n{:{}} {:>14}", "quantity", wide, "time [s]");
  for (const std::string& level : levels) fmt::print(" {:>16}", level);
  fmt::print("\n");
  for (const Row& row : rows) {
    bool is_limited = false;
    fmt::print("{:{}} {:>14}", row.heading, wide, row.time);
    for (const std::string& level : levels) {
      const auto of_it = row.of_level.find(level);
      fmt::print(" {:>16}", of_it == row.of_level.end() ? "" : in_cell(of_it->second));
      if (of_it != row.of_level.end())
        is_limited |= std::ranges::any_of(of_it->second, [&](const Value* v) { return doors::is_limited(*v, record); });
    }
    fmt::print("{}\n", is_limited ? "" : "  not limited");
  }
  for (const ObservedOrder& order : record.orders)
    if (order.levels.size() > 2)
      fmt::print("observed order of {} at {:g} s: {:.3f} +- {:.2g} over {} resolutions\n", order.quantity, order.time,
                 order.order, order.half_width, order.levels.size());
}

}  // namespace touchstone::vnv::command

#include "reports/pages/case_tables.hpp"

#include "reports/text/html.hpp"
#include "reports/text/notation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace touchstone::reports {
namespace {

bool is_number(const vnv::Cell& cell) { return std::holds_alternative<double>(cell); }

/// Words among numbers are aligned as these.
HtmlCell cell_html(const vnv::Table& table, std::size_t row, std::size_t column) {
  const vnv::Cell& cell = table.rows[row][column];
  if (is_number(cell)) return number_cell(std::get<double>(cell));
  const bool among_numbers =
      std::ranges::any_of(table.rows, [&](const auto& cells) { return is_number(cells[column]); });
  return {typeset(std::get<std::string>(cell)), among_numbers ? "number" : ""};
}

std::string table_html(const vnv::Table& table) {
  HtmlTable html{escape(table.title) + ".", typeset(table.caption), {}};
  for (const auto& column : table.columns) html.columns.push_back(typeset(column));
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    HtmlRow row;
    for (std::size_t c = 0; c < table.columns.size(); ++c) row.push_back(cell_html(table, r, c));
    const bool is_known = std::ranges::find(html.rows, row) != html.rows.end();
    if (!is_known) html.rows.push_back(std::move(row));  // methods of a case may each bring the same reference values
  }
  return to_html(html);
}

// One column per quantity and time, one row per run.
using Column = std::pair<std::string, std::string>;

/// The time is empty for what belongs to a whole run.
Column column_of(const vnv::Value& error) {
  return {error.quantity.heading(), std::isnan(error.time) ? "" : printed(error.time) + "\u202fs"};
}

std::vector<Column> error_columns(const CaseRecords& records) {
  std::vector<Column> columns;
  for_each(records, &vnv::Record::values, [&](const auto&, const auto& error) {
    if (const Column column = column_of(error); std::ranges::find(columns, column) == columns.end())
      columns.push_back(column);
  });
  std::ranges::stable_sort(columns, {}, &Column::first);
  return columns;
}

std::vector<HtmlRow> error_rows(const vnv::Record& record, const std::vector<Column>& columns) {
  std::vector<HtmlRow> rows;
  std::map<std::string, std::size_t> row_of;
  for (const auto& error : record.values) {
    const auto [found, is_new] = row_of.try_emplace(error.level, rows.size());
    if (is_new) {
      rows.push_back({escape(record.method), level_cell(error.level), number_cell(error.spacing * 1e3)});
      rows.back().resize(3 + columns.size());
    }
    const auto column = std::ranges::find(columns, column_of(error)) - columns.begin();
    rows[found->second][3 + column] = number_cell(error.value);
  }
  return rows;
}

std::string pairwise(const vnv::ObservedOrder& order) {
  std::string html;
  for (std::size_t i = 0; i < order.pairwise.size(); ++i) {
    const bool named = i + 1 < order.levels.size();
    html += fmt::format(
        "{}{}{}", i == 0 ? "" : ", ", printed(order.pairwise[i]),
        named ? fmt::format(" <small>{}–{}</small>", escape(order.levels[i]), escape(order.levels[i + 1])) : "");
  }
  return html;
}

/// "stalled", and whether the ladder is long enough to show it.
HtmlCell trend_cell(const vnv::ObservedOrder& order) {
  return {sign_and_word(order.trend) + (order.asymptotic ? "" : " <small>not asymptotic</small>"), word(order.trend)};
}

std::string floor_words(const vnv::ObservedOrder& order) {
  if (std::isnan(order.floor)) return "none found";
  return fmt::format("{} ± {} <small>order {} ± {} towards it</small>", printed(order.floor),
                     printed(order.floor_half_width), printed(order.order_to_floor),
                     printed(order.order_to_floor_half_width));
}

HtmlRow order_row(const vnv::Record& record, const vnv::ObservedOrder& order) {
  const std::string fitted = fmt::format("{} ± {}", printed(order.order), printed(order.half_width));
  return {escape(record.method),
          words_cell(escape(order.ladder)),
          typeset(order.quantity),
          number_cell(order.time),
          HtmlCell(fitted, order.order < 0 ? "number fails" : "number"),
          trend_cell(order),
          words_cell(floor_words(order)),
          words_cell(pairwise(order))};
}

/// The median, and the lowest and highest where there were several; another resource than CPU time with its name.
std::string time_with_span(const vnv::Cost& c) {
  if (c.resource != vnv::Resource::cpu) return fmt::format("{}\u202f{}\u202fs", printed(c.occupied), word(c.resource));
  if (c.repeats == 1) return printed(c.cpu);
  return fmt::format("{} <small>{}–{}</small>", printed(c.cpu), printed(c.cpu_lowest), printed(c.cpu_highest));
}

HtmlRow cost_row(const vnv::Record& record, const vnv::RunSummary& run) {
  const vnv::Cost& c = run.cost;
  const auto of_steps = [&](double value) {  // of which another code says nothing
    return number_or_blank_cell(c.steps > 0 ? value : vnv::not_a_number);
  };
  return {escape(record.method),
          level_cell(run.level),
          number_cell(run.spacing * 1e3),
          of_steps(run.time_step * 1e6),
          number_cell(run.end_time),
          number_cell(c.particles),
          of_steps(static_cast<double>(c.boundary_particles)),
          of_steps(static_cast<double>(c.steps)),
          HtmlCell(time_with_span(c), "number"),
          number_cell(c.repeats),
          number_cell(c.wall),
          number_or_blank_cell(100 * c.harness_share()),
          number_cell(c.peak_memory / 1e6),
          of_steps(c.per_particle_step() * 1e9),
          of_steps(c.particle_steps_per_second() / 1e6),
          HtmlCell(escape(run.outcome), fails_at(record, run.level) && !run.finished ? "words fails" : "words")};
}

/// A row of each item of all records.
std::string table_of(HtmlTable table, const CaseRecords& records, auto items, const auto& row) {
  for_each(records, items, [&](const auto& record, const auto& item) { table.rows.push_back(row(record, item)); });
  return to_html(table);
}

}  // namespace

std::string tables_html(const CaseRecords& records) {
  std::string html;
  for (const auto& table : tables_of(records)) html += table_html(table);
  return html;
}

std::string errors_html(const CaseRecords& records) {
  const auto columns = error_columns(records);
  HtmlTable table{"Error norms.", "Each in the unit that its name ends with.", {"method", "level", "spacing [mm]"}};
  for (const auto& [quantity, time] : columns)
    table.columns.push_back(fmt::format("{}<br><small>{}</small>", typeset(quantity), time));
  for (const auto& record : records.records)
    std::ranges::move(error_rows(record, columns), std::back_inserter(table.rows));
  return to_html(table);
}

std::string orders_html(const CaseRecords& records) {
  return table_of(
      {"Observed orders.",
       "Fitted over the whole ladder, with the 95\u202f% interval; positive when converging. A pairwise order "
       "is that between two neighbouring levels. A floor is reported where a power law that falls to it fits the "
       "errors significantly better than one that falls to zero; it is in the unit of the quantity. Stalled: the floor "
       "is more than half of the finest error, or the order is 0. Asymptotic: the orders of the two finest pairs agree "
       "with the fitted one within a tenth.",
       {"method", "ladder", "quantity", "time [s]", "order", "trend", "floor", "pairwise"}},
      records, &vnv::Record::orders, order_row);
}

std::string cost_html(const CaseRecords& records) {
  return table_of(
      {"Cost.",
       "User time of the steps; for repeated runs the median, with the lowest and highest. For codes that declare a "
       "resource, wall time × number of units is given instead, labelled by resource; it is not compared with CPU "
       "time. Memory is that of the run's own process. Harness: sampling, measuring and starting the process, as a "
       "fraction of the wall time.",
       {"method", "level", "spacing [mm]", "step [µs]", "end [s]", "particles", "boundary particles", "steps completed",
        "CPU [s]", "runs", "wall [s]", "harness [%]", "memory [MB]", "ns per particle-step", "million particle-steps/s",
        "outcome"}},
      records, &vnv::Record::runs, cost_row);
}

}  // namespace touchstone::reports

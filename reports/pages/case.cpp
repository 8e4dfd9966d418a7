#include "reports/pages/pages.hpp"

#include "reports/compare/orders.hpp"
#include "reports/pages/verdicts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace touchstone::reports {
namespace {

Data table_data(const vnv::Table& table) {
  std::vector<std::vector<std::string>> rows;
  std::vector<const char*> kinds(table.columns.size(), "");  // words among numbers are aligned as these
  for (const auto& cells : table.rows) {
    std::vector<std::string> row;
    for (std::size_t c = 0; c < kinds.size(); ++c) {
      const double* value = std::get_if<double>(&cells[c]);
      row.push_back(value ? printed(*value) : std::get<std::string>(cells[c]));
      if (value) kinds[c] = "number";
    }
    const bool is_known = std::ranges::find(rows, row) != rows.end();
    if (!is_known) rows.push_back(std::move(row));  // methods of a case may each bring the same reference values
  }
  const auto cells = [&](const std::vector<std::string>& texts) {
    List all;
    for (std::size_t c = 0; c < kinds.size(); ++c)
      all.push_back(object("text"_ = texts[c], "kind"_ = if_any(kinds[c])));
    return all;
  };
  const auto row = [&](const std::vector<std::string>& texts) { return object("cells"_ = cells(texts)); };
  return object("title"_ = table.title, "caption"_ = table.caption, "head"_ = cells(table.columns),
                "items"_ = each(rows, row));
}

// One column per quantity and time, one row per run.
using Column = std::pair<std::string, std::string>;

/// The time is empty for what belongs to a whole run.
Column column_of(const vnv::Value& error) {
  return {error.quantity.heading(), std::isnan(error.time) ? "" : valued(error.time, "s")};
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

/// A row of each level of a method; blank where something was not measured.
void add_errors(List& rows, const vnv::Record& record, const std::vector<Column>& columns) {
  std::vector<const vnv::Value*> levels;  // the first of each
  std::map<std::pair<std::string, Column>, std::string> cells;
  for (const auto& error : record.values) {
    if (std::ranges::none_of(levels, [&](const auto* e) { return e->level == error.level; })) levels.push_back(&error);
    cells[{error.level, column_of(error)}] = printed(error.value);
  }
  for (const vnv::Value* first : levels)
    rows.push_back(object("method"_ = record.method, "level"_ = level(first->level), "spacing"_ = first->spacing * 1e3,
                          "cells"_ = each(columns, [&](const Column& c) {
                            return cells[{first->level, c}];
                          })));
}

List pairwise(const vnv::ObservedOrder& order) {
  List all;
  for (std::size_t i = 0; i < order.pairwise.size(); ++i) {
    const bool is_named = i + 1 < order.levels.size();
    all.push_back(
        object("separator"_ = i == 0 ? "" : ", ", "order"_ = printed(order.pairwise[i]),
               "levels"_ = if_any(is_named ? fmt::format("{}–{}", order.levels[i], order.levels[i + 1]) : "")));
  }
  return all;
}

Data order_data(const vnv::Record& record, const vnv::ObservedOrder& order) {
  const Data floor = object("value"_ = order.floor, "half_width"_ = order.floor_half_width,
                            "order"_ = order.order_to_floor, "order_half_width"_ = order.order_to_floor_half_width);
  return object("method"_ = record.method, "ladder"_ = order.ladder, "quantity"_ = order.quantity, "time"_ = order.time,
                "order"_ = order.order, "half_width"_ = order.half_width, "grows"_ = order.order < 0,
                "kind"_ = word(order.trend), "trend"_ = sign_and_word(order.trend), "asymptotic"_ = order.asymptotic,
                "floor"_ = when(!std::isnan(order.floor), floor), "pairwise"_ = pairwise(order));
}

Data run_data(const vnv::Record& record, const vnv::RunSummary& run) {
  const vnv::Cost& c = run.cost;
  const auto of_steps = [&](double value) {
    return if_any(c.steps > 0 ? value : vnv::not_a_number);
  };  // of which another code says nothing
  const bool is_cpu_time = c.resource == vnv::Resource::cpu;
  return object(
      "method"_ = record.method, "level"_ = level(run.level), "spacing"_ = run.spacing * 1e3,
      "step"_ = of_steps(run.time_step * 1e6), "end"_ = run.end_time, "particles"_ = c.particles,
      "boundary_particles"_ = of_steps(static_cast<double>(c.boundary_particles)),
      "steps"_ = of_steps(static_cast<double>(c.steps)),
      "time"_ = is_cpu_time ? printed(c.cpu) : valued(c.occupied, word(c.resource) + "\u202fs"),
      "span"_ = when(is_cpu_time && c.repeats != 1, object("lowest"_ = c.cpu_lowest, "highest"_ = c.cpu_highest)),
      "runs"_ = c.repeats, "wall"_ = c.wall, "harness"_ = if_any(100 * c.harness_share()),
      "memory"_ = c.peak_memory / 1e6, "per_particle_step"_ = of_steps(c.per_particle_step() * 1e9),
      "particle_steps"_ = of_steps(c.particle_steps_per_second() / 1e6), "outcome"_ = run.outcome,
      "fails"_ = fails_at(record, run.level) && !run.finished);
}

/// The tables that the records bring themselves, such as the paper's numbers beside ours.
Data tables_data(const CaseRecords& records) {
  std::vector<vnv::Table> tables = tables_of(records);
  std::erase_if(tables, [](const vnv::Table& table) { return table.rows.empty(); });
  return if_any(each(tables, table_data));
}

/// One row per run, one column per norm and time.
Data errors_data(const CaseRecords& records) {
  const auto columns = error_columns(records);
  const auto heading = [](const Column& c) { return object("quantity"_ = c.first, "time"_ = c.second); };
  List rows;
  for (const auto& record : records.records) add_errors(rows, record, columns);
  return when(!columns.empty(), object("columns"_ = each(columns, heading), "items"_ = rows));
}

/// Runs that did not finish: those on which a claim fails, in the colour of that, or those made to see whether they
/// diverge.
List unfinished(const CaseRecords& records, bool failing) {
  List runs;
  for_each(records, &vnv::Record::runs, [&](const auto& record, const auto& run) {
    if (!run.finished && fails_at(record, run.level) == failing)
      runs.push_back(object("method"_ = record.method, "level"_ = run.level, "outcome"_ = run.outcome));
  });
  return runs;
}

Data figure_data(const Plots::value_type& drawn) {
  const auto& [figure, plot] = drawn;
  return object("id"_ = figure.id, "title"_ = figure.title, "caption"_ = figure.caption, "image"_ = plot.image,
                "width"_ = plot.width, "height"_ = plot.height, "covered"_ = plot.covered > 0,
                "undrawn"_ = when(plot.undrawn > 0, counted(plot.undrawn, "point")));
}

/// Titles of declared figures without data. A suite may not run as far as a figure, and another code is judged at the
/// times that its user asks for: no fault, unless something fails.
List missing(const Plots& figures, const CaseRecords& records) {
  List titles;
  for (const auto& declared : each_once(records, &vnv::Record::figures))
    if (std::ranges::none_of(figures, [&](const auto& drawn) { return drawn.first.id == declared.id; }))
      titles.push_back(declared.title);
  return titles;
}

Data method_data(const vnv::Record& record) {
  return object("method"_ = record.method, "description"_ = record.method_description);
}

/// Whether the page of orders shows this flow.
bool is_in_matrix(const CaseRecords& records) {
  return principal_comparison(records, Field::velocity) || principal_comparison(records, Field::pressure);
}

}  // namespace

std::string case_page(const CaseRecords& records, const Plots& figures, const Plots& order_plots) {
  const auto verdicts = verdicts_of(records);
  const Tally sum = tally(verdicts);
  const List declared = unfinished(records, false), undrawn = missing(figures, records);
  const Data claims = claims_data(records), diagnoses = diagnoses_data(records),
             orders = rows_of(records, &vnv::Record::orders, order_data);
  List lists;
  for (const vnv::Outcome outcome : {vnv::Outcome::fails, vnv::Outcome::inconclusive})
    if (const List items = sentences(outcome, verdicts); !items.empty())
      lists.push_back(object("kind"_ = word(outcome), "items"_ = items));
  return page("case",
              object("root"_ = "../", "name"_ = records.name, "title"_ = records.title(), "kind"_ = word(sum.worst()),
                     "sentence"_ = sentence(sum), "is_judged"_ = sum.total() > 0, "fails"_ = sum.fails > 0,
                     "sentences"_ = lists, "failed_runs"_ = if_any(unfinished(records, true)),
                     "declared_runs"_ = if_any(declared), "many"_ = when(declared.size() > 10, declared.size()),
                     "description"_ = records.records.front().description,
                     "has_figures"_ = !figures.empty() || !undrawn.empty(), "figures"_ = each(figures, figure_data),
                     "missing_figures"_ = undrawn, "tables"_ = tables_data(records),
                     "has_claims"_ = !claims.is_false() || !diagnoses.is_false(), "claims"_ = claims,
                     "diagnoses"_ = diagnoses, "errors"_ = errors_data(records),
                     "has_orders"_ = !order_plots.empty() || is_in_matrix(records) || !orders.is_false(),
                     "order_plots"_ = each(order_plots, figure_data), "is_in_matrix"_ = is_in_matrix(records),
                     "orders"_ = orders, "cost"_ = rows_of(records, &vnv::Record::runs, run_data),
                     "methods"_ = each(records.records, method_data)));
}

}  // namespace touchstone::reports

#include "vnv/command/order_table.hpp"

#include "vnv/files/tables.hpp"
#include "vnv/files/whole_file.hpp"
#include "vnv/record/quantity.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string_view>

namespace touchstone::vnv::command {
namespace {

using Words = std::vector<std::string>;

enum class ToldBy { spacing, across, all };

constexpr std::string_view whitespace = " \t\r";

std::string_view stripped(std::string_view text) {
  const std::size_t first = text.find_first_not_of(whitespace);
  return first == text.npos ? "" : text.substr(first, text.find_last_not_of(whitespace) - first + 1);
}

/// Also 1.5D-03, as Fortran writes it, and 1,5 where commas do not separate cells.
std::optional<double> number_in(std::string_view cell, char separator) {
  std::string digits(cell.substr(cell.starts_with('+') ? 1 : 0));
  for (char& c : digits) c = c == 'D' || c == 'd' ? 'e' : c == ',' && separator != ',' ? '.' : c;
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return error == std::errc{} && end == digits.data() + digits.size() ? std::optional(value) : std::nullopt;
}

/// What separates the cells of a line: the first of these that is in it, else blanks.
char separator_in(std::string_view line) {
  for (const char separator : {'|', '&', ';', '\t', ','})
    if (line.find(separator) != line.npos) return separator;
  return ' ';
}

/// Where blanks separate, so many of them do at least.
Words cells_in(std::string_view line, char separator, std::size_t blanks = 1) {
  line = stripped(line);
  if (line.ends_with("\\\\")) line = stripped(line.substr(0, line.size() - 2));  // of LaTeX
  if (separator == '|' && line.starts_with('|')) {                               // of Markdown
    line.remove_prefix(1);
    if (line.ends_with('|')) line.remove_suffix(1);
  }
  const std::string parting(separator == ' ' ? blanks : 1, separator);
  Words cells;
  for (;;) {
    const std::size_t end = line.find(parting);
    std::string_view cell = stripped(line.substr(0, end));
    if (cell.size() > 1 && cell.starts_with('"') && cell.ends_with('"')) cell = cell.substr(1, cell.size() - 2);
    cells.emplace_back(cell);
    if (end == line.npos) return cells;
    line.remove_prefix(end + parting.size());
    if (separator == ' ') line = stripped(line);
  }
}

/// Small letters and digits of a heading, without its unit, what it is divided by and "delta" of any alphabet: "dx"
/// of "Δx [m]", "h" of "$h/H$".
std::string plain_name(std::string_view heading) {
  if (heading.starts_with("1/")) return "1/" + plain_name(heading.substr(2));
  heading = heading.substr(0, heading.find_first_of("[(/"));
  std::string name;
  for (std::size_t k = 0; k < heading.size(); ++k) {
    if (heading.substr(k).starts_with("Δ") || heading.substr(k).starts_with("δ") || heading.substr(k).starts_with("∆"))
      name += 'd';
    const auto c = static_cast<unsigned char>(heading[k]);
    if (std::isalnum(c)) name += static_cast<char>(std::tolower(c));
  }
  if (name.starts_with("delta") && name.size() == 6) name = "d" + name.substr(5);
  if (name.starts_with("numberof")) name = "n" + name.substr(8);
  return name;
}

constexpr std::array spacing_names{"h",
                                   "hmax",
                                   "hmin",
                                   "dx",
                                   "dy",
                                   "dz",
                                   "dr",
                                   "ds",
                                   "dp",
                                   "dp0",
                                   "dx0",
                                   "delta",
                                   "spacing",
                                   "gridspacing",
                                   "meshsize",
                                   "meshwidth",
                                   "cellsize",
                                   "cellwidth",
                                   "particlespacing",
                                   "initialspacing",
                                   "particledistance",
                                   "1/n",
                                   "1/nx"};
constexpr std::array across_names{
    "n",   "nx",  "ny", "nz", "cells", "ncells", "ncell", "across", "cellsacross", "particlesacross", "cellsperside",
    "1/h", "1/dx"};
constexpr std::array all_names{"particles", "nparticles", "nparticle", "npart", "np",       "nptot",    "ntotal",
                               "dofs",      "dof",        "ndofs",     "ndof",  "unknowns", "nunknowns"};
constexpr std::array step_names{"dt", "timestep", "tau"};
constexpr std::array order_words{"order", "orders", "eoc", "rate", "rates", "roc", "ooc", "slope", "convergence"};
constexpr std::array other_words{"time",  "cpu",    "wall",       "runtime", "walltime", "seconds", "t",
                                 "steps", "step",   "iterations", "iter",    "memory",   "cfl",     "cycle",
                                 "level", "levels", "lvl",        "id",      "index",    "run"};

bool is_in(const auto& names, std::string_view name) { return std::ranges::find(names, name) != names.end(); }

/// What is no error by its heading: orders that somebody has observed already, costs, counts of steps. Of headings that
/// speak of an error, too, those of its order: "order of the error", "L2 error rate".
bool is_aside(std::string_view heading) {
  std::string small;
  for (const char c : heading) {
    const auto byte = static_cast<unsigned char>(c);
    small += static_cast<char>(std::isalnum(byte) ? std::tolower(byte) : ' ');
  }
  const Words words = cells_in(small, ' ');
  const auto is_of_order = [](const std::string& word) { return is_in(order_words, word); };
  if (small.find("err") != small.npos || small.find("norm") != small.npos)
    return is_of_order(words.front()) || is_of_order(words.back());
  return std::ranges::any_of(words,
                             [&](const std::string& word) { return is_of_order(word) || is_in(other_words, word); });
}

[[noreturn]] void refuse(const std::string& where, const std::string& why) {
  throw std::invalid_argument(printable(fmt::format("{}: {}", where, why)));
}

/// The names in a heading of so many columns, or of some more that a row leaves out as they are no errors; none where
/// the line is no heading.
Words names_in(std::string_view heading, char separator_of_rows, std::size_t count) {
  if (heading.empty()) return {};
  const char separator = separator_in(heading);
  for (const Words& names : {cells_in(heading, separator), cells_in(heading, separator_of_rows),
                             cells_in(heading, ' ', 2)}) {  // "h   L2 error": a blank may be part of a name
    const auto aside = static_cast<std::size_t>(std::ranges::count_if(names, is_aside));
    if (names.size() == count || names.size() == count + aside) return names;
  }
  return {};
}

/// Rows of numbers, a line each: the cells that hold none are NaN.
std::vector<TableColumn> columns_of(const std::filesystem::path& file) {
  const std::string text = files::read_whole(file);
  std::string heading;
  std::vector<TableColumn> columns;
  std::vector<std::size_t> skipped;  // by rows that leave out orders, which the coarsest has none of
  long at = 0;
  for (std::size_t begin = 0; begin < text.size(); ++at) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view line = stripped(std::string_view(text).substr(begin, end - begin));
    begin = end + 1;
    const bool is_comment = line.starts_with('#') || line.starts_with('%');
    if (is_comment) line = stripped(line.substr(std::min(line.find_first_not_of("#%"), line.size())));
    if (line.find_first_not_of("-+=|:_& \t\\") == line.npos) continue;  // empty, or a rule below a heading
    const char separator = separator_in(line);
    const Words cells = cells_in(line, separator);
    const auto numbers =
        std::ranges::count_if(cells, [&](const std::string& cell) { return number_in(cell, separator).has_value(); });
    if (is_comment || numbers < 2) {
      if (columns.empty())
        heading = std::string(line);
      else if (!is_comment)
        refuse(fmt::format("{}:{}", file.string(), at + 1),
               fmt::format("'{}', expected a row of numbers", line.substr(0, 40)));
      continue;
    }
    if (columns.empty()) {
      const Words names = names_in(heading, separator, cells.size());
      for (std::size_t k = 0; k < std::max(names.size(), cells.size()); ++k)
        columns.push_back({names.empty() ? fmt::format("column {}", k + 1) : printable(names[k]), {}});
      for (std::size_t k = 0; k < columns.size(); ++k)
        if (is_aside(columns[k].name)) skipped.push_back(k);
    }
    const bool leaves_out = cells.size() + skipped.size() == columns.size();
    if (cells.size() != columns.size() && !leaves_out)
      refuse(fmt::format("{}:{}", file.string(), at + 1),
             fmt::format("{} cells, expected {} as in the heading or the first row", cells.size(), columns.size()));
    for (std::size_t k = 0, cell = 0; k < columns.size(); ++k) {
      const bool is_left_out = leaves_out && std::ranges::find(skipped, k) != skipped.end();
      columns[k].values.push_back(is_left_out ? not_a_number
                                              : number_in(cells[cell++], separator).value_or(not_a_number));
    }
  }
  if (columns.empty()) refuse(file.string(), "no row of numbers, expected a table of resolutions and errors, as text");
  return columns;
}

/// The same spacing of every row, but for a factor, within rounding of the numbers as they are printed.
bool are_proportional(const std::vector<double>& a, const std::vector<double>& b) {
  for (std::size_t k = 0; k < a.size(); ++k)
    if (!(std::abs(a[k] * b[0] / (b[k] * a[0]) - 1) < 0.02)) return false;
  return true;
}

std::optional<ToldBy> told_by(const std::string& heading) {
  const std::string name = plain_name(heading);
  if (is_in(spacing_names, name) || is_in(step_names, name)) return ToldBy::spacing;
  if (is_in(across_names, name)) return ToldBy::across;
  if (is_in(all_names, name)) return ToldBy::all;
  return std::nullopt;
}

std::vector<double> spacings_of(const TableColumn& column, ToldBy kind, int dimension) {
  std::vector<double> spacings = column.values;
  if (kind != ToldBy::spacing)
    for (double& value : spacings) value = std::pow(value, kind == ToldBy::across ? -1.0 : -1.0 / dimension);
  return spacings;
}

/// Which column tells the resolution: the one that is said; else a spacing, cells along a side or a count of all, as
/// headings name them. Where several do, all have to say the same.
struct Found {
  const TableColumn* column;
  ToldBy kind;
};

constexpr std::string_view what_to_say =
    "say --resolution NAME, the column, with --told-by spacing, across (cells along a side) or all (with --dimension)";

Found resolution_in(const std::vector<TableColumn>& columns, const SaidOfTable& said, const std::string& file) {
  Words names;
  for (const TableColumn& column : columns) names.push_back(column.name);
  if (!said.resolution.empty() || !said.told_by.empty()) {
    const auto at =
        said.resolution.empty() ? columns.begin() : std::ranges::find(columns, said.resolution, &TableColumn::name);
    if (at == columns.end())
      refuse(file, fmt::format("no column '{}', expected one of: {}", said.resolution, fmt::join(names, ", ")));
    const auto way = std::ranges::find(ways_to_tell, said.told_by) - ways_to_tell.begin();
    const std::optional<ToldBy> kind = said.told_by.empty() ? told_by(at->name) : static_cast<ToldBy>(way);
    if (!kind) refuse(file, fmt::format("column '{}' is a spacing or a count of what?: {}", at->name, what_to_say));
    return {&*at, *kind};
  }
  std::vector<Found> found;
  for (const TableColumn& column : columns)
    if (const auto kind = told_by(column.name); kind && !is_in(step_names, plain_name(column.name)))
      found.push_back({&column, *kind});
  if (found.empty())  // in time
    for (const TableColumn& column : columns)
      if (is_in(step_names, plain_name(column.name))) found.push_back({&column, ToldBy::spacing});
  if (found.empty())
    refuse(file, fmt::format("which of its columns, {}, tells the resolution, and is it a spacing or a count?: {}",
                             fmt::join(names, ", "), what_to_say));
  std::ranges::stable_sort(found, {}, &Found::kind);
  const int dimension = said.dimension.value_or(2);
  const std::vector<double> first = spacings_of(*found[0].column, found[0].kind, dimension);
  for (const auto& [column, kind] : found)
    if (!are_proportional(spacings_of(*column, kind, dimension), first))
      refuse(file, fmt::format("columns {} and {} tell different resolutions: {}", found[0].column->name, column->name,
                               what_to_say));
  return found[0];
}

std::string in_words(const Found& found, int dimension) {
  switch (found.kind) {
    case ToldBy::spacing:
      return found.column->name;
    case ToldBy::across:
      return fmt::format("1/{}", found.column->name);
    case ToldBy::all:
      break;
  }
  return fmt::format("{}^(-1/{}), as they fill {} dimensions", found.column->name, dimension, dimension);
}

}  // namespace

OrderTable order_table(const std::filesystem::path& file, const SaidOfTable& said) {
  std::vector<TableColumn> columns = columns_of(file);
  const Found found = resolution_in(columns, said, file.string());
  const int dimension = said.dimension.value_or(2);
  OrderTable table{.spacings = spacings_of(*found.column, found.kind, dimension),
                   .resolution = in_words(found, dimension)};
  const std::vector<double>& given = found.column->values;
  for (std::size_t k = 0; k < given.size(); ++k) {
    if (!(given[k] > 0 && std::isfinite(given[k])))
      refuse(file.string(),
             fmt::format("row {}: {} = {:g}, expected a positive number", k + 1, found.column->name, given[k]));
    if (const auto same = std::ranges::find(given, given[k]); same != given.begin() + static_cast<long>(k))
      refuse(file.string(), fmt::format("rows {} and {}: {} = {:g} twice, expected each resolution once",
                                        same - given.begin() + 1, k + 1, found.column->name, given[k]));
  }
  for (TableColumn& column : columns) {
    if (&column == found.column) continue;
    const bool is_none = std::ranges::all_of(column.values, [](double value) { return std::isnan(value); });
    if (is_none || is_aside(column.name) || told_by(column.name))
      table.left_alone.push_back(column.name);
    else
      table.columns.push_back(std::move(column));
  }
  if (table.columns.empty())
    refuse(file.string(),
           fmt::format(
               "no column of errors or values beside {}{}", found.column->name,
               table.left_alone.empty() ? "" : fmt::format("; left alone: {}", fmt::join(table.left_alone, ", "))));
  return table;
}

}  // namespace touchstone::vnv::command

#include "vnv/command/order_table.hpp"

#include "vnv/doors/read/parts/numbers.hpp"
#include "vnv/files/tables.hpp"
#include "vnv/files/whole_file.hpp"
#include "vnv/record/quantity.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <regex>
#include <span>
#include <stdexcept>
#include <string_view>

namespace touchstone::vnv::command {
namespace {

using Words = std::vector<std::string>;

enum class ToldBy { spacing, across, all };

/// Also 1.5D-03, as Fortran writes it, and 1,5 where commas do not separate cells.
std::optional<double> number_in(std::string_view cell, char separator) {
  std::string digits(cell);
  for (char& c : digits) c = c == 'D' || c == 'd' ? 'e' : c == ',' && separator != ',' ? '.' : c;
  return doors::number_in(digits);
}

char separator_in(std::string_view line) { return doors::separator_of(line, "|&;\t,"); }

/// Where blanks separate, so many of them do at least.
Words cells_in(std::string_view line, char separator, std::size_t blanks = 1) {
  line = doors::trimmed(line);
  if (line.ends_with("\\\\")) line = doors::trimmed(line.substr(0, line.size() - 2));  // of LaTeX
  if (separator == '|' && line.starts_with('|')) {                                     // of Markdown
    line.remove_prefix(1);
    if (line.ends_with('|')) line.remove_suffix(1);
  }
  const std::string parting(separator == ' ' ? blanks : 1, separator);
  Words cells;
  for (;;) {
    const std::size_t end = doors::end_of_cell(line, parting);
    cells.emplace_back(doors::unquoted(doors::trimmed(line.substr(0, end))));
    if (end == line.npos) return cells;
    line.remove_prefix(end + parting.size());
    if (separator == ' ') line = doors::trimmed(line);
  }
}

/// Small letters and digits of a heading, without its unit, what it is divided by and "delta" of any alphabet: "dx"
/// of "Δx [m]", "h" of "$h/H$".
std::string plain_name(std::string_view heading) {
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

constexpr std::array across_names{
    "n", "nx", "ny", "nz", "cells", "ncells", "ncell", "across", "cellsacross", "particlesacross", "cellsperside"};
constexpr std::array either_names{"n", "cells", "ncells", "ncell"};  // across, if nothing says that they are all
constexpr double most_across = 1e4;                                  // of these without being asked
constexpr std::array all_names{"particles", "nparticles", "nparticle", "npart",      "np",         "nptot",
                               "ntotal",    "dofs",       "dof",       "ndofs",      "ndof",       "unknowns",
                               "nunknowns", "elements",   "nelements", "totalcells", "cellstotal", "vertices",
                               "nvertices", "nodes",      "nnodes"};
constexpr std::array step_names{"dt", "timestep", "tau"};
constexpr std::array order_words{"order",       "orders", "eoc",    "rate", "rates", "roc",   "ooc", "slope",
                                 "convergence", "ratio",  "ratios", "log",  "log2",  "log10", "ln"};
constexpr std::array other_words{
    "time",       "cpu",     "wall",      "runtime",    "walltime", "elapsed", "seconds", "t",     "steps",
    "step",       "nsteps",  "timesteps", "iterations", "iter",     "memory",  "cfl",     "cycle", "level",
    "levels",     "lvl",     "id",        "index",      "run",      "date",    "seed",    "cost",  "speedup",
    "efficiency", "threads", "nthreads",  "nproc",      "nprocs",   "procs",   "cores",   "ranks", "c0"};
constexpr std::array time_names{"t", "time", "times"};
constexpr std::array work_words{"solve", "solver", "compute", "computing", "computation", "computational", "execution"};
constexpr std::array norm_words{"l1", "l2", "linf", "lmax", "inf", "infty", "h1", "rms", "rmse"};
constexpr std::array field_words{"e", "u", "velocity", "pressure"};

/// "h", "dx" and "cellsize".
bool is_spacing(const std::string& name) {
  static const std::regex names{
      "h(max|min)?|d[xyzrsp]|d[px]0|delta|(grid|mesh|cell|element)size|(mesh|cell)width|"
      "(grid|initial|(inter)?particle)?spacing|(inter)?particledistance"};
  return std::regex_match(name, names);
}

bool is_in(const auto& names, std::string_view name) { return std::ranges::find(names, name) != names.end(); }

/// A heading without what only says where or when: "L2 at " of "L2 at t=0.5".
std::string without_settings(const std::string& heading) {
  static const std::regex setting(R"([A-Za-z]\w*\s*=\s*[-+]?[0-9.]+([eE][-+]?[0-9]+)?)");
  return std::regex_replace(heading, setting, " ");
}

/// The words of a heading, in small letters.
Words words_of(std::string_view heading) {
  std::string small;
  for (const char c : heading) {
    const auto byte = static_cast<unsigned char>(c);
    small += static_cast<char>(std::isalnum(byte) ? std::tolower(byte) : ' ');
  }
  return cells_in(small, ' ');
}

bool names_error(const Words& words) {
  return std::ranges::any_of(
      words, [](const std::string& word) { return word.find("err") != word.npos || word.find("norm") != word.npos; });
}

bool has_capital(std::string_view text) {
  return std::ranges::any_of(text, [](unsigned char c) { return std::isupper(c) != 0; });
}

/// L2 of "L2_T" and of "$L_2$ t", e of "e_T", which is no energy E.
bool names_norm(std::string_view heading) {
  const Words words = words_of(heading);
  const auto is_split = [](const std::string& a, const std::string& b) { return a == "l" && (b == "1" || b == "2"); };
  return heading.find("∞") != heading.npos || heading == "e" || heading.starts_with("e_") ||
         std::ranges::adjacent_find(words, is_split) != words.end() ||
         std::ranges::any_of(words, [](const std::string& word) { return is_in(norm_words, word); });
}

/// Such a column that does not change is an error that does not converge: any other, as the speed U, a parameter.
bool may_be_error(std::string_view heading) {
  const Words words = words_of(heading);
  return names_error(words) || names_norm(heading) || std::ranges::any_of(words, [&](const std::string& word) {
           return is_in(field_words, word) && !(word.size() == 1 && has_capital(heading));
         });
}

/// "H" and "dx" of "H/dx [-]".
struct Quotient {
  std::string_view over, under;
};

std::optional<Quotient> quotient_in(std::string_view heading) {
  const std::size_t slash = heading.substr(0, heading.find_first_of("[(")).find('/');
  if (slash == heading.npos) return std::nullopt;
  return Quotient{heading.substr(0, slash), heading.substr(slash + 1)};
}

/// One capital letter is a length of the flow: H of "h/H" and of "H/h".
bool names_spacing(std::string_view text) {
  const std::string name = plain_name(text);
  return is_spacing(name) && !(name.size() == 1 && has_capital(text));
}

std::optional<ToldBy> told_by(std::string_view heading) {
  if (const auto quotient = quotient_in(heading)) {
    const auto [over, under] = *quotient;
    const bool is_inverse = plain_name(over) == "1";
    if (is_inverse && told_by(under) == ToldBy::across) return ToldBy::spacing;
    if (names_spacing(under)) {
      const bool is_length = has_capital(over) && !names_spacing(over) && !may_be_error(over);
      return is_inverse || is_length ? std::optional(ToldBy::across) : std::nullopt;  // h/dx of SPH tells nothing
    }
  }
  const std::string name = plain_name(heading);
  if (is_spacing(name) || is_in(step_names, name)) return ToldBy::spacing;
  if (is_in(across_names, name)) return ToldBy::across;
  if (is_in(all_names, name)) return ToldBy::all;
  return std::nullopt;
}

/// "t" and "time [s]", but not a period or temperature T.
bool is_time(std::string_view heading) {
  const std::string name = plain_name(heading);
  return is_in(time_names, name) && !(name.size() == 1 && has_capital(heading.substr(0, heading.find_first_of("[("))));
}

/// Whether the order in a heading is that of a scheme, as in "order 1 scheme".
bool names_scheme(const Words& words) {
  const auto at = std::ranges::find(words, "order");
  return words.end() - at > 2 && at[1].find_first_not_of("0123456789") == std::string::npos;
}

/// What is no error or value by its heading: orders that somebody has observed already, costs, counts of steps, h/dx.
/// Of headings that speak of an error, too, those of its order or logarithm: "order of the error", "L2 error rate".
/// Among values a time is one, as the "reattachment time", unless it stands alone.
bool is_aside(const std::string& heading, bool are_values) {
  const std::string what = without_settings(heading);
  const Words words = words_of(what);
  const auto is_of_order = [&](const std::string& word) { return is_in(order_words, word) && !names_scheme(words); };
  if (words.empty()) return false;
  if (names_error(words)) return is_of_order(words.front()) || is_of_order(words.back());
  if (std::ranges::any_of(words, is_of_order)) return true;
  if (names_norm(what)) return false;
  const auto quotient = quotient_in(what);
  return (quotient && names_spacing(quotient->under) && !may_be_error(what)) || (are_values && is_time(what)) ||
         std::ranges::any_of(words, [&](const std::string& word) {
           return (is_in(other_words, word) && !(are_values && is_in(time_names, word))) || is_in(work_words, word);
         });
}

[[noreturn]] void refuse(const std::string& where, const std::string& why) {
  throw std::invalid_argument(printable(fmt::format("{}: {}", where, why)));
}

/// The names in a heading of so many columns, or of some more that a row leaves out as they are no errors; none where
/// the line is no heading.
Words names_in(std::string_view heading, char separator_of_rows, std::size_t count, bool are_values) {
  if (heading.empty()) return {};
  const char separator = separator_in(heading);
  for (const Words& names : {cells_in(heading, separator), cells_in(heading, separator_of_rows),
                             cells_in(heading, ' ', 2)}) {  // "h   L2 error": a blank may be part of a name
    const auto aside = static_cast<std::size_t>(
        std::ranges::count_if(names, [&](const std::string& name) { return is_aside(name, are_values); }));
    if (names.size() == count || names.size() == count + aside) return names;
  }
  return {};
}

/// Rows of numbers, a line each: the cells that hold none are NaN.
std::vector<TableColumn> columns_of(const std::filesystem::path& file, bool are_values) {
  std::string text = files::read_whole(file);
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);  // byte order mark
  std::string heading;
  std::vector<TableColumn> columns;
  std::vector<std::size_t> skipped;  // by rows that leave out orders, which the coarsest has none of
  long at = 0;
  for (std::size_t begin = 0; begin < text.size(); ++at) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view line = doors::trimmed(std::string_view(text).substr(begin, end - begin));
    begin = end + 1;
    const bool is_comment = line.starts_with('#') || line.starts_with('%');
    if (is_comment) line = doors::trimmed(line.substr(std::min(line.find_first_not_of("#%"), line.size())));
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
      const Words names = names_in(heading, separator, cells.size(), are_values);
      for (std::size_t k = 0; k < std::max(names.size(), cells.size()); ++k)
        columns.push_back({names.empty() ? fmt::format("column {}", k + 1) : printable(names[k]), {}});
      for (std::size_t k = 0; k < columns.size(); ++k)
        if (is_aside(columns[k].name, are_values)) skipped.push_back(k);
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

bool is_constant(const TableColumn& column) {
  return std::ranges::all_of(column.values, [&](double value) { return value == column.values[0]; });
}

/// The same spacing of every row, but for a factor, within rounding of the numbers as they are printed. Counts of all
/// grow a little differently, as dofs at boundaries do not double with the cells.
bool are_proportional(const std::vector<double>& a, const std::vector<double>& b, bool are_counts) {
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double grown = std::log(a[k] / a[0]), allowed = are_counts ? std::max(0.02, 0.3 * std::abs(grown)) : 0.02;
    if (!(std::abs(grown - std::log(b[k] / b[0])) < allowed)) return false;
  }
  return true;
}

std::vector<double> spacings_of(const TableColumn& column, ToldBy kind, int dimension) {
  std::vector<double> spacings = column.values;
  if (kind != ToldBy::spacing)
    for (double& value : spacings) value = std::pow(value, kind == ToldBy::across ? -1.0 : -1.0 / dimension);
  return spacings;
}

struct Found {
  const TableColumn* column;
  ToldBy kind;

  bool may_be_either() const { return kind == ToldBy::across && is_in(either_names, plain_name(column->name)); }
};

/// The columns that tell a resolution by their headings, spacings first: not the height H or one cell along z. Cells
/// are all there are where they grow like it beside a column that leaves no doubt or, without one, where the user says
/// which space they fill.
std::vector<Found> resolutions_in(const std::vector<TableColumn>& columns, const std::optional<int>& said_dimension) {
  const auto is_step = [](const Found& one) { return is_in(step_names, plain_name(one.column->name)); };
  std::vector<Found> found;
  for (const TableColumn& column : columns)
    if (const auto kind = told_by(column.name)) found.push_back({&column, *kind});
  const auto stands = [](const Found& one) { return is_constant(*one.column); };
  if (!std::ranges::all_of(found, stands)) std::erase_if(found, stands);
  if (!std::ranges::all_of(found, is_step)) std::erase_if(found, is_step);
  const int dimension = said_dimension.value_or(2);
  const auto sure = std::ranges::find_if_not(found, &Found::may_be_either);
  const auto growth = [](const std::vector<double>& values) { return std::log(values.back() / values.front()); };
  const double grown = sure == found.end() ? not_a_number : -growth(spacings_of(*sure->column, sure->kind, dimension));
  for (Found& one : found)
    if (one.may_be_either() &&
        (std::isnan(grown) ? said_dimension.has_value() : growth(one.column->values) / grown > (1 + dimension) / 2.0))
      one.kind = ToldBy::all;
  std::ranges::stable_sort(found, {}, &Found::kind);
  return found;
}

constexpr std::string_view what_to_say =
    "say --resolution NAME, the column, with --told-by spacing, across (cells along a side) or all (with --dimension)";

/// Which column tells the resolution: the one that is said; else a spacing, cells along a side or a count of all, as
/// headings name them. Where several do, all have to say the same.
Found resolution_in(const std::vector<TableColumn>& columns, const SaidOfTable& said, const std::string& file) {
  Words names;
  for (const TableColumn& column : columns) names.push_back(column.name);
  std::vector<Found> found = resolutions_in(columns, said.dimension);
  if (!said.resolution.empty() || !said.told_by.empty()) {
    const TableColumn* column = found.empty() ? &columns.front() : found.front().column;
    if (!said.resolution.empty()) {
      const auto at = std::ranges::find(columns, said.resolution, &TableColumn::name);
      if (at == columns.end())
        refuse(file, fmt::format("no column '{}', expected one of: {}", said.resolution, fmt::join(names, ", ")));
      column = &*at;
    }
    if (!said.told_by.empty())
      return {column, static_cast<ToldBy>(std::ranges::find(ways_to_tell, said.told_by) - ways_to_tell.begin())};
    const auto at = std::ranges::find(found, column, &Found::column);
    const auto kind = at == found.end() ? told_by(column->name) : std::optional(at->kind);
    if (!kind) refuse(file, fmt::format("column '{}' is a spacing or a count of what?: {}", column->name, what_to_say));
    found = {{column, *kind}};
  }
  if (found.empty())
    refuse(file, fmt::format("which of its columns, {}, tells the resolution, and is it a spacing or a count?: {}",
                             fmt::join(names, ", "), what_to_say));
  const int dimension = said.dimension.value_or(2);
  const Found& first = found.front();
  const std::vector<double> spacings = spacings_of(*first.column, first.kind, dimension);
  for (const auto& [column, kind] : std::span(found).subspan(1))
    if (!are_proportional(spacings, spacings_of(*column, kind, dimension), kind == ToldBy::all))
      refuse(file, fmt::format("columns {} and {} tell different resolutions: {}", first.column->name, column->name,
                               what_to_say));
  if (const double most = std::ranges::max(first.column->values); first.may_be_either() && most >= most_across)
    refuse(file, fmt::format("{} = {:g}, along a side or of all?: say --told-by across or all (with --dimension)",
                             first.column->name, most));
  return first;
}

std::string in_words(const Found& found, const SaidOfTable& said) {
  const std::string& name = found.column->name;
  const int dimension = said.dimension.value_or(2);
  if (found.kind == ToldBy::all)
    return fmt::format("{}^(-1/{}), as they fill {} dimensions", name, dimension, dimension);
  std::string words = name;
  if (found.kind == ToldBy::across && name.starts_with("1/"))
    words = name.substr(2);
  else if (found.kind == ToldBy::across)
    words = name.find('/') == name.npos ? "1/" + name : fmt::format("1/({})", name);
  if (said.dimension) return words + "; --dimension is of no effect";
  return words + (found.may_be_either() && said.told_by.empty() ? ", along a side; if it counts all, --dimension" : "");
}

/// Whether a column holds what somebody observed already: the orders between the rows of another, as rounded in print,
/// and none of the first. Values that are near an order by chance have a first one, too.
bool holds_orders_of(const TableColumn& errors, const TableColumn& column, const std::vector<double>& spacings) {
  const auto& [name, values] = column;
  if (may_be_error(name) || (!std::isnan(values[0]) && values[0] != 0)) return false;
  for (std::size_t k = 1; k < values.size(); ++k) {
    const double order = std::log(errors.values[k] / errors.values[k - 1]) / std::log(spacings[k] / spacings[k - 1]);
    if (!(std::abs(values[k] - order) < 0.06 * std::abs(order))) return false;
  }
  return true;
}

/// Leaves alone, of the columns that headings take for errors, orders of another one and, beside one that changes,
/// parameters that do not.
void leave_alone_by_values(OrderTable& table) {
  const bool some_change = !std::ranges::all_of(table.columns, is_constant);
  std::vector<TableColumn> kept;
  for (const TableColumn& column : table.columns) {
    const auto errors = std::ranges::find_if(
        table.columns, [&](const TableColumn& other) { return holds_orders_of(other, column, table.spacings); });
    if (errors != table.columns.end())
      table.left_alone.push_back(fmt::format("{} (orders of {})", column.name, errors->name));
    else if (some_change && is_constant(column) && !may_be_error(column.name))
      table.left_alone.push_back(column.name + " (constant)");
    else
      kept.push_back(column);
  }
  table.columns = std::move(kept);
}

}  // namespace

OrderTable order_table(const std::filesystem::path& file, const SaidOfTable& said, bool are_values) {
  std::vector<TableColumn> columns = columns_of(file, are_values);
  const Found found = resolution_in(columns, said, file.string());
  const int dimension = said.dimension.value_or(2);
  OrderTable table{.spacings = spacings_of(*found.column, found.kind, dimension), .resolution = in_words(found, said)};
  const std::vector<double>& given = found.column->values;
  for (std::size_t k = 0; k < given.size(); ++k) {
    if (!(given[k] > 0 && std::isfinite(given[k])))
      refuse(file.string(),
             fmt::format("row {}: {} = {:g}, expected a positive number", k + 1, found.column->name, given[k]));
    if (const auto same = std::ranges::find(given, given[k]); same != given.begin() + static_cast<long>(k))
      refuse(file.string(), fmt::format("rows {} and {}: {} = {:g} twice, expected each resolution once",
                                        same - given.begin() + 1, k + 1, found.column->name, given[k]));
  }
  if (given.size() < 2) refuse(file.string(), "one resolution makes no order, expected two or more");
  for (TableColumn& column : columns) {
    if (&column == found.column) continue;
    const bool is_none = std::ranges::all_of(column.values, [](double value) { return std::isnan(value); });
    if (is_none || is_aside(column.name, are_values) || told_by(column.name))
      table.left_alone.push_back(column.name);
    else
      table.columns.push_back(std::move(column));
  }
  leave_alone_by_values(table);
  if (table.columns.empty())
    refuse(file.string(),
           fmt::format(
               "no column of errors or values beside {}{}", found.column->name,
               table.left_alone.empty() ? "" : fmt::format("; left alone: {}", fmt::join(table.left_alone, ", "))));
  return table;
}

}  // namespace touchstone::vnv::command

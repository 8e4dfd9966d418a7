/// Tables of text: values apart by commas, semicolons, tabs or blanks, a row a particle. The last line before the first
/// row of numbers names the columns, behind a `#` or not; without one they are "column 1" and so on. Empty lines and
/// other lines that begin with `#` or `%` are passed over. A column named "time" or "t" parts the rows into datasets of
/// one time each; they stand in the order of their times.

#include "vnv/doors/read/format.hpp"
#include "vnv/doors/read/parts/columns.hpp"
#include "vnv/doors/read/parts/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace touchstone::vnv::doors::formats {
namespace {

/// The next cell of a line, which is taken from it; names may stand between double quotes.
std::string_view next_cell(std::string_view& line, char separator) {
  if (separator == ' ') line = trimmed(line);
  const std::string_view cell = line.substr(0, end_of_cell(line, {&separator, 1}));
  line.remove_prefix(std::min(cell.size() + 1, line.size()));
  return cell;
}

std::vector<std::string> names_in(std::string_view line, char separator) {
  std::vector<std::string> names;
  for (line = trimmed(line); !line.empty();) {
    const std::string_view cell = unquoted(trimmed(next_cell(line, separator)));
    if (separator == ' ' && (cell.starts_with('[') || cell.starts_with('(')) && !names.empty())
      names.back() += fmt::format(" {}", cell);  // a unit apart from its name
    else
      names.emplace_back(cell);
  }
  return names;
}

struct Time {
  double value;
  std::string unit;  // empty: not said
};

/// In a comment that says nothing else: "time = 20 s", "t [ms]: 20".
std::optional<Time> time_in(std::string_view words) {
  const std::size_t sign = words.find_first_of("=:");
  if (sign == words.npos || !names_time(trimmed(words.substr(0, sign)))) return std::nullopt;
  std::string_view value = trimmed(words.substr(sign + 1));
  std::string unit = unit_in(words.substr(0, sign));
  for (const auto& [name, seconds] : units_of_time)
    if (value.ends_with(" " + name)) unit = name;
  if (value.ends_with(" " + unit)) value = trimmed(value.substr(0, value.size() - unit.size()));
  const std::optional<double> time = number_in(value);
  return time && std::isfinite(*time) ? std::optional(Time{*time, unit}) : std::nullopt;
}

class Table {
 public:
  Table(const std::filesystem::path& file, std::string_view bytes, const Limits& limits)
      : file_(file), bytes_(bytes), limits_(limits) {}

  void add(std::string_view line, long at) {
    const bool is_comment = line.starts_with('#') || line.starts_with('%');
    if (trimmed(line).empty() || (is_comment && !columns_.empty())) return;
    if (columns_.empty()) {
      const std::string_view words =
          is_comment ? line.substr(std::min(line.find_first_not_of("#% \t\r"), line.size())) : line;
      if (words.empty()) return;
      if (const auto time = is_comment ? time_in(words) : std::nullopt) {
        time_ = time->value;
        time_unit_ = time->unit;
        return;
      }
      std::string_view rest = trimmed(words);
      separator_ = separator_of(rest);
      if (is_comment || !number_in(trimmed(next_cell(rest, separator_)))) {
        heading_ = std::string(words);
        return;
      }
      begin(line);
    }
    std::string_view rest = trimmed(line);
    for (Array& column : columns_) {
      const std::string_view cell = next_cell(rest, separator_);
      const std::optional<double> value = number_in(trimmed(cell));
      if (!value)
        refuse(at_line(at), fmt::format("column {}: '{}', expected a number", column.name, cell.substr(0, 40)));
      column.values.push_back(*value);
    }
    if (!trimmed(rest).empty())
      refuse(at_line(at), fmt::format("more cells than columns, expected {}", columns_.size()));
    if (columns_.front().values.size() * columns_.size() * sizeof(double) > limits_.most_bytes)
      refuse(at_line(at), fmt::format("more than {} bytes", limits_.most_bytes));
  }

  std::vector<Dataset> datasets() && {
    if (columns_.empty())
      refuse(file_.string(), fmt::format("no row of numbers, expected a table of text, {}", formats_besides_text()));
    Dataset whole{.source = file_.string(),
                  .format = separator_ == ' ' ? "text" : fmt::format("text, '{}' between cells", separator_),
                  .time = time_,
                  .time_unit = time_unit_,
                  .index = number_of(file_),
                  .arrays = std::move(columns_)};
    return parted_by_time(std::move(whole));
  }

 private:
  std::string at_line(long at) const { return fmt::format("{}:{}", file_.string(), at); }

  /// The columns, by the heading or, without one, by the first row.
  void begin(std::string_view first_row) {
    separator_ = separator_of(trimmed(first_row));
    const std::size_t count = names_in(first_row, separator_).size();
    std::vector<std::string> names = names_in(heading_, separator_of(heading_));
    if (names.size() != count && !heading_.empty()) names = names_in(heading_, separator_);
    if (!heading_.empty() && names.size() != count)
      refuse(file_.string(), fmt::format("{} names of columns, '{}', expected {} as in the first row", names.size(),
                                         heading_.substr(0, 80), count));
    const auto lines = static_cast<std::size_t>(std::count(bytes_.begin(), bytes_.end(), '\n')),
               rows = std::min(lines + 1, bytes_.size() / (2 * count) + 1);
    for (std::size_t k = 0; k < count; ++k)
      reserve_more(
          columns_.emplace_back(Array{.name = names.empty() ? fmt::format("column {}", k + 1) : names[k]}).values,
          rows);
  }

  const std::filesystem::path& file_;
  std::string_view bytes_;
  const Limits& limits_;
  std::string heading_{};
  std::optional<double> time_{};  // in a comment
  std::string time_unit_{};
  char separator_ = ' ';
  std::vector<Array> columns_{};
};

std::vector<Dataset> read_delimited(const std::filesystem::path& file, std::string_view bytes, const Limits& limits) {
  constexpr std::size_t piece = 1 << 22;
  if (bytes.find('\0') != bytes.npos)
    refuse(file.string(), fmt::format("not text, expected text, {}", formats_besides_text()));
  Table table(file, bytes, limits);
  const char* kept = bytes.data();
  for (long at = 1; !bytes.empty(); ++at) {
    table.add(next_line(bytes), at);
    if (const auto read = static_cast<std::size_t>(bytes.data() - kept); read >= piece) {
      forget(kept, read);
      kept = bytes.data();
    }
  }
  return std::move(table).datasets();
}

}  // namespace

Format delimited() {
  return {.words = "a table of text",
          .help = "text tables separated by commas, tabs or semicolons",
          .place = 1000,
          .endings = {".csv", ".tsv", ".txt"},
          .read = read_delimited};
}

}  // namespace touchstone::vnv::doors::formats

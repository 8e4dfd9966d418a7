/// Text dumps of LAMMPS. A dataset of each frame; without a time its index is the time step. Columns that are words,
/// such as elements, have labels; xs and xu are given as x, unscaled, where there is no x.

#include "vnv/doors/read/format.hpp"
#include "vnv/doors/read/parts/columns.hpp"
#include "vnv/doors/read/parts/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace touchstone::vnv::doors::formats {
namespace {

class Dump {
 public:
  static constexpr std::string_view begins = "ITEM: ";
  Dump(const std::filesystem::path& file, std::string_view bytes, const Limits& limits)
      : file_(file), rest_(bytes), limits_(limits), budget_(limits) {}

  std::vector<Dataset> datasets() && {
    std::vector<Dataset> all;
    while (rest_.find_first_not_of(" \t\r\n") != rest_.npos) {
      if (all.size() == limits_.most_datasets)
        refuse_here(fmt::format("expected no more than {} frames", limits_.most_datasets));
      all.push_back(frame());
    }
    return all;
  }

 private:
  struct Side {
    double low = 0, high = 1;
  };

  [[noreturn]] void refuse_here(const std::string& what) const {
    refuse(fmt::format("{}:{}", file_.string(), at_), what);
  }

  std::string_view next_line() {
    if (rest_.empty()) refuse_here("ends within a frame, expected more lines");
    ++at_;
    return doors::next_line(rest_);
  }

  double next_number(std::string_view& line, std::string_view of) {
    std::vector<double> number;
    append_text(line, 1, Type::float64, fmt::format("{}:{}: {:.80}", file_.string(), at_, of), number);
    return number[0];
  }

  Side next_side() {
    std::string_view line = next_line();
    const Side side{next_number(line, "a bound of the box"), next_number(line, "a bound of the box")};
    if (!std::isfinite(side.high - side.low)) refuse_here("a bound of the box that is not finite");
    return side;
  }

  Dataset frame() {
    Dataset frame{.source = file_.filename().string(), .format = "LAMMPS dump"};
    std::size_t count = 0;
    std::array<Side, 3> box;
    for (bool is_read = false; !is_read;) {
      std::string_view line = next_line();
      if (!line.starts_with(begins))
        refuse_here(fmt::format("'{}', expected 'ITEM: ' and what follows", line.substr(0, 40)));
      line.remove_prefix(begins.size());
      if (line.starts_with("ATOMS")) {
        frame.arrays = atoms(line.substr(5), count, box);
        is_read = true;
      } else if (line.starts_with("TIMESTEP")) {
        std::string_view words = next_line();
        frame.index =
            static_cast<long>(whole_number(next_word(words), fmt::format("{}:{}: TIMESTEP", file_.string(), at_)));
      } else if (line.starts_with("NUMBER OF ATOMS")) {
        std::string_view words = next_line();
        count = whole_number(next_word(words), fmt::format("{}:{}: NUMBER OF ATOMS", file_.string(), at_));
      } else if (line.starts_with("TIME")) {
        std::string_view words = next_line();
        frame.time = time_of(next_number(words, "TIME"), Type::float64, fmt::format("{}:{}", file_.string(), at_));
      } else if (line.starts_with("UNITS")) {
        std::string_view words = next_line();
        units_ = fmt::format(", units {:.40}", next_word(words));
      } else if (line.starts_with("BOX BOUNDS")) {
        if (line.find("xy") != line.npos || line.find("abc") != line.npos)
          refuse_here("a box that is tilted, expected one along the axes");
        for (Side& side : box) side = next_side();
      } else {
        refuse_here(fmt::format("item '{}', expected those of a dump of atoms", line.substr(0, 40)));
      }
    }
    frame.format += units_;
    return frame;
  }

  /// Rows under a heading of columns.
  std::vector<Array> atoms(std::string_view heading, std::size_t count, const std::array<Side, 3>& box) {
    std::vector<Array> columns;
    for (std::string_view name = next_word(heading); !name.empty(); name = next_word(heading))
      columns.push_back({.name = std::string(name)});
    budget_.take(count, columns.size(), fmt::format("{}:{}: ATOMS", file_.string(), at_));
    if (count > rest_.size() / (2 * columns.size()) + 1)
      refuse_here(fmt::format("ends within its atoms, expected {}", count));
    for (Array& column : columns) reserve_more(column.values, count);
    for (std::size_t row = 0; row < count; ++row) {
      std::string_view line = next_line();
      for (Array& column : columns) column.values.push_back(cell(line, column, row == 0));
      if (!next_word(line).empty()) refuse_here(fmt::format("more cells than columns, expected {}", columns.size()));
    }
    for (const std::size_t axis : {0, 1, 2}) place_along(axis, box[axis], columns);
    require_equal_rows(columns, file_.string());
    return columns;
  }

  /// A number, or a word in a column that begins with one.
  double cell(std::string_view& line, Array& column, bool is_first) {
    std::string_view rest = line;
    const std::string_view word = next_word(rest);
    const std::optional<double> value = number_in(word);
    const bool is_word = !word.empty() && (is_first ? !value && column.name == "element" : !column.labels.empty());
    if (!value && !is_word) return next_number(line, column.name);  // or says that it is none
    line = rest;
    if (!is_word) return *value;
    const auto known = std::ranges::find(column.labels, word);
    if (known != column.labels.end()) return static_cast<double>(known - column.labels.begin());
    if (column.labels.size() == most_labels)
      refuse_here(fmt::format("expected no more than {} words in column {:.80}", most_labels, column.name));
    column.labels.emplace_back(word);
    return static_cast<double>(column.labels.size() - 1);
  }

  /// Unscaled and unwrapped places as "x" and so on.
  static void place_along(std::size_t axis, const Side& side, std::vector<Array>& columns) {
    const std::string name(1, "xyz"[axis]);
    const auto named = [&](const std::string& end) { return std::ranges::find(columns, name + end, &Array::name); };
    if (named("") != columns.end()) return;
    for (const std::string end : {"u", "su", "s"})
      if (const auto column = named(end); column != columns.end()) {
        column->name = name;
        if (end != "u")
          for (double& value : column->values) value = side.low + value * (side.high - side.low);
        return;
      }
  }

  static constexpr std::size_t most_labels = 1000;
  const std::filesystem::path& file_;
  std::string_view rest_;
  const Limits& limits_;
  Budget budget_;
  long at_ = 0;
  std::string units_{};
};

}  // namespace

Format lammps() {
  return {.words = "a dump of LAMMPS",
          .help = "LAMMPS dumps",
          .place = 40,
          .endings = {".lammpstrj"},
          .begins = Dump::begins,
          .read = [](const std::filesystem::path& file, std::string_view bytes, const Limits& limits) {
            return Dump(file, bytes, limits).datasets();
          }};
}

}  // namespace touchstone::vnv::doors::formats

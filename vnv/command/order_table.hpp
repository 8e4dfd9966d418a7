#pragma once
/// A table of errors or values by resolution, as text of any code: which column tells the resolution, and which are
/// left alone.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace touchstone::vnv::command {

/// How a column may tell the resolution.
inline const std::vector<std::string> ways_to_tell{"spacing", "across", "all"};

/// What the user says of a table; what is not said is known from headings, else asked for.
struct SaidOfTable {
  std::string resolution{};        // name of the column
  std::string told_by{};           // "spacing", "across" (cells or particles along a side), "all" (that there are)
  std::optional<int> dimension{};  // of the space that all cells or particles fill: cells count all of them
};

struct TableColumn {
  std::string name;
  std::vector<double> values;  // NaN where a cell holds no number
};

/// Spacings, in the unit of the table or relative to the side of the domain, a row each, and the columns beside them.
struct OrderTable {
  std::vector<double> spacings;
  std::string resolution;  // how its column was taken, in words: "1/nx"
  std::vector<TableColumn> columns{};
  std::vector<std::string> left_alone{};  // columns that are neither: "Running EOC", "Re (constant)"
};

/// Of text: a line a row, cells separated by semicolons, tabs, bars, ampersands, commas or blanks, with a heading or
/// without, in double quotes or not, comments after # or %. Throws std::invalid_argument, in one line that says where,
/// what and what was expected: no rows of numbers, a resolution that is not known or told twice and differently, one
/// that is not positive, stands there twice or alone, no column beside it. Of values,
/// a T and times that do not stand alone are some.
OrderTable order_table(const std::filesystem::path& file, const SaidOfTable& said = {}, bool are_values = false);

}  // namespace touchstone::vnv::command

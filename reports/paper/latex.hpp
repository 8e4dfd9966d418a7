#pragma once
/// Texts and tables as LaTeX of 2020 or later, in UTF-8, with the packages array, booktabs and longtable.

#include <string>
#include <string_view>
#include <vector>

namespace touchstone::reports {

/// A text in which no letter is a command of LaTeX, with symbols and powers as in print.
std::string latex(std::string_view text);

/// A number with four significant digits, "${1.2\times10^{-7}}$", which no line parts; words for what is not finite.
std::string latex(double value);

/// A table over as many pages as it takes, as wide as the lines of the text. Columns by their headings, each a fraction
/// of that width; what does not fit breaks, at underscores too. Rows stand in groups below a title of their own; a
/// group without one has none. Cells are finished LaTeX.
struct LatexTable {
  struct Column {
    std::string heading;  // all empty: no line of headings
    double width;         // the space beside it included; in all 1
  };
  struct Group {
    std::string title{};
    std::vector<std::vector<std::string>> rows{};
  };
  std::vector<Column> columns;
  std::vector<Group> groups{};
};
std::string to_latex(const LatexTable& table);

}  // namespace touchstone::reports

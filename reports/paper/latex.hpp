#pragma once
/// Texts and tables as LaTeX of 2020 or later, in UTF-8, with the package booktabs.

#include <string>
#include <string_view>
#include <vector>

namespace touchstone::reports {

/// A text in which no letter is a command of LaTeX, with symbols and powers as in print.
std::string latex(std::string_view text);

/// A number with four significant digits, "$1.2\times10^{-7}$"; words for what is not finite.
std::string latex(double value);

/// Columns by their headings, each with its alignment for LaTeX: "l", "r" or "p{4cm}". Cells are finished LaTeX.
struct LatexTable {
  struct Column {
    std::string heading, alignment;
  };
  std::vector<Column> columns;
  std::vector<std::vector<std::string>> rows{};
};
std::string to_latex(const LatexTable& table);

}  // namespace touchstone::reports

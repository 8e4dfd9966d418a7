#pragma once
/// What a paper needs of a judged case.

#include "reports/read/cases.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace touchstone::reports {

/// What was written, and in one line each what could not be.
struct Paper {
  std::vector<std::filesystem::path> files{};
  std::vector<std::string> missing{};
};

/// Writes into a folder, which is made: each figure as ID.pdf with the script and the data that redraw it, ID.gp and
/// ID.csv; verdicts.tex and versions.tex, tables for LaTeX with array, booktabs and longtable; verdicts.csv,
/// values.csv, orders.csv, cost.csv and versions.csv; references.bib. A figure whose id is the name of a table, such as
/// cost, is figure_cost. Figures that gnuplot cannot draw are missing, and no error. Throws std::runtime_error for
/// records of no such case and as `read_cases`, `read_references` and `write_whole` do.
Paper write_paper(const std::filesystem::path& records, const std::string& case_name,
                  const std::filesystem::path& references, const std::filesystem::path& folder);

}  // namespace touchstone::reports

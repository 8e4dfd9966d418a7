#pragma once
/// A column of a table as a function of another one.

#include <filesystem>
#include <functional>
#include <string>

namespace touchstone::vnv::formulas {

/// The natural cubic spline through a CSV file's columns with these headings, of which the first rises from row to row;
/// not a number outside the rows. Its error falls as the fourth power of their distance, but as the second near ends
/// where the second derivative is not 0. Throws BadData for a file that is not so.
std::function<double(double)> spline_of(const std::filesystem::path& file, const std::string& of,
                                        const std::string& value);

}  // namespace touchstone::vnv::formulas

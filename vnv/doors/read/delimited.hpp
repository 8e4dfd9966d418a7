#pragma once
/// Tables of text: values apart by commas, semicolons, tabs or blanks, a row a particle.

#include "vnv/doors/read/dataset.hpp"

#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

namespace touchstone::vnv::doors {

/// The last line before the first row of numbers names the columns, behind a `#` or not; without one they are "column
/// 1" and so on. Empty lines and other lines that begin with `#` or `%` are passed over. A column named "time" or "t"
/// parts the rows into datasets of one time each; they stand in the order of their times. Throws Unreadable.
std::vector<Dataset> read_delimited(const std::filesystem::path& file, std::string_view bytes, const Limits& limits);

/// The same of a text that is given up piece by piece: `done` is called with each piece that is not read again.
std::vector<Dataset> read_delimited(const std::filesystem::path& file, std::string_view bytes, const Limits& limits,
                                    const std::function<void(std::string_view)>& done);

}  // namespace touchstone::vnv::doors

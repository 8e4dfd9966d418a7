#pragma once
/// VTK's older files, "# vtk DataFile Version 1.0" to 5.1, of text or of bytes.

#include <filesystem>
#include <string_view>
#include <vector>

#include "vnv/doors/read/dataset.hpp"

namespace touchstone::vnv::doors {

inline constexpr std::string_view vtk_legacy_begins = "# vtk DataFile Version ";

/// `bytes` are those of the file. Points first, then cells; of structured grids the points. Throws Unreadable.
std::vector<Dataset> read_vtk_legacy(const std::filesystem::path& file, std::string_view bytes, const Limits& limits);

}  // namespace touchstone::vnv::doors

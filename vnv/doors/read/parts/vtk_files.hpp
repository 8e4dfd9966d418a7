#pragma once
/// One of VTK's files, as a series of them names it.

#include "vnv/doors/read/parts/files_beside.hpp"

namespace touchstone::vnv::doors::vtk {

inline constexpr std::string_view legacy_begins = "# vtk DataFile Version ";

/// Points first, then cells. Throw Unreadable.
std::vector<Dataset> read_legacy(const std::filesystem::path& file, std::string_view bytes, const Limits& limits);
std::vector<Dataset> read_xml(const std::filesystem::path& file, std::string_view bytes, const Limits& limits,
                              FilesBeside& files);

}  // namespace touchstone::vnv::doors::vtk

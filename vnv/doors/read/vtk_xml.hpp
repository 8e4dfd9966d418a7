#pragma once
/// VTK's files of XML: particles and meshes (.vtp, .vtu), those in pieces (.pvtp, .pvtu), and trees of them (.vtm).

#include <filesystem>
#include <string_view>
#include <vector>

#include "vnv/doors/read/dataset.hpp"
#include "vnv/doors/read/parts/files_beside.hpp"

namespace touchstone::vnv::doors {

/// `bytes` are those of the file. Points first, then cells. Of a tree that has a dataset "internal", as OpenFOAM's
/// foamToVTK writes, that one only: the others bound it. Throws Unreadable.
std::vector<Dataset> read_vtk_xml(const std::filesystem::path& file, std::string_view bytes, const Limits& limits);
std::vector<Dataset> read_vtk_xml(const std::filesystem::path& file, std::string_view bytes, const Limits& limits,
                                  FilesBeside& files);

}  // namespace touchstone::vnv::doors

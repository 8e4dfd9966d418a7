#pragma once
/// Series of VTK's files with their times: a collection (.pvd) or a list in JSON (.vtk.series, .vtm.series).

#include <filesystem>
#include <string_view>
#include <vector>

#include "vnv/doors/read/dataset.hpp"

namespace touchstone::vnv::doors {

/// Datasets of all files of a series, in the order of their times, which the series gives; without a time there, that
/// of the file stays. `bytes` are those of the series; it names files of its own folder only. Throws Unreadable.
std::vector<Dataset> read_series(const std::filesystem::path& file, std::string_view bytes, const Limits& limits);

}  // namespace touchstone::vnv::doors

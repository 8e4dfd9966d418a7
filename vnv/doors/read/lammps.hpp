#pragma once
/// Text dumps of LAMMPS.

#include <filesystem>
#include <string_view>
#include <vector>

#include "vnv/doors/read/dataset.hpp"

namespace touchstone::vnv::doors {

inline constexpr std::string_view lammps_begins = "ITEM: ";

/// A dataset of each frame; without a time its index is the time step. Columns that are words, such as elements, have
/// labels; xs and xu are given as x, unscaled, where there is no x. Throws Unreadable.
std::vector<Dataset> read_lammps(const std::filesystem::path& file, std::string_view bytes, const Limits& limits);

}  // namespace touchstone::vnv::doors

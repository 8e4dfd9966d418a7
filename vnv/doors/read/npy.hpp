#pragma once
/// Files of NumPy: an array (.npy), and several in a ZIP archive (.npz), among them those that PySPH writes.

#include "vnv/doors/read/dataset.hpp"

#include <filesystem>
#include <string_view>
#include <vector>

namespace touchstone::vnv::doors {

/// Arrays of equal length are one dataset; a single number named "t" or "time" is its time. A dictionary of
/// dictionaries of arrays, as PySPH pickles its particles, is a dataset for each, a part of that name. Throws
/// Unreadable.
std::vector<Dataset> read_npy(const std::filesystem::path& file, std::string_view bytes, const Limits& limits);

}  // namespace touchstone::vnv::doors

#pragma once
/// Arrays of numpy, one a file (.npy) or several (.npz, a zip file of those), and what PySPH writes in one.

#include <filesystem>
#include <string_view>
#include <vector>

#include "vnv/doors/read/dataset.hpp"

namespace touchstone::vnv::doors {

inline constexpr std::string_view npy_begins = "\x93NUMPY", npz_begins = "PK\x03\x04";

/// Columns "column 1" and so on of a table of two dimensions, or one of one. Throws Unreadable.
std::vector<Dataset> read_npy(const std::filesystem::path& file, std::string_view bytes, const Limits& limits);

/// Arrays of equally many rows by their names, those of one number left out, one of which may be the time; "x", "y" and
/// others of one shape of two dimensions are values on a grid, and a single such array is a table as of a .npy. Of
/// PySPH's "particles" and "solver_data" the particle arrays. Nothing is written, whatever the names within say. Throws
/// Unreadable.
std::vector<Dataset> read_npz(const std::filesystem::path& file, std::string_view bytes, const Limits& limits);

}  // namespace touchstone::vnv::doors

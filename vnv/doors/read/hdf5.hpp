#pragma once
/// Datasets of HDF5, by libhdf5.

#include <filesystem>
#include <string_view>
#include <vector>

#include "vnv/doors/read/dataset.hpp"

namespace touchstone::vnv::doors {

inline constexpr std::string_view hdf5_begins = "\x89HDF\r\n\x1a\n";

/// Numbers of equally many rows in the root or in the only group that has some; groups "Step#1" and so on (H5Part), a
/// time each; or the particle arrays of PySPH. A time is an attribute or a dataset of one number, "t" or "time". Texts
/// and records are passed over. Nothing outside the file is read: no links but those to its own objects, no external or
/// virtual datasets; of filters gzip and shuffle. libhdf5 reads in a process of its own, since files that lie may crash
/// it. Throws Unreadable.
std::vector<Dataset> read_hdf5(const std::filesystem::path& file, std::string_view bytes, const Limits& limits);

/// The same without the process.
std::vector<Dataset> read_hdf5_unguarded(const std::filesystem::path& file, std::string_view bytes,
                                         const Limits& limits);

}  // namespace touchstone::vnv::doors

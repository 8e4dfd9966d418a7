#include "vnv/doors/read/delimited.hpp"
#include "vnv/doors/read/hdf5.hpp"
#include "vnv/doors/read/lammps.hpp"
#include "vnv/doors/read/npy.hpp"
#include "vnv/doors/read/parts/gzip.hpp"
#include "vnv/doors/read/parts/numbers.hpp"
#include "vnv/doors/read/series.hpp"
#include "vnv/doors/read/vtk_legacy.hpp"
#include "vnv/doors/read/vtk_xml.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>
#include <system_error>

namespace touchstone::vnv::doors {
namespace {

/// All bytes of a file, which are not filled before they are read.
struct Bytes {
  std::unique_ptr<char[]> held;
  std::size_t size;
};

Bytes bytes_of(const std::filesystem::path& file, const Limits& limits) {
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  if (error) throw Unreadable(fmt::format("{}: {}, expected a file", file.string(), error.message()));
  if (size > limits.most_bytes)
    throw Unreadable(fmt::format("{}: {} bytes, expected at most {}", file.string(), size, limits.most_bytes));
  Bytes bytes{std::make_unique_for_overwrite<char[]>(size), size};
  expect_to_fill(bytes.held.get(), size);
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(bytes.held.get(), static_cast<std::streamsize>(size)))
    throw Unreadable(fmt::format("{}: cannot be read: {}", file.string(), std::strerror(errno)));
  return bytes;
}

/// Of bytes that nobody else reads: those of a table of text are given up as it is read.
std::vector<Dataset> read_bytes(const std::filesystem::path& file, std::string_view bytes, const Limits& limits) {
  const std::string_view head = bytes.substr(0, 2000);
  const bool is_collection = head.find("type=\"Collection\"") != head.npos || file.extension() == ".series";
  if (is_collection) return read_series(file, bytes, limits);
  if (head.starts_with("<?xml") || head.find("<VTKFile") != head.npos) return read_vtk_xml(file, bytes, limits);
  if (bytes.starts_with(npy_begins)) return read_npy(file, bytes, limits);
  if (bytes.starts_with(npz_begins)) return read_npz(file, bytes, limits);
  if (bytes.starts_with(hdf5_begins)) return read_hdf5(file, bytes, limits);
  if (bytes.starts_with(lammps_begins)) return read_lammps(file, bytes, limits);
  if (head.starts_with("# vtk DataFile")) return read_vtk_legacy(file, bytes, limits);
  return read_delimited(file, bytes, limits, [](std::string_view done) { forget(done.data(), done.size()); });
}

}  // namespace

std::vector<Dataset> read_datasets(const std::filesystem::path& file, const Limits& limits) {
  Bytes all = bytes_of(file, limits);
  const std::string_view bytes(all.held.get(), all.size);
  if (!bytes.starts_with(gzip_begins)) return read_bytes(file, bytes, limits);
  const std::string text = gunzipped(file.string(), bytes, limits);
  all.held.reset();
  return read_bytes(file, text, limits);
}

}  // namespace touchstone::vnv::doors

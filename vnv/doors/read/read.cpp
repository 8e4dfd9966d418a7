#include "vnv/doors/read/delimited.hpp"
#include "vnv/doors/read/npy.hpp"
#include "vnv/doors/read/series.hpp"
#include "vnv/doors/read/vtk_legacy.hpp"
#include "vnv/doors/read/vtk_xml.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

namespace touchstone::vnv::doors {
namespace {

std::string bytes_of(const std::filesystem::path& file, const Limits& limits) {
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  if (error) throw Unreadable(fmt::format("{}: {}, expected a file", file.string(), error.message()));
  if (size > limits.most_bytes)
    throw Unreadable(fmt::format("{}: {} bytes, expected at most {}", file.string(), size, limits.most_bytes));
  std::string bytes(size, '\0');
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(size)))
    throw Unreadable(fmt::format("{}: cannot be read: {}", file.string(), std::strerror(errno)));
  return bytes;
}

}  // namespace

std::vector<Dataset> read_datasets(const std::filesystem::path& file, const Limits& limits) {
  const std::string bytes = bytes_of(file, limits);
  const std::string_view head = std::string_view(bytes).substr(0, 2000);
  const bool is_collection = head.find("type=\"Collection\"") != head.npos || file.extension() == ".series";
  if (is_collection) return read_series(file, bytes, limits);
  if (head.starts_with("<?xml") || head.find("<VTKFile") != head.npos) return read_vtk_xml(file, bytes, limits);
  if (head.starts_with("# vtk DataFile")) return read_vtk_legacy(file, bytes, limits);
  if (head.starts_with("PK\x03\x04") || head.starts_with("\x93NUMPY")) return read_npy(file, bytes, limits);
  return read_delimited(file, bytes, limits);
}

}  // namespace touchstone::vnv::doors

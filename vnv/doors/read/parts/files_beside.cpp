#include "vnv/doors/read/parts/files_beside.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "vnv/doors/read/parts/numbers.hpp"

namespace touchstone::vnv::doors {
namespace fs = std::filesystem;

FilesBeside::FilesBeside(const fs::path& first, const Limits& limits) : limits_(limits) {
  std::error_code ignored;
  seen_.insert(fs::weakly_canonical(first, ignored));
}

FilesBeside::Named FilesBeside::read(const fs::path& naming, const std::string& name) {
  const auto refuse = [&](const std::string& expected) {
    doors::refuse(naming.string(), fmt::format("file '{}', expected {}", name.substr(0, 200), expected));
  };
  const fs::path relative = name;
  if (name.empty() || relative.is_absolute() || std::find(relative.begin(), relative.end(), "..") != relative.end() ||
      name.find('\0') != name.npos)
    refuse("a path below the folder of the file that names it");
  std::error_code error;
  const fs::path folder = fs::canonical(naming.has_parent_path() ? naming.parent_path() : ".", error);
  const fs::path file = fs::canonical(folder / relative, error);
  if (error) refuse("a file that is there");
  if (*file.lexically_relative(folder).begin() == "..")
    refuse("a file within the folder, where no link leads out of it");
  const bool is_regular = fs::is_regular_file(file, error);
  const std::size_t size = is_regular ? fs::file_size(file, error) : 0;
  if (!is_regular || error) refuse("a regular file");
  if (size > limits_.most_bytes) refuse(fmt::format("no more than {} bytes", limits_.most_bytes));
  if (!seen_.insert(file).second) refuse("each file once, and none that includes itself");
  Named named{naming.parent_path() / relative, std::string(size, '\0')};
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(named.bytes.data(), static_cast<std::streamsize>(size))) refuse("a file that can be read");
  return named;
}

}  // namespace touchstone::vnv::doors

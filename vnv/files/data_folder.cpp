#include "vnv/files/data_folder.hpp"

namespace touchstone::vnv {
namespace {

/// Programs that are installed lie in folders beside their data; others read those of the sources.
std::filesystem::path own_folder() {
  std::error_code none;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", none);
  const std::filesystem::path beside = program.parent_path().parent_path() / "data";
  return std::filesystem::is_directory(beside, none) ? beside : TOUCHSTONE_DATA_DIR;
}

std::filesystem::path& folder_in_use() {
  static std::filesystem::path folder = own_folder();
  return folder;
}

}  // namespace

const std::filesystem::path& data_folder() { return folder_in_use(); }

void set_data_folder(const std::filesystem::path& folder) { folder_in_use() = folder; }

}  // namespace touchstone::vnv

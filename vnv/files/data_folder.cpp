#include "vnv/files/data_folder.hpp"

namespace touchstone::vnv {
namespace {

std::filesystem::path& folder_in_use() {
  static std::filesystem::path folder = TOUCHSTONE_DATA_DIR;
  return folder;
}

}  // namespace

const std::filesystem::path& data_folder() { return folder_in_use(); }

void set_data_folder(const std::filesystem::path& folder) { folder_in_use() = folder; }

}  // namespace touchstone::vnv

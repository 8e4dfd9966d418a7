#include "vnv/programs/scratch_folder.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace touchstone::programs {

ScratchFolder::ScratchFolder() {
  const std::string to_be_chosen(6, 'X');  // by mkdtemp, which puts letters of its own there
  std::string name = (std::filesystem::temp_directory_path() / ("touchstone." + to_be_chosen)).string();
  if (!mkdtemp(name.data()))
    throw std::runtime_error(fmt::format("{}: cannot be made: {}", name, std::strerror(errno)));
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace touchstone::programs

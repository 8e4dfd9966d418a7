#pragma once
/// Files that a file names: beside it or below, and each only once, so that none includes itself.

#include <filesystem>
#include <set>
#include <string>

#include "vnv/doors/read/dataset.hpp"

namespace touchstone::vnv::doors {

class FilesBeside {
 public:
  FilesBeside(const std::filesystem::path& first, const Limits& limits);

  struct Named {
    std::filesystem::path file;
    std::string bytes;
  };

  /// Throws Unreadable where the name leads out of the folder of the file that names it, to no regular file, to one
  /// that was read before, or to one that is too large.
  Named read(const std::filesystem::path& naming, const std::string& name);

 private:
  Limits limits_;
  std::set<std::filesystem::path> seen_{};
};

}  // namespace touchstone::vnv::doors

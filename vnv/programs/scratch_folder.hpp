#pragma once
/// A folder for a while.

#include "vnv/programs/interruption.hpp"

#include <filesystem>
#include <string>

namespace touchstone::programs {

/// A new folder among those for temporary things; it is gone with this. What tells this program to end waits so long,
/// or until it is heard by who waits for a program.
class ScratchFolder {
 public:
  /// Throws std::runtime_error if there is none to be had.
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  HeldSignals held_;
  std::filesystem::path path_;
};

}  // namespace touchstone::programs

#pragma once
/// A folder that one process at a time changes.

#include <filesystem>

namespace touchstone::files {

/// Waits until no other process holds the folder so, and holds it; whoever reads what is there, changes it and writes
/// it back loses nothing of another who does. Where the file system knows no locks nobody waits.
class HeldFolder {
 public:
  explicit HeldFolder(const std::filesystem::path& folder);
  ~HeldFolder();
  HeldFolder(const HeldFolder&) = delete;
  HeldFolder& operator=(const HeldFolder&) = delete;

 private:
  int opened_;
};

}  // namespace touchstone::files

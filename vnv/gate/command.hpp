#pragma once
/// Other programs, run and waited for.

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace touchstone::gate {

/// What the caller asked for cannot be compared; one line says why.
struct BadInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Runs a program, found as a shell finds it, and returns its exit status; what it prints goes into a file. As with
/// system(3), an interrupt from the keyboard is left to the program. Throws std::runtime_error if the program cannot be
/// started or dies of an interrupt; another signal n is the status 128 + n.
int run_command(const std::vector<std::string>& words, const std::filesystem::path& output);

/// The last lines of a text file, for a message.
std::string last_lines(const std::filesystem::path& file, long lines);

/// A folder of its own among those for temporary things; it is gone with this.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace touchstone::gate

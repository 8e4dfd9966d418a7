#pragma once
/// Programs that are started, and how they ended.

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace touchstone::vnv::command {

using Words = std::vector<std::string>;  // a program and its arguments

struct Ending {
  int status = 0;  // exit status
  int signal = 0;  // that killed it, or 0

  bool well() const { return status == 0 && signal == 0; }
  /// "ended with status 1", "was killed by signal 11 (Segmentation fault)"
  std::string sentence() const;
};

/// Starts a program whose output and errors go to a file. Throws std::runtime_error if there is no such program.
pid_t start(const Words& command, const std::filesystem::path& output);

struct Child {
  pid_t id;
  Ending ending;
};
/// A program that was started and has ended, or nothing if none did.
std::optional<Child> any_ended();

/// Runs a program to its end where this one reads and writes.
Ending run_here(const Words& command);

struct Heard {
  Ending ending;
  std::string output, errors;

  /// The first line of its errors, or how it ended if there is none or it was killed: what to quote of one that failed.
  std::string complaint() const;
};
/// Runs a program to its end and keeps what it says.
Heard run_and_hear(const Words& command);

}  // namespace touchstone::vnv::command

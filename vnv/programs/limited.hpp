#pragma once
/// A program of somebody else's: run within limits, measured with all that it starts, and nothing of it left.

#include "vnv/programs/programs.hpp"

#include <fstream>
#include <optional>
#include <string>

namespace touchstone::programs {

struct ProgramLimits {
  double wall = 600;                                          // s
  double memory = 8e9;                                        // bytes  resident, of the program and all that it started
  double output = 64e6;                                       // bytes  of what it says
  std::chrono::milliseconds grace = std::chrono::seconds(5);  // between being told to end and being killed
};

/// How a program ended, and what it and all that it started took.
struct ProcessResult {
  std::string stopped{};   // "used more than 8 GB of memory": why it was ended; empty where it ended by itself
  Ending ending{};         // where it did
  double cpu = 0;          // s  user time
  double wall = 0;         // s
  double peak_memory = 0;  // bytes

  bool succeeded() const { return stopped.empty() && ending.succeeded(); }
  /// "ended with status 3", "was ended: took longer than 600 s"
  std::string sentence() const;
};

/// Runs a program in a folder to its end or to a limit; it writes into `log`. What it started and left is killed, also
/// where that left its process group. `name` is what it is called where this program is interrupted. It must be the
/// only program that is run at the time. Throws std::runtime_error if it cannot be started.
ProcessResult run_limited(const std::string& name, const Words& words, const std::filesystem::path& folder,
                          const std::filesystem::path& log, const ProgramLimits& limits,
                          const Meanwhile& meanwhile = {});

}  // namespace touchstone::programs

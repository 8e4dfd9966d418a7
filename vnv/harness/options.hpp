#pragma once
#include "vnv/case.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace touchstone::vnv {

/// What the program of a case is asked on its command line.
struct Options {
  std::filesystem::path records{};  // empty: none is written
  Suite suite = Suite::acceptance;
  std::string method{};   // empty: all
  bool explores = false;  // one run at this `spacing`, not judged
  double spacing = 0, cell = not_a_number, time_step = not_a_number, until = 0, every = 0;
  bool accepts = false;
  std::string accept_reason{};
  std::filesystem::path vtp{};      // folder for the particles of each run; empty: none
  std::filesystem::path mutated{};  // records whose verdicts are mutated; empty: none are
  bool mutates_samples = false;     // and those of a run that is made for it
  bool list = false, describes = false;
  std::string ctest_file{};

  /// Reads them; an exit status where nothing is left to do: help was asked for, or an option was wrong and is named.
  std::optional<int> parse(const std::string& case_name, int count, char** arguments);
};

}  // namespace touchstone::vnv

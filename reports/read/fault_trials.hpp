#pragma once
/// Which tests noticed which seeded fault: what vnv/trials/faults/try.py has found.

#include "vnv/record/record.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::reports {

/// A test that was run with a fault in the sources.
struct FaultTest {
  std::string name;  // as ctest has it, "stokes_first.mpm", or "the build"
  bool noticed = false;
  double margin =
      vnv::not_a_number;   // fraction of the limit that is left; -inf for a value that was no number; nan: no limit
  std::string sentence{};  // of the verdict with that margin, or what the test complained of
};

/// What came of a fault, or of a harmless change; the first are those that somebody has to look at.
enum class Conclusion { survived, does_not_compile, false_alarm, noticed_at_night, noticed, stays_green };
constexpr auto words(Conclusion) {
  return std::to_array<std::string_view>(
      {"survived", "does not compile", "false alarm", "noticed at night", "noticed", "stays green"});
}

/// A fault, or a harmless change, that was seeded alone.
struct FaultTrial {
  std::string fault;  // "mpm_viscosity"
  std::string title;  // "The fluid of printed MPM is 5 % too viscous"
  std::string files;  // that were changed
  Conclusion conclusion = Conclusion::noticed;
  std::string why{};                        // no test notices it, as far as is known
  std::string revision{}, date_and_time{};  // when it was tried
  std::vector<FaultTest> tests{};           // at least one

  bool is_harmless() const { return conclusion == Conclusion::false_alarm || conclusion == Conclusion::stays_green; }
  /// Survived, did not compile, or a false alarm.
  bool is_open() const { return conclusion <= Conclusion::false_alarm; }
  /// The test that noticed it by the largest margin, one that has none last; null if none noticed it.
  const FaultTest* clearest() const;
};

struct FaultTrials {
  std::string machine;             // of the last trial
  std::string suite;               // what was run: "the named tests", "acceptance"
  long untried = 0;                // faults and harmless changes that nobody has tried yet
  std::vector<FaultTrial> trials;  // what is open first; of the others what was hardly noticed first
  std::filesystem::path file;      // that they were read from

  /// "97 of 102 seeded faults noticed by day (95.1 %), 100 in all (98.0 %); 0 false alarms from 17 harmless changes; 3
  /// not tried yet."
  std::string sentence() const;
};

/// Reads the lines of try.py, one for each fault and test. Throws vnv::BadData for other columns, a key that is
/// missing, a word or number that is none, or a fault that is described in two ways.
FaultTrials read_fault_trials(const std::filesystem::path& file);

}  // namespace touchstone::reports

#pragma once
/// Accepted claims: how many claims of each author every method made in a suite when that was last accepted. A suite
/// that judges fewer is not green, however much of the rest holds.

#include "vnv/record/acceptance.hpp"
#include "vnv/record/record.hpp"

namespace touchstone::vnv {

/// How many claims a method makes in a suite, by their author.
struct ClaimCount {
  std::string case_name, method, suite;
  long theory = 0, literature = 0, baseline = 0;

  long total() const { return theory + literature + baseline; }
  bool operator==(const ClaimCount&) const = default;
};
/// A claim that stands twice at one place counts once: a value of another level does not make up for one that is gone.
ClaimCount claims_in(const Record& record);

/// How many there are fewer than accepted, author by author; what is more counts for nothing.
long missing_of(const ClaimCount& accepted, const ClaimCount& found);
/// "2 of 30 theory, 1 of 4 baseline", or "all" if nothing was found.
std::string missing_in_words(const ClaimCount& accepted, const ClaimCount& found);

struct AcceptedClaims {
  Acceptance acceptance{};
  std::vector<ClaimCount> rows{};

  /// Those of a method in a suite, or null; it lives as long as this.
  const ClaimCount* find(std::string_view case_name, std::string_view method, std::string_view suite) const;
  /// Takes the place of what was accepted of the same method and suite.
  void set(const ClaimCount& count);
};

/// DATA/claims/CASE.csv: one file per case, as of baselines.
std::filesystem::path claims_file(const std::filesystem::path& data, const std::string& case_name);
/// Nothing if there is no such file. Throws BadData for a file that is not what `write_accepted_claims` writes.
AcceptedClaims read_accepted_claims(const std::filesystem::path& file);
/// Those of all cases; the acceptance is that of none.
AcceptedClaims read_all_accepted_claims(const std::filesystem::path& folder);
/// Writes the file whole or not at all, rows sorted; without rows there is no file.
void write_accepted_claims(const std::filesystem::path& file, AcceptedClaims claims);

}  // namespace touchstone::vnv

#pragma once
/// Failures that are known, each for a while and for a reason; and how a night stands beside them.

#include "reports/read/claims.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace touchstone::reports {

/// A claim that is known to fail. It names all claims on its quantity, whatever their time and author.
struct KnownFailure {
  std::string id;                 // "sph-wall-drift"
  std::string case_name, method;  // as in verdicts.csv
  std::string level;              // empty where the claim belongs to a whole ladder
  std::string quantity;           // with its unit, "L2 v_x [%]"
  std::string since, expires;     // dates, "2026-11-22"; it is known up to the day it expires, inclusive
  std::string reason;

  bool covers(const vnv::Verdict& verdict) const;
  /// `today` is a date, or begins with one.
  bool is_expired(const std::string& today) const { return today.substr(0, 10) > expires; }
};

inline constexpr int longest_known = 90;  // days from `since` to `expires`

/// Reads data/known_failures.csv: keys, a heading, a row per failure. Throws vnv::BadData for other columns, an empty
/// cell but the level, a date that is none, an expiry before `since` or more than 90 days after it, an id that stands
/// twice, or a claim that two rows name.
std::vector<KnownFailure> read_known_failures(const std::filesystem::path& file);

/// A night's failures beside those that are known. What is red: an unknown failure, one whose row has expired, a known
/// one that passes, and claims fewer than accepted.
struct NightStatus {
  std::vector<vnv::Verdict> unknown, known;
  std::vector<KnownFailure> of_known;  // beside each of `known`, its row
  std::vector<KnownFailure> expired;   // rows of what fails, and so is unknown again
  std::vector<KnownFailure> unexpected_passes;
  ClaimsStatus claims{};
  long judged = 0, inconclusive = 0;

  std::size_t red_count() const { return unknown.size() + unexpected_passes.size() + !claims.missing.empty(); }
  /// Whether something was judged, and all of it holds or is known to fail.
  bool passes() const { return red_count() == 0 && inconclusive == 0 && judged > 0; }
  /// "3 red: 2 failures unknown or expired, 1 unexpected pass; 4 known", and what there is to say of claims.
  std::string sentence() const;
};

/// A row passes unexpectedly if its claims were judged and none of them fails. A row of what this night does not judge
/// says nothing.
NightStatus night_status(const std::vector<CaseRecords>& cases, const std::vector<KnownFailure>& known,
                         const std::string& today);

}  // namespace touchstone::reports

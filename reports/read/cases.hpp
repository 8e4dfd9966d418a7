#pragma once
/// The records of a night, by case.

#include "vnv/record/record.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace touchstone::reports {

/// All methods of one case.
struct CaseRecords {
  std::string name;  // also that of its folder
  std::vector<vnv::Record> records;

  const std::string& title() const { return records.front().title; }
};

/// Every *.json of a folder, by case and then by file name.
/// Throws std::runtime_error, naming the file, if the folder is not there or empty of records, if one cannot be read,
/// if a name could not be that of a file, or if a curve or a cloud belongs to no figure.
std::vector<CaseRecords> read_cases(const std::filesystem::path& folder);

/// A limit that a value meets to the digit is one of counting (no particle lost, run to the end): it leaves no margin
/// to speak of.
bool has_margin(const vnv::Verdict& verdict);

/// Whether a claim on what a method did at a level fails. A run that diverged and fails none was made to see whether it
/// does.
bool fails_at(const vnv::Record& record, const std::string& level);

/// Verdicts, counted.
struct Tally {
  int holds = 0, fails = 0, inconclusive = 0;
  double worst_margin = vnv::not_a_number;  // not a number if none has one, or a failure has none

  void add(vnv::Outcome outcome);
  int total() const { return holds + fails + inconclusive; }
  /// The outcome that a reader must know of first; inconclusive if there is no verdict.
  vnv::Outcome worst() const;
};
Tally tally(const std::vector<vnv::Verdict>& verdicts);

/// All verdicts of a case, in the order of its records.
std::vector<vnv::Verdict> verdicts_of(const CaseRecords& records);
/// The same of all cases.
std::vector<vnv::Verdict> verdicts_of(const std::vector<CaseRecords>& cases);

/// Figures and tables of a case, each id once, in order of appearance.
std::vector<vnv::Figure> figures_of(const CaseRecords& records);
std::vector<vnv::Table> tables_of(const CaseRecords& records);

}  // namespace touchstone::reports

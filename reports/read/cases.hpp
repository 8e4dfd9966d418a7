#pragma once
/// The records of a night, by case.

#include "vnv/record/record.hpp"

#include <algorithm>
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

/// Calls `visit(record, item)` for each of these items, `&vnv::Record::runs`, of all records, in their order.
void for_each(const CaseRecords& records, auto items, const auto& visit) {
  for (const vnv::Record& record : records.records)
    for (const auto& item : record.*items) visit(record, item);
}
void for_each(const std::vector<CaseRecords>& cases, auto items, const auto& visit) {
  for (const CaseRecords& records : cases) for_each(records, items, visit);
}

/// The items of all records that have an id, `&vnv::Record::figures`, each id once.
template <class Item>
std::vector<Item> each_once(const CaseRecords& records, std::vector<Item> vnv::Record::*items) {
  std::vector<Item> found;
  for_each(records, items, [&](const auto&, const Item& item) {
    if (std::ranges::find(found, item.id, &Item::id) == found.end()) found.push_back(item);
  });
  return found;
}

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
  int theory = 0, literature = 0, baseline = 0;  // who set the limits of all of these

  void add(vnv::Outcome outcome, const std::string& author);
  int total() const { return holds + fails + inconclusive; }
  /// The outcome that a reader must know of first; inconclusive if there is no verdict.
  vnv::Outcome worst() const;
};
Tally tally(const std::vector<vnv::Verdict>& verdicts);

/// All verdicts of a case, or of all cases, in the order of the records.
std::vector<vnv::Verdict> verdicts_of(const auto& cases) {
  std::vector<vnv::Verdict> all;
  for_each(cases, &vnv::Record::verdicts, [&](const auto&, const vnv::Verdict& verdict) { all.push_back(verdict); });
  return all;
}

/// Tables of a case, each id once with the rows of all its records.
std::vector<vnv::Table> tables_of(const CaseRecords& records);

}  // namespace touchstone::reports

#include "reports/read/cases.hpp"

#include <fmt/format.h>

#include <cctype>
#include <map>
#include <set>
#include <stdexcept>

namespace touchstone::reports {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> record_files(const fs::path& folder) {
  if (!fs::is_directory(folder)) throw std::runtime_error(fmt::format("{}: no such folder", folder.string()));
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  if (files.empty()) throw std::runtime_error(fmt::format("{}: no records in it, expected *.json", folder.string()));
  return files;
}

// Names become names of files and folders, and parts of a shell's command.
void require_file_name(const std::string& name, const char* what, const fs::path& file) {
  const auto fits = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-' || c == '='; };
  if (!name.empty() && std::all_of(name.begin(), name.end(), fits)) return;
  throw std::runtime_error(
      fmt::format("{}: {} '{}', expected letters, digits, '_', '=' and '-'", file.string(), what, name));
}

vnv::Record read_checked(const fs::path& file) {
  vnv::Record record = vnv::read_record(file);
  require_file_name(record.case_name, "case", file);
  for (const auto& figure : record.figures) require_file_name(figure.id, "figure", file);
  for (const auto& diagram : record.diagrams) require_file_name(diagram.id, "diagram", file);
  return record;
}

// A curve without a figure would vanish in silence, and so would a curve in a figure of clouds.
void check_figures(const CaseRecords& all) {
  std::set<std::string> declared, of_curves;
  for_each(all, &vnv::Record::figures, [&](const auto&, const auto& figure) { declared.insert(figure.id); });
  for_each(all, &vnv::Record::curves, [&](const auto&, const auto& curve) { of_curves.insert(curve.figure); });
  const auto check_declared = [&](const auto&, const auto& mark) {
    if (!declared.contains(mark.figure))
      throw std::runtime_error(
          fmt::format("case {}: curves or clouds name figure '{}', which no record declares", all.name, mark.figure));
  };
  for_each(all, &vnv::Record::curves, check_declared);
  for_each(all, &vnv::Record::clouds, check_declared);
  for_each(all, &vnv::Record::clouds, [&](const auto&, const auto& cloud) {
    if (of_curves.contains(cloud.figure))
      throw std::runtime_error(
          fmt::format("case {}: figure '{}' has curves and clouds, expected one kind", all.name, cloud.figure));
  });
}

// Rows of all methods are joined under one heading.
void check_tables(const CaseRecords& all) {
  std::map<std::string, std::vector<std::string>> columns;
  for_each(all, &vnv::Record::tables, [&](const auto&, const auto& table) {
    if (columns.try_emplace(table.id, table.columns).first->second != table.columns)
      throw std::runtime_error(fmt::format(
          "case {}: the columns of table '{}' differ between its records, expected the same", all.name, table.id));
  });
}

}  // namespace

std::vector<CaseRecords> read_cases(const fs::path& folder) {
  std::map<std::string, CaseRecords> by_name;
  for (const auto& file : record_files(folder)) {
    vnv::Record record = read_checked(file);
    CaseRecords& records = by_name[record.case_name];
    records.name = record.case_name;
    records.records.push_back(std::move(record));
  }
  std::vector<CaseRecords> cases;
  for (auto& [name, records] : by_name) cases.push_back(std::move(records));
  for (auto& records : cases) {
    std::ranges::stable_sort(records.records, {}, &vnv::Record::another_code);  // a page speaks in the case's own words
    check_figures(records);
    check_tables(records);
  }
  return cases;
}

vnv::Outcome Tally::worst() const {
  if (fails > 0) return vnv::Outcome::fails;
  return inconclusive > 0 || holds == 0 ? vnv::Outcome::inconclusive : vnv::Outcome::holds;
}

bool has_margin(const vnv::Verdict& verdict) {
  return verdict.outcome == vnv::Outcome::fails || (verdict.outcome == vnv::Outcome::holds && verdict.margin != 0);
}

bool fails_at(const vnv::Record& record, const std::string& level) {
  return std::ranges::any_of(
      record.verdicts, [&](const vnv::Verdict& v) { return v.outcome == vnv::Outcome::fails && v.level == level; });
}

void Tally::add(vnv::Outcome outcome, const std::string& author) {
  ++(outcome == vnv::Outcome::holds ? holds : outcome == vnv::Outcome::fails ? fails : inconclusive);
  ++(author.starts_with("theory") ? theory : author.starts_with("literature") ? literature : baseline);
}

Tally tally(const std::vector<vnv::Verdict>& verdicts) {
  Tally sum;
  for (const auto& verdict : verdicts) sum.add(verdict.outcome, verdict.author);
  return sum;
}

std::vector<vnv::Table> tables_of(const CaseRecords& records) {
  std::vector<vnv::Table> tables = each_once(records, &vnv::Record::tables);
  for (vnv::Table& table : tables) {
    table.rows.clear();
    for_each(records, &vnv::Record::tables, [&](const auto&, const vnv::Table& part) {
      if (part.id == table.id) std::ranges::copy(part.rows, std::back_inserter(table.rows));
    });
  }
  return tables;
}

}  // namespace touchstone::reports

#include "reports/read/cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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
void want_file_name(const std::string& name, const char* what, const fs::path& file) {
  const auto fits = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; };
  if (!name.empty() && std::all_of(name.begin(), name.end(), fits)) return;
  throw std::runtime_error(
      fmt::format("{}: {} '{}', expected letters, digits, '_' and '-'", file.string(), what, name));
}

vnv::Record read_checked(const fs::path& file) {
  vnv::Record record = vnv::read_record(file);
  want_file_name(record.case_name, "case", file);
  for (const auto& figure : record.figures) want_file_name(figure.id, "figure", file);
  for (const auto& diagram : record.diagrams) want_file_name(diagram.id, "diagram", file);
  return record;
}

// A curve without a figure would vanish in silence, and so would a curve in a figure of clouds.
void check_figures(const CaseRecords& all) {
  std::set<std::string> known, of_curves;
  for (const auto& figure : figures_of(all)) known.insert(figure.id);
  const auto check = [&](const std::string& id, bool fits) {
    if (!fits)
      throw std::runtime_error(
          fmt::format("case {}: figure '{}' has curves and clouds, expected one kind", all.name, id));
    if (!known.contains(id))
      throw std::runtime_error(
          fmt::format("case {}: curves or clouds name figure '{}', which no record declares", all.name, id));
  };
  for (const auto& record : all.records)
    for (const auto& curve : record.curves) {
      check(curve.figure, true);
      of_curves.insert(curve.figure);
    }
  for (const auto& record : all.records)
    for (const auto& cloud : record.clouds) check(cloud.figure, !of_curves.contains(cloud.figure));
}

// Rows of all methods are joined under one heading.
void check_tables(const CaseRecords& all) {
  std::map<std::string, std::vector<std::string>> columns;
  for (const auto& record : all.records)
    for (const auto& table : record.tables)
      if (columns.try_emplace(table.id, table.columns).first->second != table.columns)
        throw std::runtime_error(fmt::format(
            "case {}: the columns of table '{}' differ between its records, expected the same", all.name, table.id));
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

void Tally::add(vnv::Outcome outcome) {
  ++(outcome == vnv::Outcome::holds ? holds : outcome == vnv::Outcome::fails ? fails : inconclusive);
}

Tally tally(const std::vector<vnv::Verdict>& verdicts) {
  Tally sum;
  std::vector<double> margins;
  for (const auto& verdict : verdicts) {
    sum.add(verdict.outcome);
    if (has_margin(verdict)) margins.push_back(verdict.margin);
  }
  const bool known = std::none_of(margins.begin(), margins.end(), [](double m) { return std::isnan(m); });
  if (known && !margins.empty()) sum.worst_margin = *std::min_element(margins.begin(), margins.end());
  return sum;
}

std::vector<vnv::Verdict> verdicts_of(const CaseRecords& records) {
  std::vector<vnv::Verdict> all;
  for (const auto& record : records.records) all.insert(all.end(), record.verdicts.begin(), record.verdicts.end());
  return all;
}

std::vector<vnv::Verdict> verdicts_of(const std::vector<CaseRecords>& cases) {
  std::vector<vnv::Verdict> all;
  for (const auto& records : cases) std::ranges::copy(verdicts_of(records), std::back_inserter(all));
  return all;
}

std::vector<vnv::Figure> figures_of(const CaseRecords& records) {
  std::vector<vnv::Figure> figures;
  for (const auto& record : records.records)
    for (const auto& figure : record.figures)
      if (std::ranges::find(figures, figure.id, &vnv::Figure::id) == figures.end()) figures.push_back(figure);
  return figures;
}

std::vector<vnv::Table> tables_of(const CaseRecords& records) {
  std::vector<vnv::Table> tables;
  for (const auto& record : records.records)
    for (const auto& table : record.tables) {
      const auto known = std::ranges::find(tables, table.id, &vnv::Table::id);
      if (known == tables.end())
        tables.push_back(table);
      else
        known->rows.insert(known->rows.end(), table.rows.begin(), table.rows.end());
    }
  return tables;
}

}  // namespace touchstone::reports

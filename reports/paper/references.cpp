#include "reports/paper/references.hpp"

#include "vnv/files/tables.hpp"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>

namespace touchstone::reports {
namespace {

/// What stands between the outer braces of a line "  named = {...},"; empty if it is no such line.
std::string field_in(const std::string& line, const std::string& name) {
  const std::string opens = "  " + name + " = {";
  const std::size_t closes = line.rfind('}');
  return line.starts_with(opens) && closes != line.npos ? line.substr(opens.size(), closes - opens.size()) : "";
}

std::string texts_of(const CaseRecords& records) {
  std::string all;
  const auto add = [&](const std::string& text) { all += text + "\n"; };
  for (const vnv::Record& record : records.records) {
    for (const std::string& text : {record.title, record.description, record.method_description}) add(text);
    for (const auto& verdict : record.verdicts) add(verdict.author);
    for (const auto& figure : record.figures) add(figure.caption);
    for (const auto& curve : record.curves) add(curve.label);
    for (const auto& table : record.tables) add(table.caption);
  }
  return all;
}

bool has_long_number(std::string_view text) {
  std::size_t digits = 0;
  return std::ranges::any_of(text, [&](char c) { return (digits = '0' <= c && c <= '9' ? digits + 1 : 0) > 9; });
}

}  // namespace

std::vector<Reference> read_references(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(fmt::format("{}: cannot be read, expected references", file.string()));
  std::vector<Reference> all;
  std::string named, oracle_of;
  const auto refuse = [&](const std::string& what) {
    throw vnv::BadData(file, 0, fmt::format("{}: {}", all.back().key, what));
  };
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with('@')) {
      const std::size_t opens = line.find('{');
      const std::string key = line.substr(opens + 1, line.find(',') - opens - 1);
      const bool is_known = std::ranges::find(all, key, &Reference::key) != all.end();
      all.push_back({.key = key});
      if (is_known) refuse("duplicate key, expected it once");
      named = oracle_of = "";
    }
    if (all.empty()) continue;  // what the file says of itself
    if (const std::string found = field_in(line, "named"); !found.empty())
      named = found;
    else if (const std::string flows = field_in(line, "oracle_of"); !flows.empty())
      oracle_of = flows;
    else if (!line.empty())
      all.back().entry += line + "\n";
    if (line != "}") continue;
    if (named.size() + oracle_of.size() > 500)
      refuse("'named' or 'oracle_of' is longer than 500 letters");  // see std::regex
    if (has_long_number(named) || has_long_number(oracle_of))
      refuse("'named' or 'oracle_of' has a number of more than nine digits");  // std::regex overflows
    if (named.empty()) refuse("no field 'named', expected how a record names it");
    try {
      all.back().named = named;
      all.back().oracle_of = oracle_of;
    } catch (const std::regex_error& error) {
      refuse(fmt::format("'{}' or '{}' is no regular expression: {}", named, oracle_of, error.what()));
    }
    all.back().is_oracle = !oracle_of.empty();
  }
  return all;
}

std::vector<Reference> named_in(const std::string& text, const std::vector<Reference>& all) {
  std::vector<Reference> found;
  for (const Reference& one : all)
    if (std::regex_search(text, one.named)) found.push_back(one);
  return found;
}

std::vector<Reference> references_of(const CaseRecords& records, const std::vector<Reference>& all) {
  const std::string texts = texts_of(records);
  std::vector<Reference> found;
  for (const Reference& one : all)
    if (std::regex_search(texts, one.named) || (one.is_oracle && std::regex_search(records.name, one.oracle_of)))
      found.push_back(one);
  return found;
}

}  // namespace touchstone::reports

#pragma once
/// The literature that the records of a case name: entries of data/references.bib.

#include "reports/read/cases.hpp"

#include <filesystem>
#include <regex>
#include <string>
#include <vector>

namespace touchstone::reports {

/// An entry of BibTeX, and how records name it.
struct Reference {
  std::string key;                  // "ghia_1982"
  std::string entry{};              // as BibTeX reads it
  std::regex named{}, oracle_of{};  // found in a text; found in the name of a case
  bool is_oracle = false;
};

/// Entries begin with @ and end with } at the beginning of a line; `named` and `oracle_of` stand on lines of their own.
/// Throws std::runtime_error naming file, entry and what is wrong: no field `named`, a key that is there twice, a
/// regular expression that is none.
std::vector<Reference> read_references(const std::filesystem::path& file);

/// Those that a text names, in the order of the file.
std::vector<Reference> named_in(const std::string& text, const std::vector<Reference>& all);

/// Those that title, description, methods, authors of claims, figures and tables of a case name, and those of its exact
/// solution.
std::vector<Reference> references_of(const CaseRecords& records, const std::vector<Reference>& all);

}  // namespace touchstone::reports

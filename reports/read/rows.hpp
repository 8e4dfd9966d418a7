#pragma once
/// Rows that people and scripts leave in comma-separated files, quoted as in RFC 4180; what is wrong with one is said
/// with file and line.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace touchstone::reports {

/// A line of a file.
struct Line {
  std::filesystem::path file;
  long number;

  /// Throws std::runtime_error, "file:line: what".
  [[noreturn]] void refuse(const std::string& what) const;
};

struct Row {
  Line line;
  std::vector<std::string> fields;  // as many as there are columns
};

struct Rows {
  std::map<std::string, std::string> keys;  // of lines "# key: value"; any other line with # is a comment
  std::vector<Row> rows;
};

/// Reads a file whose heading names exactly these columns. Throws std::runtime_error naming file and line for one that
/// cannot be read, for other columns, a quote that does not close, or another number of fields.
Rows read_rows(const std::filesystem::path& file, const std::vector<std::string>& columns);

}  // namespace touchstone::reports

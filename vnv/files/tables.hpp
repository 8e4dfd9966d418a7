#pragma once
/// CSV files that say where their numbers come from: first lines `# key: value`, then one line of headings, then rows.
/// Comma separated, UTF-8; a text with a comma stands in double quotes. A byte order mark and CRLF are accepted.

#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::vnv {

/// The text in one line that gives a terminal no orders: what it holds of control characters, ASCII's and UTF-8's, is
/// '?'. For messages that quote a file.
std::string printable(std::string text);

/// A file is not what it should be, in one line: `file:line: what; found ..., expected ...`.
class BadData : public std::runtime_error {
 public:
  /// Line 0 speaks of the whole file.
  BadData(const std::filesystem::path& file, int line, std::string_view what);
};

/// The text of a CSV file, cell by cell.
struct Sheet {
  struct Key {
    std::string name, value;
    int line;
  };
  struct Row {
    std::vector<std::string> cells;
    int line = 0;
  };
  std::filesystem::path file;
  std::vector<Key> keys;
  Row headings;
  std::vector<Row> rows;  // each as long as the headings

  /// The first line of a key; throws BadData if there is none.
  const Key& key(std::string_view name) const;
  /// A cell as a number; throws BadData unless all of it is one. Infinity is none; `nan` is one only if it is allowed.
  double number(const Row& row, std::size_t column, bool may_be_nan = false) const;
};

/// Reads a file into its cells, whatever its columns mean. Throws BadData for a file that is missing, a folder, empty,
/// without headings, without rows where there may not be none, with a heading twice, or with a row too short or too
/// long.
Sheet read_sheet(const std::filesystem::path& file, bool may_have_no_rows = false);
/// The same for a text at hand; `file` is its name in messages.
Sheet parse_sheet(const std::filesystem::path& file, std::string_view text, bool may_have_no_rows = false);

/// A field of a line to be written, in quotes where it needs them (RFC 4180).
std::string csv_field(const std::string& text);
/// A line of fields, with its end.
std::string csv_line(const std::vector<std::string>& fields);

/// Throws BadData unless each expected key stands once, each other one that may stand at most once, and no other key but
/// `note` stands at all.
void require_keys(const Sheet& sheet, const std::vector<std::string>& expected,
                  const std::vector<std::string>& optional = {});
/// Throws BadData unless the headings are these, with their units, in this order.
void require_headings(const Sheet& sheet, const std::vector<std::string>& expected);

struct ValueWithUnit {
  double value;
  std::string unit;  // "-" for a pure number
};
using ValuesWithUnits = std::map<std::string, ValueWithUnit, std::less<>>;

/// Where the numbers of a table come from, and what they hold for. All but experiment, read-out and notes must stand in
/// the file.
struct Provenance {
  std::string title, citation;
  std::string source;        // who read the numbers from where, and which copy was taken
  std::string scaling;       // in words; "none" for numbers with units
  ValuesWithUnits geometry;  // SI
  ValuesWithUnits
      uncertainty;  // by column without its unit, "L", or by column and kind, "L.repeat"; in the column's unit
  std::string experiment;  // "Martin & Moyce 1952": what is compared with it names it so; else empty
  std::string read_out;    // which of its series that is; empty: there is one
  std::vector<std::string> notes;
  int geometry_line = 0;
};

/// A table with units and provenance. A column whose heading has a unit, `T [-]`, holds numbers, any other holds words.
class DataTable {
 public:
  /// Throws BadData for a cell that is not a number, an empty word, or a fault of the provenance.
  explicit DataTable(const Sheet& sheet, const std::vector<std::string>& may_be_nan = {});

  const std::filesystem::path& file() const { return file_; }
  const Provenance& provenance() const { return provenance_; }
  std::size_t rows() const { return rows_; }
  bool has(std::string_view heading) const { return numbers_.contains(heading) || words_.contains(heading); }
  /// A column by its whole heading; throws BadData if there is none of its kind.
  const std::vector<double>& numbers(std::string_view heading) const;
  const std::vector<std::string>& words(std::string_view heading) const;
  /// The rows with this word in this column, in their order; throws BadData if there are none.
  DataTable only(std::string_view heading, std::string_view word) const;

 private:
  std::filesystem::path file_;
  Provenance provenance_;
  std::size_t rows_;
  std::map<std::string, std::vector<double>, std::less<>> numbers_;
  std::map<std::string, std::vector<std::string>, std::less<>> words_;
};

/// Reads a table. Throws BadData.
DataTable read_table(const std::filesystem::path& file, const std::vector<std::string>& may_be_nan = {});

/// The tables of a folder that name their experiment, in the order of their files.
std::vector<DataTable> read_experiments(const std::filesystem::path& folder);

/// The files that `read_table` has read so far in this process: what its numbers rest on.
const std::set<std::filesystem::path>& tables_read();

/// Refuses data that were taken in another geometry. Value and tolerance are SI. Throws BadData.
void require_geometry(const DataTable& table, std::string_view key, double value, double tolerance);

}  // namespace touchstone::vnv

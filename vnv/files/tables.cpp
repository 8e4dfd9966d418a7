#include "vnv/files/tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#define CSV_IO_NO_THREAD  // of its reader, which is not used
#include <libfccp/csv.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <system_error>

namespace touchstone::vnv {
namespace {

using std::filesystem::path;

bool contains(const std::vector<std::string>& words, std::string_view word) {
  return std::ranges::find(words, word) != words.end();
}

std::string listed(const std::vector<std::string>& words) {
  return words.empty() ? "none" : fmt::format("'{}'", fmt::join(words, "', '"));
}

std::vector<std::string> names_in(const auto& map) {
  std::vector<std::string> names;
  for (const auto& [name, value] : map) names.push_back(name);
  return names;
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

std::optional<double> finite_number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc{} && end == text.data() + text.size();
  return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::string contents(const path& file) {
  std::error_code unknown;
  if (std::filesystem::is_directory(file, unknown)) throw BadData(file, 0, "found a folder, expected a CSV file");
  std::ifstream in(file, std::ios::binary);
  if (!in) throw BadData(file, 0, fmt::format("{}; expected a CSV file", std::generic_category().message(errno)));
  return {std::istreambuf_iterator<char>(in), {}};
}

Sheet::Key key_on(const path& file, int line, std::string_view text) {
  const auto colon = text.find(':');
  const auto name = trimmed(text.substr(1, std::min(colon, text.size()) - 1));
  const auto value = colon == text.npos ? std::string_view{} : trimmed(text.substr(colon + 1));
  if (name.empty() || value.empty())
    throw BadData(file, line, fmt::format("not a line of provenance; found '{}', expected '# key: value'", text));
  return {std::string(name), std::string(value), line};
}

std::vector<std::string> cells_of(const path& file, int number, char* line) {
  using Quotes = io::double_quote_escape<',', '"'>;
  std::vector<std::string> cells;
  try {
    for (bool more = true; more;) {
      char* begin = line;
      char* end = begin + (Quotes::find_next_column_end(begin) - begin);
      more = *end != '\0';
      line = end + 1;
      io::trim_chars<' ', '\t'>::trim(begin, end);
      Quotes::unescape(begin, end);
      cells.emplace_back(begin, end);
    }
  } catch (const io::error::escaped_string_not_closed&) {
    throw BadData(file, number, fmt::format("a quote that does not close; found '{}', expected a second '\"'", line));
  }
  return cells;
}

void require_names(const Sheet& sheet) {
  const auto& found = sheet.headings.cells;
  for (const auto& heading : found)
    if (heading.empty() || std::count(found.begin(), found.end(), heading) > 1)
      throw BadData(sheet.file, sheet.headings.line,
                    fmt::format("no name of one column: '{}'; found {}, expected a name for each and none twice",
                                heading, listed(found)));
}

void require_cells(const Sheet& sheet, bool ends_with_newline) {
  const auto expected = sheet.headings.cells.size();
  for (const auto& row : sheet.rows) {
    const auto found = row.cells.size();
    if (found == expected) continue;
    const bool cut = !ends_with_newline && found < expected && &row == &sheet.rows.back();
    throw BadData(sheet.file, row.line,
                  fmt::format("{}; found {}, expected {} cells",
                              cut                ? "the file ends within this row"
                              : found < expected ? "row too short"
                                                 : "row too long",
                              found, expected));
  }
}

void add_line(Sheet& sheet, int number, char* line) {
  if (io::empty_line_comment::is_comment(line)) return;
  const bool above_columns = sheet.headings.cells.empty();
  if (above_columns && *line == '#') {
    sheet.keys.push_back(key_on(sheet.file, number, line));
    return;
  }
  Sheet::Row row{cells_of(sheet.file, number, line), number};
  if (above_columns)
    sheet.headings = std::move(row);
  else
    sheet.rows.push_back(std::move(row));
}

/// Not by io::LineReader, which takes 48 MiB however small the text is and refuses lines of 16 MiB.
void add_lines(Sheet& sheet, std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // a byte order mark
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string line(text.substr(0, end));
    if (line.ends_with('\r')) line.pop_back();
    add_line(sheet, number, line.data());  // which undoes quotes in place
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

/// The headings with the same name and another unit, if any; else all of them.
std::vector<std::string> like(const std::string& expected, const std::vector<std::string>& found) {
  const auto name = [](const std::string& heading) { return heading.substr(0, heading.find(" [")); };
  std::vector<std::string> near;
  std::copy_if(found.begin(), found.end(), std::back_inserter(near),
               [&](const std::string& heading) { return name(heading) == name(expected); });
  return near.empty() ? found : near;
}

bool has_unit(const std::string& heading) { return heading.ends_with(']') && heading.find(" [") != heading.npos; }

/// One `name = value unit`.
std::pair<std::string, ValueWithUnit> quantity_in(const Sheet& sheet, const Sheet::Key& key, std::string_view text) {
  const auto equals = std::min(text.find('='), text.size());
  const auto name = trimmed(text.substr(0, equals));
  const auto amount = trimmed(text.substr(std::min(equals + 1, text.size())));
  const auto space = std::min(amount.find(' '), amount.size());
  const auto value = finite_number(amount.substr(0, space));
  if (name.empty() || !value)
    throw BadData(sheet.file, key.line,
                  fmt::format("{}; found '{}', expected 'name = number unit'", key.name, trimmed(text)));
  const auto unit = trimmed(amount.substr(space));
  return {std::string(name), {*value, unit.empty() ? "-" : std::string(unit)}};
}

/// The quantities of a key, parted by semicolons; "none" for none.
ValuesWithUnits quantities(const Sheet& sheet, std::string_view name) {
  const auto& key = sheet.key(name);
  ValuesWithUnits all;
  if (key.value == "none") return all;
  std::string_view rest = key.value;
  while (!rest.empty()) {
    const auto end = std::min(rest.find(';'), rest.size());
    const auto [entry, is_new] = all.insert(quantity_in(sheet, key, rest.substr(0, end)));
    if (!is_new)
      throw BadData(sheet.file, key.line, fmt::format("{}; found '{}' twice, expected it once", name, entry->first));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return all;
}

void require_si(const Sheet& sheet, const Provenance& provenance) {
  static const std::vector<std::string> si{"-", "m", "s", "m/s", "m/s²", "m²/s", "kg/m³", "Pa", "Pa s"};
  for (const auto& [name, quantity] : provenance.geometry)
    if (!contains(si, quantity.unit))
      throw BadData(sheet.file, provenance.geometry_line,
                    fmt::format("unit of {}; found '{}', expected {}", name, quantity.unit, listed(si)));
}

std::string value_if_any(const Sheet& sheet, std::string_view name) {
  const auto found = std::ranges::find(sheet.keys, name, &Sheet::Key::name);
  return found == sheet.keys.end() ? "" : found->value;
}

Provenance provenance_of(const Sheet& sheet) {
  require_keys(sheet, {"title", "citation", "source", "scaling", "geometry", "uncertainty"},
               {"experiment", "read-out"});
  Provenance provenance{.title = sheet.key("title").value,
                        .citation = sheet.key("citation").value,
                        .source = sheet.key("source").value,
                        .scaling = sheet.key("scaling").value,
                        .geometry = quantities(sheet, "geometry"),
                        .uncertainty = quantities(sheet, "uncertainty"),
                        .experiment = value_if_any(sheet, "experiment"),
                        .read_out = value_if_any(sheet, "read-out"),
                        .notes = {},
                        .geometry_line = sheet.key("geometry").line};
  for (const auto& key : sheet.keys)
    if (key.name == "note") provenance.notes.push_back(key.value);
  require_si(sheet, provenance);
  return provenance;
}

const std::string& word(const Sheet& sheet, const Sheet::Row& row, std::size_t column) {
  if (row.cells[column].empty())
    throw BadData(sheet.file, row.line,
                  fmt::format("empty cell in '{}'; expected a word", sheet.headings.cells[column]));
  return row.cells[column];
}

const auto& column(const DataTable& table, const auto& columns, std::string_view kind, std::string_view heading) {
  const auto found = columns.find(heading);
  if (found != columns.end()) return found->second;
  throw BadData(table.file(), 0,
                fmt::format("no column of {} '{}'; found {}", kind, heading,
                            listed(like(std::string(heading), names_in(columns)))));
}

void keep(auto& columns, const std::vector<std::string>& words, std::string_view expected) {
  for (auto& [heading, cells] : columns) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < words.size(); ++i)
      if (words[i] == expected) cells[kept++] = cells[i];
    cells.resize(kept);
  }
}

std::set<path>& remembered_tables() {
  static std::set<path> files;
  return files;
}

}  // namespace

std::string printable(std::string text) {
  for (std::size_t k = 0; k < text.size(); ++k) {
    const auto byte = [&](std::size_t at) { return at < text.size() ? static_cast<unsigned char>(text[at]) : 0; };
    if (byte(k) < 0x20 || byte(k) == 0x7f) text[k] = '?';
    if (byte(k) == 0xc2 && byte(k + 1) >= 0x80 && byte(k + 1) < 0xa0) text.replace(k, 2, "?");
  }
  return text;
}

BadData::BadData(const path& file, int line, std::string_view what)
    : std::runtime_error(printable(line > 0 ? fmt::format("{}:{}: {}", file.string(), line, what)
                                            : fmt::format("{}: {}", file.string(), what))) {}

const Sheet::Key& Sheet::key(std::string_view name) const {
  if (const auto at = std::ranges::find(keys, name, &Key::name); at != keys.end()) return *at;
  std::vector<std::string> found;
  for (const auto& candidate : keys) found.push_back(candidate.name);
  throw BadData(file, headings.line,
                fmt::format("no line '# {}: ...' above the columns; found {}", name, listed(found)));
}

double Sheet::number(const Row& row, std::size_t column, bool may_be_nan) const {
  const auto& cell = row.cells[column];
  if (may_be_nan && cell == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (const auto value = finite_number(cell)) return *value;
  throw BadData(file, row.line,
                fmt::format("not a number in '{}'; found '{}', expected a decimal number{}", headings.cells[column],
                            cell, may_be_nan ? " or nan" : ""));
}

Sheet read_sheet(const path& file, bool may_have_no_rows) {
  return parse_sheet(file, contents(file), may_have_no_rows);
}

Sheet parse_sheet(const path& file, std::string_view text, bool may_have_no_rows) {
  if (text.empty()) throw BadData(file, 0, "the file is empty; expected '# key: value' lines, headings and rows");
  if (text.find('\0') != text.npos) throw BadData(file, 0, "found a zero byte, expected text in UTF-8");
  Sheet sheet{.file = file, .keys = {}, .headings = {}, .rows = {}};
  add_lines(sheet, text);
  if (sheet.headings.cells.empty())
    throw BadData(file, 0, "no columns; expected a line of headings below the '#' lines");
  require_names(sheet);
  if (sheet.rows.empty() && !may_have_no_rows)
    throw BadData(file, sheet.headings.line, "no rows; found headings alone, expected rows below");
  require_cells(sheet, text.ends_with('\n'));
  return sheet;
}

std::string csv_field(const std::string& text) {
  const bool is_padded = text.starts_with(' ') || text.ends_with(' ');
  if (!is_padded && text.find_first_of(",\"\t\r\n") == text.npos) return text;
  std::string quoted;
  for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return fmt::format("\"{}\"", quoted);
}

std::string csv_line(const std::vector<std::string>& fields) {
  std::string line;
  for (const auto& field : fields) line += csv_field(field) + ',';
  if (!line.empty()) line.pop_back();
  return line + '\n';
}

void require_keys(const Sheet& sheet, const std::vector<std::string>& expected,
                  const std::vector<std::string>& optional) {
  for (const auto& key : sheet.keys) {
    if (key.name == "note") continue;
    if (!contains(expected, key.name) && !contains(optional, key.name))
      throw BadData(sheet.file, key.line,
                    fmt::format("unknown key; found '{}', expected {}", key.name, listed(expected)));
    if (const auto& first = sheet.key(key.name); &first != &key)
      throw BadData(sheet.file, key.line,
                    fmt::format("duplicate key; found '{}' on line {} too, expected it once", key.name, first.line));
  }
  for (const auto& name : expected) sheet.key(name);
}

void require_headings(const Sheet& sheet, const std::vector<std::string>& expected) {
  const auto& found = sheet.headings.cells;
  const auto refuse = [&](const std::string& what) { throw BadData(sheet.file, sheet.headings.line, what); };
  for (const auto& heading : expected)
    if (!contains(found, heading))
      refuse(fmt::format("no column '{}'; found {}", heading, listed(like(heading, found))));
  for (const auto& heading : found)
    if (!contains(expected, heading))
      refuse(fmt::format("unknown column; found '{}', expected {}", heading, listed(expected)));
  if (found != expected)
    refuse(fmt::format("columns out of order; found {}, expected {}", listed(found), listed(expected)));
}

DataTable::DataTable(const Sheet& sheet, const std::vector<std::string>& may_be_nan)
    : file_(sheet.file), provenance_(provenance_of(sheet)), rows_(sheet.rows.size()) {
  for (std::size_t i = 0; i < sheet.headings.cells.size(); ++i) {
    const auto& heading = sheet.headings.cells[i];
    const bool is_numeric = has_unit(heading);
    for (const auto& row : sheet.rows) {
      if (is_numeric)
        numbers_[heading].push_back(sheet.number(row, i, contains(may_be_nan, heading)));
      else
        words_[heading].push_back(word(sheet, row, i));
    }
  }
}

const std::vector<double>& DataTable::numbers(std::string_view heading) const {
  return column(*this, numbers_, "numbers", heading);
}

const std::vector<std::string>& DataTable::words(std::string_view heading) const {
  return column(*this, words_, "words", heading);
}

DataTable DataTable::only(std::string_view heading, std::string_view word) const {
  const auto& choice = words(heading);
  DataTable part = *this;
  part.rows_ = static_cast<std::size_t>(std::count(choice.begin(), choice.end(), word));
  if (part.rows_ == 0) {
    const std::set<std::string> found(choice.begin(), choice.end());
    throw BadData(file_, 0,
                  fmt::format("no row with {} '{}'; found {}", heading, word, listed({found.begin(), found.end()})));
  }
  keep(part.numbers_, choice, word);
  keep(part.words_, choice, word);
  return part;
}

DataTable read_table(const path& file, const std::vector<std::string>& may_be_nan) {
  DataTable table(read_sheet(file), may_be_nan);
  remembered_tables().insert(file);
  return table;
}

std::vector<DataTable> read_experiments(const path& folder) {
  std::set<path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".csv") files.insert(entry.path());
  std::vector<DataTable> all;
  for (const path& file : files)
    if (const Sheet sheet = read_sheet(file); !value_if_any(sheet, "experiment").empty()) {
      all.emplace_back(sheet);
      remembered_tables().insert(file);
    }
  return all;
}

const std::set<path>& tables_read() { return remembered_tables(); }

void require_geometry(const DataTable& table, std::string_view key, double value, double tolerance) {
  const auto& provenance = table.provenance();
  const auto refuse = [&](const std::string& what) { throw BadData(table.file(), provenance.geometry_line, what); };
  const auto found = provenance.geometry.find(key);
  if (found == provenance.geometry.end())
    refuse(fmt::format("no {} in the geometry; found {}", key, listed(names_in(provenance.geometry))));
  const auto& [measured, unit] = found->second;
  if (!(std::abs(measured - value) <= tolerance))
    refuse(fmt::format("another geometry, {}; found {} {}, expected {} ± {} {}", key, measured, unit, value, tolerance,
                       unit));
}

}  // namespace touchstone::vnv

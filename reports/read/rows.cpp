#include "reports/read/rows.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace touchstone::reports {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> fields_of(const std::string& text, const Line& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"' && quoted && text.substr(i + 1, 1) == "\"")
      fields.back() += text[++i];
    else if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      fields.emplace_back();
    else
      fields.back() += c;
  }
  if (quoted) line.refuse("a quote that does not close, expected a second '\"'");
  return fields;
}

std::string with_commas(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all.append(all.empty() ? "" : ",").append(word);
  return all;
}

void add_key(std::map<std::string, std::string>& keys, const std::string& comment) {
  const auto colon = comment.find(": ");
  if (comment.starts_with("# ") && colon != std::string::npos)
    keys[comment.substr(2, colon - 2)] = comment.substr(colon + 2);
}

}  // namespace

void Line::refuse(const std::string& what) const {
  throw std::runtime_error(fmt::format("{}:{}: {}", file.string(), number, what));
}

Rows read_rows(const fs::path& file, const std::vector<std::string>& columns) {
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error(fmt::format("{}: cannot be read: {}", file.string(), std::strerror(errno)));
  Rows all;
  bool has_heading = false;
  Line line{file, 0};
  for (std::string text; std::getline(stream, text);) {
    ++line.number;
    if (text.ends_with('\r')) text.pop_back();
    if (text.starts_with('#')) add_key(all.keys, text);
    if (text.empty() || text.starts_with('#')) continue;
    Row row{line, fields_of(text, line)};
    if (!has_heading && row.fields != columns)
      line.refuse(fmt::format("other columns, expected {}", with_commas(columns)));
    if (row.fields.size() != columns.size())
      line.refuse(fmt::format("{} cells, expected {}", row.fields.size(), columns.size()));
    if (has_heading) all.rows.push_back(std::move(row));
    has_heading = true;
  }
  if (!has_heading) line.refuse(fmt::format("no columns, expected {}", with_commas(columns)));
  return all;
}

}  // namespace touchstone::reports

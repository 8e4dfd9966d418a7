/// PLY, as text or bytes of either order (Turk 1994): the properties of its vertices. Other elements behind them, such
/// as faces, are left alone; a comment "time 0.5" is the time.

#include "vnv/doors/read/format.hpp"
#include "vnv/doors/read/parts/columns.hpp"
#include "vnv/doors/read/parts/numbers.hpp"

#include <fmt/format.h>

#include <map>

namespace touchstone::vnv::doors::formats {
namespace {

const std::map<std::string_view, Type> types{
    {"char", Type::int8},     {"int8", Type::int8},       {"uchar", Type::uint8},    {"uint8", Type::uint8},
    {"short", Type::int16},   {"int16", Type::int16},     {"ushort", Type::uint16},  {"uint16", Type::uint16},
    {"int", Type::int32},     {"int32", Type::int32},     {"uint", Type::uint32},    {"uint32", Type::uint32},
    {"float", Type::float32}, {"float32", Type::float32}, {"double", Type::float64}, {"float64", Type::float64}};

struct Header {
  std::string encoding{};
  std::size_t rows = 0;
  std::vector<std::pair<std::string, Type>> properties{};
  std::optional<double> time{};
};

/// Takes the header off the text.
Header header_of(std::string_view& rest, const std::string& file) {
  Header header;
  bool of_vertices = false, is_any_element = false;
  next_line(rest);  // "ply"
  for (long at = 2;; ++at) {
    const std::string where = fmt::format("{}:{}", file, at);
    if (rest.empty()) refuse(where, "ends within its header, expected 'end_header'");
    std::string_view line = trimmed(next_line(rest));
    const std::string_view whole = line, word = next_word(line);
    if (word == "end_header") break;
    if (word == "format") {
      header.encoding = next_word(line);
    } else if (word == "comment" || word == "obj_info") {
      if (std::string_view words = line; names_time(next_word(words)))
        if (const auto time = number_in(trimmed(words))) header.time = time_of(*time, Type::float64, where);
    } else if (word == "element") {
      of_vertices = next_word(line) == "vertex";
      if (!of_vertices && !is_any_element)
        refuse(where, fmt::format("'{:.60}', expected 'element vertex' before all others", whole));
      if (of_vertices) header.rows = whole_number(next_word(line), where);
      is_any_element = true;
    } else if (word == "property" && of_vertices) {
      const auto type = types.find(next_word(line));
      if (type == types.end() || trimmed(line).empty())
        refuse(where, fmt::format("'{:.60}', expected a property of one number of a vertex", whole));
      header.properties.emplace_back(trimmed(line), type->second);
    } else if (word != "property") {
      refuse(where, fmt::format("'{:.60}', expected format, comment, element, property or end_header", whole));
    }
  }
  if (header.properties.empty()) refuse(file, "no properties of vertices, expected some");
  return header;
}

std::vector<Array> rows_of_text(std::string_view rest, const Header& header, const std::string& file) {
  std::vector<Array> columns;
  for (const auto& [name, type] : header.properties) columns.push_back({.name = name});
  for (Array& column : columns) reserve_more(column.values, header.rows);
  for (std::size_t row = 0; row < header.rows; ++row) {
    if (rest.empty()) refuse(file, fmt::format("ends after {} vertices, expected {}", row, header.rows));
    std::string_view line = next_line(rest);
    for (Array& column : columns)
      append_text(line, 1, Type::float64, fmt::format("{}: vertex {}: {:.80}", file, row + 1, column.name),
                  column.values);
    if (!trimmed(line).empty())
      refuse(file, fmt::format("vertex {}: more numbers than {} properties", row + 1, columns.size()));
  }
  return columns;
}

std::vector<Array> rows_of_bytes(std::string_view rest, const Header& header, std::endian order,
                                 const std::string& file) {
  std::size_t width = 0;
  for (const auto& [name, type] : header.properties) width += bytes_of(type);
  if (rest.size() / width < header.rows)
    refuse(file, fmt::format("ends after {} vertices, expected {}", rest.size() / width, header.rows));
  std::vector<Array> columns;
  std::size_t at = 0;
  for (const auto& [name, type] : header.properties) {
    Array& column = columns.emplace_back(Array{.name = name});
    reserve_more(column.values, header.rows);
    with_type(type, [&]<class From>(From) {
      for (std::size_t row = 0; row < header.rows; ++row)
        column.values.push_back(static_cast<double>(load<From>(rest.data() + row * width + at, order)));
    });
    at += bytes_of(type);
  }
  return columns;
}

}  // namespace

Format ply() {
  return {.words = "PLY",
          .place = 42,
          .endings = {".ply"},
          .begins = "ply",
          .read = [](const std::filesystem::path& file, std::string_view bytes, const Limits& limits) {
            const std::string name = file.string();
            std::string_view rest = bytes;
            const Header header = header_of(rest, name);
            Budget(limits).take(header.rows, header.properties.size(), name);
            const bool is_text = header.encoding == "ascii", is_little = header.encoding == "binary_little_endian";
            if (!is_text && !is_little && header.encoding != "binary_big_endian")
              refuse(name, fmt::format("format '{:.40}', expected ascii, binary_little_endian or binary_big_endian",
                                       header.encoding));
            if (is_text && header.rows > rest.size() / 2 + 1)  // a digit and the end of a line each
              refuse(name, fmt::format("ends within its vertices, expected {}", header.rows));
            Dataset data{.source = file.filename().string(),
                         .format = "PLY, " + header.encoding,
                         .time = header.time,
                         .index = number_of(file)};
            data.arrays = is_text
                              ? rows_of_text(rest, header, name)
                              : rows_of_bytes(rest, header, is_little ? std::endian::little : std::endian::big, name);
            require_equal_rows(data.arrays, name);
            return std::vector{std::move(data)};
          }};
}

}  // namespace touchstone::vnv::doors::formats

/// XYZ, plain or extended: frames of a count, a line of comment and a row for each particle. The comment of an extended
/// one names its columns, Properties=species:S:1:pos:R:3, and may have the time; of a plain one they are the species,
/// x, y, z and "column 5" and so on.

#include "vnv/doors/read/format.hpp"
#include "vnv/doors/read/parts/columns.hpp"
#include "vnv/doors/read/parts/numbers.hpp"

#include <fmt/format.h>

namespace touchstone::vnv::doors::formats {
namespace {

bool is_count(std::string_view line) {
  line = trimmed(line);
  return !line.empty() && line.find_first_not_of("0123456789") == line.npos;
}

/// A column, or several of one array; of words where its letter is S.
struct Column {
  std::string name;
  char letter;
  int components;
};

class Frames {
 public:
  Frames(const std::filesystem::path& file, std::string_view bytes, const Limits& limits)
      : file_(file), rest_(bytes), limits_(limits), budget_(limits) {}

  std::vector<Dataset> datasets() && {
    std::vector<Dataset> all;
    while (!trimmed(rest_).empty()) {
      if (all.size() == limits_.most_datasets)
        refuse_here(fmt::format("expected no more than {} frames", limits_.most_datasets));
      all.push_back(frame());
    }
    if (all.size() == 1 && !all[0].time) all[0].index = number_of(file_);
    return all;
  }

 private:
  [[noreturn]] void refuse_here(const std::string& what) const {
    refuse(fmt::format("{}:{}", file_.string(), at_), what);
  }
  std::string here(std::string_view of) const { return fmt::format("{}:{}: {:.80}", file_.string(), at_, of); }

  std::string_view next() {
    if (rest_.empty()) refuse_here("ends within a frame, expected more lines");
    ++at_;
    return next_line(rest_);
  }

  /// What a key of the comment says, without quotes; empty where there is none.
  static std::string_view said(std::string_view comment, std::string_view key) {
    for (std::size_t at = comment.find(key); at != comment.npos; at = comment.find(key, at + 1)) {
      if ((at > 0 && comment[at - 1] != ' ') || comment.substr(at + key.size(), 1) != "=") continue;
      const std::string_view value = comment.substr(at + key.size() + 1);
      return value.starts_with('"') ? value.substr(1, value.find('"', 1) - 1) : value.substr(0, value.find(' '));
    }
    return {};
  }

  std::vector<Column> columns_of(std::string_view properties) const {
    std::vector<Column> all;
    const auto next_part = [&] {
      const std::string_view part = properties.substr(0, properties.find(':'));
      properties.remove_prefix(std::min(properties.size(), part.size() + 1));
      return part;
    };
    while (!properties.empty()) {
      const std::string_view name = next_part(), letter = next_part(), count = next_part();
      if (name.empty() || letter.size() != 1 || std::string_view("SRIL").find(letter) == letter.npos ||
          !is_count(count))
        refuse_here(fmt::format("Properties of '{:.40}', expected NAME:S, R, I or L:COUNT each", name));
      const std::size_t components = whole_number(count, here("Properties"));
      if (components == 0 || components > limits_.most_components || (letter == "S" && components > 1))
        refuse_here(fmt::format("{:.40} of {} columns, expected 1 to {}, of words 1", name, components,
                                limits_.most_components));
      all.push_back({name == "velo" ? "velocity" : std::string(name), letter[0], static_cast<int>(components)});
    }
    return all;
  }

  /// Of a plain frame, by its first row.
  std::vector<Column> plain_columns() const {
    std::string_view line = rest_.substr(0, rest_.find('\n'));
    std::vector<Column> all{{"species", 'S', 1}, {"x", 'R', 1}, {"y", 'R', 1}, {"z", 'R', 1}};
    std::size_t words = 0;
    while (!next_word(line).empty()) ++words;
    if (words < all.size()) refuse(here("row"), "expected a species and three coordinates");
    for (std::size_t k = all.size(); k < words; ++k) all.push_back({fmt::format("column {}", k + 1), 'R', 1});
    return all;
  }

  Dataset frame() {
    Dataset data{.source = file_.filename().string(), .format = "XYZ"};
    const std::string_view line = next();
    if (!is_count(line)) refuse_here(fmt::format("'{:.40}', expected how many rows there are", line));
    const std::size_t rows = whole_number(trimmed(line), here("rows"));
    const std::string_view comment = next(), properties = said(comment, "Properties");
    for (const std::string_view key : {"Time", "time"})
      if (const auto time = number_in(said(comment, key))) data.time = time_of(*time, Type::float64, here(key));
    if (!properties.empty()) data.format = "extended XYZ";
    const std::vector<Column> columns = properties.empty() ? plain_columns() : columns_of(properties);
    std::size_t width = 0;
    for (const Column& one : columns) {
      width += static_cast<std::size_t>(one.components);
      data.arrays.push_back({.name = one.name, .components = one.components});
    }
    budget_.take(rows, width, here("rows"));
    if (rows > rest_.size() / (2 * width) + 1) refuse_here(fmt::format("ends within its rows, expected {}", rows));
    for (std::size_t row = 0; row < rows; ++row) {
      std::string_view cells = next();
      for (std::size_t k = 0; k < columns.size(); ++k) take(cells, columns[k], data.arrays[k]);
      if (!trimmed(cells).empty()) refuse_here(fmt::format("more cells than columns, expected {}", width));
    }
    require_equal_rows(data.arrays, file_.string());
    return data;
  }

  void take(std::string_view& cells, const Column& column, Array& array) const {
    if (column.letter != 'S' && column.letter != 'L')
      return append_text(cells, static_cast<std::size_t>(column.components), Type::float64, here(column.name),
                         array.values);
    for (int k = 0; k < column.components; ++k) {
      const std::string_view word = next_word(cells);
      if (word.empty()) refuse_here(fmt::format("ends before {:.80}", column.name));
      if (column.letter == 'L') {
        array.values.push_back(word.starts_with('T') || word.starts_with('t') ? 1 : 0);
        continue;
      }
      auto label = std::ranges::find(array.labels, word);
      if (label == array.labels.end()) {
        constexpr std::size_t most_labels = 1000;
        if (array.labels.size() == most_labels)
          refuse_here(fmt::format("expected no more than {} species", most_labels));
        label = array.labels.insert(label, std::string(word));
      }
      array.values.push_back(static_cast<double>(label - array.labels.begin()));
    }
  }

  const std::filesystem::path& file_;
  std::string_view rest_;
  const Limits& limits_;
  Budget budget_;
  long at_ = 0;
};

}  // namespace

Format xyz() {
  return {.words = "XYZ",
          .place = 44,
          .endings = {".xyz"},
          .is_it =
              [](const std::filesystem::path& file, std::string_view head) {
                const std::string_view first = next_line(head), comment = next_line(head);
                return is_count(first) && (file.extension() == ".xyz" || comment.find("Properties=") != comment.npos);
              },
          .read = [](const std::filesystem::path& file, std::string_view bytes,
                     const Limits& limits) { return Frames(file, bytes, limits).datasets(); }};
}

}  // namespace touchstone::vnv::doors::formats

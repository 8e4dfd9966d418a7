#include "vnv/doors/read/parts/numbers.hpp"

#include "vnv/files/tables.hpp"

#include <fmt/format.h>
#include <sys/mman.h>

#include <cmath>

namespace touchstone::vnv::doors {

void refuse(const std::string& where, const std::string& what) { throw Unreadable(printable(where + ": " + what)); }

std::size_t whole_number(std::string_view text, const std::string& where) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size())
    refuse(where, fmt::format("'{}', expected a whole number from 0", text.substr(0, 40)));
  return number;
}

/// Says it of the whole pages of memory, for the system to follow or not.
static void advise(const void* begin, std::size_t bytes, int advice) {
  constexpr std::uintptr_t page = 4096;
  const auto first = (reinterpret_cast<std::uintptr_t>(begin) + page - 1) / page * page,
             end = (reinterpret_cast<std::uintptr_t>(begin) + bytes) / page * page;
  if (first < end) madvise(reinterpret_cast<void*>(first), end - first, advice);
}

void expect_to_fill(const void* begin, std::size_t bytes) {
  constexpr std::size_t least = 1 << 22;
  if (bytes >= least) advise(begin, bytes, MADV_HUGEPAGE);
}

void forget(const void* begin, std::size_t bytes) {
  advise(begin, bytes, MADV_NOHUGEPAGE);  // into which the system would gather them again
  advise(begin, bytes, MADV_DONTNEED);
}

std::size_t Budget::take(std::size_t rows, std::size_t components, const std::string& where) {
  if (components < 1 || components > limits_.most_components)
    refuse(where, fmt::format("'{}' components, expected 1 to {}", components, limits_.most_components));
  if (rows > left_ / components)
    refuse(where, fmt::format("'{}' rows of {} numbers, expected no more than {} bytes of numbers in a file", rows,
                              components, limits_.most_bytes));
  left_ -= rows * components;
  return rows * components;
}

std::string_view next_word(std::string_view& text) {
  constexpr std::string_view blanks = " \t\n\r\v\f";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(blanks));
  text.remove_prefix(word.size());
  return word;
}

std::string_view next_line(std::string_view& text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  text.remove_prefix(std::min(line.size() + 1, text.size()));
  return line;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == text.npos ? "" : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::optional<double> number_in(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

char separator_of(std::string_view line, std::string_view separators) {
  std::string bare;
  bool is_quoted = false;
  for (const char c : line) {
    is_quoted ^= c == '"';
    if (!is_quoted) bare += c;
  }
  for (const char separator : separators)
    if (bare.find(separator) != bare.npos) return separator;
  return ' ';
}

std::size_t end_of_cell(std::string_view text, std::string_view separator) {
  const std::size_t first = std::min(text.find_first_not_of(' '), text.size());
  const std::size_t closing = text.substr(first).starts_with('"') ? text.find('"', first + 1) : 0;
  const std::size_t from = closing == text.npos ? 0 : closing;
  return separator == " " ? text.find_first_of(" \t", from) : text.find(separator, from);
}

std::string_view unquoted(std::string_view cell) {
  return cell.size() > 1 && cell.starts_with('"') && cell.ends_with('"') ? cell.substr(1, cell.size() - 2) : cell;
}

double time_of(double stored, Type type, const std::string& where) {
  if (!std::isfinite(stored)) refuse(where, fmt::format("'{}', expected a time", stored));
  return type == Type::float32 ? std::strtod(fmt::format("{}", static_cast<float>(stored)).c_str(), nullptr) : stored;
}

std::optional<int> rank_as_time(std::string_view name) {
  constexpr std::array<std::string_view, 5> names = {"TimeValue", "TIME", "Time", "time", "TimeStep"};
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return {};
  return static_cast<int>(found - names.begin());
}

std::optional<long> number_of(const std::filesystem::path& file) {
  const std::string stem = (file.extension() == ".gz" ? file.stem() : file).stem().string();
  const std::size_t first = stem.find_last_not_of("0123456789") + 1;  // 0 where all are digits
  long number = 0;
  const auto [end, error] = std::from_chars(stem.data() + first, stem.data() + stem.size(), number);
  if (error != std::errc{}) return {};
  return number;
}

}  // namespace touchstone::vnv::doors

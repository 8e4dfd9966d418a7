#pragma once
/// Numbers as files hold them: of ten types, as text and in its cells or as bytes of either order, and how many a file
/// may claim.

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "vnv/doors/read/dataset.hpp"

namespace touchstone::vnv::doors {

enum class Type { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

/// Calls with a number of the type.
template <class Call>
decltype(auto) with_type(Type type, Call&& call) {
  switch (type) {
    case Type::int8:
      return call(std::int8_t{});
    case Type::uint8:
      return call(std::uint8_t{});
    case Type::int16:
      return call(std::int16_t{});
    case Type::uint16:
      return call(std::uint16_t{});
    case Type::int32:
      return call(std::int32_t{});
    case Type::uint32:
      return call(std::uint32_t{});
    case Type::int64:
      return call(std::int64_t{});
    case Type::uint64:
      return call(std::uint64_t{});
    case Type::float32:
      return call(float{});
    case Type::float64:
      break;
  }
  return call(double{});
}

inline std::size_t bytes_of(Type type) {
  return with_type(type, [](auto number) { return sizeof(number); });
}
inline bool is_whole(Type type) { return type < Type::float32; }

/// Times that zlib makes bytes smaller, at the most (zlib.net/zlib_tech.html); LZ4 255 times.
inline constexpr std::size_t most_that_deflate_saves = 1032;

/// Throws Unreadable in one line, whatever characters of a file it quotes.
[[noreturn]] void refuse(const std::string& where, const std::string& what);

/// A count as a file writes it. Throws Unreadable unless it is digits only.
std::size_t whole_number(std::string_view text, const std::string& where);

/// Memory that is about to be filled comes in large pages, since each page costs when it is first touched.
void expect_to_fill(const void* begin, std::size_t bytes);

/// Gives memory that is not read again back to the system; what stood there is undefined from then on.
void forget(const void* begin, std::size_t bytes);

/// Space for so many more numbers.
template <class Number>
void reserve_more(std::vector<Number>& numbers, std::size_t count) {
  if (numbers.capacity() - numbers.size() >= count) return;
  numbers.reserve(std::max(numbers.size() + count, 2 * numbers.size()));
  expect_to_fill(numbers.data(), numbers.capacity() * sizeof(Number));
}

/// What the arrays of a file may still take.
class Budget {
 public:
  explicit Budget(const Limits& limits) : limits_(limits), left_(limits.most_bytes / sizeof(double)) {}

  /// Rows times components, both of which the file claims, taken from what is left. Throws Unreadable.
  std::size_t take(std::size_t rows, std::size_t components, const std::string& where);

 private:
  Limits limits_;
  std::size_t left_;
};

template <class From>
From load(const char* bytes, std::endian order) {
  From number;
  std::memcpy(&number, bytes, sizeof(From));
  if (order == std::endian::native) return number;
  auto reversed = std::bit_cast<std::array<char, sizeof(From)>>(number);
  std::reverse(reversed.begin(), reversed.end());
  return std::bit_cast<From>(reversed);
}

/// Appends all numbers that the bytes hold.
template <class To>
void append_bytes(std::string_view bytes, Type type, std::endian order, std::vector<To>& to) {
  with_type(type, [&]<class From>(From) {
    const std::size_t count = bytes.size() / sizeof(From), first = to.size();
    reserve_more(to, count);
    to.resize(first + count);
    const char* from = bytes.data();
    To* out = to.data() + first;
    if (order == std::endian::native)
      for (std::size_t i = 0; i < count; ++i)
        out[i] = static_cast<To>(load<From>(from + i * sizeof(From), std::endian::native));
    else
      for (std::size_t i = 0; i < count; ++i) out[i] = static_cast<To>(load<From>(from + i * sizeof(From), order));
  });
}

/// The text up to the next blank, which is cut off with what stands before it; empty at the end.
std::string_view next_word(std::string_view& text);

/// The text up to the end of a line, which is cut off.
std::string_view next_line(std::string_view& text);

/// Without the blanks at its ends.
std::string_view trimmed(std::string_view text);

/// The number that all of a text is, with a "+" before it or not.
std::optional<double> number_in(std::string_view text);

/// What separates the cells of a line: the first of these that stands in it outside double quotes, else blanks.
char separator_of(std::string_view line, std::string_view separators = ";\t,");

/// Where the cell ends with which a text begins, in double quotes or not; npos where nothing follows it. A single blank
/// stands for any.
std::size_t end_of_cell(std::string_view text, std::string_view separator);

/// A cell without the double quotes about it.
std::string_view unquoted(std::string_view cell);

/// Appends `count` numbers and cuts them off the text. Throws Unreadable.
template <class To>
void append_text(std::string_view& text, std::size_t count, Type type, const std::string& where, std::vector<To>& to) {
  if (count > text.size() / 2 + 1)  // a digit and a blank each
    refuse(where, "ends within its numbers, expected " + std::to_string(count));
  if (to.empty()) to.reserve(count);
  with_type(type, [&]<class From>(From number) {
    for (std::size_t i = 0; i < count; ++i) {
      std::string_view word = next_word(text);
      const std::string_view whole = word;
      if (word.starts_with('+')) word.remove_prefix(1);
      const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
      if constexpr (std::is_floating_point_v<From>)  // too small or too large for the type: 0 or infinite
        if (error == std::errc::result_out_of_range)
          number = static_cast<From>(std::strtod(std::string(word).c_str(), nullptr));
      const bool is_read =
          error == std::errc{} || (std::is_floating_point_v<From> && error == std::errc::result_out_of_range);
      if (!is_read || end != word.data() + word.size() || word.empty())
        refuse(where, "number " + std::to_string(i + 1) + " '" + std::string(whole.substr(0, 40)) + "', expected " +
                          (is_whole(type) ? "a whole number of its type" : "a number"));
      to.push_back(static_cast<To>(number));
    }
  });
}

/// A time of single precision is the shortest decimal that is stored so: 0.01, not 0.00999999977648258. Throws
/// Unreadable where it is not finite.
double time_of(double stored, Type type, const std::string& where);

/// How well the name of an array of fields says that it is the time, 0 best; none where it says so not at all.
std::optional<int> rank_as_time(std::string_view name);

/// The number that ends the name of a file before its extension: 12 of "out_12.vtp".
std::optional<long> number_of(const std::filesystem::path& file);

}  // namespace touchstone::vnv::doors

#include "vnv/doors/read/format.hpp"

#include "vnv/doors/read/parts/gzip.hpp"
#include "vnv/doors/read/parts/in_a_child.hpp"
#include "vnv/doors/read/parts/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>
#include <system_error>

namespace touchstone::vnv::doors {
namespace {

/// All bytes of a file, which are not filled before they are read.
struct Bytes {
  std::unique_ptr<char[]> held;
  std::size_t size;
};

Bytes bytes_of(const std::filesystem::path& file, const Limits& limits) {
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  if (error) throw Unreadable(fmt::format("{}: {}, expected a file", file.string(), error.message()));
  if (size > limits.most_bytes)
    throw Unreadable(fmt::format("{}: {} bytes, expected at most {}", file.string(), size, limits.most_bytes));
  Bytes bytes{std::make_unique_for_overwrite<char[]>(size), size};
  expect_to_fill(bytes.held.get(), size);
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(bytes.held.get(), static_cast<std::streamsize>(size)))
    throw Unreadable(fmt::format("{}: cannot be read: {}", file.string(), std::strerror(errno)));
  return bytes;
}

/// In the order of lists.
const std::vector<Format>& formats_in_order() {
  static const std::vector<Format> all = [] {
    std::vector<Format> made;
    for (const auto& [name, format] : all_formats()) made.push_back(format());
    std::ranges::stable_sort(made, {}, &Format::place);
    return made;
  }();
  return all;
}

/// "a, b or c".
std::string listed(const std::vector<std::string_view>& words, std::string_view before_last) {
  std::string all(words.front());
  for (std::size_t k = 1; k < words.size(); ++k) all.append(k + 1 < words.size() ? ", " : before_last).append(words[k]);
  return all;
}

}  // namespace

const Format& format_of(const std::filesystem::path& file, std::string_view bytes) {
  const auto is_it = [&](const Format& format) { return format.is_it && format.is_it(file, bytes.substr(0, 2000)); };
  const auto begins = [&](const Format& format) { return !format.begins.empty() && bytes.starts_with(format.begins); };
  const std::vector<Format>& all = formats_in_order();
  if (const auto last = std::find_if(all.rbegin(), all.rend(), is_it); last != all.rend()) return *last;
  const auto first = std::ranges::find_if(all, begins);
  return first == all.end() ? all.back() : *first;
}

std::vector<Dataset> read_as(const Format& format, const std::filesystem::path& file, std::string_view bytes,
                             const Limits& limits) {
  if (!format.may_crash) return format.read(file, bytes, limits);
  constexpr std::size_t seconds = 1, bytes_a_second = 1 << 22;  // a tenth of what libhdf5 reads at the least
  constexpr std::size_t constant = 1 << 28;                     // it allocates what a broken file claims
  return read_in_a_child(file.string(), static_cast<unsigned>(seconds + bytes.size() / bytes_a_second),
                         constant + 2 * most_that_deflate_saves * bytes.size(),
                         [&] { return format.read(file, bytes, limits); });
}

std::string formats_besides_text() {
  std::vector<std::string_view> words;
  for (const Format& format : formats_in_order()) words.push_back(format.words);
  return listed({words.begin(), words.end() - 1}, " or ");
}

std::string formats_in_help() {
  std::vector<std::string_view> words;
  for (const Format& format : formats_in_order()) words.push_back(format.help.empty() ? format.words : format.help);
  words.erase(std::unique(words.begin(), words.end()), words.end());
  return listed(words, ", and ");
}

std::vector<Dataset> read_datasets(const std::filesystem::path& file, const Limits& limits) {
  Bytes all = bytes_of(file, limits);
  const std::string_view bytes(all.held.get(), all.size);
  if (!bytes.starts_with(gzip_begins)) return read_as(format_of(file, bytes), file, bytes, limits);
  const std::string text = gunzipped(file.string(), bytes, limits);
  all.held.reset();
  return read_as(format_of(file, text), file, text, limits);
}

}  // namespace touchstone::vnv::doors

#pragma once
#include "vnv/flows/flow.hpp"

#include <fmt/format.h>

#include <charconv>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::vnv::command {

/// What stands before and behind the first "=" of each. Throws std::invalid_argument where there is none.
inline std::map<std::string, std::string> pairs_of(std::string_view option, const std::vector<std::string>& words) {
  std::map<std::string, std::string> pairs;
  for (const std::string& word : words) {
    const std::size_t equals = word.find('=');
    if (equals == word.npos || equals == 0)
      throw std::invalid_argument(fmt::format("{} '{}': expected NAME=VALUE", option, word));
    pairs[word.substr(0, equals)] = word.substr(equals + 1);
  }
  return pairs;
}

/// A number, all of the text; throws std::invalid_argument with one line.
inline double number_of(std::string_view what, std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size())
    throw std::invalid_argument(fmt::format("{} '{}': expected a number", what, text));
  return value;
}

inline Settings settings_of(const std::vector<std::string>& set) {
  std::map<std::string, double> numbers;
  for (const auto& [name, text] : pairs_of("--set", set)) numbers[name] = number_of("--set " + name, text);
  return Settings(std::move(numbers));
}

}  // namespace touchstone::vnv::command

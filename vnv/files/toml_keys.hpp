#pragma once
/// TOML files: what their keys hold, and one line that says where and what is wrong with a file that is not as it
/// should be.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::vnv::files {

/// A table of the file: gives what its keys hold, and refuses those that nobody asked for.
class Keys {
 public:
  Keys(const toml::table& table, const std::filesystem::path& file, std::string of = "")
      : table_(table), file_(file), of_(std::move(of)) {}

  bool has(const std::string& key) const { return asked_.insert(key), table_.contains(key); }

  std::string text(const std::string& key, const std::string& otherwise = "") const {
    return has(key) ? of_kind<std::string>(*table_.get(key), key, "a text") : otherwise;
  }
  double number(const std::string& key) const { return of_kind<double>(*table_.get(key), key, "a number"); }
  double positive(const std::string& key, double otherwise) const {
    if (!has(key)) return otherwise;
    const double value = number(key);
    if (!(value > 0)) refuse(*table_.get(key), key, "a number above 0");
    return value;
  }
  std::optional<double> number_if_there(const std::string& key) const {
    return has(key) ? std::optional(number(key)) : std::nullopt;
  }
  bool flag(const std::string& key) const { return has(key) && of_kind<bool>(*table_.get(key), key, "true or false"); }

  std::vector<double> numbers(const std::string& key) const { return all<double>(key, "an array of numbers"); }
  /// One text or an array of them.
  std::vector<std::string> texts(const std::string& key) const {
    if (has(key) && table_.get(key)->is_string()) return {text(key)};
    return all<std::string>(key, "a text or an array of texts");
  }

  /// The table of a key, empty if there is none.
  Keys table(const std::string& key) const {
    static const toml::table none;
    if (!has(key)) return {none, file_, key};
    if (!table_.get(key)->is_table()) refuse(*table_.get(key), key, "a table");
    return {*table_.get(key)->as_table(), file_, key};
  }
  template <class T>
  std::map<std::string, T> pairs(const std::string& kind) const {
    std::map<std::string, T> all;
    for (const auto& [key, node] : table_) {
      asked_.emplace(key.str());
      all.emplace(key.str(), of_kind<T>(node, std::string(key.str()), kind));
    }
    return all;
  }

  /// The keys in the order of the file.
  std::vector<std::string> in_order() const {
    std::vector<std::pair<toml::source_position, std::string>> all;
    for (const auto& [key, node] : table_) all.emplace_back(key.source().begin, key.str());
    std::ranges::sort(all, [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::string> names;
    for (auto& [at, name] : all) names.push_back(std::move(name));
    return names;
  }
  /// What a key holds, or null.
  const toml::node* node(const std::string& key) const { return has(key) ? table_.get(key) : nullptr; }
  const std::filesystem::path& file() const { return file_; }

  /// Throws for a key that was not asked for.
  void require_no_other() const {
    for (const auto& [key, node] : table_)
      if (!asked_.contains(std::string(key.str())))
        throw std::invalid_argument(fmt::format("{}:{}: unknown key '{}'{}, expected one of: {}", file_.string(),
                                                key.source().begin.line, key.str(), of_.empty() ? "" : " of " + of_,
                                                fmt::join(asked_, ", ")));
  }

  [[noreturn]] void refuse(const toml::node& node, const std::string& key, std::string_view expected) const {
    std::ostringstream value;
    if (const auto number = node.value_exact<double>())
      value << fmt::format("{}", *number);  // as it was written: toml++ writes 1e-7 as 9.9999999999999995e-08
    else
      node.visit([&](const auto& held) { value << held; });
    throw std::invalid_argument(fmt::format("{}:{}: {}{} = {}, expected {}", file_.string(), node.source().begin.line,
                                            of_.empty() ? "" : of_ + ".", key, value.str(), expected));
  }
  void require(const std::string& key, std::string_view example) const {
    if (!has(key))
      throw std::invalid_argument(fmt::format("{}: no key '{}'{}, expected one such as {} = {}", file_.string(), key,
                                              of_.empty() ? "" : " of " + of_, key, example));
  }

 private:
  template <class T>
  T of_kind(const toml::node& node, const std::string& key, std::string_view expected) const {
    const std::optional<T> value = node.value<T>();
    if (!value) refuse(node, key, expected);
    return *value;
  }
  template <class T>
  std::vector<T> all(const std::string& key, std::string_view expected) const {
    std::vector<T> values;
    if (!has(key)) return values;
    const toml::array* array = table_.get(key)->as_array();
    if (!array || array->empty()) refuse(*table_.get(key), key, expected);
    for (const toml::node& node : *array) values.push_back(of_kind<T>(node, key, expected));
    return values;
  }

  const toml::table& table_;
  const std::filesystem::path& file_;
  std::string of_;
  mutable std::set<std::string> asked_{};
};

/// Throws std::invalid_argument: file, line and what is wrong.
inline toml::table parsed_toml(const std::filesystem::path& file) try {
  if (!std::filesystem::is_regular_file(file))
    throw std::invalid_argument(fmt::format("{}: no such file", file.string()));
  return toml::parse_file(file.string());
} catch (const toml::parse_error& error) {
  throw std::invalid_argument(fmt::format("{}:{}: {}", file.string(), error.source().begin.line, error.description()));
}

}  // namespace touchstone::vnv::files

#pragma once
/// How a struct becomes JSON and is read back, for all that the project writes: TOUCHSTONE_FIELDS names its fields
/// once, so that writer and reader cannot disagree. What does not fit is refused by its place: "runs[2].cost.cpu".

#include "vnv/files/tables.hpp"
#include "vnv/record/word_of.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/preprocessor/seq/for_each.hpp>
#include <boost/preprocessor/stringize.hpp>
#include <boost/preprocessor/tuple/elem.hpp>
#include <boost/preprocessor/variadic/to_seq.hpp>
#include <cmath>
#include <concepts>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

/// In the namespace of the struct: TOUCHSTONE_FIELDS(Cost, particles, steps, cpu).
#define TOUCHSTONE_FIELDS(Type, ...)                                          \
  void describe(auto& field, ::touchstone::vnv::json::A<Type> auto& object) { \
    TOUCHSTONE_EACH_FIELD(field, object, __VA_ARGS__)                         \
  }
/// The same for what belongs to a case, its `case_name`: JSON calls that "case", as C++ lets no member be called.
#define TOUCHSTONE_FIELDS_OF_A_CASE(Type, ...)                                \
  void describe(auto& field, ::touchstone::vnv::json::A<Type> auto& object) { \
    field("case", object.case_name);                                          \
    TOUCHSTONE_EACH_FIELD(field, object, __VA_ARGS__)                         \
  }
#define TOUCHSTONE_EACH_FIELD(field, object, ...) \
  BOOST_PP_SEQ_FOR_EACH(TOUCHSTONE_FIELD, (field, object), BOOST_PP_VARIADIC_TO_SEQ(__VA_ARGS__))
#define TOUCHSTONE_FIELD(r, field_and_object, name) \
  BOOST_PP_TUPLE_ELEM(0, field_and_object)          \
  (BOOST_PP_STRINGIZE(name), BOOST_PP_TUPLE_ELEM(1, field_and_object).name);

namespace touchstone::vnv::json {

using Json = nlohmann::ordered_json;

template <class T, class Plain>
concept A = std::same_as<std::remove_const_t<T>, Plain>;
/// Its words, in the order of its enumerators, are `words(value)`.
template <class T>
concept Enumeration = std::is_enum_v<T>;
template <class T>
concept Struct = std::is_class_v<T>;

/// What does not fit, and where.
struct Misfit {
  std::string where, what;

  std::string sentence() const { return where.empty() ? what : where + " " + what; }
  /// The same, seen from one level above: `name` is "cost", or "[2]".
  Misfit within(const std::string& name) const {
    const bool joined = where.empty() || where.front() == '[';
    return {name + (joined ? "" : ".") + where, what};
  }
};

inline void require(bool fits, const Json& found, std::string_view expected) {
  if (!fits) throw Misfit{"", fmt::format("is {}, expected {}", found.dump().substr(0, 60), expected)};
}

/// JSON has no number that is not finite: these are texts.
inline std::optional<double> not_finite(const Json& json) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (json == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (json == "inf") return infinity;
  if (json == "-inf") return -infinity;
  return std::nullopt;
}

class Writer {
 public:
  void operator()(const char* name, const auto& value) { object_[name] = json(value); }
  const Json& object() const { return object_; }

  static Json json(const std::string& text) { return text; }
  static Json json(bool value) { return value; }
  static Json json(std::integral auto value) { return value; }
  static Json json(double value) {
    if (std::isfinite(value)) return value;
    if (std::isnan(value)) return "nan";
    return value > 0 ? "inf" : "-inf";
  }
  static Json json(const std::optional<double>& value) { return value ? json(*value) : Json(nullptr); }
  static Json json(const std::variant<std::string, double>& cell) {
    return std::visit([](const auto& value) { return json(value); }, cell);
  }
  static Json json(Enumeration auto value) { return word_of(value); }
  template <class T>
  static Json json(const std::vector<T>& list) {
    Json array = Json::array();
    for (const auto& item : list) array.push_back(json(item));
    return array;
  }
  template <class T>
  static Json json(const std::map<std::string, T>& items) {
    Json object = Json::object();
    for (const auto& [name, item] : items) object[name] = json(item);
    return object;
  }
  static Json json(const Struct auto& value) {
    Writer writer;
    describe(writer, value);
    return std::move(writer.object_);
  }

 private:
  Json object_ = Json::object();
};

class Reader {
 public:
  explicit Reader(const Json& object) : object_(object) { require(object.is_object(), object, "an object"); }

  void operator()(const char* name, auto& value) const {
    const auto found = object_.find(name);
    if (found == object_.end()) throw Misfit{name, "is not there"};
    read_within(name, *found, value);
  }

  static void read(const Json& json, std::string& text) {
    require(json.is_string(), json, "a text");
    text = json;
  }
  static void read(const Json& json, bool& value) {
    require(json.is_boolean(), json, "true or false");
    value = json;
  }
  static void read(const Json& json, std::integral auto& value) {
    require(json.is_number_integer(), json, "a whole number");
    value = json;
  }
  static void read(const Json& json, double& value) {
    const std::optional<double> special = not_finite(json);
    require(json.is_number() || special, json, "a number");
    value = special ? *special : json.get<double>();
  }
  static void read(const Json& json, std::optional<double>& value) {
    if (json.is_null()) return value.reset();
    read(json, value.emplace());
  }
  // A cell with the text "nan" comes back as the number, and looks the same.
  static void read(const Json& json, std::variant<std::string, double>& cell) {
    if (json.is_string() && !not_finite(json)) return read(json, cell.emplace<std::string>());
    read(json, cell.emplace<double>());
  }
  static void read(const Json& json, Enumeration auto& value) {
    std::string word;
    read(json, word);
    const auto known = words(value);
    const auto found = std::find(known.begin(), known.end(), word);
    require(found != known.end(), json, fmt::format("one of {}", fmt::join(known, ", ")));
    value = static_cast<std::remove_cvref_t<decltype(value)>>(found - known.begin());
  }
  template <class T>
  static void read(const Json& json, std::vector<T>& list) {
    require(json.is_array(), json, "a list");
    list.resize(json.size());
    for (std::size_t i = 0; i < list.size(); ++i) read_within(i, json[i], list[i]);
  }
  template <class T>
  static void read(const Json& json, std::map<std::string, T>& items) {
    require(json.is_object(), json, "an object");
    for (const auto& [name, item] : json.items()) read_within(name, item, items[name]);
  }
  static void read(const Json& json, Struct auto& value) {
    const Reader reader(json);
    describe(reader, value);
  }

 private:
  /// `place` is a name, or the number of an item, spelled only when it is needed: a cloud has a hundred thousand.
  static void read_within(const auto& place, const Json& json, auto& value) {
    try {
      read(json, value);
    } catch (const Misfit& misfit) {
      constexpr bool is_number = std::integral<std::remove_cvref_t<decltype(place)>>;
      throw misfit.within(fmt::format(is_number ? "[{}]" : "{}", place));
    }
  }

  const Json& object_;
};

/// Throws Misfit for what is nested deeper than anything of ours: who writes or copies a value calls itself at each level.
inline Json parsed(const std::string& text) {
  constexpr int deepest = 64;
  return Json::parse(text, [=](int depth, Json::parse_event_t, const Json&) {
    if (depth > deepest) throw Misfit{"", fmt::format("is nested deeper than {} levels", deepest)};
    return true;
  });
}

/// What reads or writes JSON, with what it throws as std::runtime_error in one line: "FILE: not a complete record: ..."
auto with_clear_errors(const std::string& file, const std::string& what_else, const auto& work) {
  try {
    return work();
  } catch (const Json::exception& error) {
    const std::string message = error.what();  // opens with "[json.exception.parse_error.101] "
    throw BadData(file, 0, fmt::format("{}: {}", what_else, message.substr(message.find("] ") + 2)));
  } catch (const Misfit& misfit) {
    throw BadData(file, 0, misfit.sentence());
  }
}

}  // namespace touchstone::vnv::json

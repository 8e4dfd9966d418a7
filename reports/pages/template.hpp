#pragma once
/// Pages are mustache templates, which stand in templates/, are compiled in, and are filled with data.

#include "reports/text/notation.hpp"

#include <kainjow/mustache.hpp>

#include <cmath>
#include <concepts>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace touchstone::reports {

/// style.css, site.js and the templates, by their file names.
extern const std::map<std::string, std::string_view, std::less<>> compiled_in;

/// What a name of a template stands for: a text, a truth, an object or a list.
using Data = kainjow::mustache::data;
using List = kainjow::mustache::list;

/// A value as data; numbers as in print.
template <class T>
Data data_of(const T& value) {
  if constexpr (std::floating_point<T>)
    return printed(value);
  else if constexpr (std::integral<T> && !std::same_as<T, bool>)
    return printed(static_cast<long>(value));
  else
    return value;
}
inline Data data_of(Data value) { return value; }

/// "method"_ = record.method, as an argument of `object`.
struct Entry {
  const char* name;
  Data value;
};
struct EntryName {
  const char* name;
  Entry operator=(auto&& value) const { return {name, data_of(std::forward<decltype(value)>(value))}; }
};
constexpr EntryName operator""_(const char* name, std::size_t) { return {name}; }

Data object(std::same_as<Entry> auto... entries) {
  Data all;
  ((all[entries.name] = std::move(entries.value)), ...);
  return all;
}

/// What `datum` makes of each item.
template <class Datum = std::identity>
List each(const auto& items, const Datum& datum = {}) {
  List all;
  all.reserve(std::size(items));
  for (const auto& item : items) all.push_back(data_of(datum(item)));
  return all;
}

/// A value, or false, so that a section of its name is left out.
Data when(bool is_there, const auto& value) { return is_there ? data_of(value) : Data(false); }
inline Data if_any(const std::string& text) { return when(!text.empty(), text); }
inline Data if_any(double number) { return when(!std::isnan(number), number); }
inline Data if_any(const List& items) { return when(!items.empty(), object("items"_ = items)); }

/// A text of a template with these data in it. {{name}} escapes, {{>name}} is the template of that name, and what
/// {{#typeset}}, {{#numbers}}, {{#breakable}} or {{#paragraphs}} encloses is set by the function of html.hpp.
/// Throws std::runtime_error where the template is not well formed or uses a name that is not there.
std::string filled(std::string_view text, const Data& data);

/// The template NAME.html, filled. Throws as `filled` does, naming it.
std::string page(const std::string& name, const Data& data);

}  // namespace touchstone::reports

#include "reports/pages/template.hpp"

#include "reports/text/html.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace touchstone::reports {
namespace {

namespace mustache = kainjow::mustache;

/// With the text of each template NAME in the place of {{>NAME}}. The last newline of its file is no part of it.
std::string with_partials(std::string text) {
  for (std::size_t at = text.find("{{>"); at != text.npos; at = text.find("{{>", at)) {
    const std::size_t end = text.find("}}", at);
    const std::string name = text.substr(at + 3, end - at - 3);
    const auto found = compiled_in.find(name + ".html");
    if (found == compiled_in.end()) throw std::runtime_error(fmt::format("there is no template '{}'", name));
    text.replace(at, end + 2 - at, found->second.substr(0, found->second.rfind('\n')));
  }
  return text;
}

/// Fills a text, which is parsed only once: pages have the same ones in row after row.
std::string filled(const std::string& text, mustache::context<std::string>& names) {
  static std::map<std::string, mustache::mustache> all;
  auto known = all.find(text);
  if (known == all.end()) {
    known = all.emplace(text, with_partials(text)).first;
    known->second.set_custom_escape([](const std::string& raw) { return escape(raw); });
  }
  mustache::mustache& parsed = known->second;
  if (!parsed.is_valid()) throw std::runtime_error(parsed.error_message());
  return parsed.render(names);
}

/// Where names are looked up, for which the library would put nothing where they are not there.
class Names : public mustache::context<std::string> {
 public:
  explicit Names(const Data& data)
      : filters_(object("typeset"_ = filter(typeset), "numbers"_ = filter(numbers), "breakable"_ = filter(breakable),
                        "paragraphs"_ = filter(paragraphs), "root"_ = "")) {
    push(&filters_);
    push(&data);
  }
  const Data* get(const std::string& name) const override {
    if (const Data* found = context::get(name)) return found;
    throw std::runtime_error(fmt::format("'{}' is not among the data", name));
  }

 private:
  Data filter(std::string (*set)(std::string_view)) {
    return mustache::lambda2(
        [this, set](const std::string& text, const mustache::renderer&) { return set(filled(text, *this)); });
  }

  Data filters_;
};

}  // namespace

std::string filled(std::string_view text, const Data& data) {
  Names names(data);
  return filled(std::string(text), names);
}

std::string page(const std::string& name, const Data& data) try {
  return filled(compiled_in.at(name + ".html"), data);
} catch (const std::exception& error) {
  throw std::runtime_error(fmt::format("{}.html: {}", name, error.what()));
}

}  // namespace touchstone::reports

#include "reports/pages/template.hpp"

#include "reports/text/html.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace touchstone::reports {
namespace {

namespace mustache = kainjow::mustache;

Data filter(std::string (*set)(std::string_view)) {
  return mustache::lambda2(
      [set](const std::string& text, const mustache::renderer& render) { return set(render(text)); });
}

/// Partials by their names. The last newline of their file is no part of them.
std::map<std::string, Data> partials() {
  std::map<std::string, Data> all;
  for (const auto& [file, text] : compiled_in)
    if (file.ends_with(".html"))
      all.emplace(file.substr(0, file.size() - 5), std::string(text.substr(0, text.rfind('\n'))));
  return all;
}

/// Where names are looked up, for which the library would put nothing where they are not there.
class Names : public mustache::context<std::string> {
 public:
  explicit Names(const Data& data) {
    static const Data filters = object("typeset"_ = filter(typeset), "numbers"_ = filter(numbers),
                                       "breakable"_ = filter(breakable), "paragraphs"_ = filter(paragraphs));
    push(&filters);
    push(&data);
  }
  const Data* get(const std::string& name) const override {
    if (const Data* found = context::get(name)) return found;
    throw std::runtime_error(fmt::format("'{}' is not among the data", name));
  }
  const Data* get_partial(const std::string& name) const override {
    static const std::map<std::string, Data> all = partials();
    if (const auto found = all.find(name); found != all.end()) return &found->second;
    throw std::runtime_error(fmt::format("there is no template '{}'", name));
  }
};

}  // namespace

std::string filled(std::string_view text, const Data& data) {
  mustache::mustache parsed{std::string(text)};
  parsed.set_custom_escape([](const std::string& raw) { return escape(raw); });
  Names names(data);
  const std::string html = parsed.is_valid() ? parsed.render(names) : "";
  if (!parsed.is_valid()) throw std::runtime_error(parsed.error_message());  // or a partial is not
  return html;
}

std::string page(const std::string& name, const Data& data) try {
  return filled(compiled_in.at(name + ".html"), data);
} catch (const std::exception& error) {
  throw std::runtime_error(fmt::format("{}.html: {}", name, error.what()));
}

}  // namespace touchstone::reports

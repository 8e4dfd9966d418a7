#include "vnv/command/patterns.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <functional>
#include <set>
#include <stdexcept>

namespace touchstone::vnv::command {
namespace {

std::string case_of(const std::string& name) { return name.substr(0, name.find('.')); }

bool is_glob(const std::string& pattern) { return pattern.find_first_of("*?[") != pattern.npos; }

bool fits(const std::string& pattern, const std::string& text) {
  return is_glob(pattern) ? fnmatch(pattern.c_str(), text.c_str(), 0) == 0 : text.find(pattern) != text.npos;
}

}  // namespace

std::vector<std::string> matches(const std::string& pattern, const std::vector<std::string>& names) {
  const std::function<bool(const std::string&)> ways[] = {
      [&](const std::string& name) { return name == pattern; },
      [&](const std::string& name) { return case_of(name) == pattern; },
      [&](const std::string& name) {
        return fits(pattern, name) || (is_glob(pattern) && fits(pattern, case_of(name)));
      },
  };
  std::vector<std::string> chosen;
  for (const auto& way : ways)
    if (chosen.empty()) std::ranges::copy_if(names, std::back_inserter(chosen), way);
  return chosen;
}

std::vector<std::string> chosen_by(const std::vector<std::string>& patterns, const std::vector<std::string>& names) {
  if (patterns.empty()) return names;
  std::set<std::string> expected;
  for (const std::string& pattern : patterns) {
    const std::vector<std::string> found = matches(pattern, names);
    if (found.empty())
      throw std::invalid_argument(fmt::format(
          "no method fits '{}'; expected a case, CASE.METHOD, a glob or a part of one, as `vnv list` shows them",
          pattern));
    expected.insert(found.begin(), found.end());
  }
  std::vector<std::string> chosen;
  std::ranges::copy_if(names, std::back_inserter(chosen),
                       [&](const std::string& name) { return expected.contains(name); });
  return chosen;
}

bool fits_a_case(const std::string& pattern, const std::vector<std::string>& cases) {
  return std::ranges::any_of(cases, [&](const std::string& name) { return fits(case_of(pattern), name); });
}

std::vector<std::string> possible_cases(const std::string& pattern, const std::vector<std::string>& cases) {
  const std::string part = case_of(pattern);
  if (std::ranges::find(cases, part) != cases.end()) return {part};
  if (part != pattern && !is_glob(pattern)) return cases;  // "seuille.m" is a part of names
  std::vector<std::string> possible;
  std::ranges::copy_if(cases, std::back_inserter(possible), [&](const std::string& name) { return fits(part, name); });
  return possible.empty() ? cases : possible;  // else it may be a part of the names of methods
}

}  // namespace touchstone::vnv::command

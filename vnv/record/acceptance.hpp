#pragma once
#include "vnv/files/tables.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::vnv {

/// Who accepted what, when and why: the first lines of a file of baselines or of accepted claims.
struct Acceptance {
  std::string title, revision, date, reason;
  std::vector<std::string> notes{};

  /// As those lines, and read from them; throws BadData where one of the four is missing.
  std::string text() const {
    std::string lines =
        fmt::format("# title: {}\n# revision: {}\n# date: {}\n# reason: {}\n", title, revision, date, reason);
    for (const std::string& note : notes) lines += fmt::format("# note: {}\n", note);
    return lines;
  }
  static Acceptance read(const Sheet& sheet) {
    require_keys(sheet, {"title", "revision", "date", "reason"});
    Acceptance found{sheet.key("title").value, sheet.key("revision").value, sheet.key("date").value,
                     sheet.key("reason").value};
    for (const Sheet::Key& key : sheet.keys)
      if (key.name == "note") found.notes.push_back(key.value);
    return found;
  }
};

/// What a test does must not change what it is judged by: throws std::invalid_argument where ctest has set one of these
/// for a test of its.
inline void require_no_test(std::string_view option) {
  for (const char* mark : {"DASHBOARD_TEST_FROM_CTEST", "CTEST_INTERACTIVE_DEBUG_MODE"})
    if (std::getenv(mark))
      throw std::invalid_argument(fmt::format("{}: {} is set, as in a test of ctest; expected a person", option, mark));
}

}  // namespace touchstone::vnv

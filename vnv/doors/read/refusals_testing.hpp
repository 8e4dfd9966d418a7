#pragma once
/// What readers refuse, in tests: apart from what their fuzzing targets, which know no GoogleTest, use too.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "vnv/doors/read/testing.hpp"

namespace touchstone::vnv::doors {

/// Each text is refused by the reader of a format with these words among others.
inline void expect_refusals(std::string_view format, const std::filesystem::path& file,
                            const std::vector<std::pair<std::string, std::string>>& texts) {
  for (const auto& [text, expected] : texts) {
    const std::string found = refusal([&] { read_as(format, file, text, {}); });
    EXPECT_NE(found.find(expected), std::string::npos) << text << found;
  }
}

}  // namespace touchstone::vnv::doors

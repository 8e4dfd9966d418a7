#include "reports/text/text.hpp"

#include <gtest/gtest.h>

namespace touchstone::reports {
namespace {

using Kind = Piece::Kind;

TEST(Text, FindsSymbolsAndPowersAmongWords) {
  const auto found = pieces("L2 of v_max^2, m^-1.5.");
  ASSERT_EQ(found.size(), 6u);
  EXPECT_EQ(found[1].kind, Kind::symbol);
  EXPECT_EQ(found[1].index, "max");
  EXPECT_EQ(found[2].text, "2");
  EXPECT_EQ(found[4].text, "-1.5");
  EXPECT_EQ(found[5].text, ".");
}

TEST(Text, LeavesNamesAndLoneSignsAlone) {
  for (const char* text : {"mpm_reset", "a ^ b", "_x", "v_", "v_ x", "^", "2^-"}) {
    std::string plain;
    for (const auto& piece : pieces(text))
      if (piece.kind == Kind::plain) plain += piece.text;
    EXPECT_EQ(plain, text);
  }
}

TEST(Text, KeepsEveryLetter) {
  std::string all;
  for (const auto& piece : pieces("ν·∂v_x/∂y = 10^3 {a}"))
    all += piece.kind == Kind::symbol ? piece.text + "_" + piece.index
                                      : (piece.kind == Kind::power ? "^" : "") + piece.text;
  EXPECT_EQ(all, "ν·∂v_x/∂y = 10^3 {a}");
}

TEST(Text, ReplacesEveryOccurrenceOnce) { EXPECT_EQ(replaced("a'b''", "'", "''"), "a''b''''"); }

}  // namespace
}  // namespace touchstone::reports

#include "reports/text/html.hpp"

#include <gtest/gtest.h>

namespace touchstone::reports {
namespace {

TEST(Html, EscapesWhatABrowserWouldTakeForMarkup) {
  EXPECT_EQ(escape("<b>\"A\" & 'B'</b>"), "&lt;b&gt;&quot;A&quot; &amp; &#39;B&#39;&lt;/b&gt;");
}

TEST(Html, SetsIndexAndPowerButNotTheNameOfAMethod) {
  EXPECT_EQ(typeset("v_x"), "<i>v</i><sub>x</sub>");
  EXPECT_EQ(typeset("10^-3 m^2"), "10<sup>−3</sup> m<sup>2</sup>");
  EXPECT_EQ(typeset("L2 of v_max^2, m^-1.5."), "L2 of <i>v</i><sub>max</sub><sup>2</sup>, m<sup>−1.5</sup>.");
  EXPECT_EQ(typeset("ν·∂v_x/∂y"), "ν·∂<i>v</i><sub>x</sub>/∂y");
}

TEST(Html, DoesNotPartANumberFromItsPerCent) { EXPECT_EQ(typeset("L2 = 2.51 %, limit"), "L2 = 2.51\u202f%, limit"); }

TEST(Html, LeavesNamesAndLoneSignsAlone) {
  for (const char* text : {"mpm_reset", "a ^ b", "_x", "v_", "v_ x", "^", "2^-"}) EXPECT_EQ(typeset(text), text);
}

TEST(Html, MarksWhatIsNotFiniteButNoWordThatBeginsAsThat) {
  EXPECT_EQ(numbers("<td>nan\u202f%</td>"), "<td><span class=\"nan\">nan</span>\u202f%</td>");
  EXPECT_EQ(numbers("2 ± −inf"), "2 ± <span class=\"nan\">−inf</span>");
  for (const char* text : {"<td>information</td>", "<td>nano</td>", "<td title=\"nan\">1</td>", "L2 = nan: FAILS"})
    EXPECT_EQ(numbers(text), text);
}

TEST(Html, RaisesExponentsOfNumbersAlone) {
  EXPECT_EQ(numbers("<td>−1.25\u202f×\u202f10^-7</td>"), "<td>−1.25\u202f×\u202f10<sup>−7</sup></td>");
  EXPECT_EQ(numbers("2\u202f×\u202f10^12 m_x"), "2\u202f×\u202f10<sup>12</sup> m_x");
}

TEST(Html, ReplacesEveryOccurrenceOnce) { EXPECT_EQ(replaced("a'b''", "'", "''"), "a''b''''"); }

TEST(Html, ANameMayBreakBetweenItsWords) {
  EXPECT_EQ(breakable("unit.A.SticksToBoth&lt;"), "unit.A.Sticks<wbr>To<wbr>Both&lt;");
  EXPECT_EQ(breakable("mpm_reset_"), "mpm_<wbr>reset_");
}

TEST(Html, BlankLinesPartParagraphs) {
  EXPECT_EQ(paragraphs("one\nline\n\n \nother"), "<p>one\nline</p>\n<p>other</p>\n");
  EXPECT_EQ(paragraphs("\n"), "");
}

}  // namespace
}  // namespace touchstone::reports

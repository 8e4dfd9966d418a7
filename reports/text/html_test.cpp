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

TEST(Html, EscapesAlsoWhereItTypesets) { EXPECT_EQ(typeset("v_x < 1"), "<i>v</i><sub>x</sub> &lt; 1"); }

TEST(Html, ReplacesEveryOccurrenceOnce) { EXPECT_EQ(replaced("a'b''", "'", "''"), "a''b''''"); }

TEST(Html, ANameMayBreakBetweenItsWords) {
  EXPECT_EQ(breakable("unit.A.SticksToBoth<"), "unit.A.Sticks<wbr>To<wbr>Both&lt;");
  EXPECT_EQ(breakable("mpm_reset_"), "mpm_<wbr>reset_");
}

TEST(Html, BlankLinesPartParagraphs) {
  EXPECT_EQ(paragraphs("one\nline\n\n \nother"), "<p>one\nline</p>\n<p>other</p>\n");
  EXPECT_EQ(paragraphs("\n"), "");
}

TEST(Html, ATableKeepsEveryCellAndAlignsAHeadingAsItsNumbers) {
  const std::string html = to_html({"Norms.", "", {"level", "L2"}, {{HtmlCell("M1"), HtmlCell("3.34", "number")}}});
  EXPECT_NE(html.find("<th>level</th><th class=\"number\">L2</th>"), std::string::npos) << html;
  EXPECT_NE(html.find("<td>M1</td><td class=\"number\">3.34</td>"), std::string::npos) << html;
}

TEST(Html, ACellMayReachOverRows) {
  const std::string html = to_html({"Flows.",
                                    "",
                                    {"flow", "error"},
                                    {{HtmlCell("Couette", "flow", 2), {"1", "number"}}, {{"2", "number"}}},
                                    "flows"});
  EXPECT_NE(
      html.find(
          "<tr><td class=\"flow\" rowspan=\"2\">Couette</td><td class=\"number\">1</td></tr>\n<tr><td class=\"number\">2</td></tr>"),
      std::string::npos)
      << html;
  EXPECT_NE(html.find("<th>flow</th><th class=\"number\">error</th>"), std::string::npos) << html;
  EXPECT_NE(html.find("<div class=\"table flows\">"), std::string::npos) << html;
}

TEST(Html, ATableWithoutRowsIsNone) { EXPECT_EQ(to_html({"Norms.", "", {"level"}}), ""); }

}  // namespace
}  // namespace touchstone::reports

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
  EXPECT_EQ(typeset("mpm_reset"), "mpm_reset");
}

TEST(Html, EscapesAlsoWhereItTypesets) { EXPECT_EQ(typeset("v_x < 1"), "<i>v</i><sub>x</sub> &lt; 1"); }

TEST(Html, BlankLinesPartParagraphs) {
  EXPECT_EQ(paragraphs("one\nline\n\n \nother"), "<p>one\nline</p>\n<p>other</p>\n");
  EXPECT_EQ(paragraphs("\n"), "");
}

TEST(Html, ATableKeepsEveryCell) {
  const std::string html = to_html({"Norms.", "", {{"level"}, {"L2", "number"}}, {{{"M1"}, {"3.34", "number"}}}});
  EXPECT_NE(html.find("<th>level</th><th class=\"number\">L2</th>"), std::string::npos) << html;
  EXPECT_NE(html.find("<td>M1</td><td class=\"number\">3.34</td>"), std::string::npos) << html;
}

}  // namespace
}  // namespace touchstone::reports

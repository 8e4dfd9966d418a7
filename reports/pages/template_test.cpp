#include "reports/pages/template.hpp"

#include "reports/testing.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace touchstone::reports {
namespace {

/// What is said of a template that cannot be filled; empty where it can.
std::string refusal(const std::string& text, const Data& data) {
  try {
    filled(text, data);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Template, EscapesEveryText) {
  const Data data = object("text"_ = "<b>\"A\" & 'B'</b>");
  EXPECT_EQ(filled("{{text}}", data), "&lt;b&gt;&quot;A&quot; &amp; &#39;B&#39;&lt;/b&gt;");
  EXPECT_EQ(filled("{{#typeset}}{{x}}{{/typeset}}", object("x"_ = "v_x < 1")), "<i>v</i><sub>x</sub> &lt; 1");
  EXPECT_EQ(filled("{{#breakable}}{{x}}{{/breakable}}", object("x"_ = "a_b<c")), "a_<wbr>b&lt;c");
}

TEST(Template, PutsNumbersAsInPrint) {
  const Data data = object("length"_ = 2.5e-7, "count"_ = 14400, "none"_ = if_any(vnv::not_a_number));
  EXPECT_EQ(filled("{{#numbers}}{{length}}{{/numbers}}", data), "2.5\u202f×\u202f10<sup>−7</sup>");
  EXPECT_EQ(filled("{{count}}{{#none}} and {{.}}{{/none}}", data), "14\u202f400");
}

TEST(Template, LeavesOutSectionsOfWhatIsNotThere) {
  const std::string text = "{{#list}}<ul>{{#items}}<li>{{.}}</li>{{/items}}</ul>{{/list}}{{^list}}none{{/list}}";
  EXPECT_EQ(filled(text, object("list"_ = if_any(List{"a", "b"}))), "<ul><li>a</li><li>b</li></ul>");
  EXPECT_EQ(filled(text, object("list"_ = if_any(List{}))), "none");
  EXPECT_EQ(filled("{{#text}}({{.}}){{/text}}", object("text"_ = if_any(""))), "");
}

TEST(Template, IsRefusedWhereANameIsNotAmongTheData) {
  const Data data = object("title"_ = "A", "items"_ = List{object("level"_ = "M1"), object("name"_ = "M2")});
  EXPECT_EQ(refusal("{{title}}", data), "");
  EXPECT_EQ(refusal("{{titel}}", data), "'titel' is not among the data");
  EXPECT_EQ(refusal("{{#titel}}{{/titel}}", data), "'titel' is not among the data");
  EXPECT_EQ(refusal("{{^titel}}{{/titel}}", data), "'titel' is not among the data");
  EXPECT_EQ(refusal("{{#typeset}}{{titel}}{{/typeset}}", data), "'titel' is not among the data");
  EXPECT_EQ(refusal("{{#items}}{{level}}{{/items}}", data), "'level' is not among the data") << "only of one item";
  EXPECT_EQ(refusal("{{>titel}}", data), "there is no template 'titel'");
}

TEST(Template, IsRefusedWhereItIsNotWellFormed) {
  for (const char* text : {"{{#title}}", "{{title", "{{/title}}", "{{#title}}{{/titel}}"})
    EXPECT_NE(refusal(text, object("title"_ = "A", "titel"_ = "B")), "") << text;
}

TEST(Template, OfAPageIsNamedWhereItIsRefused) {
  try {
    page("verdicts", object());
    FAIL() << "no name is there";
  } catch (const std::runtime_error& error) {
    EXPECT_TRUE(contains(error.what(), "verdicts.html: '")) << error.what();
  }
}

}  // namespace
}  // namespace touchstone::reports

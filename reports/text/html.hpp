#pragma once
/// Text and tables of a page. What comes from a record is escaped here and nowhere else.

#include <string>
#include <string_view>
#include <vector>

namespace touchstone::reports {

/// Text as HTML shows it: & < > " and ' are spelled out.
std::string escape(std::string_view text);

/// Escaped, with symbols as in print: v_x and 10^-3 get their index and power, mpm_reset stays as it is.
std::string typeset(std::string_view text);

/// Escaped paragraphs; blank lines part them.
std::string paragraphs(std::string_view text);

/// A cell of a table: finished HTML and the class by which the style sheet knows it.
struct HtmlCell {
  std::string html;
  std::string kind{};  // "number", "holds", ...; empty for words
};

/// A table with rules above and below, in a box of its own that scrolls where the page is narrower.
struct HtmlTable {
  std::string title;    // finished HTML
  std::string caption;  // finished HTML
  std::vector<HtmlCell> columns;
  std::vector<std::vector<HtmlCell>> rows;
};
std::string to_html(const HtmlTable& table);

/// A whole page. `root` leads from its folder to that of the index: "" or "../".
std::string html_page(std::string_view title, std::string_view root, std::string_view body);

}  // namespace touchstone::reports

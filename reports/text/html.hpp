#pragma once
/// Text and tables of a page. What comes from a record is escaped here and nowhere else.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace touchstone::reports {

/// Every `from` replaced by `to`.
std::string replaced(std::string text, std::string_view from, std::string_view to);

/// The symbols and powers of a text, as records write them, in another notation: v_x has an index, 10^-3 a power; the
/// method mpm_reset has neither. `symbol` and `power` are what std::regex_replace puts for them: $1 is the letter or
/// the exponent, $2 the index. A backslash before _ or ^ may stand for the escape of that notation.
std::string with_symbols(const std::string& text, const std::string& symbol, const std::string& power);

/// Text as HTML shows it: & < > " and ' are spelled out.
std::string escape(std::string_view text);

/// Escaped, with symbols as in print and no break before a %.
std::string typeset(std::string_view text);

/// An escaped name that may break after an underscore and before a capital.
std::string breakable(std::string_view name);

/// Escaped paragraphs; blank lines part them.
std::string paragraphs(std::string_view text);

/// A list of finished items, "<li>...</li>", of a kind that the style sheet knows; empty without items.
std::string html_list(std::string_view kind, const std::string& items);

/// A cell of a table: finished HTML and the class by which the style sheet knows it.
struct HtmlCell {
  std::string html;
  std::string kind;      // "number", "holds", ...; empty for text on one line
  std::size_t rows = 1;  // over which it reaches; those below begin with the next column

  HtmlCell(std::string its_html = "", std::string its_kind = "", std::size_t its_rows = 1)
      : html(std::move(its_html)), kind(std::move(its_kind)), rows(its_rows) {}
  bool is_number() const { return kind.starts_with("number"); }
  bool operator==(const HtmlCell&) const = default;
};
using HtmlRow = std::vector<HtmlCell>;

/// A cell of words, which may take several lines.
inline HtmlCell words_cell(std::string html) { return {std::move(html), "words"}; }

/// A table with rules above and below, in a box of its own that scrolls where the page is narrower.
struct HtmlTable {
  std::string title, caption;        // finished HTML
  std::vector<std::string> columns;  // finished HTML; a heading is aligned as the numbers below it
  std::vector<HtmlRow> rows{};
  std::string kind{};  // "claims", by which the style sheet knows it; empty for most
};
/// Empty for a table without rows.
std::string to_html(const HtmlTable& table);

/// A whole page. `root` leads from its folder to that of the index: "" or "../".
std::string html_page(std::string_view title, std::string_view root, std::string_view body);

/// A page beside the index, which it leads back to by `path`. `sum` is what is said first, finished HTML.
std::string html_page_beside_index(std::string_view title, std::string_view path, std::string_view sum,
                                   std::string_view body, std::string_view main_attributes = "");

}  // namespace touchstone::reports

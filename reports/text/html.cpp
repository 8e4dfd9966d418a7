#include "reports/text/html.hpp"

#include "reports/text/text.hpp"

#include <fmt/format.h>

#include <sstream>

namespace touchstone::reports {
namespace {

std::string_view spelled(const char& letter) {
  switch (letter) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return {&letter, 1};
  }
}

std::string row(const std::vector<HtmlCell>& cells, std::string_view tag) {
  std::string html;
  for (const auto& cell : cells)
    html += fmt::format("<{0}{1}>{2}</{0}>", tag, cell.kind.empty() ? "" : " class=\"" + cell.kind + "\"", cell.html);
  return fmt::format("<tr>{}</tr>\n", html);
}

}  // namespace

std::string escape(std::string_view text) {
  std::string html;
  for (const char& letter : text) html += spelled(letter);
  return html;
}

std::string typeset(std::string_view text) {
  std::string html;
  for (const auto& piece : pieces(text)) {
    if (piece.kind == Piece::Kind::plain) html += escape(piece.text);
    if (piece.kind == Piece::Kind::symbol) html += fmt::format("<i>{}</i><sub>{}</sub>", piece.text, piece.index);
    if (piece.kind == Piece::Kind::power) html += fmt::format("<sup>{}</sup>", replaced(piece.text, "-", "−"));
  }
  return html;
}

std::string paragraphs(std::string_view text) {
  std::istringstream lines{std::string(text)};
  std::string html, paragraph;
  const auto close = [&] {
    if (!paragraph.empty()) html += fmt::format("<p>{}</p>\n", typeset(paragraph));
    paragraph.clear();
  };
  for (std::string line; std::getline(lines, line);) {
    if (line.find_first_not_of(" \t\r") == std::string::npos)
      close();
    else
      paragraph += (paragraph.empty() ? "" : "\n") + line;
  }
  close();
  return html;
}

std::string to_html(const HtmlTable& table) {
  std::string body;
  for (const auto& cells : table.rows) body += row(cells, "td");
  return fmt::format(
      "<div class=\"table\">\n<p class=\"caption\"><b>{}</b> {}</p>\n"
      "<div class=\"scroll\" "
      "tabindex=\"0\">\n<table>\n<thead>\n{}</thead>\n<tbody>\n{}</tbody>\n</table>\n</div>\n</div>\n",
      table.title, table.caption, row(table.columns, "th"), body);
}

std::string html_page(std::string_view title, std::string_view root, std::string_view body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{0}</title>\n<link rel=\"stylesheet\" href=\"{1}style.css\">\n<script src=\"{1}site.js\" defer></script>\n</head>\n<body>\n{2}</body>\n</html>\n",
      escape(title), root, body);
}

}  // namespace touchstone::reports

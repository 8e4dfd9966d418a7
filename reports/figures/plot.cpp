#include "reports/figures/plot.hpp"

#include "reports/text/text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace touchstone::reports {
namespace {

// What enhanced text would take for a command; a last space would be lost before other letters.
std::string escaped(const std::string& text) {
  std::string plain;
  for (const char letter : text) {
    if (std::string_view("\\{}@&~_^").find(letter) != std::string_view::npos) plain += '\\';
    plain += letter;
  }
  if (plain.ends_with(' ')) plain.replace(plain.size() - 1, 1, "\u00a0");
  return plain;
}

}  // namespace

std::string gnuplot_string(std::string_view text) {
  std::string quoted;
  for (const char letter : text) {
    if (letter == '\'') quoted += '\'';
    quoted += static_cast<unsigned char>(letter) < ' ' ? ' ' : letter;
  }
  return "'" + quoted + "'";
}

std::string gnuplot_label(std::string_view text) {
  std::string label;
  for (const auto& piece : pieces(text)) {
    if (piece.kind == Piece::Kind::plain) label += escaped(piece.text);
    if (piece.kind == Piece::Kind::symbol) label += fmt::format("{{/:Italic {}}}_{{{}}}", piece.text, piece.index);
    if (piece.kind == Piece::Kind::power) label += fmt::format("^{{{}}}", replaced(piece.text, "-", "−"));
  }
  return label;
}

std::string gnuplot_number(double value) { return std::isnan(value) ? "nan" : fmt::format("{:.9g}", value); }

}  // namespace touchstone::reports

#include "reports/text/text.hpp"

#include <cctype>

namespace touchstone::reports {
namespace {

bool is_word(std::string_view text, std::size_t i) {
  return i < text.size() && (std::isalnum(static_cast<unsigned char>(text[i])) || text[i] == '_');
}
bool is_alphanumeric(std::string_view text, std::size_t i) { return is_word(text, i) && text[i] != '_'; }

bool starts_symbol(std::string_view text, std::size_t i) {
  const bool is_alone = i == 0 || !is_word(text, i - 1);
  return is_alone && std::isalpha(static_cast<unsigned char>(text[i])) && text.substr(i + 1, 1) == "_" &&
         is_alphanumeric(text, i + 2);
}

std::size_t end_of_index(std::string_view text, std::size_t i) {
  while (is_alphanumeric(text, i)) ++i;
  return i;
}

// A full stop belongs to the exponent only inside it.
std::size_t end_of_exponent(std::string_view text, std::size_t i) {
  if (text.substr(i, 1) == "-") ++i;
  while (is_alphanumeric(text, i) || (text.substr(i, 1) == "." && is_alphanumeric(text, i + 1))) ++i;
  return i;
}

bool starts_power(std::string_view text, std::size_t i) {
  return text[i] == '^' &&
         (is_alphanumeric(text, i + 1) || (text.substr(i + 1, 1) == "-" && is_alphanumeric(text, i + 2)));
}

void add_plain(std::vector<Piece>& all, char letter) {
  if (all.empty() || all.back().kind != Piece::Kind::plain) all.push_back({Piece::Kind::plain, ""});
  all.back().text += letter;
}

}  // namespace

std::vector<Piece> pieces(std::string_view text) {
  std::vector<Piece> all;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i + 1;
    if (starts_symbol(text, i)) {
      end = end_of_index(text, i + 2);
      all.push_back({Piece::Kind::symbol, std::string(1, text[i]), std::string(text.substr(i + 2, end - i - 2))});
    } else if (starts_power(text, i)) {
      end = end_of_exponent(text, i + 1);
      all.push_back({Piece::Kind::power, std::string(text.substr(i + 1, end - i - 1))});
    } else {
      add_plain(all, text[i]);
    }
    i = end;
  }
  return all;
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

}  // namespace touchstone::reports

#include "reports/paper/latex.hpp"

#include "reports/text/html.hpp"
#include "reports/text/notation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace touchstone::reports {
namespace {

std::string escaped(char letter) {
  const auto is_of = [&](std::string_view letters) { return letters.find(letter) != letters.npos; };
  if (letter == '\\') return "\\textbackslash{}";
  if (letter == '~') return "\\textasciitilde{}";
  if (letter == '"') return "''";
  if (is_of("<>|")) return fmt::format("${}$", letter);
  if (is_of("&%$#{}_^")) return fmt::format("\\{}", letter);  // the last two for `with_symbols`
  return static_cast<unsigned char>(letter) < ' ' ? " " : std::string(1, letter);
}

/// What no font of LaTeX has under its own number.
std::string with_signs(std::string text) {
  for (const auto& [letter, command] : {std::pair{"≤", "$\\le$"},
                                        {"≥", "$\\ge$"},
                                        {"±", "$\\pm$"},
                                        {"×", "$\\times$"},
                                        {"−", "$-$"},
                                        {"∞", "$\\infty$"},
                                        {"≈", "$\\approx$"},
                                        {"ν", "$\\nu$"},
                                        {"ρ", "$\\rho$"},
                                        {"δ", "$\\delta$"},
                                        {"ω", "$\\omega$"},
                                        {"²", "\\textsuperscript{2}"},
                                        {"³", "\\textsuperscript{3}"},
                                        {"⁻¹", "\\textsuperscript{$-$1}"},
                                        {"µ", "\\textmu{}"},
                                        {"μ", "\\textmu{}"},
                                        {"°", "\\textdegree{}"},
                                        {"–", "--"},
                                        {"…", "\\dots{}"},
                                        {"\u202f", "\\,"},
                                        {"\u00a0", "~"}})
    text = replaced(std::move(text), letter, command);
  return text;
}

std::string row_of(const std::vector<std::string>& cells, std::string_view space = "") {
  return fmt::format("{} \\\\{}\n", fmt::join(cells, " & "), space);
}

}  // namespace

std::string latex(std::string_view text) {
  std::string all;
  for (const char letter : text) all += escaped(letter);
  all = with_symbols(all, "$$$1_{\\mathrm{$2}}$$", "\\textsuperscript{$1}");
  return with_signs(replaced(std::move(all), "\\^", "\\textasciicircum{}"));
}

std::string latex(double value) {
  const std::string number = plain(value);
  const auto e = number.find('e');
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "$\\infty$" : "$-\\infty$";
  if (e == std::string::npos) return fmt::format("${}$", number);
  return fmt::format("${{{}\\times10^{{{}}}}}$", number.substr(0, e), std::stoi(number.substr(e + 1)));
}

std::string to_latex(const LatexTable& table) {
  std::string alignment, body, title;
  std::vector<std::string> headings;
  for (const LatexTable::Column& column : table.columns) {
    alignment +=
        fmt::format(">{{\\raggedright\\arraybackslash}}p{{\\dimexpr {:.3g}\\linewidth-2\\tabcolsep}}", column.width);
    headings.push_back(latex(column.heading));
    title += column.heading;
  }
  for (const LatexTable::Group& group : table.groups) {
    body += body.empty() ? "" : "\\addlinespace\n";
    if (!group.title.empty())
      body += fmt::format("\\multicolumn{{{}}}{{@{{}}l}}{{\\textit{{{}}}}} \\\\*\n", table.columns.size(), group.title);
    for (const auto& cells : group.rows) body += row_of(cells, "[1.5pt]");
  }
  return fmt::format(
      "% \\usepackage{{array,booktabs,longtable}}\n\\begingroup\\scriptsize\\setlength{{\\tabcolsep}}{{2pt}}\n"
      "\\renewcommand{{\\_}}{{\\textunderscore\\allowbreak}}\n\\begin{{longtable}}{{{}}}\n\\toprule\n{}\\endhead\n"
      "\\bottomrule\n\\endfoot\n{}\\end{{longtable}}\n\\endgroup\n",
      alignment, title.empty() ? "" : row_of(headings) + "\\midrule\n", body);
}

}  // namespace touchstone::reports

#include "reports/pages/verdicts.hpp"

#include "reports/text/numbers.hpp"
#include "reports/text/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace touchstone::reports {
namespace {

// The plain text of a limit, with the signs of print.
std::string limit_html(const vnv::Verdict& verdict) {
  return replaced(replaced(replaced(limit(verdict), "<=", "≤"), ">=", "≥"), "-", "−");
}

HtmlCell optional_number(double value) { return {std::isnan(value) ? "" : printed(value), "number"}; }

std::vector<HtmlCell> verdict_row(const vnv::Verdict& v) {
  const std::string unit = v.unit.empty() ? "" : "\u202f" + typeset(v.unit);
  return {outcome_cell(v.outcome),
          {escape(v.method)},
          {escape(v.level)},
          optional_number(v.spacing * 1e3),
          optional_number(v.time),
          {typeset(v.quantity), "words"},
          {valued(v.value, v.unit), "number"},
          {limit_html(v) + unit, "number"},
          {has_margin(v) ? margin_bar(v.margin) : ""},
          {escape(v.author), "words"}};
}

std::string complaint_list(const std::vector<vnv::Verdict>& verdicts, vnv::Outcome outcome) {
  std::string items;
  for (const auto& verdict : verdicts)
    if (verdict.outcome == outcome) items += fmt::format("<li>{}</li>\n", typeset(verdict.sentence));
  return items.empty() ? "" : fmt::format("<ul class=\"{}\">\n{}</ul>\n", word(outcome), items);
}

}  // namespace

std::string sentence(const Tally& t) {
  if (t.total() == 0) return "Nothing is claimed.";
  std::string text = fmt::format("{} of {} {} {}", t.holds, t.total(), t.total() == 1 ? "claim" : "claims",
                                 t.holds == 1 ? "holds" : "hold");
  if (t.fails > 0) text += fmt::format(", {} {}", t.fails, t.fails == 1 ? "fails" : "fail");
  if (t.inconclusive > 0)
    text += fmt::format(", {} {} inconclusive", t.inconclusive, t.inconclusive == 1 ? "is" : "are");
  return text + ".";
}

HtmlCell outcome_cell(vnv::Outcome outcome) { return {word(outcome), word(outcome)}; }

std::string margin_bar(double margin) {
  const double filled = std::isfinite(margin) ? std::min(1.0, std::abs(margin)) : 1;
  return fmt::format("<span class=\"bar{}\"><i style=\"width:{:.0f}%\"></i></span>{}", margin >= 0 ? "" : " over",
                     100 * filled, in_percent(margin));
}

std::string complaints(const std::vector<vnv::Verdict>& verdicts) {
  return complaint_list(verdicts, vnv::Outcome::fails) + complaint_list(verdicts, vnv::Outcome::inconclusive);
}

std::string verdict_table(const std::vector<vnv::Verdict>& verdicts) {
  HtmlTable table{
      "Claims.",
      "The margin is the unused fraction of the limit, negative where the claim fails. The author of each limit "
      "is given.",
      {{"verdict"},
       {"method"},
       {"level"},
       {"spacing [mm]", "number"},
       {"time [s]", "number"},
       {"quantity"},
       {"value", "number"},
       {"limit", "number"},
       {"margin"},
       {"limit set by"}},
      {}};
  for (const auto& verdict : verdicts) table.rows.push_back(verdict_row(verdict));
  return to_html(table);
}

}  // namespace touchstone::reports

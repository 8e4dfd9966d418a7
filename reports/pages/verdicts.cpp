#include "reports/pages/verdicts.hpp"

#include "reports/text/notation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace touchstone::reports {
namespace {

const std::vector<std::string> claim_columns{"outcome",  "method", "level", "spacing [mm]", "quantity",
                                             "time [s]", "value",  "limit", "margin",       "limit set by"};

/// What a comparison is of and, where its error was diagnosed, what explains that.
std::string quantity_html(const vnv::Record& record, const vnv::Verdict& v) {
  const vnv::Diagnosis* found = vnv::diagnosis_of(v, record);
  return typeset(v.quantity) +
         (found ? fmt::format(" <small class=\"diagnosis\">{}</small>", escape(found->sentence)) : "");
}

HtmlRow verdict_row(const vnv::Record& record, const vnv::Verdict& v) {
  const std::string unit = v.unit.empty() ? "" : "\u202f" + typeset(v.unit);
  return {outcome_cell(v),
          breakable(v.method),
          level_cell(v.level),
          number_or_blank_cell(v.spacing * 1e3),
          words_cell(quantity_html(record, v)),
          number_or_blank_cell(v.time),
          HtmlCell(valued(v.value, v.unit), "number"),
          HtmlCell(replaced(replaced(printed_limit(v.lower, v.upper) + unit, " ", "\u00a0"), ",\u00a0", ", "),
                   "number limit"),
          HtmlCell(has_margin(v) ? margin_bar(v.margin) : "", "number"),
          words_cell(escape(v.author))};
}

std::string claims_html(const CaseRecords& records, const std::string& title, const std::string& text) {
  HtmlTable table{title, text, claim_columns, {}, "claims"};
  for_each(records, &vnv::Record::verdicts,
           [&](const auto& record, const auto& verdict) { table.rows.push_back(verdict_row(record, verdict)); });
  return to_html(table);
}

constexpr const char* caption =
    "The margin is the fraction of the limit that is left; negative where the claim fails. Who set a limit stands beside "
    "it.";

}  // namespace

std::string sentence(const Tally& t) {
  if (t.total() == 0) return "Nothing is claimed.";
  std::string text = fmt::format("{} of {} {}", t.holds, counted(t.total(), "claim"), t.holds == 1 ? "holds" : "hold");
  if (t.fails > 0) text += fmt::format(", {} {}", t.fails, t.fails == 1 ? "fails" : "fail");
  if (t.inconclusive > 0)
    text += fmt::format(", {} {} inconclusive", t.inconclusive, t.inconclusive == 1 ? "is" : "are");
  std::string authors;
  if (t.theory > 0) authors = fmt::format(" Theory set the limits of {}", printed(long{t.theory}));
  if (t.literature > 0)
    authors += fmt::format("{} {}", authors.empty() ? " Literature set the limits of" : ", literature of",
                           printed(long{t.literature}));
  if (t.baseline > 0)
    authors += fmt::format("{} {} {} no more than that values are as last accepted", authors.empty() ? "" : ";",
                           printed(long{t.baseline}), t.baseline == 1 ? "says" : "say");
  return text + "." + authors + ".";
}

HtmlCell outcome_cell(const vnv::Verdict& v) {
  if (v.outcome == vnv::Outcome::holds && v.author.starts_with("baseline")) return {"as accepted", "accepted"};
  return {word(v.outcome), word(v.outcome)};
}

std::string margin_bar(double margin) {
  const double filled = std::isfinite(margin) ? std::min(1.0, std::abs(margin)) : 1;
  return fmt::format("<span class=\"bar{}\"><i style=\"width:{:.0f}%\"></i></span>{}", margin >= 0 ? "" : " over",
                     100 * filled, in_percent(margin));
}

std::string list_of(vnv::Outcome outcome, const std::vector<vnv::Verdict>& verdicts) {
  std::string items;
  for (const auto& verdict : verdicts)
    if (verdict.outcome == outcome) items += fmt::format("<li>{}</li>\n", typeset(verdict.sentence));
  return html_list(word(outcome), items);
}

std::string verdict_table(const CaseRecords& records) { return claims_html(records, "Claims.", caption); }

std::string diagnosis_table(const CaseRecords& records) {
  HtmlTable table{
      "What explains the errors.",
      "Possible causes, each fitted by least squares to the difference from the exact field, with its 95\u202f% "
      "interval and the share of the squared error that it explains. The causes listed for one field and level cannot "
      "be distinguished by these data.",
      {"method", "level", "field", "error [%]", "fitted", "explained [%]"}};
  for_each(records, &vnv::Record::diagnoses, [&](const vnv::Record& record, const vnv::Diagnosis& found) {
    for (const vnv::Explanation& one : found.explanations) {
      if (!one.named && &one != &found.explanations.front()) continue;  // the best is shown where none suffices
      std::string fitted;
      for (const vnv::FittedCause& c : one.causes)
        fitted +=
            (fitted.empty() ? "" : ", ") + escape(c.cause) +
            (c.unit.empty() ? "" : fmt::format(" {}\u202f{}", replaced(vnv::in_digits(c), "-", "−"), escape(c.unit)));
      table.rows.push_back(
          {breakable(record.method), level_cell(found.level), escape(found.field), number_cell(found.error),
           words_cell(fitted + (one.named ? "" : " <small>does not suffice</small>")), number_cell(100 * one.share)});
    }
  });
  return to_html(table);
}

std::string verdicts_page(const std::vector<CaseRecords>& cases) {
  std::string tables;
  for (const CaseRecords& records : cases) {
    const std::string& name = records.name;
    const std::size_t rows = verdicts_of(records).size();
    // A browser lays out what is near the window alone, and takes this height for the rest.
    tables +=
        fmt::format("<section style=\"contain-intrinsic-size:auto {}rem\">\n{}</section>\n", 4 + 3 * rows,
                    claims_html(records, fmt::format("<a href=\"{}/index.html\">{}</a>.", name, breakable(name)), ""));
  }
  const Tally sum = tally(verdicts_of(cases));
  return html_page_beside_index(
      "Verdicts", "verdicts", fmt::format("<p class=\"sum {}\">{}</p>\n", word(sum.worst()), sentence(sum)),
      "<p>Every claim of every method: the value that was computed, the limit that it is held against, and who set that "
      "limit: theory, literature or the value last accepted (baseline). " +
          std::string(caption) + "</p>\n<div class=\"wide filtered\">\n" + tables +
          "</div>\n"
          "<p class=\"files\">Table for other programs: <a href=\"verdicts.csv\">verdicts</a></p>\n");
}

}  // namespace touchstone::reports

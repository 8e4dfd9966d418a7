#include "reports/pages/verdicts.hpp"

#include "reports/text/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace touchstone::reports {
namespace {

/// "23 %" with a bar of that fraction of the limit; of the other colour if the claim fails.
Data margin_data(double margin) {
  const double filled = std::isfinite(margin) ? std::min(1.0, std::abs(margin)) : 1;
  return object("over"_ = !(margin >= 0), "filled"_ = fmt::format("{:.0f}", 100 * filled),
                "text"_ = in_percent(margin));
}

/// A baseline that holds does not say that a method is right.
Data claim(const vnv::Record& record, const vnv::Verdict& v) {
  const bool is_accepted = v.outcome == vnv::Outcome::holds && v.author.starts_with("baseline");
  const vnv::Diagnosis* found = vnv::diagnosis_of(v, record);
  const std::string limit = printed_limit(v.lower, v.upper) + (v.unit.empty() ? "" : "\u202f" + v.unit);
  return object("holds"_ = v.outcome == vnv::Outcome::holds, "kind"_ = is_accepted ? "accepted" : word(v.outcome),
                "outcome"_ = is_accepted ? "as accepted" : word(v.outcome), "method"_ = v.method,
                "level"_ = level(v.level), "spacing"_ = if_any(v.spacing * 1e3), "quantity"_ = v.quantity,
                "diagnosis"_ = if_any(found ? found->sentence : ""), "time"_ = if_any(v.time),
                "value"_ = valued(v.value, v.unit),
                "limit"_ = replaced(replaced(limit, " ", "\u00a0"), ",\u00a0", ", "),
                "margin"_ = when(has_margin(v), margin_data(v.margin)), "author"_ = v.author);
}

/// "viscosity −5.1 ± 0.5 %, time 2.0 ± 1.0 s"
std::string fitted(const std::vector<vnv::FittedCause>& causes) {
  std::string text;
  for (const vnv::FittedCause& c : causes)
    text += (text.empty() ? "" : ", ") + c.cause +
            (c.unit.empty() ? "" : " " + replaced(vnv::in_digits(c), "-", "−") + "\u202f" + c.unit);
  return text;
}

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

Data level(const std::string& name) { return object("name"_ = name, "is_long"_ = name.size() > 16); }

List sentences(vnv::Outcome outcome, const std::vector<vnv::Verdict>& verdicts) {
  List items;
  for (const auto& verdict : verdicts)
    if (verdict.outcome == outcome) items.push_back(object("text"_ = verdict.sentence, "note"_ = false));
  return items;
}

Data claims_data(const CaseRecords& records) { return rows_of(records, &vnv::Record::verdicts, claim); }

Data diagnoses_data(const CaseRecords& records) {
  List items;
  for_each(records, &vnv::Record::diagnoses, [&](const vnv::Record& record, const vnv::Diagnosis& found) {
    for (const vnv::Explanation& one : found.explanations)
      if (one.named || &one == &found.explanations.front())  // the best is shown where none suffices
        items.push_back(object("method"_ = record.method, "level"_ = level(found.level), "field"_ = found.field,
                               "error"_ = found.error, "fitted"_ = fitted(one.causes), "suffices"_ = one.named,
                               "explained"_ = 100 * one.share));
  });
  return if_any(items);
}

}  // namespace touchstone::reports

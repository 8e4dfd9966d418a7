#include "reports/pages/case_page.hpp"

#include "reports/pages/case_tables.hpp"
#include "reports/pages/order_matrix.hpp"
#include "reports/pages/verdicts.hpp"
#include "reports/text/notation.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace touchstone::reports {
namespace {

std::string section(const std::string& title, const std::string& body) {
  return body.empty() ? "" : fmt::format("<section>\n<h2>{}</h2>\n{}</section>\n", title, body);
}

// In the colour of a failure only where a claim on that run fails: others were made to see whether they diverge, and
// are folded where they are many.
std::string unfinished_runs(const CaseRecords& records) {
  std::string failed, declared;
  for_each(records, &vnv::Record::runs, [&](const auto& record, const auto& run) {
    if (!run.finished)
      (fails_at(record, run.level) ? failed : declared) += fmt::format(
          "<li>{} {} did not finish: {}</li>\n", escape(record.method), escape(run.level), escape(run.outcome));
  });
  std::string others = html_list("declared", declared);
  if (const auto count = std::ranges::count(declared, '\n'); count > 10)
    others =
        fmt::format("<details>\n<summary>{} runs that were made to see whether they diverge</summary>\n{}</details>\n",
                    count, others);
  return html_list("fails", failed) + others;
}

std::string head(const CaseRecords& records) {
  const auto verdicts = verdicts_of(records);
  const Tally sum = tally(verdicts);
  const std::string why = sum.total() == 0 ? " Without a claim this page proves nothing." : "";
  return fmt::format(
      "<header>\n<p class=\"path\"><a href=\"../index.html\">Touchstone</a> / {}</p>\n<h1>{}</h1>\n"
      "<p class=\"sum {}\">{}{}</p>\n{}{}</header>\n",
      escape(records.name), escape(records.title()), word(sum.worst()), sentence(sum), why, unfinished_runs(records),
      list_of(vnv::Outcome::fails, verdicts) + list_of(vnv::Outcome::inconclusive, verdicts));
}

// Points of runs that diverged as declared are no fault.
std::string undrawn_html(const DrawnFigure& drawn, const CaseRecords& records) {
  const std::string covered = drawn.covered > 0 ? " Of marks that would cover each other one is drawn." : "";
  if (drawn.undrawn == 0) return covered;
  const bool is_declared = std::ranges::any_of(records.records, [](const vnv::Record& record) {
    return std::ranges::any_of(record.runs, [&](const auto& r) { return !r.finished && !fails_at(record, r.level); });
  });
  return covered +
         fmt::format(" <span class=\"{}\">{} not drawn, since no axis can show a value that is not finite{}.</span>",
                     is_declared ? "quiet" : "nan", counted(drawn.undrawn, "point"),
                     is_declared ? ", as a diverged run leaves" : "");
}

std::string figure_html(const DrawnFigure& drawn, const CaseRecords& records) {
  return fmt::format(
      "<figure id=\"{0}\">\n<a href=\"{1}\"><img src=\"{1}\" alt=\"{2}\" width=\"{3}\" height=\"{4}\"></a>\n"
      "<figcaption><b>{2}.</b> {5}{6} <span class=\"files\"><a href=\"{0}.csv\">data</a> "
      "<a href=\"{0}.gp\">gnuplot script</a></span></figcaption>\n</figure>\n",
      drawn.figure.id, drawn.image, escape(drawn.figure.title), drawn.width, drawn.height,
      typeset(drawn.figure.caption), undrawn_html(drawn, records));
}

std::string figures_html(const CaseRecords& records, const std::vector<DrawnFigure>& figures) {
  std::string html;
  for (const auto& drawn : figures) html += figure_html(drawn, records);
  // A suite may not run as far as a figure, and another code is judged at the times that its user asks for: no fault,
  // unless something fails.
  const bool fails = tally(verdicts_of(records)).fails > 0;
  for (const auto& declared : each_once(records, &vnv::Record::figures)) {
    if (std::ranges::none_of(figures, [&](const DrawnFigure& drawn) { return drawn.figure.id == declared.id; }))
      html += fmt::format("<p class=\"{}\">Nothing was run that the figure “{}” shows.</p>\n", fails ? "nan" : "quiet",
                          escape(declared.title));
  }
  return html;
}

std::string orders_section(const CaseRecords& records, const std::vector<DrawnFigure>& order_plots) {
  std::string html;
  for (const auto& drawn : order_plots) html += figure_html(drawn, records);
  if (is_in_matrix(records))
    html += "<p class=\"files\">Compared with other flows: <a href=\"../orders.html\">orders of convergence</a></p>\n";
  return html + orders_html(records);
}

std::string methods_html(const CaseRecords& records) {
  std::string html;
  for (const auto& record : records.records)
    html += fmt::format("<dt>{}</dt>\n<dd>{}</dd>\n", escape(record.method), paragraphs(record.method_description));
  return "<dl>\n" + html + "</dl>\n";
}

}  // namespace

std::string case_page(const CaseRecords& records, const std::vector<DrawnFigure>& figures,
                      const std::vector<DrawnFigure>& order_plots) {
  const std::string body =
      head(records) + paragraphs(records.records.front().description) +
      section("Figures", figures_html(records, figures)) + section("Tables", tables_html(records)) +
      section("Claims", verdict_table(records) + diagnosis_table(records)) + section("Errors", errors_html(records)) +
      section("Orders", orders_section(records, order_plots)) + section("Cost", cost_html(records)) +
      section("Methods", methods_html(records));
  return html_page(records.title(), "../", "<main>\n" + body + "</main>\n");
}

}  // namespace touchstone::reports

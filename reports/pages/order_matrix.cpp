#include "reports/pages/order_matrix.hpp"

#include "reports/compare/work_precision.hpp"
#include "reports/text/html.hpp"
#include "reports/text/notation.hpp"
#include "vnv/record/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace touchstone::reports {
namespace {

/// A column.
struct Flow {
  const CaseRecords* records;
  OrderComparison comparison;

  std::string figure_link() const { return fmt::format("{}/index.html#{}", records->name, comparison.id()); }
  std::string unit() const { return vnv::with_heading(comparison.subject.quantity).unit; }
};

std::vector<Flow> flows_with(Field field, const std::vector<CaseRecords>& cases) {
  std::vector<Flow> flows;
  for (const auto& records : cases)
    if (auto comparison = principal_comparison(records, field)) flows.push_back({&records, std::move(*comparison)});
  return flows;
}

std::set<std::string> methods_in(const std::vector<Flow>& flows) {
  std::set<std::string> methods;
  for (const auto& flow : flows)
    for (const auto& record : flow.records->records) methods.insert(record.method);
  return methods;
}

/// Why a cell has no order, as the notes below the table say.
struct Reason {
  char letter;
  const char* words;
};
constexpr std::array reasons{Reason{'a', "not run in this flow"},
                             Reason{'b', "this quantity was not measured at this time"},
                             Reason{'c', "measured at fewer than two spacings of a ladder"}};

const Reason& reason_for_none(const Flow& flow, const std::string& method) {
  const auto& all = flow.records->records;
  const auto record = std::ranges::find(all, method, &vnv::Record::method);
  if (record == all.end()) return reasons[0];
  const bool is_measured = std::ranges::any_of(
      record->values, [&](const vnv::Value& e) { return flow.comparison.subject.is(e.quantity.heading(), e.time); });
  return is_measured ? reasons[2] : reasons[1];
}

/// What is shown to a pointer that rests on an order.
std::string details(const vnv::ObservedOrder& o) {
  return fmt::format("{} spacings from {} to {} mm, {}{}", o.spacings.size(), plain(1e3 * o.spacings.front()),
                     plain(1e3 * o.spacings.back()), o.ladder, o.asymptotic ? "; asymptotic" : "");
}

std::string order_html(const Flow& flow, const OrderLine& line, bool is_alone) {
  const vnv::ObservedOrder& o = line.order;
  std::string html =
      fmt::format("<a href=\"{}\" title=\"{}\">{}</a><br>{}", flow.figure_link(), escape(details(o)),
                  std::isnan(o.order) ? "no order" : with_interval(o.order, o.half_width), sign_and_word(o.trend));
  if (o.spacings.size() == 2) html += "<br><small>two spacings</small>";
  if (!std::isnan(o.floor)) html += fmt::format("<br><small>floor {}</small>", rounded(o.floor, flow.unit()));
  if (!is_alone) html += fmt::format("<br><small>{}</small>", escape(o.ladder));
  return html;
}

HtmlCell cell(const Flow& flow, const std::string& method, std::set<char>& notes) {
  const std::vector<OrderLine> lines = flow.comparison.of_method(method);
  if (lines.empty()) {
    const Reason& why = reason_for_none(flow, method);
    notes.insert(why.letter);
    return {fmt::format("<span title=\"{}\">–<sup>{}</sup></span>", why.words, why.letter), "none"};
  }
  std::string html;
  for (const auto& line : lines) html += (html.empty() ? "" : "<br>") + order_html(flow, line, lines.size() == 1);
  return {html, word(lines.front().order.trend)};
}

std::string cost(const Cheapest::Cost& cost) {
  return (cost.time.at_most ? "≤\u202f" : "") + rounded(cost.time.cpu, "s");
}

HtmlCell cheapest_cell(const Flow& flow) {
  const auto found = cheapest(*flow.records, flow.comparison.subject);
  if (!found) return {"–", "best none"};
  const std::string where = found->machine.empty() ? "" : fmt::format(" title=\"on {}\"", escape(found->machine));
  return {fmt::format("<b>{}</b><br>{} to {}<br><small{}>{} {}</small>", escape(found->best.method), cost(found->best),
                      rounded(found->error, flow.unit()), where, escape(found->next.method), cost(found->next)),
          "best"};
}

std::string heading(const Flow& flow) {
  return fmt::format("<a href=\"{}\">{}</a><br><small>{}, {}\u202fs</small>", flow.figure_link(),
                     escape(flow.records->title()), typeset(vnv::with_heading(flow.comparison.subject.quantity).name),
                     printed(flow.comparison.subject.time));
}

std::string notes_html(const std::set<char>& used) {
  std::string html;
  for (const auto& [letter, words] : reasons)
    if (used.contains(letter)) html += fmt::format("<sup>{}</sup>\u202f{}. ", letter, words);
  return html.empty() ? "" : fmt::format("<p class=\"notes\">{}</p>\n", html);
}

std::string matrix(const std::string& title, Field field, const std::vector<CaseRecords>& cases) {
  const std::vector<Flow> flows = flows_with(field, cases);
  if (flows.empty()) return "";
  HtmlTable table{
      title,
      "Observed order with its 95\u202f% interval, linked to its figure, and the floor of the errors where "
      "one was found. Last row: the least CPU time to a given error, the smallest that two methods reach, and what the "
      "next method takes, among those run on one machine; ≤ if its cheapest run already does better.",
      {"method"}};
  for (const auto& flow : flows) table.columns.push_back(heading(flow));
  std::set<char> notes;
  for (const auto& method : methods_in(flows)) {
    HtmlRow row{escape(method)};
    for (const auto& flow : flows) row.push_back(cell(flow, method, notes));
    table.rows.push_back(std::move(row));
  }
  HtmlRow last{HtmlCell("cheapest", "best")};
  for (const auto& flow : flows) last.push_back(cheapest_cell(flow));
  table.rows.push_back(std::move(last));
  return fmt::format("<div class=\"wide matrix\">\n{}{}</div>\n", to_html(table), notes_html(notes));
}

std::string legend() {
  const auto item = [](vnv::Trend trend, const char* meaning) {
    return fmt::format("<li class=\"{}\"><b>{}</b> {}</li>\n", word(trend), sign_and_word(trend), meaning);
  };
  return "<ul class=\"legend\">\n" +
         item(vnv::Trend::converging, "the whole interval of the order, above a floor if there is one, is positive") +
         item(vnv::Trend::stalled, "a floor is more than half of the finest error, or the order is 0 within 0.5") +
         item(vnv::Trend::diverging, "the whole interval is negative: errors grow as the spacing decreases") +
         item(vnv::Trend::inconclusive, "the interval contains both signs; two spacings have no interval") + "</ul>\n";
}

}  // namespace

bool is_in_matrix(const CaseRecords& records) {
  return principal_comparison(records, Field::velocity) || principal_comparison(records, Field::pressure);
}

std::string order_matrix_page(const std::vector<CaseRecords>& cases) {
  return html_page_beside_index(
      "Observed orders of convergence", "orders", "",
      "<p>How fast the errors of each method decrease with its spacing, in each flow. An order alone says little: a method "
      "may converge fast from large errors, so the last row says what an error costs. Equal spacing would be no fair "
      "measure of that, since a step of one method costs many times that of another.</p>\n" +
          legend() + matrix("Velocity.", Field::velocity, cases) + matrix("Pressure.", Field::pressure, cases) +
          "<p class=\"files\">Table for other programs: <a href=\"orders.csv\">orders</a></p>\n");
}

}  // namespace touchstone::reports

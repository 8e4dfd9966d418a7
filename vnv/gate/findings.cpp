#include "vnv/gate/findings.hpp"

#include "vnv/record/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

namespace touchstone::gate {

TOUCHSTONE_FIELDS_OF_A_CASE(Difference, method, level, time, quantity, kind, before, after, change, why)

namespace {

/// So many changes are named; the JSON holds the rest.
constexpr std::size_t most_named = 40;

struct Column {
  Kind kind;
  std::string_view heading;
};
constexpr auto columns = std::to_array<Column>({{Kind::run, "runs"},
                                                {Kind::claim, "claims"},
                                                {Kind::error, "error"},
                                                {Kind::order, "order"},
                                                {Kind::stability, "stability limit"},
                                                {Kind::other, "other values"},
                                                {Kind::cost, "cost, after over before"}});

using Row = std::vector<std::string>;
using vnv::json::Json;
using vnv::json::Writer;

/// "worse, 2 of 12", "same, 12", or the words of a cost; a dash if there is nothing of the kind.
std::string cell_of(const std::vector<const Difference*>& all) {
  if (all.empty()) return "–";
  const Change worst = (*std::ranges::max_element(all, {}, &Difference::change))->change;
  if (all.front()->kind == Kind::cost) return fmt::format("{}: {}", word_of(worst), all.front()->why);
  const auto count = std::ranges::count(all, worst, &Difference::change);
  const std::string counted = static_cast<std::size_t>(count) == all.size() ? "" : fmt::format("{} of ", count);
  return fmt::format("{}, {}{}", word_of(worst), counted, all.size());
}

/// The headings, and below them a row for each method of each case.
std::vector<Row> table_of(const Findings& findings) {
  std::map<std::pair<std::string, std::string>, std::map<Kind, std::vector<const Difference*>>> methods;
  for (const Difference& d : findings.differences) methods[{d.case_name, d.method}][d.kind].push_back(&d);
  std::vector<Row> rows = {{"case", "method"}};
  for (const Column& column : columns) rows.front().emplace_back(column.heading);
  for (auto& [place, by_kind] : methods) {
    Row& row = rows.emplace_back(Row{place.first, place.second});
    for (const Column& column : columns) row.push_back(cell_of(by_kind[column.kind]));
  }
  return rows;
}

/// What needs attention, worst first and runs before values; what got better last.
std::vector<const Difference*> changes_of(const Findings& findings) {
  std::vector<const Difference*> changes;
  for (const Difference& d : findings.differences)
    if (d.change > Change::same) changes.push_back(&d);
  std::ranges::stable_sort(changes, [](const Difference* a, const Difference* b) {
    return a->change != b->change ? a->change > b->change : a->kind < b->kind;
  });
  return changes;
}

std::string lines_of_changes(const Findings& findings, std::string_view mark) {
  const std::vector<const Difference*> changes = changes_of(findings);
  std::string text;
  for (std::size_t k = 0; k < std::min(changes.size(), most_named); ++k)
    text += fmt::format("{}{}\n", mark, sentence_of(*changes[k]));
  if (changes.size() > most_named) text += fmt::format("{}and {} more\n", mark, changes.size() - most_named);
  return text;
}

std::string summary_of(const Findings& findings) {
  std::map<Change, long> count;
  for (const Difference& d : findings.differences) ++count[d.change];
  const std::string skipped =
      findings.skipped.empty() ? "" : fmt::format(", programs of {} cases the same", findings.skipped.size());
  return fmt::format(
      "{} against {}, suite {}: {} things compared: {} worse, {} inconclusive, {} better, {} same, {} "
      "unjudged{}",
      findings.after, findings.before, findings.suite, findings.differences.size(), count[Change::worse],
      count[Change::inconclusive], count[Change::better], count[Change::same], count[Change::unjudged], skipped);
}

/// In letters, not bytes; all that a table holds are letters of the width of one.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string aligned(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const Row& row : rows)
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], width_of(row[k]));
  std::string text;
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t k = 0; k < row.size(); ++k) line += row[k] + std::string(widths[k] - width_of(row[k]) + 2, ' ');
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

std::string markdown_row(const Row& row) { return fmt::format("| {} |\n", fmt::join(row, " | ")); }

}  // namespace

Change conclusion_of(const Findings& findings) {
  Change worst = Change::same;  // the changes rise: same, better, inconclusive, worse
  for (const Difference& d : findings.differences) worst = std::max(worst, d.change);
  return worst;
}

std::string text_of(const Findings& findings) {
  const std::vector<Row> table = table_of(findings);
  return (table.size() > 1 ? aligned(table) + "\n" : "") + lines_of_changes(findings, "") +
         fmt::format("{}: {}\n", word_of(conclusion_of(findings)), summary_of(findings));
}

std::string markdown_of(const Findings& findings) {
  std::string text = fmt::format("**{}**: {}\n", word_of(conclusion_of(findings)), summary_of(findings));
  const std::vector<Row> table = table_of(findings);
  if (table.size() > 1) {
    text.append("\n").append(markdown_row(table.front())).append(markdown_row(Row(table.front().size(), "---")));
    for (std::size_t k = 1; k < table.size(); ++k) text += markdown_row(table[k]);
  }
  const std::string changes = lines_of_changes(findings, "- ");
  if (!changes.empty()) text.append("\n").append(changes);
  return text;
}

std::vector<vnv::Verdict> verdicts_of(const Findings& findings) {
  const auto verdict = [&](Change change, const std::string& quantity, const std::string& sentence) {
    vnv::Verdict v;
    v.case_name = v.method = "gate";
    v.quantity = quantity;
    v.value = change < Change::inconclusive ? 1 : 0;
    if (change != Change::inconclusive) v.lower = 1;  // without a limit nothing is decided
    v.author = fmt::format("baseline: {}", findings.before);
    v.outcome = outcome_of(v);
    v.margin = margin_of(v);
    v.sentence = sentence;
    return v;
  };
  const Change conclusion = conclusion_of(findings);
  std::vector<vnv::Verdict> verdicts = {
      verdict(conclusion, "no regression overall", fmt::format("{}: {}", word_of(conclusion), summary_of(findings)))};
  for (const Difference* change : changes_of(findings))
    if (change->change >= Change::inconclusive)
      verdicts.push_back(
          verdict(change->change, fmt::format("no regression in {}", change->quantity), sentence_of(*change)));
  return verdicts;
}

vnv::Table page_table_of(const Findings& findings) {
  const std::vector<Row> rows = table_of(findings);
  vnv::Table table{.id = "gate",
                   .title = "Before and after",
                   .caption = summary_of(findings) + ".",
                   .columns = rows.front(),
                   .rows = {}};
  for (std::size_t k = 1; k < rows.size(); ++k) table.rows.emplace_back(rows[k].begin(), rows[k].end());
  return table;
}

std::string json_of(const Findings& findings) {
  const Json json = {{"before", findings.before},   {"after", findings.after},
                     {"suite", findings.suite},     {"conclusion", word_of(conclusion_of(findings))},
                     {"skipped", findings.skipped}, {"differences", Writer::json(findings.differences)}};
  return json.dump(1) + "\n";
}

}  // namespace touchstone::gate

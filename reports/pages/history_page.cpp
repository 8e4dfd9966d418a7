#include "reports/pages/history_page.hpp"

#include "reports/figures/sparkline.hpp"
#include "reports/pages/verdicts.hpp"
#include "reports/read/csv.hpp"
#include "reports/text/notation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <tuple>

namespace touchstone::reports {
namespace {

/// A step, and the series it is in.
struct Change {
  const Series* series;
  Step step;
};

/// Changes of a method in one night, but for costs, which have a group of their own; the first went furthest.
using Group = std::vector<Change>;

/// In the order of their first ones.
std::vector<Group> grouped(const std::vector<Change>& changes) {
  std::vector<Group> groups;
  const auto place = [](const Change& c) {
    return std::tuple(c.step.night, c.series->kind == Series::Kind::cost, std::string_view(c.series->case_name),
                      std::string_view(c.series->method));
  };
  for (const Change& change : changes) {
    const auto found = std::ranges::find(groups, place(change), [&](const Group& g) { return place(g.front()); });
    (found == groups.end() ? groups.emplace_back() : *found).push_back(change);
  }
  return groups;
}

/// The newest first; those of one night by how far they went.
std::vector<Change> changes_of(const std::vector<Series>& all) {
  std::vector<Change> changes;
  for (const Series& series : all)
    for (const Step& step : series.steps) changes.push_back({&series, step});
  const auto distance = [](const Step& s) {  // as a factor; what has none comes first
    const double factor = std::abs(std::log(s.after / s.before));
    return std::isnan(factor) ? INFINITY : factor;
  };
  std::ranges::stable_sort(changes, [&](const Change& a, const Change& b) {
    if (a.step.night != b.step.night) return a.step.night > b.step.night;
    return distance(a.step) > distance(b.step);
  });
  return changes;
}

std::string date(const Night& night) { return night.finished_at.substr(0, 10); }
std::string revision(const Night& night) { return "<code>" + escape(night.revision) + "</code>"; }

/// "L2 v_x [%]" -> "L2 v_x, M2, 1 s".
std::string subject(const Series& s) {
  std::string text = typeset(s.quantity);
  if (!s.level.empty()) text += ", " + escape(s.level);
  if (!std::isnan(s.time)) text += fmt::format(", {}\u202fs", printed(s.time));
  return text;
}

std::string case_link(const std::string& name, const std::vector<CaseRecords>& tonight) {
  const auto found = std::ranges::find(tonight, name, &CaseRecords::name);
  if (found == tonight.end()) return escape(name);
  return fmt::format("<a href=\"{}/index.html\">{}</a>", name, escape(found->title()));
}

/// What tells a step of a value by another machine from one by another revision.
std::string machine_words(const Change& change, const History& history) {
  const auto before = night_on_another_machine(*change.series, change.step);
  if (!before) return "";
  const std::size_t now = change.step.night;
  const bool is_same_revision = history.nights[*before].revision == history.nights[now].revision;
  return fmt::format("<br><small>{}: {} before, now {}</small>",
                     is_same_revision ? "this value depends on the machine" : "run on another machine",
                     escape(change.series->points[*before].machine), escape(change.series->points[now].machine));
}

HtmlRow change_row(const Group& group, const History& history) {
  const auto& [series, step] = group.front();
  const std::string more = group.size() == 1 ? "" : fmt::format(" <small>and {} more</small>", group.size() - 1);
  const Night& night = history.nights[step.night];
  const double ratio = step.after / step.before;
  const bool fails = std::ranges::any_of(group, [](const Change& c) { return c.series->points[c.step.night].fails; });
  return {date(night),
          revision(night),
          escape(series->case_name),
          escape(series->method),
          words_cell(subject(*series) + more + machine_words(group.front(), history)),
          number_cell(step.before),
          HtmlCell(printed(step.after), fails ? "number fails" : "number"),
          HtmlCell(std::isfinite(ratio) ? printed(ratio) : "–", "number")};
}

std::string changes_html(const std::vector<Change>& changes, const History& history) {
  if (changes.empty()) return "<p>Nothing has changed over these nights.</p>\n";
  HtmlTable table{"What changed.",
                  "Newest first, one line per method and night: the value that changed most, its level before, its "
                  "first value after the change, and their ratio; in red where a claim fails.",
                  {"night", "revision", "case", "method", "quantity", "before", "after", "ratio"}};
  const auto groups = grouped(changes);
  for (std::size_t g = 0; g < groups.size() && g < most_changes_listed; ++g)
    table.rows.push_back(change_row(groups[g], history));
  if (groups.size() <= most_changes_listed) return to_html(table);
  return to_html(table) +
         fmt::format(
             "<p class=\"notes\">{} older lines are left out; <a href=\"trend_steps.csv\">the table of steps</a> "
             "has every value.</p>\n",
             groups.size() - most_changes_listed);
}

std::string summary(const std::vector<Change>& changes, const History& history) {
  const std::size_t last = history.nights.size() - 1;
  const auto is_new = [&](const Change& c) { return c.step.night == last; };
  const auto changed = std::ranges::count_if(changes, is_new);
  const bool fails =
      std::ranges::any_of(changes, [&](const Change& c) { return is_new(c) && c.series->points[c.step.night].fails; });
  const std::string nights = fmt::format("{}, {} to {}:", counted(std::ssize(history.nights), "night"),
                                         date(history.nights.front()), date(history.nights.back()));
  const std::string what = last == 0 ? "nothing to compare it with yet."
                                     : fmt::format("the last one changed {}.", counted(changed, "value"));
  return fmt::format("<p class=\"sum {}\">{} {}</p>\n",
                     fails         ? "fails"
                     : changed > 0 ? "inconclusive"
                                   : "holds",
                     nights, what);
}

std::string refusals(const History& history) {
  std::string items;
  for (const auto& refusal : history.refused) items += fmt::format("<li>Left out: {}</li>\n", escape(refusal));
  return html_list("fails", items);
}

/// The values of all nights, for the script that shows them: "1.5,,nan".
std::string values(const Series& series) {
  std::string list;
  for (const auto& point : series.points) list += (point.is_there ? plain(point.value) : "") + ",";
  list.pop_back();
  return list;
}

/// The last value, coloured where it fails.
std::string last_value(const Series& series) {
  const SeriesPoint& last = series.points.back();
  if (!last.is_there) return "<b>not run</b>";
  return fmt::format("<b{}>{}</b>", last.fails ? " class=\"fails\"" : "", printed(last.value));
}

/// Lowest and highest over the nights, between which the curve is drawn; nothing for one that stays.
std::string range_words(const Series& series) {
  const auto [low, high] = series.range();
  if (!(low < high) || plain(low) == plain(high)) return "";
  return fmt::format("<span>range {} to {}</span>", printed(low), printed(high));
}

std::string limit_words(const Series& series) {
  if (series.author.empty()) return "";
  return fmt::format("<span title=\"{}\">expected {}</span>", escape(series.author),
                     printed_limit(series.lower, series.upper));
}

/// The revision that made the last step stands beside the curve.
std::string last_step(const Series& series, const History& history) {
  if (series.steps.empty()) return "";
  const Step& step = series.steps.back();
  const Night& night = history.nights[step.night];
  return fmt::format("<span class=\"step\">step {}, {}</span>", date(night), revision(night));
}

std::string multiple(const Series& series, const History& history) {
  return fmt::format("<div class=\"trend\" data-values=\"{}\" tabindex=\"0\"><p>{}</p>{}<p>{} {} {} {}</p></div>\n",
                     values(series), subject(series), sparkline(series), last_value(series), range_words(series),
                     limit_words(series), last_step(series, history));
}

/// A section of each case, and in it a grid of curves of each method.
std::string multiples(const std::vector<const Series*>& drawn, const History& history,
                      const std::vector<CaseRecords>& tonight) {
  std::string html;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const Series &series = *drawn[i], *before = i > 0 ? drawn[i - 1] : nullptr;
    const bool new_case = !before || before->case_name != series.case_name;
    const bool new_method = new_case || before->method != series.method;
    if (before && new_method) html += "</div>\n";
    if (before && new_case) html += "</section>\n";
    if (new_case)
      html += fmt::format("<section class=\"trends\">\n<h2>{}</h2>\n", case_link(series.case_name, tonight));
    if (new_method) html += fmt::format("<h3>{}</h3>\n<div class=\"multiples\">\n", escape(series.method));
    html += multiple(series, history);
  }
  return drawn.empty() ? "" : html + "</div>\n</section>\n";
}

HtmlRow night_row(std::size_t number, const Night& night) {
  Tally sum;
  for (const auto& verdict : night.verdicts) sum.add(verdict.outcome, verdict.author);
  double cpu = 0;  // s
  for (const auto& run : night.runs)
    if (!std::isnan(run.cpu)) cpu += run.cpu;  // else it is unknown or of another resource
  return {number_cell(number + 1),
          escape(night.finished_at),
          revision(night),
          number_cell(sum.holds),
          HtmlCell(printed(long{sum.fails}), sum.fails > 0 ? "number fails" : "number"),
          number_cell(sum.inconclusive),
          number_cell(cpu),
          words_cell(escape(night.compiler)),
          words_cell(escape(night.machine))};
}

std::string nights_html(const History& history) {
  HtmlTable table{"Nights.",
                  "All that are kept, the newest first; CPU is the user time of all runs.",
                  {"no.", "finished", "revision", "hold", "fail", "inconclusive", "CPU [s]", "compiler", "machine"}};
  for (std::size_t n = history.nights.size(); n-- > 0;) table.rows.push_back(night_row(n, history.nights[n]));
  return to_html(table);
}

/// Names of all nights, for the script.
std::string names_of_nights(const History& history) {
  std::string names;
  for (const Night& night : history.nights)
    names += fmt::format("{}{} {}", names.empty() ? "" : ",", date(night), escape(night.revision));
  return names;
}

const std::string how_to_read_history =
    "<p>Each curve runs over the nights, oldest on the left; pointing at it or touching it shows night, revision and "
    "value. An orange line marks a step: from there on, the value differs from its level (the median of the first "
    "fifteen nights since the last step) by more than the tolerance of its baseline (without one 1 %, for costs 10 %) "
    "and by more than four times its scatter. A step of a cost has to last for two nights, and cost series restart on "
    "another machine. Dashed: a limit within the range; red dots: a claim fails; crosses: not a number. Shown are "
    "values judged by theory or literature, at their last time and finest spacing, observed orders, stability limits, "
    "and the most expensive run of each method; steps are sought in all values.</p>\n";

}  // namespace

std::string trend_page(const History& history, const std::vector<Series>& all,
                       const std::vector<CaseRecords>& tonight) {
  const auto changes = changes_of(all);
  return html_page_beside_index("Trend over the nights", "trend", summary(changes, history) + refusals(history),
                                changes_html(changes, history) + how_to_read_history +
                                    multiples(worth_drawing(all), history, tonight) + nights_html(history) +
                                    "<p class=\"files\">Tables for other programs: <a href=\"trend.csv\">curves</a> <a "
                                    "href=\"trend_steps.csv\">steps</a></p>\n",
                                fmt::format(" data-nights=\"{}\"", names_of_nights(history)));
}

std::string steps_csv(const History& history, const std::vector<Series>& all) {
  std::string csv = "night,revision,case,method,level,time [s],quantity,before,after\n";
  for (const auto& [series, step] : changes_of(all)) {
    const Night& night = history.nights[step.night];
    csv += csv_line({night.finished_at, night.revision, series->case_name, series->method, series->level,
                     plain_or_empty(series->time), series->quantity, plain(step.before), plain(step.after)});
  }
  return csv;
}

std::string trend_csv(const History& history, const std::vector<Series>& all) {
  std::vector<std::string> heading{"case", "method", "level", "time [s]", "quantity"};
  for (const Night& night : history.nights) heading.push_back(night.finished_at + " " + night.revision);
  std::string csv = csv_line(heading);
  for (const Series* series : worth_drawing(all)) {
    std::vector<std::string> line{series->case_name, series->method, series->level, plain_or_empty(series->time),
                                  series->quantity};
    for (const auto& point : series->points)
      line.push_back(!point.is_there ? "" : std::isnan(point.value) ? "nan" : fmt::format("{}", point.value));
    csv += csv_line(line);
  }
  return csv;
}

}  // namespace touchstone::reports

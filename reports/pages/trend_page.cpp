#include "reports/pages/pages.hpp"

#include "reports/figures/sparkline.hpp"
#include "reports/read/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>
#include <tuple>

namespace touchstone::reports::pages {
namespace {

constexpr std::size_t most_changes_listed = 100;  // all steps are in trend_steps.csv

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

/// "L2 v_x [%], M2, 1 s", in its parts.
Data subject(const Series& s) {
  return object("quantity"_ = s.quantity, "level"_ = if_any(s.level),
                "time"_ = when(!std::isnan(s.time), valued(s.time, "s")));
}

/// What tells a step of a value by another machine from one by another revision.
Data machines_data(const Change& change, const History& history) {
  const auto before = night_on_another_machine(*change.series, change.step);
  if (!before) return false;
  const std::size_t now = change.step.night;
  return object("is_same_revision"_ = history.nights[*before].revision == history.nights[now].revision,
                "before"_ = change.series->points[*before].machine, "now"_ = change.series->points[now].machine);
}

Data change_data(const Group& group, const History& history) {
  const auto& [series, step] = group.front();
  const Night& night = history.nights[step.night];
  const double ratio = step.after / step.before;
  return object(
      "date"_ = date(night), "revision"_ = night.revision, "case"_ = series->case_name, "method"_ = series->method,
      "subject"_ = subject(*series), "more"_ = when(group.size() > 1, group.size() - 1),
      "machines"_ = machines_data(group.front(), history), "before"_ = step.before, "after"_ = step.after,
      "fails"_ = std::ranges::any_of(group, [](const Change& c) { return c.series->points[c.step.night].fails; }),
      "ratio"_ = std::isfinite(ratio) ? printed(ratio) : "–");
}

/// The first lines, and how many are left out.
Data changes_data(const std::vector<Change>& changes, const History& history) {
  const auto groups = grouped(changes);
  const std::size_t listed = std::min(groups.size(), most_changes_listed);
  const auto change = [&](const Group& group) { return change_data(group, history); };
  return when(!groups.empty(), object("items"_ = each(std::span(groups).first(listed), change),
                                      "left_out"_ = when(groups.size() > listed, groups.size() - listed)));
}

/// The values of all nights, for the script that shows them: "1.5,,nan".
std::string values(const Series& series) {
  std::string list;
  for (const auto& point : series.points) list += (point.is_there ? plain(point.value) : "") + ",";
  list.pop_back();
  return list;
}

/// Lowest and highest over the nights, between which the curve is drawn; nothing for one that stays.
Data range_data(const Series& series) {
  const auto [low, high] = series.range();
  if (!(low < high) || plain(low) == plain(high)) return false;
  return object("low"_ = low, "high"_ = high);
}

/// The date and revision of the last step.
Data last_step(const Series& series, const History& history) {
  if (series.steps.empty()) return false;
  const Step& step = series.steps.back();
  const Night& night = history.nights[step.night];
  return object("date"_ = date(night), "revision"_ = night.revision);
}

Data curve(const Series& series, const History& history) {
  const SeriesPoint& last = series.points.back();
  const Data limit = object("author"_ = series.author, "text"_ = printed_limit(series.lower, series.upper));
  const auto path = [](const SparklinePath& p) { return object("kind"_ = p.kind, "d"_ = p.d); };
  return object("values"_ = values(series), "subject"_ = subject(series), "paths"_ = each(sparkline(series), path),
                "last"_ = when(last.is_there, last.value), "fails"_ = last.fails, "range"_ = range_data(series),
                "limit"_ = when(!series.author.empty(), limit), "step"_ = last_step(series, history));
}

/// Those that follow each other and have the same in this place.
std::vector<std::vector<const Series*>> runs_of(const std::vector<const Series*>& all, std::string Series::*place) {
  std::vector<std::vector<const Series*>> runs;
  for (const Series* series : all)
    if (runs.empty() || runs.back().back()->*place != series->*place)
      runs.push_back({series});
    else
      runs.back().push_back(series);
  return runs;
}

/// The curves of each method of each case.
List cases_data(const std::vector<const Series*>& drawn, const History& history,
                const std::vector<CaseRecords>& tonight) {
  const auto method = [&](const std::vector<const Series*>& curves) {
    return object("method"_ = curves.front()->method,
                  "curves"_ = each(curves, [&](const Series* series) { return curve(*series, history); }));
  };
  return each(runs_of(drawn, &Series::case_name), [&](const std::vector<const Series*>& of_case) {
    const std::string& name = of_case.front()->case_name;
    const auto found = std::ranges::find(tonight, name, &CaseRecords::name);
    return object("case"_ = name, "title"_ = found == tonight.end() ? false : data_of(found->title()),
                  "methods"_ = each(runs_of(of_case, &Series::method), method));
  });
}

/// The newest first.
List nights_data(const History& history) {
  List items;
  for (std::size_t n = history.nights.size(); n-- > 0;) {
    const Night& night = history.nights[n];
    Tally sum;
    for (const auto& verdict : night.verdicts) sum.add(verdict.outcome, verdict.author);
    double cpu = 0;  // s
    for (const auto& run : night.runs)
      if (!std::isnan(run.cpu)) cpu += run.cpu;  // else it is unknown or of another resource
    items.push_back(object("night"_ = n + 1, "finished"_ = night.finished_at, "revision"_ = night.revision,
                           "holds"_ = sum.holds, "fails"_ = sum.fails, "is_red"_ = sum.fails > 0,
                           "inconclusive"_ = sum.inconclusive, "cpu"_ = cpu, "compiler"_ = night.compiler,
                           "machine"_ = night.machine));
  }
  return items;
}

/// Names of all nights, for the script.
std::string names_of_nights(const History& history) {
  std::string names;
  for (const Night& night : history.nights)
    names += fmt::format("{}{} {}", names.empty() ? "" : ",", date(night), night.revision);
  return names;
}

Data trend_data(const History& history, const std::vector<Series>& all, const std::vector<CaseRecords>& tonight) {
  const auto changes = changes_of(all);
  const std::size_t last = history.nights.size() - 1;
  const auto is_new = [&](const Change& c) { return c.step.night == last; };
  const auto fails = [&](const Change& c) { return is_new(c) && c.series->points[c.step.night].fails; };
  const auto changed = std::ranges::count_if(changes, is_new);
  return object("kind"_ = std::ranges::any_of(changes, fails) ? "fails"
                          : changed > 0                       ? "inconclusive"
                                                              : "holds",
                "count"_ = counted(std::ssize(history.nights), "night"), "first"_ = date(history.nights.front()),
                "last"_ = date(history.nights.back()), "changed"_ = when(last > 0, counted(changed, "value")),
                "names_of_nights"_ = names_of_nights(history), "refused"_ = if_any(each(history.refused)),
                "changes"_ = changes_data(changes, history),
                "cases"_ = cases_data(worth_drawing(all), history, tonight), "nights"_ = nights_data(history));
}

/// One line per step.
std::string steps_csv(const History& history, const std::vector<Series>& all) {
  std::string csv = "night,revision,case,method,level,time [s],quantity,before,after\n";
  for (const auto& [series, step] : changes_of(all)) {
    const Night& night = history.nights[step.night];
    csv += csv_line({night.finished_at, night.revision, series->case_name, series->method, series->level,
                     plain_or_empty(series->time), series->quantity, plain(step.before), plain(step.after)});
  }
  return csv;
}

/// One line per series that is drawn, one column per night, headed by its date and revision.
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

}  // namespace

Page trend() {
  return {.title = "Trend over the nights",
          .sentence = "How the values developed from night to night, and what changed last",
          .content = [](const Findings& all) -> Content {
            if (!all.history) return {};
            const auto series = series_of(all.history->nights);
            return {
                trend_data(*all.history, series, all.cases),
                {{"trend.csv", trend_csv(*all.history, series)}, {"trend_steps.csv", steps_csv(*all.history, series)}}};
          }};
}

}  // namespace touchstone::reports::pages

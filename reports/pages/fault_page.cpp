#include "reports/pages/fault_page.hpp"

#include "reports/text/html.hpp"
#include "reports/text/notation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <vector>

namespace touchstone::reports {
namespace {

constexpr std::size_t most_tests_listed = 5;  // of a fault; faults.csv has all
constexpr double hardly = -0.1;               // a margin between this and 0

/// A test with its margin, and its sentence for a pointer that rests on it.
std::string test_html(const FaultTest& test) {
  const std::string percentage =
      std::isnan(test.margin)
          ? ""
          : fmt::format(" <small class=\"{}\">{}</small>", test.noticed ? "fails" : "holds", in_percent(test.margin));
  return fmt::format("<span title=\"{}\">{}{}</span> ", escape(test.sentence), breakable(test.name), percentage);
}

/// The tests that noticed, or those that did not: what is farthest beyond its limit, or closest to it, first.
HtmlCell tests_cell(const FaultTrial& trial, bool noticed) {
  std::vector<FaultTest> tests;
  std::ranges::copy_if(trial.tests, std::back_inserter(tests),
                       [&](const FaultTest& t) { return t.noticed == noticed; });
  std::ranges::stable_sort(tests, {}, [](const FaultTest& t) { return std::isnan(t.margin) ? INFINITY : t.margin; });
  std::string html;
  for (std::size_t t = 0; t < tests.size() && t < most_tests_listed; ++t) html += test_html(tests[t]);
  if (tests.size() > most_tests_listed)
    html += fmt::format("<small>and {} more</small>", tests.size() - most_tests_listed);
  return words_cell("<div class=\"tests\">" + html + "</div>");
}

HtmlCell title_cell(const FaultTrial& trial) {
  return words_cell(fmt::format("{}<br><small>{}</small>", typeset(trial.title), escape(trial.files)));
}

HtmlCell conclusion_cell(const FaultTrial& trial) {
  const bool is_explained = trial.is_open() && !trial.why.empty();
  const char* kind = is_explained                                       ? "known"
                     : trial.is_open()                                  ? "fails"
                     : trial.conclusion == Conclusion::noticed_at_night ? "stalled"
                                                                        : "holds";
  return {std::string(name_of(trial.conclusion)), kind};
}

std::string open_html(const FaultTrials& all) {
  HtmlTable table{
      "Open.",
      "Faults that no test noticed or that do not compile, and harmless changes that some test noticed. The "
      "margin is the fraction of a limit that is left.",
      {"fault", "conclusion", "known reason", "tests"}};
  for (const FaultTrial& trial : all.trials)
    if (trial.is_open())
      table.rows.push_back({title_cell(trial), conclusion_cell(trial),
                            words_cell(trial.why.empty() ? "none yet" : typeset(trial.why)),
                            tests_cell(trial, trial.conclusion != Conclusion::survived)});
  return to_html(table);
}

/// How far beyond its limit; nothing where no test that noticed has one.
HtmlCell margin_cell(const FaultTrial& trial) {
  const FaultTest* clearest = trial.clearest();
  const bool has_margin = clearest && !std::isnan(clearest->margin);
  return {has_margin ? in_percent(clearest->margin) : "–", "number"};
}

HtmlRow fault_row(const FaultTrial& trial) {
  const auto noticed = std::ranges::count_if(trial.tests, &FaultTest::noticed);
  return {title_cell(trial), conclusion_cell(trial), margin_cell(trial),
          HtmlCell(fmt::format("{} of {}", noticed, trial.tests.size()), "number"), tests_cell(trial, true)};
}

std::string faults_html(const FaultTrials& all) {
  HtmlTable table{
      "Faults.",
      "Survivors first, then those hardly noticed. The margin is that of the test that noticed most clearly: the "
      "fraction of its limit that is left, negative beyond it, −inf for a value that is not a number; unit tests have "
      "none. Tests: how many of those run noticed.",
      {"fault", "conclusion", "margin", "tests", "noticed by"}};
  for (const FaultTrial& trial : all.trials)
    if (!trial.is_harmless()) table.rows.push_back(fault_row(trial));
  return to_html(table);
}

std::string harmless_html(const FaultTrials& all) {
  HtmlTable table{"Harmless changes.",
                  "The order of sums, names, compiler, threads and optimisation: no test may notice them.",
                  {"change", "conclusion", "tests run"}};
  for (const FaultTrial& trial : all.trials)
    if (trial.is_harmless())
      table.rows.push_back({title_cell(trial), conclusion_cell(trial), number_cell(trial.tests.size())});
  return to_html(table);
}

/// The column of a test: its own, but for tests without limits, which have one together.
std::string column_of(const FaultTest& test) {
  const std::string module = test.name.substr(0, test.name.find('.', 5));
  if (module.starts_with("unit.")) return module.substr(5) + ", units";
  return test.name.starts_with("selftest.") ? "selftests" : test.name;
}

/// The columns with a test that noticed something, those that noticed most first.
std::vector<std::string> columns_of(const FaultTrials& all) {
  std::map<std::string, long> noticed;
  for (const FaultTrial& trial : all.trials)
    for (const FaultTest& test : trial.tests)
      if (test.noticed && !trial.is_harmless()) ++noticed[column_of(test)];
  std::vector<std::string> columns;
  for (const auto& [column, count] : noticed) columns.push_back(column);
  std::ranges::stable_sort(columns, std::ranges::greater{}, [&](const auto& column) { return noticed.at(column); });
  return columns;
}

/// What the tests of a column say of a fault.
struct Detection {
  long run = 0, noticed = 0;
  double margin = vnv::not_a_number;  // the smallest of those that noticed
  std::string sentences{};            // a line each, of those that noticed
};

void add(Detection& found, const FaultTest& test) {
  ++found.run;
  if (!test.noticed) return;
  ++found.noticed;
  found.margin = std::fmin(found.margin, test.margin);
  found.sentences += fmt::format("{}{}: {}", found.sentences.empty() ? "" : "\n", test.name, test.sentence);
}

HtmlCell detection_cell(const Detection& found) {
  if (found.run == 0) return {};
  if (found.noticed == 0) return {"–", "none"};
  const bool has_margin = !std::isnan(found.margin);
  const std::string words = !has_margin                ? printed(found.noticed)
                            : std::isinf(found.margin) ? printed(found.margin)
                                                       : printed(std::round(100 * found.margin));
  return {fmt::format("<span title=\"{}\">{}</span>", escape(found.sentences), words),
          found.margin > hardly ? "hardly" : "noticed"};
}

std::string matrix_html(const FaultTrials& all) {
  const std::vector<std::string> columns = columns_of(all);
  HtmlTable table{
      "Faults by tests.",
      "Each cell holds the margin in per cent of the limit, green where the test noticed the fault, yellow where it "
      "did so by less than a tenth of its limit; – where it was run and did not; blank where it was not run. The unit "
      "tests of a module share a column, as do the selftests; it counts those that noticed. Tests that noticed nothing "
      "are left out.",
      {"fault"}};
  for (const auto& column : columns) table.columns.push_back("<span>" + escape(column) + "</span>");
  for (const FaultTrial& trial : all.trials) {
    if (trial.is_harmless()) continue;
    std::map<std::string, Detection> detections;
    for (const FaultTest& test : trial.tests) add(detections[column_of(test)], test);
    HtmlRow row{typeset(trial.title)};
    for (const auto& column : columns) row.push_back(detection_cell(detections[column]));
    table.rows.push_back(std::move(row));
  }
  return columns.empty() ? "" : fmt::format("<div class=\"wide detections\">\n{}</div>\n", to_html(table));
}

/// "Tried between 2026-11-20T23:00:00Z and 2026-11-22T04:00:00Z, at revisions def5678 to abc1234": each trial keeps the
/// day on which it was last made.
std::string when_html(const FaultTrials& all) {
  const auto [first, last] = std::ranges::minmax_element(all.trials, {}, &FaultTrial::date_and_time);
  const auto code = [](const FaultTrial& trial) { return "<code>" + escape(trial.revision) + "</code>"; };
  if (first->revision == last->revision)
    return fmt::format("Tried at revision {}, the last {}", code(*first), escape(last->date_and_time));
  return fmt::format("Tried between {} and {}, at revisions {} to {}", escape(first->date_and_time),
                     escape(last->date_and_time), code(*first), code(*last));
}

const std::string how_to_read_faults =
    "<p>What would the tests miss? One fault at a time is seeded in a copy of the sources: a mistake that somebody could "
    "make in a solver, an exact solution, a measure or the judge itself. A test that fails has detected it, in the "
    "acceptance suite unless it says nightly. Harmless changes are seeded as well, to count false alarms.</p>\n";

}  // namespace

std::string kind_of(const FaultTrials& all) {
  const auto is_unexplained = [](const FaultTrial& trial) { return trial.is_open() && trial.why.empty(); };
  if (std::ranges::any_of(all.trials, is_unexplained)) return "fails";
  return std::ranges::any_of(all.trials, &FaultTrial::is_open) ? "known" : "holds";
}

std::string fault_page(const FaultTrials& all) {
  const std::string when =
      fmt::format("<p>{}, with {}, on {}.</p>\n", when_html(all), escape(all.suite), escape(all.machine));
  return html_page_beside_index(
      "Detection rate", "seeded faults", fmt::format("<p class=\"sum {}\">{}</p>\n", kind_of(all), all.sentence()),
      how_to_read_faults + when + open_html(all) + faults_html(all) + matrix_html(all) + harmless_html(all) +
          "<p class=\"files\">Table for other programs: <a href=\"faults.csv\">each test of each fault</a></p>\n");
}

}  // namespace touchstone::reports

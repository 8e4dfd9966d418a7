#include "reports/pages/pages.hpp"

#include "vnv/files/whole_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <span>
#include <vector>

namespace touchstone::reports::pages {
namespace {

constexpr std::size_t most_tests_listed = 5;  // of a fault; faults.csv has all
constexpr double hardly = -0.1;               // a margin between this and 0

/// A test with its margin, and its sentence for a pointer that rests on it.
Data test_data(const FaultTest& test) {
  return object("name"_ = test.name, "sentence"_ = test.sentence, "kind"_ = test.noticed ? "fails" : "holds",
                "margin"_ = when(!std::isnan(test.margin), in_percent(test.margin)));
}

/// The tests that noticed, or those that did not: what is farthest beyond its limit, or closest to it, first.
Data tests_data(const FaultTrial& trial, bool noticed) {
  std::vector<FaultTest> tests;
  std::ranges::copy_if(trial.tests, std::back_inserter(tests),
                       [&](const FaultTest& t) { return t.noticed == noticed; });
  std::ranges::stable_sort(tests, {}, [](const FaultTest& t) { return std::isnan(t.margin) ? INFINITY : t.margin; });
  const std::size_t listed = std::min(tests.size(), most_tests_listed);
  return object("items"_ = each(std::span(tests).first(listed), test_data),
                "more"_ = when(tests.size() > listed, tests.size() - listed));
}

const char* kind_of_conclusion(const FaultTrial& trial) {
  if (trial.is_open()) return trial.why.empty() ? "fails" : "known";
  return trial.conclusion == Conclusion::noticed_at_night ? "stalled" : "holds";
}

/// The margin is how far beyond its limit the clearest test is; none where no test that noticed has one.
Data trial_data(const FaultTrial& trial) {
  const FaultTest* clearest = trial.clearest();
  const bool has_margin = clearest && !std::isnan(clearest->margin);
  return object("title"_ = trial.title, "files"_ = trial.files, "kind"_ = kind_of_conclusion(trial),
                "conclusion"_ = word(trial.conclusion), "why"_ = if_any(trial.why),
                "margin"_ = has_margin ? in_percent(clearest->margin) : "–",
                "noticed"_ = std::ranges::count_if(trial.tests, &FaultTest::noticed), "run"_ = trial.tests.size(),
                "noticed_by"_ = tests_data(trial, true),
                "tests"_ = tests_data(trial, trial.conclusion != Conclusion::survived));
}

Data trials_data(const FaultTrials& all, const auto& are_chosen) {
  std::vector<FaultTrial> chosen;
  std::ranges::copy_if(all.trials, std::back_inserter(chosen), are_chosen);
  return if_any(each(chosen, trial_data));
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

/// The margin in per cent, or how many noticed where none has one; nothing where no test of the column was run.
Data detection_data(const Detection& found) {
  if (found.run == 0) return object("kind"_ = false, "sentences"_ = false, "text"_ = "");
  if (found.noticed == 0) return object("kind"_ = "none", "sentences"_ = false, "text"_ = "–");
  return object("kind"_ = found.margin > hardly ? "hardly" : "noticed", "sentences"_ = found.sentences,
                "text"_ = std::isnan(found.margin)   ? printed(found.noticed)
                          : std::isinf(found.margin) ? printed(found.margin)
                                                     : printed(std::round(100 * found.margin)));
}

Data matrix_data(const FaultTrials& all) {
  const std::vector<std::string> columns = columns_of(all);
  if (columns.empty()) return false;
  List rows;
  for (const FaultTrial& trial : all.trials) {
    if (trial.is_harmless()) continue;
    std::map<std::string, Detection> detections;
    for (const FaultTest& test : trial.tests) add(detections[column_of(test)], test);
    const auto cell = [&](const std::string& column) { return detection_data(detections[column]); };
    rows.push_back(object("title"_ = trial.title, "cells"_ = each(columns, cell)));
  }
  return object("columns"_ = each(columns), "rows"_ = rows);
}

/// "holds" if all is noticed, "known" if it is known why not, else "fails".
const char* kind_of(const FaultTrials& all) {
  const auto is_unexplained = [](const FaultTrial& trial) { return trial.is_open() && trial.why.empty(); };
  if (std::ranges::any_of(all.trials, is_unexplained)) return "fails";
  return std::ranges::any_of(all.trials, &FaultTrial::is_open) ? "known" : "holds";
}

Data faults_data(const FaultTrials& all) {
  const auto [first, last] = std::ranges::minmax_element(all.trials, {}, &FaultTrial::date_and_time);
  const auto is_fault = [](const FaultTrial& trial) { return !trial.is_harmless(); };
  return object("kind"_ = kind_of(all), "sentence"_ = all.sentence(), "first_tried"_ = first->date_and_time,
                "last_tried"_ = last->date_and_time,
                "first_revision"_ = when(first->revision != last->revision, first->revision),
                "last_revision"_ = last->revision, "suite"_ = all.suite, "machine"_ = all.machine,
                "open"_ = trials_data(all, &FaultTrial::is_open), "faults"_ = trials_data(all, is_fault),
                "matrix"_ = matrix_data(all), "harmless"_ = trials_data(all, &FaultTrial::is_harmless));
}

}  // namespace

Page faults() {
  return {.title = "Detection rate",
          .sentence = "What the tests would miss",
          .content = [](const Findings& all) -> Content {
            if (!all.faults) return {};
            return {faults_data(*all.faults),
                    {{"faults.csv", files::read_whole(all.faults->file)}},
                    all.faults->sentence()};
          }};
}

}  // namespace touchstone::reports::pages

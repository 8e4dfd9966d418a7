#include "reports/read/fault_trials.hpp"

#include "reports/text/notation.hpp"
#include "vnv/files/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <tuple>

namespace touchstone::reports {
namespace {

const std::vector<std::string> trial_columns{"fault",   "title",      "files",    "conclusion", "why",      "test",
                                             "noticed", "margin [-]", "sentence", "revision",   "tried at", "digest"};

template <class Number>
bool is_read(const std::string& text, Number& value) {
  const char* last = text.data() + text.size();
  return std::from_chars(text.data(), last, value).ptr == last;
}

FaultTrial trial_on(const vnv::Sheet& sheet, const vnv::Sheet::Row& row) {
  const auto refuse = [&](const std::string& what) { throw vnv::BadData(sheet.file, row.line, what); };
  const auto& c = row.cells;
  for (const std::size_t i : {0, 1, 5, 9, 10})
    if (c[i].empty()) refuse(fmt::format("no {}, expected one", trial_columns[i]));
  constexpr auto conclusions = words(Conclusion{});
  const auto conclusion = std::ranges::find(conclusions, c[3]);
  if (conclusion == conclusions.end())
    refuse(fmt::format("conclusion '{}', expected one such as '{}'", c[3], conclusions.front()));
  if (c[6] != "yes" && c[6] != "no") refuse(fmt::format("noticed '{}', expected yes or no", c[6]));
  double margin = vnv::not_a_number;
  if (!c[7].empty() && !is_read(c[7], margin))
    refuse(fmt::format("margin [-] '{}', expected a number or nothing", c[7]));
  return {.fault = c[0],
          .title = c[1],
          .files = c[2],
          .conclusion = static_cast<Conclusion>(conclusion - conclusions.begin()),
          .why = c[4],
          .revision = c[9],
          .date_and_time = c[10],
          .tests = {{c[5], c[6] == "yes", margin, c[8]}}};
}

/// What is open first; of the rest what was hardly noticed.
void sort(std::vector<FaultTrial>& trials) {
  const auto place = [](const FaultTrial& trial) {
    const FaultTest* clearest = trial.clearest();
    const double margin = clearest && !std::isnan(clearest->margin) ? clearest->margin : 0;
    return std::tuple(trial.conclusion, -margin, trial.fault);
  };
  std::ranges::sort(trials, {}, place);
}

std::string percent_of(long part, long whole) {
  return fmt::format("{:.1f}\u202f%", 100.0 * static_cast<double>(part) / static_cast<double>(whole));
}

}  // namespace

const FaultTest* FaultTrial::clearest() const {
  const FaultTest* found = nullptr;
  for (const FaultTest& test : tests) {
    if (!test.noticed) continue;
    const bool has_first_margin = found && std::isnan(found->margin) && !std::isnan(test.margin);
    if (!found || test.margin < found->margin || has_first_margin) found = &test;
  }
  return found;
}

std::string FaultTrials::sentence() const {
  const auto count = [&](Conclusion expected) { return std::ranges::count(trials, expected, &FaultTrial::conclusion); };
  const long harmless = std::ranges::count_if(trials, &FaultTrial::is_harmless);
  const long faults = std::ssize(trials) - harmless, alarms = count(Conclusion::false_alarm);
  const long by_day = count(Conclusion::noticed), in_all = by_day + count(Conclusion::noticed_at_night);
  std::string words;
  if (faults > 0)
    words = fmt::format("{} of {} noticed by day ({}), {} in all ({})", by_day, counted(faults, "seeded fault"),
                        percent_of(by_day, faults), in_all, percent_of(in_all, faults));
  if (harmless > 0)
    words += fmt::format("{}{} from {}", words.empty() ? "" : "; ", counted(alarms, "false alarm"),
                         counted(harmless, "harmless change"));
  if (untried > 0) words += fmt::format("; {} not tried yet", untried);
  return words + ".";
}

FaultTrials read_fault_trials(const std::filesystem::path& file) {
  const vnv::Sheet sheet = vnv::read_sheet(file);
  vnv::require_headings(sheet, trial_columns);
  const auto& untried = sheet.key("untried");
  FaultTrials all{sheet.key("machine").value, sheet.key("tests").value, -1, {}, file};
  if (!is_read(untried.value, all.untried) || all.untried < 0)
    throw vnv::BadData(file, untried.line, fmt::format("untried '{}', expected how many", untried.value));
  for (const auto& row : sheet.rows) {
    FaultTrial trial = trial_on(sheet, row);
    const auto known = std::ranges::find(all.trials, trial.fault, &FaultTrial::fault);
    if (known == all.trials.end()) {
      all.trials.push_back(std::move(trial));
      continue;
    }
    const auto said = [](const FaultTrial& t) { return std::tie(t.title, t.files, t.conclusion, t.why, t.revision); };
    if (said(*known) != said(trial))
      throw vnv::BadData(
          file, row.line,
          fmt::format("fault '{}' is described otherwise than above, expected the same for each test", trial.fault));
    known->tests.push_back(std::move(trial.tests.front()));
  }
  sort(all.trials);
  return all;
}

}  // namespace touchstone::reports

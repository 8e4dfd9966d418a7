#include "reports/read/fault_trials.hpp"

#include "reports/read/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <tuple>

namespace touchstone::reports {
namespace {

const std::vector<std::string> columns{"fault",   "title",      "files",    "conclusion", "why",      "test",
                                       "noticed", "margin [-]", "sentence", "revision",   "tried at", "digest"};

// In the order of the enumerators.
constexpr auto conclusions = std::to_array<std::string_view>(
    {"survived", "does not compile", "false alarm", "noticed at night", "noticed", "stays green"});

Conclusion conclusion_of(const std::string& word, const Line& line) {
  const auto found = std::ranges::find(conclusions, word);
  if (found == conclusions.end())
    line.refuse(fmt::format("conclusion '{}', expected one such as '{}'", word, conclusions.front()));
  return static_cast<Conclusion>(found - conclusions.begin());
}

bool yes_or_no(const std::string& word, const Line& line) {
  if (word != "yes" && word != "no") line.refuse(fmt::format("noticed '{}', expected yes or no", word));
  return word == "yes";
}

double margin_of(const std::string& text, const Line& line) {
  if (text.empty()) return vnv::not_a_number;
  double value = 0;
  const char* last = text.data() + text.size();
  if (std::from_chars(text.data(), last, value).ptr != last)
    line.refuse(fmt::format("margin [-] '{}', expected a number or nothing", text));
  return value;
}

long count_of(const std::string& text, const Line& line) {
  long value = -1;
  const char* last = text.data() + text.size();
  if (std::from_chars(text.data(), last, value).ptr != last || value < 0)
    line.refuse(fmt::format("untried '{}', expected how many", text));
  return value;
}

FaultTrial trial_on(const Row& row) {
  const auto& f = row.fields;
  for (const std::size_t i : {0, 1, 5, 9, 10})
    if (f[i].empty()) row.line.refuse(fmt::format("no {}, expected one", columns[i]));
  return {.fault = f[0],
          .title = f[1],
          .files = f[2],
          .conclusion = conclusion_of(f[3], row.line),
          .why = f[4],
          .revision = f[9],
          .date_and_time = f[10],
          .tests = {{f[5], yes_or_no(f[6], row.line), margin_of(f[7], row.line), f[8]}}};
}

/// A fault has as many lines as tests were run.
void add(std::vector<FaultTrial>& all, FaultTrial trial, const Line& line) {
  const auto known = std::ranges::find(all, trial.fault, &FaultTrial::fault);
  if (known == all.end()) {
    all.push_back(std::move(trial));
    return;
  }
  const auto told = [](const FaultTrial& t) { return std::tie(t.title, t.files, t.conclusion, t.why, t.revision); };
  if (told(*known) != told(trial))
    line.refuse(fmt::format("fault '{}' is told otherwise than above, expected the same of each test", trial.fault));
  known->tests.push_back(std::move(trial.tests.front()));
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

std::string_view name_of(Conclusion conclusion) { return conclusions[static_cast<std::size_t>(conclusion)]; }

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
    words =
        fmt::format("{} of {} seeded {} noticed by day ({}), {} in all ({})", by_day, faults,
                    faults == 1 ? "fault" : "faults", percent_of(by_day, faults), in_all, percent_of(in_all, faults));
  if (harmless > 0)
    words += fmt::format("{}{} false {} from {} harmless {}", words.empty() ? "" : "; ", alarms,
                         alarms == 1 ? "alarm" : "alarms", harmless, harmless == 1 ? "change" : "changes");
  if (untried > 0) words += fmt::format("; {} not tried yet", untried);
  return words + ".";
}

FaultTrials read_fault_trials(const std::filesystem::path& file) {
  const Rows rows = read_rows(file, columns);
  const auto key = [&](const char* name) {
    const auto found = rows.keys.find(name);
    if (found == rows.keys.end()) Line{file, 1}.refuse(fmt::format("no key '{}', expected '# {}: ...'", name, name));
    return found->second;
  };
  FaultTrials all{key("machine"), key("tests"), count_of(key("untried"), {file, 1}), {}};
  if (rows.rows.empty()) Line{file, 1}.refuse("no trials, expected at least one");
  for (const Row& row : rows.rows) add(all.trials, trial_on(row), row.line);
  sort(all.trials);
  return all;
}

}  // namespace touchstone::reports

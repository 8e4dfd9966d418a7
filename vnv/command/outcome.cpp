#include "vnv/command/outcome.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

namespace touchstone::vnv::command {
namespace {

/// Short of memory, killed, on a full disk: another time it may be otherwise.
bool is_of_method(const Record& record) {
  const auto crashed = [](const RunSummary& run) { return run.outcome.starts_with("died of signal"); };
  return std::ranges::none_of(record.runs, crashed) &&
         std::ranges::find(record.verdicts, could_be_assessed, &Verdict::quantity) == record.verdicts.end();
}

/// ": what" of the last line "CASE.METHOD: what" or "CASE: what" that a program said; nothing if there is none.
std::string complaint_in(const std::filesystem::path& log, const std::string& name) {
  std::string complaint;
  std::ifstream lines(log);
  for (std::string line; std::getline(lines, line);)
    for (const std::string& who : {name + ": ", name.substr(0, name.find('.')) + ": "})
      if (line.starts_with(who)) complaint = ": " + line.substr(who.size());
  return complaint;
}

/// Where it said more, unless the disk was full.
std::string where(const std::filesystem::path& log) {
  std::error_code ignored;
  const bool has_space = std::filesystem::space(log, ignored).available > 0 || ignored;
  return log.string() + (has_space ? "" : ", on a disk that is full");
}

}  // namespace

MethodOutcome outcome_in(const Record& record) {
  MethodOutcome outcome;
  for (const RunSummary& run : record.runs) outcome.spent += run.cost.spent() * static_cast<double>(run.cost.repeats);
  if (!record.runs.empty()) outcome.resource = record.runs.front().cost.resource;
  for (const Verdict& verdict : record.verdicts) {
    ++outcome.judged;
    if (verdict.outcome == Outcome::holds)
      ++outcome.held;
    else
      outcome.failures.push_back(verdict.sentence);
  }
  outcome.is_inconclusive = !outcome.failures.empty() && std::ranges::find(record.verdicts, Outcome::fails,
                                                                           &Verdict::outcome) == record.verdicts.end();
  outcome.is_of_method = is_of_method(record);
  return outcome;
}

MethodOutcome outcome_of(const std::string& name, const JobResult& result, const std::filesystem::path& record,
                         const std::filesystem::path& log) {
  const bool is_written = std::filesystem::exists(record);
  MethodOutcome outcome = is_written ? outcome_in(read_record(record)) : MethodOutcome{};
  if (!result.succeeded() && outcome.failures.empty())
    outcome.failures.push_back(
        fmt::format("{}: its program {}{}; {}", name, result.sentence(), complaint_in(log, name), where(log)));
  else if (!is_written)
    outcome.failures.push_back(fmt::format("{}: its program wrote no record; {}", name, where(log)));
  return outcome;
}

bool is_conclusive(const MethodOutcome& outcome, const JobResult& result) {
  return result.stopped.empty() && result.ending.signal == 0 && outcome.is_of_method && outcome.judged > 0 &&
         (result.ending.status == 0) == (outcome.held == outcome.judged);
}

}  // namespace touchstone::vnv::command

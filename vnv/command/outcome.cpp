#include "vnv/command/outcome.hpp"

#include <fmt/format.h>

namespace touchstone::vnv::command {

MethodOutcome outcome_in(const Record& record) {
  MethodOutcome outcome;
  for (const RunSummary& run : record.runs) outcome.cpu += run.cost.cpu * static_cast<double>(run.cost.repeats);
  for (const Verdict& verdict : record.verdicts) {
    ++outcome.judged;
    if (verdict.outcome == Outcome::holds)
      ++outcome.held;
    else
      outcome.failures.push_back(verdict.sentence);
  }
  return outcome;
}

MethodOutcome outcome_of(const std::string& name, const Ending& ending, const std::filesystem::path& record,
                         const std::filesystem::path& log) {
  const bool is_written = std::filesystem::exists(record);
  MethodOutcome outcome = is_written ? outcome_in(read_record(record)) : MethodOutcome{};
  if (!ending.well() && outcome.failures.empty())
    outcome.failures.push_back(fmt::format("{}: its program {}; {}", name, ending.sentence(), log.string()));
  else if (!is_written)
    outcome.failures.push_back(fmt::format("{}: its program wrote no record; {}", name, log.string()));
  return outcome;
}

bool is_conclusive(const MethodOutcome& outcome, const Ending& ending) {
  return ending.signal == 0 && outcome.judged > 0 && (ending.status == 0) == (outcome.held == outcome.judged);
}

}  // namespace touchstone::vnv::command

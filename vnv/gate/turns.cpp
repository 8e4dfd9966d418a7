#include "vnv/gate/turns.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace touchstone::gate {
namespace {

namespace fs = std::filesystem;

const vnv::Record* record_in(const Records& records, const Contest& contest) {
  const auto found = std::ranges::find_if(records, [&](const vnv::Record& record) {
    return record.case_name == contest.case_name && record.method == contest.method;
  });
  return found == records.end() ? nullptr : &*found;
}

const vnv::RunSummary* finished_run(const vnv::Record& record, const std::string& level) {
  const auto found = std::ranges::find(record.runs, level, &vnv::RunSummary::level);
  return found == record.runs.end() || !found->finished ? nullptr : &*found;
}

}  // namespace

RunOnce run_of(const Program& program, const std::string& method, const std::string& suite) {
  return [=](std::ostream& log) -> std::optional<vnv::Record> {  // that claims fail is no matter here
    const programs::ScratchFolder scratch;
    const fs::path output = scratch.path() / "output";
    const programs::Ending ending = programs::run_into(output, {program.file, "--suite", suite, "--method", method,
                                                                "--records", scratch.path(), "--data", program.data});
    const fs::path file = scratch.path() / fmt::format("{}.{}.json", program.case_name, method);
    if (fs::exists(file)) return vnv::read_record(file);
    log << fmt::format("gate: {} --method {} {} and no record: {}\n", program.file.string(), method, ending.sentence(),
                       programs::last_lines(output, 3))
        << std::flush;
    return std::nullopt;
  };
}

Turns take_turns(const std::vector<Contest>& contests, long pairs, std::ostream& log) {
  log << fmt::format("gate: runs {} methods by both programs, {} times in turn\n", contests.size(), pairs)
      << std::flush;
  Turns turns;
  const auto run = [&](const RunOnce& once, Records& records) {
    if (std::optional<vnv::Record> record = once(log)) records.push_back(std::move(*record));
  };
  for (long pair = 0; pair < pairs; ++pair) {
    Records &before = turns.before.emplace_back(), &after = turns.after.emplace_back();
    for (const Contest& contest : contests) {
      if (pair > 0 && contest.is_timed) continue;
      if (pair % 2 == 0) run(contest.before, before);
      run(contest.after, after);
      if (pair % 2 == 1) run(contest.before, before);
    }
  }
  return turns;
}

Timing timing_of(const Contest& contest, const Turns& turns) {
  Timing timing{contest.case_name, contest.method, {}, {}};
  for (std::size_t pair = 0; pair < turns.before.size(); ++pair) {
    const vnv::Record *before = record_in(turns.before[pair], contest), *after = record_in(turns.after[pair], contest);
    if (!before || !after) continue;
    double was = 0, is = 0;
    for (const vnv::RunSummary& run : before->runs) {
      const vnv::RunSummary* other = finished_run(*after, run.level);
      if (!run.finished || !other) continue;
      was += run.cost.spent();
      is += other->cost.spent();
      timing.resource_before = run.cost.resource;
      timing.resource_after = other->cost.resource;
    }
    timing.before.push_back(was);
    timing.after.push_back(is);
  }
  return timing;
}

}  // namespace touchstone::gate

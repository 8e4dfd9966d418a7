#include "vnv/gate/turns.hpp"

#include "vnv/programs/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

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

/// Runs that are to come, each expected to take what its method took when it ran last, by either program.
class Ahead {
 public:
  Ahead(const std::vector<Contest>& contests, long pairs) : pairs_(pairs) {
    for (const Contest& contest : contests) expect(contest, 0, std::nullopt);
  }
  void begin(const Contest& contest, bool is_after, long pair) {
    began_ = programs::Work::Clock::now();
    work_.begin(name_of(contest, is_after, pair), began_);
  }
  void show() {
    line_.show([&] { return work_.sentence(); });
  }
  void end(const Contest& contest, bool is_after, long pair) {
    const auto now = programs::Work::Clock::now();
    work_.end(name_of(contest, is_after, pair), now);
    expect(contest, pair, std::chrono::duration<double>(now - began_).count());
    line_.clear();
  }

 private:
  static std::string name_of(const Contest& contest, bool is_after, long pair) {
    return fmt::format("{}.{} {}, pair {}", contest.case_name, contest.method, is_after ? "after" : "before", pair + 1);
  }
  void expect(const Contest& contest, long from, std::optional<double> seconds) {
    for (long pair = from; pair < (contest.is_timed ? 1 : pairs_); ++pair)
      for (const bool is_after : {false, true}) work_.expect(name_of(contest, is_after, pair), seconds);
  }

  long pairs_;
  programs::Work work_;
  programs::Progress line_{"gate"};
  programs::Work::Clock::time_point began_{};
};

}  // namespace

RunOnce run_of(const Program& program, const std::string& method, const std::string& suite) {
  return
      [=](std::ostream& log,
          const programs::Meanwhile& meanwhile) -> std::optional<vnv::Record> {  // that claims fail is no matter here
        const programs::ScratchFolder scratch;
        const fs::path output = scratch.path() / "output";
        const programs::Ending ending = programs::run_into(
            output,
            {program.file, "--suite", suite, "--method", method, "--records", scratch.path(), "--data", program.data},
            meanwhile);
        const fs::path file = scratch.path() / fmt::format("{}.{}.json", program.case_name, method);
        if (fs::exists(file)) return vnv::read_record(file);
        log << fmt::format("gate: {} --method {} {} and no record: {}\n", program.file.string(), method,
                           ending.sentence(), programs::last_lines(output, 3))
            << std::flush;
        return std::nullopt;
      };
}

Turns take_turns(const std::vector<Contest>& contests, long pairs, std::ostream& log) {
  log << fmt::format("gate: runs {} methods by both programs, {} times in turn\n", contests.size(), pairs)
      << std::flush;
  Turns turns;
  Ahead ahead(contests, pairs);
  const auto run = [&](const Contest& contest, bool is_after, long pair) {
    ahead.begin(contest, is_after, pair);
    std::ostringstream said;
    std::optional<vnv::Record> record = (is_after ? contest.after : contest.before)(said, [&] { ahead.show(); });
    ahead.end(contest, is_after, pair);
    log << said.str() << std::flush;
    if (record) (is_after ? turns.after : turns.before).back().push_back(std::move(*record));
  };
  for (long pair = 0; pair < pairs; ++pair) {
    turns.before.emplace_back();
    turns.after.emplace_back();
    for (const Contest& contest : contests) {
      if (pair > 0 && contest.is_timed) continue;
      const bool after_is_first = pair % 2 == 1;
      run(contest, after_is_first, pair);
      run(contest, !after_is_first, pair);
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

#include "vnv/gate/turns.hpp"

#include "vnv/programs/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace touchstone::gate {
namespace {

namespace fs = std::filesystem;

const vnv::Record* record_in(const Records& records, const Contest& contest) {
  const auto found = std::ranges::find_if(records, [&](const auto& one) { return are_of_one_method(one, contest); });
  return found == records.end() ? nullptr : &*found;
}

const vnv::RunSummary* finished_run(const vnv::Record& record, const std::string& level) {
  const auto found = std::ranges::find(record.runs, level, &vnv::RunSummary::level);
  return found == record.runs.end() || !found->finished ? nullptr : &*found;
}

constexpr double long_enough = 0.6;  // s  of an excerpt: twelve times the shortest run that is timed
constexpr long whole_pairs = 2;      // where excerpts are timed: whether values are the same in all runs

/// So long a beginning of the level that took longest; none where the whole took little longer, or is not told in
/// seconds of the CPU.
std::optional<Excerpt> excerpt_of(const vnv::Record& record) {
  double all = 0;
  const vnv::RunSummary* dearest = nullptr;
  for (const vnv::RunSummary& run : record.runs) {
    if (!run.finished || run.cost.resource != vnv::Resource::cpu || !(run.cost.cpu > 0)) return std::nullopt;
    all += run.cost.cpu;
    if (!dearest || run.cost.cpu > dearest->cost.cpu) dearest = &run;
  }
  if (all < 2 * long_enough || !(dearest->spacing > 0)) return std::nullopt;
  return Excerpt{dearest->spacing, dearest->end_time * std::min(1.0, long_enough / dearest->cost.cpu)};
}

/// Runs that are to come, each expected to take what its method took when it ran last, by either program.
class Ahead {
 public:
  void expect(const Contest& contest, long from, long to, std::optional<double> seconds) {
    for (long round = from; round < to; ++round)
      for (const bool is_after : {false, true}) work_.expect(name_of(contest, is_after, round), seconds);
  }
  void begin(const Contest& contest, bool is_after, long round) {
    began_ = programs::Work::Clock::now();
    work_.begin(name_of(contest, is_after, round), began_);
  }
  void show() {
    line_.show([&] { return work_.sentence(); });
  }
  void end(const Contest& contest, bool is_after, long round, long to) {
    const auto now = programs::Work::Clock::now();
    work_.end(name_of(contest, is_after, round), now);
    expect(contest, round, to, std::chrono::duration<double>(now - began_).count());
    line_.clear();
  }

 private:
  static std::string name_of(const Contest& contest, bool is_after, long round) {
    return fmt::format("{}.{} {}, pair {}", contest.case_name, contest.method, is_after ? "after" : "before",
                       round + 1);
  }

  programs::Work work_;
  programs::Progress line_{"gate"};
  programs::Work::Clock::time_point began_{};
};

}  // namespace

RunOnce run_of(const Program& program, const std::string& method, const std::string& suite,
               const std::optional<Excerpt>& excerpt) {
  return
      [=](std::ostream& log,
          const programs::Meanwhile& meanwhile) -> std::optional<vnv::Record> {  // that claims fail is no matter here
        const programs::ScratchFolder scratch;
        const fs::path output = scratch.path() / "output";
        programs::Words words{program.file, "--suite",      suite,    "--method",  method,
                              "--records",  scratch.path(), "--data", program.data};
        if (excerpt)
          words.insert(words.end(), {"--spacing", fmt::format("{}", excerpt->spacing), "--until",
                                     fmt::format("{}", excerpt->until)});
        const programs::Ending ending = programs::run_into(output, words, meanwhile);
        const fs::path file = scratch.path() / fmt::format("{}.{}.json", program.case_name, method);
        if (fs::exists(file)) return vnv::read_record(file);
        if (!excerpt)
          log << fmt::format("gate: {} --method {} {} and no record: {}\n", program.file.string(), method,
                             ending.sentence(), programs::last_lines(output, 3))
              << std::flush;
        return std::nullopt;
      };
}

Turns take_turns(std::vector<Contest>& contests, long pairs, std::ostream& log) {
  log << fmt::format("gate: runs {} methods by both programs, {} times in turn\n", contests.size(), pairs)
      << std::flush;
  Turns turns;
  Ahead ahead;
  // Of each method the round in which its excerpts begin, if any, and the round after its last.
  struct Rounds {
    long excerpts, end;
  };
  std::vector<Rounds> rounds;
  for (const Contest& contest : contests) {
    const long all = contest.is_timed ? 1 : pairs;
    rounds.push_back({contest.excerpt ? 0 : all, all});
    ahead.expect(contest, 0, all, std::nullopt);
  }
  const auto run = [&](const Contest& contest, bool is_after, long round, const Rounds& of) {
    const bool is_excerpt = round >= of.excerpts;
    std::vector<Records>&before = is_excerpt ? turns.excerpts_before : turns.before,
    &after = is_excerpt ? turns.excerpts_after : turns.after;
    for (std::vector<Records>* all : {&before, &after})
      all->resize(std::max(all->size(), static_cast<std::size_t>(round) + 1));
    ahead.begin(contest, is_after, round);
    std::ostringstream said;
    const RunOnce run_once = is_excerpt ? (is_after ? contest.excerpt_after : contest.excerpt_before)(*contest.excerpt)
                                        : (is_after ? contest.after : contest.before);
    std::optional<vnv::Record> record = run_once(said, [&] { ahead.show(); });
    ahead.end(contest, is_after, round, is_excerpt ? of.end : std::min(of.end, of.excerpts));
    log << said.str() << std::flush;
    if (!record) return false;
    (is_after ? after : before)[static_cast<std::size_t>(round)].push_back(std::move(*record));
    return true;
  };
  for (long round = 0; std::ranges::any_of(rounds, [&](const Rounds& of) { return round < of.end; }); ++round)
    for (std::size_t k = 0; k < contests.size(); ++k) {
      Contest& contest = contests[k];
      Rounds& of = rounds[k];
      if (round >= of.end) continue;
      const bool after_is_first = round % 2 == 1, first = run(contest, after_is_first, round, of),
                 second = run(contest, !after_is_first, round, of);
      if (round == whole_pairs && of.excerpts == whole_pairs && !(first && second)) {  // whole runs, then
        contest.excerpt.reset();
        of = {pairs + 1, pairs + 1};
      }
      if (round > 0 || pairs < 2 || contest.is_timed || contest.excerpt || !contest.excerpt_before || !first || !second)
        continue;
      contest.excerpt = excerpt_of(*record_in(turns.before[0], contest));
      if (!contest.excerpt) continue;
      of = {whole_pairs, whole_pairs + pairs};
      ahead.expect(contest, whole_pairs, of.end, long_enough);
    }
  return turns;
}

Timing timing_of(const Contest& contest, const Turns& turns) {
  Timing timing{contest.case_name, contest.method, {}, {}};
  const auto& [all_before, all_after] = contest.excerpt ? std::tie(turns.excerpts_before, turns.excerpts_after)
                                                        : std::tie(turns.before, turns.after);
  for (std::size_t pair = 0; pair < std::min(all_before.size(), all_after.size()); ++pair) {
    const vnv::Record *before = record_in(all_before[pair], contest), *after = record_in(all_after[pair], contest);
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

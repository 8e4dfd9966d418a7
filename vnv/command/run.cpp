/// vnv run: judges methods by their programs, several at once, and skips what was done before from the same inputs.

#include "vnv/command/commands.hpp"
#include "vnv/command/inputs.hpp"
#include "vnv/command/outcome.hpp"
#include "vnv/command/solvers.hpp"
#include "vnv/command/terminal.hpp"
#include "vnv/files/whole_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>

namespace touchstone::vnv::command {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

struct Job {
  Chosen chosen;
  Inputs inputs;
};

/// What came of all methods.
struct Sum {
  long methods = 0, failed = 0, skipped = 0, not_run = 0;
  long held = 0, judged = 0;  // claims
  std::vector<std::string> failures{};
};

void print_line(const std::string& name, const MethodOutcome& outcome, std::string_view how) {
  const bool holds = outcome.failures.empty();
  fmt::print("{} {}: {} of {} claims hold, {:.3g} {} s{}\n",
             coloured(holds ? Colour::green : Colour::red, holds ? "holds" : "FAILS"), name, outcome.held,
             outcome.judged, outcome.spent, words(outcome.resource).at(static_cast<std::size_t>(outcome.resource)),
             how);
  std::fflush(stdout);
}

void add(Sum& sum, const std::string& name, const MethodOutcome& outcome, bool skipped) {
  ++sum.methods;
  sum.failed += !outcome.failures.empty();
  sum.skipped += skipped;
  sum.held += outcome.held;
  sum.judged += outcome.judged;
  sum.failures.insert(sum.failures.end(), outcome.failures.begin(), outcome.failures.end());
  if (!skipped || !outcome.failures.empty()) print_line(name, outcome, skipped ? ", as before" : "");
}

/// Runs jobs, the dearest first, and those whose claims are of time alone, last.
class Runner {
 public:
  Runner(const Build& build, const RunOptions& options, Sum& sum) : build_(build), options_(options), sum_(sum) {}

  void run(std::vector<Job> jobs) {
    std::ranges::sort(jobs, [](const Job& a, const Job& b) {
      const auto place = [](const Job& job) {
        return std::pair(job.chosen.of->timed, -job.chosen.method->relative_cost);
      };
      return place(a) < place(b);
    });
    count_ = jobs.size();
    auto next = jobs.cbegin();
    while (next != jobs.cend() || !running_.empty()) {
      while (next != jobs.cend() && may_start(*next)) begin(*next++);
      if (const std::optional<programs::Child> child = programs_.wait(between_shows)) end(*child);
      show_progress();
    }
  }

 private:
  static constexpr std::chrono::milliseconds between_shows{200};

  struct Started {
    const Job* job;
    Clock::time_point since;
  };

  bool may_start(const Job& job) const {
    const bool one_is_timed =
        std::ranges::any_of(running_, [](const auto& entry) { return entry.second.job->chosen.of->timed; });
    return running_.empty() || (!job.chosen.of->timed && !one_is_timed && std::ssize(running_) < options_.at_once);
  }

  fs::path log(const std::string& name) const { return options_.records / "logs" / (name + ".txt"); }

  void begin(const Job& job) {
    const std::string name = job.chosen.name();
    forget(options_.records, name);
    const Words call = build_.call(job.chosen.of->name, {"--method", job.chosen.method->name, "--suite", options_.suite,
                                                         "--records", options_.records.string()});
    running_.emplace(programs_.start(name, call, log(name)), Started{&job, Clock::now()});
  }

  void end(const programs::Child& child) {
    const Job& job = *running_.at(child.id).job;
    running_.erase(child.id);
    const std::string name = job.chosen.name();
    const MethodOutcome outcome = outcome_of(name, child.ending, record_file(options_.records, name), log(name));
    if (is_conclusive(outcome, child.ending)) set_done(options_.records, name, job.inputs);
    line_.clear();
    add(sum_, name, outcome, false);
    ++ended_;
  }

  void show_progress() {
    if (Clock::now() - shown_ < between_shows) return;
    shown_ = Clock::now();
    std::string text = fmt::format("{} of {}:", ended_, count_);
    for (const auto& [id, one] : running_)
      text += fmt::format(" {} {:.0f} s", one.job->chosen.name(),
                          std::chrono::duration<double>(shown_ - one.since).count());
    line_.show(text);
  }

  const Build& build_;
  const RunOptions& options_;
  Sum& sum_;
  ProgressLine line_;
  programs::Running programs_;
  std::map<pid_t, Started> running_;
  std::size_t ended_ = 0, count_ = 0;
  Clock::time_point shown_{};
};

/// The jobs that are still to do; what was done before is added to the sum.
std::vector<Job> skip_done(const Build& build, const RunOptions& options, const std::vector<Chosen>& methods,
                           Sum& sum) {
  std::map<const Description*, std::string> hashes;
  std::vector<Job> todo;
  for (const Chosen& one : methods) {
    std::string& hash = hashes[one.of];
    if (hash.empty()) hash = hash_of_inputs(build.program(one.of->name), *one.of);
    const Inputs inputs{hash, options.suite};
    if (options.again || !is_done(options.records, one.name(), inputs)) {
      todo.push_back({one, inputs});
      continue;
    }
    const fs::path record = record_file(options.records, one.name());
    files::remove_what_the_killed_left(record);
    add(sum, one.name(), outcome_in(read_record(record)), true);
  }
  return todo;
}

/// Another code is run anew each time: of what it is made from nothing is known.
void run_solver(const doors::Solver& solver, const RunOptions& options, Sum& sum) {
  if (const std::string missing = missing_here(solver); !missing.empty()) {
    fmt::print("{}: not run: needs {}\n", solver.case_and_method(), missing);
    ++sum.not_run;
    return;
  }
  const doors::Judgement judgement = run_and_record(solver, options.suite, options.records);
  const std::string name = solver.case_and_method();
  fmt::print("{}\n", name);
  if (const auto& files = judgement.files; !files.empty())
    fmt::print("  {}{}\n", files.front(), files.size() > 1 ? fmt::format(", and {} more", files.size() - 1) : "");
  for (const std::string& line : judgement.words) fmt::print("  {}\n", line);
  for (const std::string& line : judgement.not_judged) fmt::print("  not judged: {}\n", line);
  add(sum, name, outcome_in(judgement.record), false);
}

int conclude(const Sum& sum) {
  for (const std::string& sentence : sum.failures) fmt::print("{}\n", coloured(Colour::red, sentence));
  fmt::print("{} of {} methods hold, {} of {} claims", sum.methods - sum.failed, sum.methods, sum.held, sum.judged);
  if (sum.skipped > 0)
    fmt::print("; {} skipped, whose programs and data are as they were (--again runs them)", sum.skipped);
  if (sum.not_run > 0) fmt::print("; {} not run, for want of programs", sum.not_run);
  fmt::print("\n");
  return sum.failures.empty() && sum.methods > 0 ? all_holds : something_fails;
}

}  // namespace

int run(const Build& build, const RunOptions& chosen) {
  RunOptions options = chosen;
  const std::vector<doors::Solver> solvers = take_solvers(options.patterns);
  if (options.records.empty()) options.records = build.records(options.suite);
  files::make_folder(options.records / "logs");
  Sum sum;
  if (solvers.empty() || !options.patterns.empty()) {
    const Catalogue catalogue = read_catalogue(build, options.patterns);
    const std::vector<Chosen> methods = choose_all(catalogue, options.patterns, options.suite);
    const std::vector<Job> todo = skip_done(build, options, methods, sum);
    Runner(build, options, sum).run(todo);
  }
  for (const doors::Solver& solver : solvers) run_solver(solver, options, sum);
  return conclude(sum);
}

}  // namespace touchstone::vnv::command

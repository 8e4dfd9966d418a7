/// vnv run: judges methods by their programs, wherever these run, and skips what was done before from the same inputs.

#include "vnv/command/commands.hpp"
#include "vnv/command/inputs.hpp"
#include "vnv/command/outcome.hpp"
#include "vnv/command/solvers.hpp"
#include "vnv/command/terminal.hpp"
#include "vnv/command/values.hpp"
#include "vnv/files/whole_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace touchstone::vnv::command {
namespace {

namespace fs = std::filesystem;

/// What came of all methods.
struct Sum {
  long methods = 0, failed = 0, skipped = 0, not_run = 0;
  long held = 0, judged = 0;  // claims
  std::vector<std::string> failures{};
};

void print_line(const std::string& name, const MethodOutcome& outcome, std::string_view how) {
  const std::string word = outcome.failures.empty()  ? coloured(Colour::green, "holds")
                           : outcome.is_inconclusive ? coloured(Colour::yellow, "inconclusive")
                                                     : coloured(Colour::red, "FAILS");
  const std::string claims =
      outcome.judged > 0 ? fmt::format("{} of {} claims hold", outcome.held, outcome.judged) : "nothing judged";
  fmt::print("{} {}: {}, {:.3g} {} s{}\n", word, name, claims, outcome.spent,
             words(outcome.resource).at(static_cast<std::size_t>(outcome.resource)), how);
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

/// The methods of a suite, judged by their programs wherever these run.
class Judging {
 public:
  Judging(const Build& build, const RunOptions& options, Sum& sum)
      : build_{fs::absolute(build.folder), build.data.empty() ? "" : fs::absolute(build.data)},
        options_(options),
        sum_(sum) {}

  void judge(const std::vector<Chosen>& methods) {
    std::vector<Job> todo;
    for (const Chosen& one : methods)
      if (options_.again || !was_done(one)) todo.push_back(job_of(one));
    make_engine(options_.where)
        ->run(std::move(todo),
              {.begins = [&](const Job& job) { begin(job); },
               .ended = [&](const Job& job, const JobResult& result) { end(job.name, result, false); }});
  }

 private:
  const fs::path& records() const { return options_.where.records; }

  const Inputs& inputs_of(const Chosen& one) {
    std::string& hash = hashes_[one.of];
    if (hash.empty()) hash = hash_of_inputs(build_.program(one.of->name), *one.of);
    return inputs_.insert_or_assign(one.name(), Inputs{hash, options_.suite}).first->second;
  }

  static std::string key_of(const Inputs& inputs) { return inputs.suite + "-" + inputs.hash; }

  /// Then it is added to the sum. What ended elsewhere while nobody listened is heard now.
  bool was_done(const Chosen& one) {
    const std::string name = one.name();
    const Inputs& inputs = inputs_of(one);
    if (!is_done(records(), name, inputs)) {
      const std::optional<JobResult> result = ended_elsewhere(records(), name, key_of(inputs));
      return result && end(name, *result, true);
    }
    const fs::path record = record_file(records(), name);
    files::remove_what_the_killed_left(record);
    add(sum_, name, outcome_in(read_record(record)), true);
    return true;
  }

  Job job_of(const Chosen& one) {
    const std::string name = one.name();
    return {.name = name,
            .key = key_of(inputs_of(one)),
            .call = build_.call(one.of->name, {"--method", one.method->name, "--suite", options_.suite, "--records",
                                               records().string()}),
            .alone = one.of->timed,
            .relative_cost = one.method->relative_cost,
            .last = last_cost(record_file(records(), name))};
  }

  void begin(const Job& job) {
    forget(records(), job.name);
    forget_ended(records(), job.name);
  }

  /// Whether that is how it ends; a former run's is only if another would give the same.
  bool end(const std::string& name, const JobResult& result, bool is_former) {
    const MethodOutcome outcome =
        outcome_of(name, result, record_file(records(), name), records() / "logs" / (name + ".txt"));
    const bool is_final = is_conclusive(outcome, result);
    if (is_final) set_done(records(), name, inputs_.at(name));
    if (is_final || !is_former) add(sum_, name, outcome, is_former);
    return is_final;
  }

  const Build build_;
  const RunOptions& options_;
  Sum& sum_;
  std::map<const Description*, std::string> hashes_;
  std::map<std::string, Inputs> inputs_;  // by name of the method
};

/// Another code is run anew each time: of what it is made from nothing is known.
void run_solver(const doors::Solver& solver, const RunOptions& options, Sum& sum) {
  if (const std::string missing = missing_here(solver); !missing.empty()) {
    fmt::print("{}: not run: needs {}\n", solver.case_and_method(), missing);
    ++sum.not_run;
    return;
  }
  const doors::Judgement judgement = run_and_record(solver, options.suite, options.where.records);
  const std::string name = solver.case_and_method();
  fmt::print("{}\n", name);
  if (const auto& files = judgement.files; !files.empty())
    fmt::print("  {}{}\n", files.front(), files.size() > 1 ? fmt::format(", and {} more", files.size() - 1) : "");
  for (const std::string& line : judgement.words) fmt::print("  {}\n", line);
  print_values(judgement.record);
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

int run(const Build& build, RunOptions options) {
  const std::vector<doors::Solver> solvers = take_solvers(options.patterns);
  if (options.where.records.empty()) options.where.records = build.records(options.suite);
  options.where.records = fs::absolute(options.where.records);
  Catalogue catalogue;
  std::vector<Chosen> methods;
  if (solvers.empty() || !options.patterns.empty()) {
    catalogue = read_catalogue(build, options.patterns);
    methods = choose_all(catalogue, options.patterns, options.suite);
  }
  files::make_folder(options.where.records / "logs");
  Sum sum;
  Judging(build, options, sum).judge(methods);
  for (const doors::Solver& solver : solvers) run_solver(solver, options, sum);
  return conclude(sum);
}

}  // namespace touchstone::vnv::command

/// The program of one case: each method of the_case() becomes a test.

#include "solvers/lattice.hpp"
#include "vnv/files/held_folder.hpp"
#include "vnv/files/whole_file.hpp"
#include "vnv/harness/assess.hpp"
#include "vnv/harness/describe.hpp"
#include "vnv/harness/measurements.hpp"
#include "vnv/harness/mutate.hpp"
#include "vnv/harness/options.hpp"
#include "vnv/harness/run_levels.hpp"
#include "vnv/programs/out_of_memory.hpp"
#include "vnv/record/same_time.hpp"
#include "vnv/run/vtp_series.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

namespace touchstone::vnv {
namespace {

std::string case_name;  // that of the program

Options options;

std::filesystem::path baselines_file() { return data_folder() / "baselines" / (case_name + ".csv"); }

Baselines baselines_of_case() { return read_baselines(baselines_file()).value_or(Baselines{}); }

AcceptedClaims claims_of_case() { return read_accepted_claims(claims_file(data_folder(), case_name)); }

void print(const Record& record) {
  for (const RunSummary& run : record.runs)
    fmt::print("{}.{} {}: {}; {} particles, {} steps, {:.3g} CPU s, {:.3g} ns per particle-step\n", record.case_name,
               record.method, run.level, run.outcome, run.cost.particles, run.cost.steps, run.cost.cpu,
               1e9 * run.cost.per_particle_step());
  for (const Verdict& verdict : record.verdicts)
    if (verdict.outcome == Outcome::holds) fmt::print("{}\n", verdict.sentence);
  if (is_run_for_dashboard()) fmt::print("{}", measurement_lines(record));
}

/// The runs of a method, whose particles are kept as files where that is asked for.
Results results_of(const Case& declared, const Method& method, Suite suite) {
  Results results{method, suite, run_levels(case_name, declared, method, suite)};
  if (!options.vtp.empty())
    for (const Run& run : results.runs)
      write_vtp_series(options.vtp, stem_of_files(case_name + "." + method.name, run.summary.level), run.samples);
  return results;
}

/// A test is a method: it passes when every claim holds, and they are no fewer than accepted.
class MethodTest : public testing::Test {
 public:
  MethodTest(const Case& declared, const Method& method) : declared_(declared), method_(method) {}

  void TestBody() override try {
    const Record record = assessed();
    if (!options.records.empty()) write(record, options.records / fmt::format("{}.{}.json", case_name, method_.name));
    print(record);
    const std::vector<std::string> why = complaints(record, claims_of_case());
    if (!why.empty()) ADD_FAILURE() << fmt::format("{}", fmt::join(why, "\n"));
  } catch (const std::exception& error) {  // that a record cannot be written is no fault of the method
    FAIL() << case_name << "." << method_.name << ": " << error.what();
  }

 private:
  Record assessed() const try {
    return assess(case_name, declared_, results_of(declared_, method_, options.suite), baselines_of_case());
  } catch (const std::exception& error) {
    return failed(error.what());
  }

  /// What a report shall say of a method that could not be assessed.
  Record failed(const std::string& why) const {
    Record record = record_of(case_name, declared_, method_, options.suite);
    Verdict verdict = judge(at_least({std::string(could_be_assessed)}, 1, theory("a method can be assessed")),
                            Place{.case_name = case_name, .method = method_.name, .level = ""}, 0);
    verdict.sentence = fmt::format("{}.{}: {}: FAILS", case_name, method_.name, why);
    record.verdicts.push_back(verdict);
    return record;
  }

  const Case& declared_;
  const Method& method_;
};

bool runs_in(Suite suite, const Method& method) {
  return std::ranges::any_of(method.levels, [&](const Level& level) { return level.until(suite) > 0; });
}

std::vector<const Method*> chosen_methods(const Case& declared) {
  std::vector<const Method*> chosen;
  std::string known;
  for (const Method& method : declared.methods) {
    known += (known.empty() ? "" : ", ") + method.name;
    if (options.method.empty() || method.name == options.method) chosen.push_back(&method);
  }
  if (chosen.empty())
    throw std::invalid_argument(fmt::format("no method '{}'; expected one of: {}", options.method, known));
  return chosen;
}

/// Unless it is named, a method that the suite leaves out is left out.
int run_tests(const Case& declared, char* program) {
  std::vector<const Method*> chosen = chosen_methods(declared);
  if (options.method.empty())
    std::erase_if(chosen, [](const Method* method) { return !runs_in(options.suite, *method); });
  if (chosen.empty())
    throw std::invalid_argument(fmt::format("nothing runs in {}; expected another --suite", name_of(options.suite)));
  for (const Method* method : chosen)
    testing::RegisterTest(case_name.c_str(), method->name.c_str(), nullptr, nullptr, __FILE__, __LINE__,
                          [&declared, method]() -> testing::Test* { return new MethodTest(declared, *method); });
  int count = 1;
  char* arguments[] = {program, nullptr};
  testing::InitGoogleTest(&count, arguments);
  return RUN_ALL_TESTS();
}

/// One run at any resolution, measured and not judged.
int explore(const Case& declared) {
  for (const Method* method : chosen_methods(declared)) {
    Level level = level_at(*method, options.spacing);
    if (!std::isnan(options.cell)) level.cell = options.cell;
    level.time_step = options.time_step;
    level.acceptance = options.until > 0 ? options.until : declared.times.front();
    Method custom = *method;
    custom.levels = {level};
    custom.ladders.clear();
    custom.claims.clear();
    Case unjudged = declared;
    unjudged.claims.clear();
    unjudged.plots.clear();
    if (options.every > 0) unjudged.times.clear();
    for (int k = 0; options.every > 0 && options.every * k < level.acceptance * (1 - 1e-9); ++k)
      unjudged.times.push_back(as_meant(options.every * k));
    const Record record = assess(case_name, unjudged, results_of(unjudged, custom, Suite::acceptance), std::nullopt);
    if (!options.records.empty()) write(record, options.records / fmt::format("{}.{}.json", case_name, method->name));
    print(record);
    for (const Value& e : record.values) fmt::print("{} = {:.6g} at {:.6g} s\n", e.quantity.heading(), e.value, e.time);
    if (!record.runs.front().finished) return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

/// Makes today's values the baselines, and forgets those of methods and levels that are gone, unless a claim of theory
/// or literature fails.
int accept(const Case& declared) {
  std::vector<const Method*> running = chosen_methods(declared);
  std::erase_if(running, [](const Method* method) { return !runs_in(options.suite, *method); });
  if (running.empty()) {
    fmt::print("{}: nothing runs in {}, nothing to accept\n", case_name, name_of(options.suite));
    return EXIT_SUCCESS;
  }
  const files::HeldFolder held(data_folder());
  Baselines baselines = baselines_of_case();
  AcceptedClaims claims = claims_of_case();
  const auto is_gone = [&](const auto& old) {
    return std::ranges::none_of(declared.methods, [&](const Method& m) { return m.name == old.method; });
  };
  std::erase_if(baselines.rows, is_gone);
  std::erase_if(claims.rows, is_gone);
  for (const Method* method : running) {
    const Results results = results_of(declared, *method, options.suite);
    const Record record = assess(case_name, declared, results, std::nullopt);
    print(record);
    for (const Verdict& verdict : record.verdicts)
      if (verdict.outcome != Outcome::holds) {
        fmt::print(stderr, "{}: nothing is accepted while a claim does not hold: {}\n", case_name, verdict.sentence);
        return EXIT_FAILURE;
      }
    std::erase_if(baselines.rows, [&](const Baseline& old) {
      const auto is_its_level = [&](const auto& level) { return level == old.level; };
      return old.method == method->name && (std::ranges::any_of(record.runs, is_its_level, &RunSummary::level) ||
                                            std::ranges::none_of(method->levels, is_its_level, &Level::name));
    });
    const std::vector<Baseline> rows = baselines_from(record, method->tolerance);
    baselines.rows.insert(baselines.rows.end(), rows.begin(), rows.end());
    baselines.acceptance = {fmt::format("Last accepted values of {}", case_name), record.revision, record.finished_at,
                            options.accept_reason};
    claims.set(claims_in(assess(case_name, declared, results, baselines)));
  }
  claims.acceptance = baselines.acceptance;
  claims.acceptance.title = fmt::format("Last accepted number of claims of {}", case_name);
  std::filesystem::create_directories(baselines_file().parent_path());
  write_baselines(baselines_file(), baselines.rows, baselines.acceptance);
  write_accepted_claims(claims_file(data_folder(), case_name), claims);
  fmt::print("{}: {} baselines accepted\n", baselines_file().string(), baselines.rows.size());
  return EXIT_SUCCESS;
}

/// Verdict mutation, of the records of a folder or of samples; a line for each method.
int mutate(const Case& declared) {
  long survivors = 0;
  for (const Method* method : chosen_methods(declared)) {
    const std::filesystem::path file = options.mutated / fmt::format("{}.{}.json", case_name, method->name);
    std::vector<std::string> least;
    if (!options.mutates_samples && !std::filesystem::exists(file)) continue;
    const Mutations all =
        options.mutates_samples
            ? mutate_samples(case_name, declared, *method, options.suite, baselines_of_case(), least)
            : mutate_record(declared, *method, read_record(file), baselines_of_case(), claims_of_case());
    if (all.failing && !options.records.empty()) write(*all.failing, options.records / file.filename());
    for (const std::string& line : least) fmt::print("{}\n", line);
    for (const std::string& line : all.survivors) fmt::print("SURVIVED {}\n", line);
    fmt::print("{}.{}: {}{}\n", case_name, method->name, all.sentence(),
               options.mutates_samples ? fmt::format("; mutated for {:.2f} s", all.seconds) : "");
    survivors += std::ssize(all.survivors);
  }
  return survivors == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

/// Lines of CMake that register each method with ctest, once per suite that runs it.
void write_ctest_file(const Case& declared, const char* program, const std::string& file, const std::string& records) {
  std::string text;
  for (const Method& method : declared.methods)
    for (const Suite suite : suites) {
      if (!runs_in(suite, method)) continue;
      const std::string prefix = suite == Suite::acceptance ? "" : std::string(name_of(suite)) + ".";
      const std::string test = fmt::format("{}{}.{}", prefix, case_name, method.name);
      text += fmt::format("add_test([=[{}]=] [=[{}]=] --method {} --suite {} --records [=[{}/{}]=])\n", test, program,
                          method.name, name_of(suite), records, name_of(suite));
      const std::string labels = std::string(name_of(suite)) +
                                 (suite == Suite::acceptance && !declared.label.empty() ? ";" + declared.label : "");
      text += fmt::format(
          "set_tests_properties([=[{}]=] PROPERTIES LABELS \"{}\" FIXTURES_REQUIRED {}_records COST {:.6g} TIMEOUT "
          "5400{})\n",
          test, labels, name_of(suite), method.relative_cost, declared.timed ? " RUN_SERIAL TRUE" : "");
    }
  files::write_whole(file, text);
}

int run(int count, char** arguments) {
  if (const auto status = options.parse(case_name, count, arguments)) return *status;
  if (!options.ctest_file.empty()) {
    write_ctest_file(the_case(), arguments[0], options.ctest_file, options.records);
    return EXIT_SUCCESS;
  }
  if (!options.records.empty()) files::make_folder(options.records);
  const Case declared = the_case();
  if (options.list) {
    for (const Method& method : declared.methods) {
      fmt::print("{}:", method.name);
      for (const Level& level : method.levels) fmt::print(" {}", level.name);
      fmt::print("\n");
    }
    return EXIT_SUCCESS;
  }
  if (options.describes) {
    fmt::print("{}", json_of(describe(case_name, declared, data_folder())));
    return EXIT_SUCCESS;
  }
  if (options.explores) {
    require_positive("--spacing", "spacing [m]", options.spacing);
    return explore(declared);
  }
  if (options.mutates_samples || !options.mutated.empty()) return mutate(declared);
  if (options.accepts) {
    if (options.accept_reason.empty())
      throw std::invalid_argument("--accept '': expected the reason why the new values are right");
    require_no_test("--accept");
    return accept(declared);
  }
  return run_tests(declared, arguments[0]);
}

}  // namespace

}  // namespace touchstone::vnv

int main(int count, char** arguments) {
  touchstone::vnv::case_name = std::filesystem::path(arguments[0]).stem();
  touchstone::programs::tell_when_out_of_memory(touchstone::vnv::case_name, EXIT_FAILURE);
  try {
    return touchstone::vnv::run(count, arguments);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", touchstone::vnv::case_name, error.what());
    return EXIT_FAILURE;
  }
}

/// vnv accept: makes today's values the baselines, by the programs, which alone write them, or counts the claims of
/// records that are there already.

#include "vnv/command/changes.hpp"
#include "vnv/command/inputs.hpp"
#include "vnv/command/patterns.hpp"
#include "vnv/command/solvers.hpp"
#include "vnv/command/tasks.hpp"
#include "vnv/command/terminal.hpp"
#include "vnv/files/held_folder.hpp"
#include "vnv/programs/progress.hpp"
#include "vnv/programs/scratch_folder.hpp"
#include "vnv/record/accepted_claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace touchstone::vnv::command {
namespace {

Baselines accepted_of(const Description& one) { return read_baselines(one.baseline_file).value_or(Baselines{}); }

/// Whether the program accepted; it refuses where a claim of theory or literature fails, and within a test.
bool accept_one(const Build& build, const AcceptOptions& options, const Chosen& one,
                const programs::Meanwhile& meanwhile) {
  const Baselines before = accepted_of(*one.of);
  const programs::CapturedOutput captured = programs::run_and_capture(
      build.call(one.of->name, {"--accept", options.reason, "--method", one.method->name, "--suite", options.suite}),
      meanwhile);
  if (!captured.ending.succeeded()) {
    fmt::print(stderr, "vnv: {}: not accepted: {}\n", one.name(), captured.complaint());
    return false;
  }
  const std::vector<BaselineChange> found = changes(before, accepted_of(*one.of));
  for (const BaselineChange& change : found)
    fmt::print("{}\n", coloured(change.margin() < 0 ? Colour::yellow : Colour::green, change.sentence(one.of->name)));
  fmt::print("{}: {} baselines changed\n", one.name(), found.size());
  return true;
}

using Records = std::map<std::string, Record>;  // by CASE.METHOD

Records records_of(const std::filesystem::path& folder, const std::string& suite) {
  Records records;
  for (const std::filesystem::directory_entry& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;
    Record record = read_record(entry);
    if (record.suite == suite) records.emplace(record.case_name + "." + record.method, std::move(record));
  }
  if (records.empty())
    throw std::invalid_argument(
        fmt::format("--claims {}: no record of the suite {}, expected at least one", folder.string(), suite));
  return records;
}

/// Accepts, for one method, the count in its record, or that there is none any more. Whether it did: not of what fails.
bool accept_claims_of_one(const std::string& name, const Records& records, const std::string& suite,
                          AcceptedClaims& claims) {
  const std::size_t point = name.find('.');
  const ClaimCount* old = claims.find(name.substr(0, point), name.substr(point + 1), suite);
  const ClaimCount before = old ? *old : ClaimCount{};
  const auto found = records.find(name);
  if (found == records.end()) {
    std::erase(claims.rows, before);
    fmt::print("{}: {} claims, gone\n", name, before.total());
    return true;
  }
  const Record& record = found->second;
  for (const Verdict& v : record.verdicts)
    if (v.outcome != Outcome::holds) {
      fmt::print(stderr, "vnv: {}: not accepted: {}\n", name, v.sentence);
      return false;
    }
  claims.set(claims_in(record));
  if (claims_in(record) == before) return true;
  claims.acceptance.revision = record.revision;
  claims.acceptance.date = record.finished_at;
  fmt::print("{}: {} claims, before {}\n", name, claims_in(record).total(), before.total());
  return true;
}

int accept_claims(const Build& build, const AcceptOptions& options) {
  require_no_test("--claims");
  const Records records = records_of(options.claims, options.suite);
  const std::filesystem::path data = build.data_in_use();
  const files::HeldFolder held(data);
  std::map<std::string, AcceptedClaims> by_case;
  std::vector<std::string> names;
  const auto add = [&](const std::string& case_name, const std::string& method) {
    const std::string name = case_name + "." + method;
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    if (!by_case.contains(case_name)) by_case[case_name] = read_accepted_claims(claims_file(data, case_name));
  };
  for (const auto& [name, record] : records) add(record.case_name, record.method);
  if (std::filesystem::exists(data / "claims"))
    for (const ClaimCount& row : read_all_accepted_claims(data / "claims").rows)
      if (row.suite == options.suite) add(row.case_name, row.method);
  long refused = 0;
  for (const std::string& name : chosen_by(options.patterns, names))
    refused += !accept_claims_of_one(name, records, options.suite, by_case[name.substr(0, name.find('.'))]);
  for (auto& [case_name, claims] : by_case) {
    if (claims.rows == read_accepted_claims(claims_file(data, case_name)).rows) continue;
    claims.acceptance.title = fmt::format("Last accepted number of claims of {}", case_name);
    claims.acceptance.reason = options.reason;
    write_accepted_claims(claims_file(data, case_name), claims);
  }
  return refused == 0 ? all_holds : something_fails;
}

}  // namespace

/// Judged without what was accepted before.
void accept_solver(const Build& build, const doors::Solver& solver, const AcceptOptions& options) {
  require_no_test("accept");
  doors::Solver unaccepted = solver;
  unaccepted.baselines.clear();
  const programs::ScratchFolder records;
  accept(solver, run_and_record(unaccepted, options.suite, records.path(), build.records(options.suite)).record,
         options.reason);
  fmt::print("{}: accepted in {}\n", solver.case_and_method(), solver.baseline_file().string());
}

int accept(const Build& build, AcceptOptions options) {
  if (options.reason.find_first_not_of(" \t\n") == std::string::npos)
    throw std::invalid_argument(
        fmt::format("--reason '{}': expected the reason why the new values are right", options.reason));
  if (!options.claims.empty()) return accept_claims(build, options);
  for (const doors::Solver& solver : take_solvers(options.patterns)) accept_solver(build, solver, options);
  if (options.patterns.empty()) return all_holds;
  const Catalogue catalogue = read_catalogue(build, options.patterns);
  const std::vector<Chosen> methods = choose_all(catalogue, options.patterns, options.suite);
  long refused = 0;
  programs::Work work;
  for (const Chosen& one : methods)
    if (const auto last = last_cost(record_file(build.records(options.suite), one.name())))
      work.expect(one.name(), last->wall);
    else
      work.guess(one.name(), one.method->relative_cost);
  programs::Progress line("vnv accept");
  for (const Chosen& one : methods) {
    work.begin(one.name());
    refused += !accept_one(build, options, one, [&] { line.show([&] { return work.sentence(); }); });
    work.end(one.name());
  }
  return refused == 0 ? all_holds : something_fails;
}

}  // namespace touchstone::vnv::command

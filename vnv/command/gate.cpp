/// vnv gate: whether a change made methods better, worse, slower or faster.

#include "vnv/command/solvers.hpp"
#include "vnv/gate/turns.hpp"
#include "vnv/programs/scratch_folder.hpp"

#include <fmt/format.h>

#include <iostream>
#include <optional>

namespace touchstone::vnv::command {

namespace {

bool is_solver(const std::string& source) { return source.ends_with(".toml"); }

doors::Solver solver_here(const std::string& file) {
  doors::Solver solver = doors::read_solver(file);
  if (const std::string missing = missing_here(solver); !missing.empty())
    throw gate::BadInput(fmt::format("{}: needs {}", file, missing));
  return solver;
}

/// Two versions of one solver; the second counts as the same method, whatever it is called.
gate::Contest contest_of(const gate::GateRequest& request) {
  const doors::Solver before = solver_here(request.before);
  doors::Solver after = solver_here(request.after);
  if (before.flow.case_name() != after.flow.case_name())
    throw gate::BadInput(fmt::format("{}: {}, {}: {}, expected one flow with the same parameters", request.before,
                                     before.flow.case_name(), request.after, after.flow.case_name()));
  after.name = before.name;
  const auto run_of = [&](const doors::Solver& solver) {
    return [solver, suite = suite_named(request.suite)](std::ostream&, const programs::Meanwhile&) {
      const programs::ScratchFolder scratch;
      return std::optional(doors::run_solver(solver, scratch.path(), suite).record);
    };
  };
  return {before.flow.case_name(), before.name, false, run_of(before), run_of(after)};
}

/// Makes, of a solver that is compared with records, its record now, in a folder for a while.
void record_now(std::string& source, const std::string& suite, std::optional<programs::ScratchFolder>& folder) {
  if (!is_solver(source)) return;
  const doors::Solver solver = solver_here(source);
  run_and_record(solver, suite, folder.emplace().path());
  source = folder->path() / (solver.case_and_method() + ".json");
}

gate::Status status_of(gate::GateRequest request) {
  if (is_solver(request.before) && is_solver(request.after))
    return gate::gate(request, contest_of(request), std::cout, std::cerr);
  std::optional<programs::ScratchFolder> folder;
  for (std::string* source : {&request.before, &request.after}) record_now(*source, request.suite, folder);
  return gate::gate(request, std::cout, std::cerr);
}

}  // namespace

int run_gate(const Build& build, const GateOptions& options) {
  gate::GateRequest request = options.request;
  std::optional<programs::ScratchFolder> records;
  if (!options.site.empty()) request.figure = records.emplace().path() / "gate.gate.json";
  const gate::Status status = status_of(request);
  if (records) make_pages(build, {records->path(), options.site});
  return status;
}

}  // namespace touchstone::vnv::command

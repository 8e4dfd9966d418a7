/// vnv gate: whether a change made methods better, worse, slower or faster.

#include "vnv/command/solvers.hpp"
#include "vnv/programs/scratch_folder.hpp"

#include <iostream>
#include <optional>

namespace touchstone::vnv::command {

namespace {

/// Records of a solver, made now, in a folder for a while; anything else stays what it is.
void run_if_solver(std::string& source, const std::string& suite, std::optional<programs::ScratchFolder>& folder) {
  if (!source.ends_with(".toml")) return;
  const doors::Solver solver = doors::read_solver(source);
  run_and_record(solver, suite, folder.emplace().path());
  source = folder->path() / (solver.case_and_method() + ".json");
}

}  // namespace

int run_gate(const Build& build, const GateOptions& options) {
  gate::GateRequest request = options.request;
  std::optional<programs::ScratchFolder> records, before, after;
  run_if_solver(request.before, request.suite, before);
  run_if_solver(request.after, request.suite, after);
  if (!options.site.empty()) request.figure = records.emplace().path() / "gate.gate.json";
  const gate::Status status = gate::gate(request, std::cout, std::cerr);
  if (records) make_pages(build, {records->path(), options.site});
  return status;
}

}  // namespace touchstone::vnv::command

/// vnv gate: whether a change made methods better, worse, slower or faster.

#include "vnv/command/solvers.hpp"
#include "vnv/programs/scratch_folder.hpp"

#include <iostream>
#include <optional>

namespace touchstone::vnv::command {

namespace {

/// Records of solvers, made now, in folders for a while; anything else stays what it is.
class SolversRun {
 public:
  /// Of two solvers the second counts as the same method, whatever it is called.
  explicit SolversRun(gate::GateRequest& request) {
    for (const auto& [source, folder] : {std::pair(&request.before, &before_), std::pair(&request.after, &after_)}) {
      if (!source->ends_with(".toml")) continue;
      doors::Solver solver = doors::read_solver(*source);
      if (before_ && folder == &after_) solver.name = name_;
      name_ = solver.name;
      run_and_record(solver, request.suite, folder->emplace().path());
      *source = (*folder)->path() / (solver.case_and_method() + ".json");
    }
  }

 private:
  std::string name_{};
  std::optional<programs::ScratchFolder> before_{}, after_{};
};

}  // namespace

int run_gate(const Build& build, const GateOptions& options) {
  gate::GateRequest request = options.request;
  const SolversRun solvers(request);
  std::optional<programs::ScratchFolder> records;
  if (!options.site.empty()) request.figure = records.emplace().path() / "gate.gate.json";
  const gate::Status status = gate::gate(request, std::cout, std::cerr);
  if (records) make_pages(build, {records->path(), options.site});
  return status;
}

}  // namespace touchstone::vnv::command

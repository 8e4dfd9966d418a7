/// vnv gate: whether a change made methods better, worse, slower or faster.

#include "vnv/command/commands.hpp"
#include "vnv/programs/scratch_folder.hpp"

#include <iostream>
#include <optional>

namespace touchstone::vnv::command {

int run_gate(const Build& build, const GateOptions& options) {
  gate::GateRequest request = options.request;
  std::optional<programs::ScratchFolder> records;
  if (!options.site.empty()) request.figure = records.emplace().path() / "gate.gate.json";
  const gate::Status status = gate::gate(request, std::cout, std::cerr);
  if (records) make_pages(build, {records->path(), options.site});
  return status;
}

}  // namespace touchstone::vnv::command

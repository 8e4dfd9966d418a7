/// vnv gate: whether a change made methods better, worse or dearer.

#include "vnv/gate/gate.hpp"

#include "vnv/command/commands.hpp"
#include "vnv/programs/scratch_folder.hpp"

#include <iostream>
#include <memory>
#include <optional>

namespace touchstone::vnv::command {
namespace {

struct Options {
  gate::GateRequest request{};
  std::filesystem::path site{};
};

int run(const Build& build, Options options) {
  std::optional<programs::ScratchFolder> drawn;
  if (!options.site.empty()) options.request.figure = drawn.emplace().path() / "gate.gate.json";
  const gate::Status status = gate::gate(options.request, std::cout, std::cerr);
  if (drawn) make_pages(build, {drawn->path(), options.site});
  return status;
}

}  // namespace

void add_gate(CLI::App& app, Session& session) {
  const auto options = std::make_shared<Options>();
  gate::GateRequest& request = options->request;
  CLI::App* command = app.add_subcommand("gate", "Compares before and after: what got better, worse or dearer.");
  command->footer(
      "BEFORE and AFTER are records, folders of records, build folders, or git revisions, which are built in folders\n"
      "of their own. Programs that differ run in turn: their values are compared, and the ratio of their CPU times has a\n"
      "95 % interval.\n"
      "Exit status: 0 same or better, 1 worse, 2 inconclusive, 3 bad input, 4 bad usage.\n"
      "Examples:\n  vnv gate ../main/build build --markdown review.md\n"
      "  vnv gate HEAD~1 HEAD --case poiseuille --case couette\n"
      "  vnv gate nights/monday nights/tuesday --json gate.json");
  command->add_option("BEFORE", request.before, "what it was")->required();
  command->add_option("AFTER", request.after, "what it is")->required();
  add_suite(*command, request.suite)->capture_default_str();
  command->add_option("--case", request.cases, "only this case; may be given several times")->allow_extra_args(false);
  command->add_option("--only", request.only, "only methods in whose CASE.METHOD this regular expression is found");
  command->add_option("--repeats", request.repeats, "pairs of runs in turn, 6 or more; 0: leave out what it costs")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_flag("--all", request.all, "run programs that are the same, too");
  command->add_option("--markdown", request.markdown, "file to write the findings to, for a review");
  command->add_option("--json", request.json, "file to write all findings to, for programs");
  command->add_option("--site", options->site, "folder for pages with error against run time, before and after");
  set_todo(*command, session, run, options);
}

}  // namespace touchstone::vnv::command

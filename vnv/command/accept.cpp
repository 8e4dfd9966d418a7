/// vnv accept: makes today's values the baselines, by the programs, which alone write them.

#include "vnv/command/changes.hpp"
#include "vnv/command/commands.hpp"
#include "vnv/command/terminal.hpp"

#include <fmt/format.h>

namespace touchstone::vnv::command {
namespace {

Baselines accepted_of(const Description& one) { return read_baselines(one.baseline_file).value_or(Baselines{}); }

/// Whether the program accepted; it refuses where a claim of theory or literature fails, and within a test.
bool accept_one(const Build& build, const AcceptOptions& options, const Chosen& one) {
  const Baselines before = accepted_of(*one.of);
  const programs::Heard heard = programs::run_and_hear(
      build.call(one.of->name, {"--accept", options.reason, "--method", one.method->name, "--suite", options.suite}));
  if (!heard.ending.well()) {
    fmt::print(stderr, "vnv: {}: not accepted: {}\n", one.name(), heard.complaint());
    return false;
  }
  const std::vector<Change> found = changes(before, accepted_of(*one.of));
  for (const Change& change : found)
    fmt::print("{}\n", coloured(change.margin() < 0 ? Colour::yellow : Colour::green, change.sentence(one.of->name)));
  fmt::print("{}: {} baselines changed\n", one.name(), found.size());
  return true;
}

}  // namespace

int accept(const Build& build, const AcceptOptions& options) {
  if (options.reason.find_first_not_of(" \t\n") == std::string::npos)
    throw std::invalid_argument(
        fmt::format("--reason '{}': expected the reason why the new values are right", options.reason));
  const Catalogue catalogue = read_catalogue(build, options.patterns);
  const std::vector<Chosen> methods = choose_all(catalogue, options.patterns, options.suite);
  long refused = 0;
  ProgressLine line;
  for (const Chosen& one : methods) {
    line.show(one.name());
    refused += !accept_one(build, options, one);
    line.clear();
  }
  return refused == 0 ? all_holds : something_fails;
}

}  // namespace touchstone::vnv::command

/// vnv report and export: records to pages, and to what a paper needs.

#include "vnv/command/commands.hpp"
#include "vnv/gate/source.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace touchstone::vnv::command {
namespace {

namespace fs = std::filesystem;

/// Only a build's own nights are added to its history by default.
std::string history_of(const Build& build, const ReportOptions& options) {
  const bool is_own_night = options.records.empty() && options.suite == "nightly";
  return options.history.empty() && is_own_night ? gate::configured(build.folder, "TOUCHSTONE_HISTORY")
                                                 : options.history;
}

/// The file that was named, else the usual one if it is there, else none.
std::string named_or(const std::string& named, const fs::path& usual) {
  return !named.empty() ? named : fs::exists(usual) ? usual.string() : "";
}

fs::path records_of(const Build& build, const std::string& named, const std::string& suite) {
  return named.empty() ? build.records(suite) : fs::path(named);
}

/// How touchstone_report ends.
int ended_with(const Build& build, const Words& arguments, bool refusals_speak_for_themselves) {
  const fs::path program = build.folder / "reports" / "touchstone_report";
  if (!fs::exists(program))
    throw std::runtime_error(fmt::format("{}: not built; build it with: cmake --build {} --target touchstone_report",
                                         program.string(), build.folder.string()));
  Words call = {program.string()};
  call.insert(call.end(), arguments.begin(), arguments.end());
  const programs::Ending ending = programs::run_here(call);
  if (refusals_speak_for_themselves && ending.signal == 0 && ending.status == bad_input) return bad_input;
  if (ending.signal != 0 || (ending.status != all_holds && ending.status != something_fails))
    throw std::runtime_error(fmt::format("{} {}", fmt::join(call, " "), ending.sentence()));
  return ending.status;
}

}  // namespace

int make_pages(const Build& build, const Words& arguments) { return ended_with(build, arguments, false); }

/// Without options as the test SUITE.pages does.
int report(const Build& build, const ReportOptions& options) {
  const std::string records = records_of(build, options.records, options.suite);
  const std::string site = options.site.empty() ? (build.results() / "site" / options.suite).string() : options.site;
  Words arguments{records, site};
  const auto pass_on = [&](const std::string& option, const std::string& value) {
    if (!value.empty()) arguments.insert(arguments.end(), {option, value});
  };
  pass_on("--history", history_of(build, options));
  const fs::path sources = gate::configured(build.folder, "CMAKE_HOME_DIRECTORY");
  const fs::path data = build.data_in_use();
  pass_on("--known-failures", named_or(options.known_failures, data / "known_failures.csv"));
  pass_on("--faults", named_or(options.faults, sources / "vnv/trials/faults/trials.csv"));
  pass_on("--claims", named_or("", data / "claims"));
  const int status = make_pages(build, arguments);
  fmt::print("{}\n", (fs::path(site) / "index.html").string());
  return status;
}

int export_case(const Build& build, const ExportOptions& options) {
  const fs::path folder =
      options.folder.empty() ? build.results() / "export" / options.case_name : fs::path(options.folder);
  return ended_with(build,
                    {records_of(build, options.records, options.suite), folder, "--paper", options.case_name,
                     "--references", build.data_in_use() / "references.bib"},
                    true);
}

}  // namespace touchstone::vnv::command

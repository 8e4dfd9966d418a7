/// vnv report: records to pages.

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

}  // namespace

int make_pages(const Build& build, const Words& arguments) {
  Words call = {(build.folder / "reports" / "touchstone_report").string()};
  call.insert(call.end(), arguments.begin(), arguments.end());
  const programs::Ending ending = programs::run_here(call);
  if (ending.signal != 0 || (ending.status != all_holds && ending.status != something_fails))
    throw std::runtime_error(fmt::format("{} {}", fmt::join(call, " "), ending.sentence()));
  return ending.status;
}

/// Without options as the test SUITE.pages does.
int report(const Build& build, const ReportOptions& options) {
  const std::string records = options.records.empty() ? build.records(options.suite).string() : options.records;
  const std::string site = options.site.empty() ? (build.results() / "site" / options.suite).string() : options.site;
  Words arguments{records, site};
  const auto pass_on = [&](const std::string& option, const std::string& value) {
    if (!value.empty()) arguments.insert(arguments.end(), {option, value});
  };
  pass_on("--history", history_of(build, options));
  const fs::path sources = gate::configured(build.folder, "CMAKE_HOME_DIRECTORY");
  const fs::path data = build.data.empty() ? sources / "data" : build.data;
  pass_on("--known-failures", named_or(options.known_failures, data / "known_failures.csv"));
  pass_on("--faults", named_or(options.faults, sources / "vnv/trials/faults/trials.csv"));
  pass_on("--claims", named_or("", data / "claims"));
  const int status = make_pages(build, arguments);
  fmt::print("{}\n", (fs::path(site) / "index.html").string());
  return status;
}

}  // namespace touchstone::vnv::command

/// vnv report: records to pages.

#include "vnv/command/commands.hpp"

#include <fmt/format.h>

#include <fstream>
#include <memory>

namespace touchstone::vnv::command {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string records{}, site{}, suite = "acceptance", history{}, known_failures{}, faults{};
};

/// What a build folder was configured with; empty if it does not say.
std::string configured(const Build& build, const std::string& name) {
  std::ifstream cache(build.folder / "CMakeCache.txt");
  for (std::string line; std::getline(cache, line);)
    if (line.starts_with(name + ":")) return line.substr(line.find('=') + 1);
  return "";
}

/// Only a build's own nights join its history by themselves.
std::string history_of(const Build& build, const Options& options) {
  const bool is_own_night = options.records.empty() && options.suite == "nightly";
  return options.history.empty() && is_own_night ? configured(build, "TOUCHSTONE_HISTORY") : options.history;
}

std::string known_failures_of(const Build& build, const Options& options) {
  if (!options.known_failures.empty()) return options.known_failures;
  const fs::path sources = configured(build, "CMAKE_HOME_DIRECTORY");
  const fs::path file = (build.data.empty() ? sources / "data" : build.data) / "known_failures.csv";
  return fs::exists(file) ? file.string() : "";
}

/// Of a build in its sources, what came of the seeded faults there.
std::string faults_of(const Build& build, const Options& options) {
  if (!options.faults.empty()) return options.faults;
  const fs::path file = fs::path(configured(build, "CMAKE_HOME_DIRECTORY")) / "vnv/trials/faults/trials.csv";
  return fs::exists(file) ? file.string() : "";
}

/// As the test SUITE.pages does, where nothing else is asked for.
int report(const Build& build, const Options& options) {
  const std::string records = options.records.empty() ? build.records(options.suite).string() : options.records;
  const std::string site = options.site.empty() ? (build.folder / "site" / options.suite).string() : options.site;
  Words arguments{records, site};
  const auto pass_on = [&](const std::string& option, const std::string& value) {
    if (!value.empty()) arguments.insert(arguments.end(), {option, value});
  };
  pass_on("--history", history_of(build, options));
  pass_on("--known-failures", known_failures_of(build, options));
  pass_on("--faults", faults_of(build, options));
  make_pages(build, arguments);
  fmt::print("{}\n", (fs::path(site) / "index.html").string());
  return all_holds;
}

}  // namespace

void add_report(CLI::App& app, Session& session) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("report", "Turns records into pages, and tells where they begin.");
  command->footer("Examples:\n  vnv report --suite nightly\n  vnv report my_records my_site --history my_nights");
  command->add_option("RECORDS", options->records, "folder of records; else BUILD/records/SUITE");
  command->add_option("SITE", options->site, "folder for the pages, replaced; else BUILD/site/SUITE");
  add_suite(*command, options->suite)->capture_default_str();
  command->add_option("--history", options->history,
                      "folder of all nights, which these records join; else that of the build, for its own nights");
  command->add_option("--known-failures", options->known_failures,
                      "claims that are known to fail; else known_failures.csv of the data");
  command->add_option("--faults", options->faults,
                      "what came of seeded faults; else vnv/trials/faults/trials.csv of the sources, if it is there");
  set_todo(*command, session, report, options);
}

}  // namespace touchstone::vnv::command

/// vnv report: records to pages.

#include "vnv/command/commands.hpp"

#include <fmt/format.h>

#include <memory>

namespace touchstone::vnv::command {
namespace {

struct Options {
  std::string records{}, site{}, suite = "acceptance";
};

int report(const Build& build, const Options& options) {
  const std::string records = options.records.empty() ? build.records(options.suite).string() : options.records;
  const std::string site = options.site.empty() ? (build.folder / "site" / options.suite).string() : options.site;
  make_pages(build, {records, site});
  fmt::print("{}\n", (std::filesystem::path(site) / "index.html").string());
  return all_holds;
}

}  // namespace

void add_report(CLI::App& app, Session& session) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("report", "Turns records into pages, and tells where they begin.");
  command->footer("Examples:\n  vnv report --suite nightly\n  vnv report my_records my_site");
  command->add_option("RECORDS", options->records, "folder of records; else BUILD/records/SUITE");
  command->add_option("SITE", options->site, "folder for the pages, replaced; else BUILD/site/SUITE");
  add_suite(*command, options->suite)->capture_default_str();
  set_todo(*command, session, report, options);
}

}  // namespace touchstone::vnv::command

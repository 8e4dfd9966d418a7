/// touchstone_report: one night's records to an index, a page per case, a matrix of orders, three tables, and the trend
/// over all nights. Exit status: 0 all claims hold or are known to fail, 1 the pages are not green, 3 there are none, 4
/// bad usage.

#include "reports/figures/attachments.hpp"
#include "reports/pages/site.hpp"
#include "reports/paper/paper.hpp"
#include "vnv/programs/command_line.hpp"
#include "vnv/programs/interruption.hpp"
#include "vnv/programs/out_of_memory.hpp"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

int main(int argc, char** argv) {
  touchstone::programs::tell_when_out_of_memory("touchstone_report", 3);
  CLI::App app{
      "Turns the records of cases into a site: an index, a page per case with its figures, a matrix of the orders of "
      "convergence, and the tables verdicts.csv, orders.csv and cost.csv.",
      "touchstone_report"};
  app.footer(
      "Example: touchstone_report build/records/nightly build/site/nightly --history nights\n"
      "Exit status: 0 all claims hold or are known to fail, 1 something is red or inconclusive, 3 no pages were made, 4 bad "
      "usage.");
  std::string records, site, history, known_failures, faults, claims, attachments, paper, references;
  bool whole = false;
  app.add_option("RECORDS_DIR", records, "folder with the records, *.json")->required();
  app.add_option("SITE_DIR", site, "folder for the pages; a former site in it is replaced")->required();
  app.add_option("--history", history, "folder of all nights: this one joins it, and a page shows the trend over them");
  app.add_option("--known-failures", known_failures, "claims that are known to fail, data/known_failures.csv");
  app.add_option("--faults", faults,
                 "what vnv/trials/faults/try.py has found, trials.csv: a page shows which tests noticed it");
  app.add_option("--claims", claims, "folder of accepted claims, data/claims: a method that makes fewer is red");
  app.add_flag("--whole", whole, "all of the suite was run: an accepted method without a record is red, too")
      ->envname("TOUCHSTONE_WHOLE_SUITE");
  app.add_option("--attachments", attachments,
                 "folder for the figures as PNG, for a dashboard: drawn and named where ctest runs this for one");
  CLI::Option* literature = app.add_option("--references", references, "literature, data/references.bib");
  app.add_option("--paper", paper,
                 "no pages: what a paper needs of this case, written into SITE_DIR, which is not replaced")
      ->needs(literature);
  if (const auto status = touchstone::programs::read_command_line(app, argc, argv)) return *status;
  try {
    if (!paper.empty()) {
      const auto written = touchstone::reports::write_paper(records, paper, references, site);
      for (const auto& file : written.files) fmt::print("{}\n", file.string());
      for (const auto& line : written.missing) fmt::print(stderr, "touchstone_report: {}\n", line);
      return 0;
    }
    const auto status = touchstone::reports::make_site(
        records, site,
        {.history = history, .known_failures = known_failures, .faults = faults, .claims = claims, .whole = whole});
    fmt::print("{}: {}\n", site, status.sentence());
    if (!attachments.empty() && std::getenv("DASHBOARD_TEST_FROM_CTEST"))
      fmt::print("{}", touchstone::reports::attach_figures(site, attachments));
    return status.passes() ? 0 : 1;
  } catch (const touchstone::programs::Interrupted& told) {
    fmt::print(stderr, "touchstone_report: {}\n", told.sentence());
    touchstone::programs::end_by(told.signal);
  } catch (const std::exception& error) {
    fmt::print(stderr, "touchstone_report: {}\n", error.what());
    return 3;
  }
}

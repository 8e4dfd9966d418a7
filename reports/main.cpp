/// touchstone_report: one night's records to an index, a page per case, a matrix of orders, and three tables.

#include "reports/site.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <string>

int main(int argc, char** argv) {
  CLI::App app{
      "Turns the records of cases into a site: an index, a page per case with its figures, a matrix of the orders of "
      "convergence, and the tables verdicts.csv, orders.csv and cost.csv."};
  app.footer("Example: touchstone_report build/records build/site");
  std::string records, site;
  app.add_option("RECORDS_DIR", records, "folder with the records, *.json")->required();
  app.add_option("SITE_DIR", site, "folder for the pages; a former site in it is replaced")->required();
  CLI11_PARSE(app, argc, argv);
  try {
    touchstone::reports::make_site(records, site);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "touchstone_report: {}\n", error.what());
    return 1;
  }
}

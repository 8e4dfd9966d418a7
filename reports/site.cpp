#include "reports/site.hpp"

#include "reports/csv.hpp"
#include "reports/figures.hpp"
#include "reports/files.hpp"
#include "reports/gnuplot.hpp"
#include "reports/index.hpp"
#include "reports/order_matrix.hpp"
#include "reports/page.hpp"
#include "reports/style.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace touchstone::reports {
namespace {

namespace fs = std::filesystem;

// Publishing removes the former site, and records inside would go with it.
void want_apart(const fs::path& records, const fs::path& site) {
  const fs::path inner = fs::weakly_canonical(records), outer = fs::weakly_canonical(site);
  const auto [end_of_outer, _] = std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end());
  if (end_of_outer == outer.end())
    throw std::runtime_error(fmt::format("{}: holds the records, wanted a folder apart from them", site.string()));
}

void write_tables(const std::vector<CaseRecords>& cases, const fs::path& folder) {
  save(folder / "verdicts.csv", verdicts_csv(cases));
  save(folder / "orders.csv", orders_csv(cases));
  save(folder / "cost.csv", cost_csv(cases));
}

void write_case(const CaseRecords& records, const fs::path& folder) {
  fs::create_directory(folder);
  save(folder / "index.html", case_page(records, draw_all(records, folder), draw_orders(records, folder)));
}

}  // namespace

void make_site(const fs::path& records, const fs::path& site) {
  const auto cases = read_cases(records);
  want_apart(records, site);
  Staging staging(site);
  write_tables(cases, staging.folder());
  try {
    find_gnuplot();
  } catch (const GnuplotMissing& missing) {
    for (const char* table : {"verdicts.csv", "orders.csv", "cost.csv"}) staging.publish_file(table);
    throw GnuplotMissing(fmt::format("{}; wrote only verdicts.csv, orders.csv and cost.csv", missing.what()));
  }
  for (const auto& one : cases) write_case(one, staging.folder() / one.name);
  save(staging.folder() / "style.css", std::string(style));
  save(staging.folder() / "index.html", index_page(cases));
  if (std::ranges::any_of(cases, is_in_matrix)) save(staging.folder() / "orders.html", order_matrix_page(cases));
  staging.publish();
}

}  // namespace touchstone::reports

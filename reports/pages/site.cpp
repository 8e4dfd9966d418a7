#include "reports/pages/site.hpp"

#include "reports/compare/work_precision.hpp"
#include "reports/figures/gnuplot.hpp"
#include "reports/pages/pages.hpp"
#include "reports/pages/staging.hpp"
#include "reports/read/csv.hpp"
#include "vnv/files/whole_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>

namespace touchstone::reports {
namespace {

namespace fs = std::filesystem;
using files::write_whole;

// Publishing removes the former site, and what is kept inside would go with it.
void require_apart(const fs::path& kept, const char* what, const fs::path& site) {
  const fs::path inner = fs::weakly_canonical(kept), outer = fs::weakly_canonical(site);
  const auto [end_of_outer, _] = std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end());
  if (end_of_outer == outer.end())
    throw std::runtime_error(fmt::format("{}: holds the {}, expected a folder apart from them", site.string(), what));
}

void write_case(const CaseRecords& records, const fs::path& folder) {
  fs::create_directory(folder);
  const Plots figures = plots_of_all(records), orders = plots_of_orders(records);
  draw(figures, folder);
  draw(orders, folder);
  write_whole(folder / "index.html", case_page(records, figures, orders));
}

/// The date of the night: the same records give the same pages on any day.
std::string date_of(const std::vector<CaseRecords>& cases) {
  std::string date;
  for (const auto& one : cases)
    for (const auto& record : one.records) date = std::max(date, record.finished_at);
  return date;
}

/// Writes the pages beside the index that have something to show; links to them.
List write_pages(const Findings& all, const fs::path& folder) {
  List links;
  for (const auto& [name, page] : all_pages())
    if (Content shown = page.content(all); !shown.data.is_false()) {
      write_whole(folder / (name + ".html"), html_of(name, std::move(shown.data)));
      for (const auto& [file, text] : shown.tables) write_whole(folder / file, text);
      links.push_back(
          object("name"_ = name, "title"_ = page.title, "sentence"_ = page.sentence, "note"_ = if_any(shown.note)));
    }
  return links;
}

}  // namespace

NightStatus make_site(const fs::path& records, const fs::path& site, const SiteInputs& inputs) {
  Findings all{.cases = read_cases(records)};
  std::vector<CaseRecords>& cases = all.cases;
  require_apart(records, "records", site);
  const auto known =
      inputs.known_failures.empty() ? std::vector<KnownFailure>{} : read_known_failures(inputs.known_failures);
  NightStatus tonight = night_status(cases, known, date_of(cases));
  if (!inputs.claims.empty())
    tonight.claims = claims_status(cases, vnv::read_all_accepted_claims(inputs.claims), inputs.whole);
  if (!inputs.faults.empty()) all.faults = read_fault_trials(inputs.faults);
  if (!inputs.history.empty()) {
    require_apart(inputs.history, "nights", site);
    const Night night = night_of(cases);
    write_night(night, inputs.history);
    all.history = read_history(inputs.history, night.suite);
    const auto& refused = all.history->refused;
    if (all.history->nights.empty())  // not even what was just written
      throw std::runtime_error(fmt::format("no night can be read: {}", fmt::join(refused, "; ")));
    for (const auto& file : refused) fmt::print(stderr, "touchstone_report: left out: {}\n", file);
  }
  std::ranges::for_each(cases, add_work_precision);
  Staging staging(site);
  const fs::path& folder = staging.folder();
  write_whole(folder / "verdicts.csv", verdicts_csv(cases));
  write_whole(folder / "orders.csv", orders_csv(cases));
  write_whole(folder / "cost.csv", cost_csv(cases));
  try {
    find_gnuplot();
  } catch (const GnuplotMissing& missing) {
    for (const char* table : {"verdicts.csv", "orders.csv", "cost.csv"}) staging.publish_file(table);
    throw GnuplotMissing(fmt::format("{}; wrote only verdicts.csv, orders.csv and cost.csv", missing.what()));
  }
  for (const auto& one : cases) {
    staging.stop_if_told();
    write_case(one, folder / one.name);
  }
  for (const char* file : {"style.css", "site.js"}) write_whole(folder / file, compiled_in.at(file));
  write_whole(folder / "index.html", index_page(cases, tonight, write_pages(all, folder)));
  staging.publish();
  return tonight;
}

}  // namespace touchstone::reports

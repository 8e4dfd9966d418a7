#include "reports/pages/site.hpp"

#include "reports/compare/work_precision.hpp"
#include "reports/figures/gnuplot.hpp"
#include "reports/pages/pages.hpp"
#include "reports/pages/staging.hpp"
#include "reports/pages/verdicts.hpp"
#include "reports/read/csv.hpp"
#include "vnv/files/whole_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <string>

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

/// Writes the trend over the history, and names on standard error what had to be left out.
void write_trend(const fs::path& folder, const History& history, const std::vector<CaseRecords>& cases) {
  for (const auto& refusal : history.refused) fmt::print(stderr, "touchstone_report: left out: {}\n", refusal);
  const auto all = series_of(history.nights);
  write_whole(folder / "trend.html", trend_page(history, all, cases));
  write_whole(folder / "trend.csv", trend_csv(history, all));
  write_whole(folder / "trend_steps.csv", steps_csv(history, all));
}

}  // namespace

NightStatus make_site(const fs::path& records, const fs::path& site, const SiteInputs& inputs) {
  auto cases = read_cases(records);
  require_apart(records, "records", site);
  const auto known =
      inputs.known_failures.empty() ? std::vector<KnownFailure>{} : read_known_failures(inputs.known_failures);
  NightStatus tonight = night_status(cases, known, date_of(cases));
  if (!inputs.claims.empty())
    tonight.claims = claims_status(cases, vnv::read_all_accepted_claims(inputs.claims), inputs.whole);
  std::optional<FaultTrials> faults;
  if (!inputs.faults.empty()) faults = read_fault_trials(inputs.faults);
  std::optional<History> history;
  if (!inputs.history.empty()) {
    require_apart(inputs.history, "nights", site);
    const Night night = night_of(cases);
    write_night(night, inputs.history);
    history = read_history(inputs.history, night.suite);
    if (history->nights.empty())  // not even what was just written
      throw std::runtime_error(fmt::format("no night can be read: {}", fmt::join(history->refused, "; ")));
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
  write_whole(folder / "index.html", index_page(cases, tonight, history.has_value(), faults));
  write_whole(folder / "verdicts.html", verdicts_page(cases));
  write_whole(folder / "a_verdict_fails.html", page("a_verdict_fails", object()));
  if (std::ranges::any_of(cases, is_in_matrix)) write_whole(folder / "orders.html", order_matrix_page(cases));
  if (std::ranges::any_of(cases, is_priced)) {
    write_whole(folder / "work.html", work_page(cases));
    write_whole(folder / "work.csv", work_csv(cases));
  }
  if (history) write_trend(folder, *history, cases);
  if (faults) {
    write_whole(folder / "faults.html", fault_page(*faults));
    fs::copy_file(inputs.faults, folder / "faults.csv");
  }
  staging.publish();
  return tonight;
}

}  // namespace touchstone::reports

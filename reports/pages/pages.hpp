#pragma once
/// The pages of a site as HTML, from what each of them shows.

#include "reports/compare/series.hpp"
#include "reports/figures/figures.hpp"
#include "reports/pages/template.hpp"
#include "reports/read/fault_trials.hpp"
#include "reports/read/known_failures.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace touchstone::reports {

/// What pages are filled from.
struct Findings {
  std::vector<CaseRecords> cases;
  std::optional<History> history{};
  std::optional<FaultTrials> faults{};
};

/// What a page shows.
struct Content {
  Data data = false;                            // of its template; false: there is nothing to show
  std::map<std::string, std::string> tables{};  // that lie beside it, by file name
  std::string note{};                           // that the index adds to its link
};

/// A page beside the index. `Page pages::NAME()` in NAME_page.cpp with templates/NAME.html makes it NAME.html, to which
/// the index leads.
struct Page {
  std::string title;     // its heading, and the words of the link to it
  std::string sentence;  // before that link on the index
  Content (*content)(const Findings& all);
};

/// Each of them, by name.
const std::map<std::string, Page>& all_pages();

/// The HTML of one of them.
std::string html_of(const std::string& name, Data data);

/// The first page: how much holds, the cases and their methods, and where it was run. It leads to these pages.
std::string index_page(const std::vector<CaseRecords>& cases, const NightStatus& status, const List& links = {});

/// Data of the index: error against run time in one flow, beside it how many methods are right on whose word and which
/// are farthest off; then the tables of all flows and of all other cases, with what each method reaches and is called.
Data overview_data(const std::vector<CaseRecords>& cases, const NightStatus& status);

/// What was solved in a case, how it compares, and what is claimed. Stands in the case's folder, beside its figures.
std::string case_page(const CaseRecords& records, const Plots& figures, const Plots& order_plots);

}  // namespace touchstone::reports

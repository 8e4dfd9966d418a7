#pragma once
/// The pages of a site as HTML, from what each of them shows, and the tables that lie beside some.

#include "reports/compare/series.hpp"
#include "reports/figures/figures.hpp"
#include "reports/pages/template.hpp"
#include "reports/read/fault_trials.hpp"
#include "reports/read/known_failures.hpp"

#include <optional>
#include <string>
#include <vector>

namespace touchstone::reports {

/// The first page: how much holds, the cases and their methods, and where it was run. With a history it leads to the
/// trend, too, and with trials of faults to their page.
std::string index_page(const std::vector<CaseRecords>& cases, const NightStatus& status, bool has_trend,
                       const std::optional<FaultTrials>& faults = {});

/// Data of the index: error against run time in one flow, beside it how many methods are right on whose word and which
/// are farthest off; then the tables of all flows and of all other cases, with what each method reaches and is called.
Data overview_data(const std::vector<CaseRecords>& cases, const NightStatus& status);

/// What was solved in a case, how it compares, and what is claimed. Stands in the case's folder, beside its figures;
/// all others stand beside the index.
std::string case_page(const CaseRecords& records, const Plots& figures, const Plots& order_plots);

/// How each method converges in each flow, and whether that shows a flow: it has an order of velocity or pressure.
std::string order_matrix_page(const std::vector<CaseRecords>& cases);
bool is_in_matrix(const CaseRecords& records);

/// What an error costs over all flows, which method is cheapest, and whether a flow is among them: it has a
/// work-precision diagram of its own methods.
std::string work_page(const std::vector<CaseRecords>& cases);
bool is_priced(const CaseRecords& records);
/// The same for programs, and for data/work.csv, by which `vnv explain` names the default method of a flow.
std::string work_csv(const std::vector<CaseRecords>& cases);

/// What changed over all nights, and how the numbers that matter went.
std::string trend_page(const History& history, const std::vector<Series>& all, const std::vector<CaseRecords>& tonight);
/// One line per step.
std::string steps_csv(const History& history, const std::vector<Series>& all);
/// One line per series that is drawn, one column per night, headed by its date and revision.
std::string trend_csv(const History& history, const std::vector<Series>& all);

/// The project's own detection rate: which tests notice which seeded fault, and by how much.
std::string fault_page(const FaultTrials& trials);

}  // namespace touchstone::reports

#pragma once
#include "vnv/record/median.hpp"
#include "vnv/record/record.hpp"
#include "vnv/studies/ensemble.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace touchstone::vnv {

/// Where the members of an ensemble are, over time: the median of what was monitored in a `column`, and the two
/// curves between which eight of ten lie, as the caption says.
inline Plot bands(const std::string& id, const std::string& title, const std::string& caption, const Axis& axis,
                  std::size_t column) {
  const Figure frame{id,
                     title,
                     fmt::format("{} Bold: the median of {} ensemble members; thin: the 10 % and 90 % quantiles.",
                                 caption, Ensemble{}.members),
                     {"t [s]"},
                     axis};
  return [=](const Results& results, Record& record) {
    record.figures.push_back(frame);
    if (results.runs.empty()) return;
    const std::string& name = results.method.name;
    const std::array levels{0.5, 0.1, 0.9};
    std::array curves{Curve{frame.id, name, Role::ours, {}, {}, false},
                      Curve{frame.id, name + ", 10 %", Role::guide, {}, {}, false},
                      Curve{frame.id, name + ", 90 %", Role::guide, {}, {}, false}};
    const std::vector<double>& times = results.runs.front().history.time;
    for (std::size_t k = 0; k < times.size(); ++k) {
      std::vector<double> seen;
      for (const Run& run : results.runs)
        if (k < run.history.values.size() && std::isfinite(run.history.values[k][column]))
          seen.push_back(run.history.values[k][column]);
      if (seen.empty()) continue;
      for (std::size_t c = 0; c < curves.size(); ++c) {
        curves[c].x.push_back(times[k]);
        curves[c].y.push_back(quantile(seen, levels[c]));
      }
    }
    for (Curve& curve : curves) record.curves.push_back(std::move(curve));
  };
}

/// A row for each number of each method: today's ensemble beside the accepted one.
inline Plot ensemble_table() {
  return [](const Results& results, Record& record) {
    Table table{"ensembles",
                "Ensemble compared with the accepted one",
                "Medians and 10 to 90 % ranges; Wasserstein distance between the two ensembles "
                "(in the unit of the quantity), and p-value of the hypothesis of equal "
                "distributions (Anderson-Darling test).",
                {"method", "quantity", "t [s]", "median", "10 to 90 %", "accepted median", "accepted 10 to 90 %",
                 "distance", "p-value"},
                {}};
    const auto middle = [](const std::vector<double>& members) {
      return members.empty() ? Cell("–") : Cell(median(members));
    };
    const auto band = [](const std::vector<double>& members) {
      if (members.empty()) return Cell("–");
      return Cell(fmt::format("{:.4g} to {:.4g}", quantile(members, 0.1), quantile(members, 0.9)));
    };
    const Baselines accepted =
        read_baselines(data_folder() / "baselines" / (record.case_name + ".csv")).value_or(Baselines{});
    for (const EnsembleComparison& one : compare_with_accepted(record, accepted))
      table.rows.push_back({results.method.name, one.quantity.heading(), one.time, middle(one.members),
                            band(one.members), middle(one.accepted), band(one.accepted), one.distance, one.p_value});
    record.tables.push_back(std::move(table));
  };
}

}  // namespace touchstone::vnv

#include "vnv/stability/ablation.hpp"

#include "vnv/measures/plots/along_ladders.hpp"
#include "vnv/stability/named_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace touchstone::vnv {
namespace {

Outcomes outcomes_of(const Run& run, const Record& record, const Pick& error) {
  return {.finished = run.summary.finished,
          .error = error(record, run).value_or(not_a_number),
          .critical_step = run.value_of(critical_step_found) * us,
          .per_particle_step = run.summary.cost.per_particle_step()};
}

double change_in_percent(double of_whole, double without) { return 100 * (without / of_whole - 1); }

std::vector<Cell> row_of(const Results& results, const Run& run, const Outcomes& all, const Outcomes& one,
                         bool has_more) {
  const bool is_whole = run.summary.level == unabridged;
  std::vector<Cell> row = {results.method.name, run.summary.level, run.summary.end_time};
  const auto add = [&](double scale, double Outcomes::*value) {
    row.push_back(scale * one.*value);
    row.push_back(is_whole ? Cell("") : Cell(change_in_percent(all.*value, one.*value)));
  };
  add(1, &Outcomes::error);
  add(1 / us, &Outcomes::critical_step);
  add(1e9, &Outcomes::per_particle_step);
  row.push_back(is_whole ? "" : has_more ? needed_for(one, all) : needed_for(all, one));
  return row;
}

}  // namespace

std::string needed_for(const Outcomes& whole_method, const Outcomes& without) {
  const bool accuracy = without.finished && !(without.error <= 1.1 * whole_method.error);
  const bool stability = !without.finished || !(without.critical_step >= 0.95 * whole_method.critical_step);
  if (accuracy && stability) return "accuracy and stability";
  return accuracy ? "accuracy" : stability ? "stability" : "neither";
}

Method ablation(Method method, const Level& level, const std::vector<Variant>& variants) {
  if (variants.empty() || variants.front().name != unabridged)
    throw std::invalid_argument(fmt::format("{}: expected the {} method as first variant", method.name, unabridged));
  std::vector<NamedRun> runs;
  for (const Variant& variant : variants) {
    runs.push_back({level, variant.run});
    runs.back().level.name = variant.name;
    runs.back().level.may_diverge = variant.name != unabridged;
  }
  return with_runs(std::move(method), std::move(runs));
}

Plot ablation_table(Quantity quantity, std::vector<std::string> with_more, std::string id) {
  return [=](const Results& results, Record& record) {
    Table table{id,
                fmt::format("Ablation: what each ingredient contributes, by {}", quantity.name),
                "Each variant lacks one ingredient of the complete method, or replaces it. An ingredient is "
                "needed for accuracy if the error grows by more than a tenth without it; for stability if the run does "
                "not finish or the largest stable step falls by more than 5 %. Errors are those at the end time.",
                {"method", "variant", "end [s]", quantity.heading(), "change [%]", "critical step [us]", "change [%]",
                 "ns per particle-step", "change [%]", "needed for"},
                {}};
    const Pick error = error_of(quantity, results.runs.front().summary.end_time);
    for (const Run& run : results.runs)
      table.rows.push_back(row_of(results, run, outcomes_of(results.runs.front(), record, error),
                                  outcomes_of(run, record, error),
                                  std::ranges::count(with_more, run.summary.level) > 0));
    record.tables.push_back(std::move(table));
  };
}

}  // namespace touchstone::vnv

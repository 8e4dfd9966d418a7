#include "vnv/bench/race.hpp"

#include "vnv/record/record.hpp"

namespace touchstone::bench {

std::vector<vnv::Run> tries(std::size_t number, const vnv::Quantity& quantity,
                            const std::function<vnv::Run()>& attempt) {
  std::vector<vnv::Run> runs(number);
  std::ranges::generate(runs, attempt);
  std::ranges::sort(runs, {}, [&](const vnv::Run& run) { return run.value_of(quantity); });
  return runs;
}

void tabulate_sub_steps(const vnv::Results& results, vnv::Record& record) {
  vnv::Table table{"sub_steps",
                   "Time of a step by sub-step",
                   "Nanoseconds per particle-step, medians over alternating rounds.",
                   {"method", "model", "whole step", "plain loop"},
                   {}};
  table.columns.insert(table.columns.end(), names_of_sub_steps.begin(), names_of_sub_steps.end());
  for (const vnv::Run& run : results.runs) {
    if (std::isnan(run.value_of(loop_time))) continue;
    std::vector<vnv::Cell> row = {results.method.name, run.summary.level, run.value_of(solver_time),
                                  run.value_of(loop_time)};
    for (std::size_t k = 0; k < names_of_sub_steps.size(); ++k) {
      const double time = run.value_of(time_of(SubStep(k)));
      row.push_back(std::isnan(time) ? 0 : time);
    }
    table.rows.push_back(std::move(row));
  }
  record.tables.push_back(std::move(table));
}

void draw_empty_background(const vnv::Results& results, vnv::Record& record) {
  vnv::Curve curve{"empty_background", results.method.name, vnv::Role::ours, {}, {}, false};
  for (const vnv::Run& run : results.runs)
    if (const double fraction = run.value_of(empty_fraction); !std::isnan(fraction)) {
      curve.x.push_back(fraction);
      curve.y.push_back(run.summary.cost.per_step());
    }
  if (curve.x.empty()) return;
  record.figures.push_back(
      {"empty_background",
       "CPU time per step against the empty fraction of the background grid",
       "The same column of 14400 particles in tanks 1, 10 and 100 times as large. Sun et al. give the empty background "
       "as a cost of MPM in the dam break.",
       {.label = "empty fraction of the grid [%]", .low = 80, .high = 100},
       {.label = "T_p [ms]", .scale = 1e3, .low = 0}});
  record.curves.push_back(std::move(curve));
}

}  // namespace touchstone::bench

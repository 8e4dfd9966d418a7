#include "vnv/flows/dams/survival.hpp"

#include "vnv/record/record.hpp"

namespace touchstone::vnv {
namespace {

/// What came of the runs whose levels begin so.
struct Survival {
  double starts = 0, reached = 0, first_end = end_of_impact, most_energy_made = 0;

  Survival(const Results& results, std::string_view name) {
    for (const Run& run : results.runs) {
      if (!run.summary.level.starts_with(name)) continue;
      ++starts;
      reached += run.summary.finished;
      first_end = std::min(first_end, run.summary.end_time);
      if (run.summary.finished) most_energy_made = std::max(most_energy_made, largest_rise_of_energy(run, 0, 1));
    }
  }
};

}  // namespace

std::vector<Value> survival(const Results& results, const Record&) {
  const Survival all(results, "");
  return {{"", not_a_number, end_of_impact, ended_early, all.starts - all.reached},
          {"", not_a_number, end_of_impact, first_end, all.first_end},
          {"", not_a_number, end_of_impact, most_energy_made, all.most_energy_made}};
}

void survival_table(const Results& results, Record& record) {
  Table table{"robustness",
              "Runs to 2 s",
              "Starts differ by a hundredth of a spacing. Energy made: the largest rise of the sum of kinetic, "
              "potential and elastic energy, relative to the potential energy that the column loses until it lies "
              "flat, among the runs that reached 2 s.",
              {"method", "column", "across", "starts", "reached 2 s", "earliest end [s]", "most energy made [%]"},
              {}};
  for (const Level& level : results.method.levels) {
    const std::string_view name = level.name;
    if (!name.ends_with(", start 1")) continue;
    const Survival one(results, name.substr(0, name.size() - 1));
    if (one.starts == 0) continue;
    const std::size_t comma = name.find(", ");
    table.rows.push_back({results.method.name, level.name.substr(0, comma), std::stod(level.name.substr(comma + 2)),
                          one.starts, one.reached, one.reached < one.starts ? Cell(one.first_end) : Cell(""),
                          one.reached > 0 ? Cell(100 * one.most_energy_made) : Cell("")});
  }
  record.tables.push_back(std::move(table));
}

}  // namespace touchstone::vnv

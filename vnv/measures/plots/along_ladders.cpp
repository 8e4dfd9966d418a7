#include "vnv/measures/plots/along_ladders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace touchstone::vnv {

Pick error_of(Quantity quantity, double time) {
  return [=](const Record& record, const Run& run) -> std::optional<double> {
    for (const Value& e : record.values)
      if (e.level == run.summary.level && e.quantity == quantity && std::abs(e.time - time) <= 1e-9 * time)
        return e.value;
    return std::nullopt;
  };
}
Pick particle_number() {
  return [](const Record&, const Run& run) { return static_cast<double>(run.summary.cost.particles); };
}
Pick spacing() {
  return [](const Record&, const Run& run) { return run.summary.spacing; };
}
Pick time_per_step() {
  return [](const Record&, const Run& run) { return run.summary.cost.per_step(); };
}

Plot along_ladders(Figure frame, std::vector<std::string> ladders, Pick x, std::vector<Ordinate> ordinates) {
  return [=](const Results& results, Record& record) {
    record.figures.push_back(frame);
    std::vector<Ladder> drawn;
    for (const Ladder& ladder : results.method.ladders)
      if (ladders.empty() || std::ranges::find(ladders, ladder.name) != ladders.end()) drawn.push_back(ladder);
    for (const Ladder& ladder : drawn)
      for (const Ordinate& ordinate : ordinates) {
        const std::string which = drawn.size() == 1 ? "" : ", " + ladder.name;
        Curve curve{frame.id, results.method.name + ordinate.suffix + which, Role::ours, {}, {}, false};
        for (const std::string& level : ladder.levels) {
          const Run* run = results.run(level);
          if (!run || !run->summary.finished) continue;
          const std::optional<double> across = x(record, *run), up = ordinate.pick(record, *run);
          if (!across || !up) continue;
          curve.x.push_back(*across);
          curve.y.push_back(*up);
        }
        if (!curve.x.empty()) record.curves.push_back(std::move(curve));
      }
  };
}

Plot error_against_spacing(std::string id, std::string title, std::string caption, std::string label,
                           const Quantity& error, double time) {
  return along_ladders({std::move(id),
                        std::move(title),
                        std::move(caption),
                        {.label = "particle spacing [mm]", .scale = 1e3, .logarithmic = true},
                        {.label = std::move(label), .logarithmic = true}},
                       {}, spacing(), {{"", error_of(error, time)}});
}
Plot work_precision(const Quantity& error) {
  return [=](const Results&, Record& record) {
    record.diagrams.push_back(
        {.id = "cost", .title = "Work-precision diagram", .caption = "", .quantity = error, .targets = {}});
  };
}
std::vector<Plot> errors_of_velocity(std::string id, const std::string& label, const Quantity& error, double time) {
  return {error_against_spacing(std::move(id), "Error against spacing",
                                fmt::format("L2 error of the velocity, over particles, at t = {:g} s.", time), label,
                                error, time),
          work_precision(error)};
}

Plot beside(std::vector<Curve> curves) {
  return
      [=](const Results&, Record& record) { record.curves.insert(record.curves.end(), curves.begin(), curves.end()); };
}

}  // namespace touchstone::vnv

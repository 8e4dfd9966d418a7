#include "vnv/measures/plots/over_time.hpp"

#include <utility>

namespace touchstone::vnv {

Plot over_time(std::string id, std::string title, std::string caption, Axis quantity, std::size_t column,
               std::vector<std::string> levels) {
  return [column, levels,
          frame = Figure{std::move(id), std::move(title), std::move(caption), {"t [s]"}, std::move(quantity)}](
             const Results& results, Record& record) {
    record.figures.push_back(frame);
    for (const std::string& level : levels) {
      const Run* run = results.run(level);
      if (!run) continue;
      Curve curve{frame.id, results.method.name + " " + level, Role::ours, run->history.time, {}, false};
      for (const std::vector<double>& row : run->history.values) curve.y.push_back(row[column]);
      record.curves.push_back(std::move(curve));
    }
  };
}

Plot kinetic_energy_over_time(std::size_t column, std::vector<std::string> levels) {
  return over_time("energy", "Kinetic energy", "Of all particles.", {"kinetic energy [J/m]"}, column,
                   std::move(levels));
}

Plot exact_over_time(std::string figure, std::function<double(double t)> truth, double until) {
  return [=](const Results&, Record& record) {
    Curve exact{figure, "exact", Role::exact, {}, {}, false};
    for (int k = 0; k <= 200; ++k) {
      exact.x.push_back(until * k / 200);
      exact.y.push_back(truth(exact.x.back()));
    }
    record.curves.push_back(std::move(exact));
  };
}

}  // namespace touchstone::vnv

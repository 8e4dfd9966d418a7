#pragma once
#include "vnv/case.hpp"
#include "vnv/record/record.hpp"

#include <string>
#include <utility>
#include <vector>

namespace touchstone::vnv {

/// What the watch saw in its `column` over time, one curve per level named (those that were run).
inline Plot over_time(Figure frame, std::size_t column, std::vector<std::string> levels) {
  return [=](const Results& results, Record& record) {
    record.figures.push_back(frame);
    for (const std::string& level : levels) {
      const Run* run = results.run(level);
      if (!run) continue;
      Curve curve{frame.id, results.method.name + " " + level, Role::ours, run->history.time, {}, false};
      for (const std::vector<double>& seen : run->history.seen) curve.y.push_back(seen[column]);
      record.curves.push_back(std::move(curve));
    }
  };
}

/// An exact line from t = 0 to `until` [s].
inline Plot exact_over_time(std::string figure, std::function<double(double t)> truth, double until) {
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

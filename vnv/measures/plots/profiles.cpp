#include "vnv/measures/plots/profiles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace touchstone::vnv {

void add_points(Curve& curve, const Profile& profile, double height) {
  double largest = 0;
  for (const double value : profile.value) largest = std::max(largest, std::abs(value));
  const auto place = [](double value, double whole) {
    return std::isfinite(value / whole) ? std::lround(2000 * value / whole) : std::numeric_limits<long>::min();
  };
  std::set<std::pair<long, long>> drawn;
  for (std::size_t k = 0; k < profile.at.size(); ++k)
    if (drawn.insert({place(profile.at[k], height), place(profile.value[k], largest)}).second) {
      curve.x.push_back(profile.at[k]);
      curve.y.push_back(profile.value[k]);
    }
}

Plot profiles(Figure frame, std::function<Measure(const Level&)> measure, Truth truth, double height,
              std::vector<std::string> levels) {
  return [=](const Results& results, Record& record) {
    record.figures.push_back(frame);
    for (const Level& level : results.method.levels) {
      const Run* run = results.run(level.name);
      if (!run || std::ranges::find(levels, level.name) == levels.end()) continue;
      Curve ours{frame.id, results.method.name + " " + level.name, Role::ours, {}, {}, true};
      for (const Samples& samples : run->samples) {
        add_points(ours, measure(level)(samples), height);
        Curve exact{frame.id, fmt::format("exact, t = {:.3g} s", samples.time), Role::exact, {}, {}, false};
        for (int k = 0; k <= 200; ++k) {
          exact.x.push_back(height * k / 200);
          exact.y.push_back(truth(exact.x.back(), samples.time));
        }
        record.curves.push_back(std::move(exact));
      }
      record.curves.push_back(std::move(ours));
    }
  };
}

}  // namespace touchstone::vnv

#pragma once
#include "vnv/measures/norms_of.hpp"
#include "vnv/record/record.hpp"

#include <fmt/format.h>

namespace touchstone::vnv {

/// A measured profile at each time of the levels named, as points over the exact lines.
inline Plot profiles(Figure frame, std::function<Measure(const Level&)> measure, Truth truth, double height,
                     std::vector<std::string> levels) {
  return [=](const Results& results, Record& record) {
    record.figures.push_back(frame);
    for (const Level& level : results.method.levels) {
      const Run* run = results.run(level.name);
      if (!run || std::ranges::find(levels, level.name) == levels.end()) continue;
      Curve ours{frame.id, results.method.name + " " + level.name, Role::ours, {}, {}, true};
      for (const Samples& samples : run->samples) {
        const Profile profile = measure(level)(samples);
        ours.x.insert(ours.x.end(), profile.at.begin(), profile.at.end());
        ours.y.insert(ours.y.end(), profile.value.begin(), profile.value.end());
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

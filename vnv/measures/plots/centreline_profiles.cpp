#include "vnv/measures/plots/centreline_profiles.hpp"

#include "vnv/files/data_folder.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace touchstone::vnv {

Plot centreline_profile(Figure frame, Cavity cavity, int Re, Centreline::Direction direction,
                        std::vector<std::string> levels) {
  return [=](const Results& results, Record& record) {
    const auto is_there = [&](const std::string& level) {
      const Run* run = results.run(level);
      return run && run->summary.finished;
    };
    const auto finest = std::ranges::find_if(levels, is_there);
    if (finest == levels.end()) return;
    const Run& run = *results.run(*finest);
    record.figures.push_back(frame);
    const Centreline published = ghia_centreline(data_folder(), direction, Re);
    record.curves.push_back(
        {frame.id, "Ghia, Ghia & Shin 1982", Role::published, published.at, published.velocity, true});
    const ConvergedProfile profile(data_folder(), direction, Re);
    Curve converged{frame.id, "converged", Role::exact, {}, {}, false};
    for (int k = 0; k <= 200; ++k) {
      converged.x.push_back(0.005 * k);
      converged.y.push_back(profile(converged.x.back()));
    }
    record.curves.push_back(std::move(converged));
    Curve ours{frame.id, fmt::format("{} {}", results.method.name, *finest), Role::ours, {}, {}, false};
    const double nearest = 1.5 * run.summary.spacing / cavity.side;
    for (int k = 0; k <= 100; ++k) {
      ours.x.push_back(nearest + (1 - 2 * nearest) * 0.01 * k);
      ours.y.push_back(cavity.mean_velocity_at(run, direction, ours.x.back(), run.summary.spacing));
    }
    record.curves.push_back(std::move(ours));
  };
}

}  // namespace touchstone::vnv

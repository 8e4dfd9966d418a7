#include "vnv/plots/centreline_profiles.hpp"

namespace touchstone::vnv {

Plot centreline_profile(Figure frame, Cavity cavity, Centreline published, std::string level) {
  return [=](const Results& results, Record& record) {
    record.figures.push_back(frame);
    record.curves.push_back(
        {frame.id, "Ghia, Ghia & Shin 1982", Role::published, published.at, published.velocity, true});
    const Run* run = results.run(level);
    if (!run || !run->summary.finished) return;
    Curve ours{frame.id, results.method.name, Role::ours, {}, {}, false};
    const double nearest = 1.5 * run->summary.spacing / cavity.side;
    for (int k = 0; k <= 100; ++k) {
      ours.x.push_back(nearest + (1 - 2 * nearest) * 0.01 * k);
      ours.y.push_back(cavity.mean_velocity_at(*run, published.direction, ours.x.back(), run->summary.spacing));
    }
    record.curves.push_back(std::move(ours));
  };
}

}  // namespace touchstone::vnv

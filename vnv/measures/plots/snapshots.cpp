#include "vnv/measures/plots/snapshots.hpp"

#include <fmt/format.h>

namespace touchstone::vnv {

Plot snapshots(Figure frame, std::vector<std::string> levels, std::vector<double> times, ParticleField colour) {
  return [=](const Results& results, Record& record) {
    Figure figure = frame;
    figure.equal_axes = true;
    record.figures.push_back(figure);
    for (const std::string& level : levels) {
      const Run* run = results.run(level);
      if (!run) continue;
      for (const double time : times)
        if (const Samples* s = run->at(time)) {
          Cloud cloud{frame.id, results.method.name + " " + level, fmt::format("t = {:.2f} s", time), {}, {}, {}};
          for (Eigen::Index p = 0; p < s->size(); ++p) {
            cloud.x.push_back(s->x(0, p));
            cloud.y.push_back(s->x(1, p));
            cloud.colour.push_back(colour(*s, p));
          }
          record.clouds.push_back(std::move(cloud));
        }
    }
  };
}

}  // namespace touchstone::vnv

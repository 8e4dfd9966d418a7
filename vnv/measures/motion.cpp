#include "vnv/measures/motion.hpp"

#include "vnv/judge/norms.hpp"

namespace touchstone::vnv {

Measurement part_of_motion(const Moment& moment) {
  return [moment](const Level& level, const Run& run) -> std::vector<Value> {
    double moved = 0, scale = 0, value_before = 0, rate_before = 0, time_before = 0;
    for (const Samples& s : run.samples) {
      double value = 0, rate = 0;
      for (Eigen::Index p = 0; p < s.size(); ++p) {
        value += s.mass[p] * moment.of(s.x.col(p));
        rate += s.mass[p] * moment.slope(s.x.col(p)).dot(s.v.col(p));
      }
      value /= s.mass.sum(), rate /= s.mass.sum();
      if (&s != &run.samples.front()) {
        const double made = (value - value_before) / (s.time - time_before);
        moved += made * (rate_before + rate) / 2;
        scale += made * made;
      }
      value_before = value, rate_before = rate, time_before = s.time;
    }
    norms::require_scale("part_of_motion", scale);
    return {{level.name, level.spacing, run.samples.back().time, part_of_motion_found, moved / scale}};
  };
}

Claim moves_by_its_velocity() {
  return between(part_of_motion_found, 0.5, 1.5, theory("a fluid moves with its velocity"));
}

}  // namespace touchstone::vnv

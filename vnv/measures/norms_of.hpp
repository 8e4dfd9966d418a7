#pragma once
#include "vnv/case.hpp"
#include "vnv/judge/norms.hpp"
#include "vnv/measures/profile.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace touchstone::vnv {

/// The truth across a channel: value at y [m] and time [s].
using Truth = std::function<double(double y, double t)>;

/// L2 (34) and Linf (35) of a measured profile against the truth, in per cent, at every time of a run. `what` names
/// field and measure: "v_x, row means" gives "L2 v_x, row means [%]". The measure may depend on the level.
inline Measurement norms_of(std::string what, std::function<Measure(const Level&)> measure, Truth truth) {
  return [=](const Level& level, const Run& run) {
    std::vector<Value> errors;
    for (const Samples& samples : run.samples) {
      const Profile profile = measure(level)(samples);
      std::vector<double> exact;
      for (const double y : profile.at) exact.push_back(truth(y, samples.time));
      const auto add = [&](const char* norm, double value) {
        errors.push_back({level.name,
                          level.spacing,
                          samples.time,
                          {fmt::format("{} {}", norm, what), "%", Kind::norm},
                          100 * value});
      };
      add("L2", relative_l2(profile.value, exact, profile.weight));
      add("Linf", relative_linf(profile.value, exact));
    }
    return errors;
  };
}

}  // namespace touchstone::vnv

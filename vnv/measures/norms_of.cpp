#include "vnv/measures/norms_of.hpp"

#include "vnv/judge/norms.hpp"

#include <fmt/format.h>

namespace touchstone::vnv {

Measurement norms_of(std::string what, std::function<Measure(const Level&)> measure, Truth truth) {
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

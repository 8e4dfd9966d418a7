#pragma once
/// What a measure makes of samples, and the fields it may be asked for.

#include "solvers/samples.hpp"

#include <functional>
#include <utility>
#include <vector>

namespace touchstone::vnv {

/// Values of one field across a channel; three equally long lists.
struct Profile {
  std::vector<double> at;      // m  y
  std::vector<double> value;   // in the unit of the field
  std::vector<double> weight;  // of each value in a norm; only ratios matter
};

/// One number of one particle.
using ParticleField = std::function<double(const Samples&, Eigen::Index particle)>;

/// Its mean over the particles at chosen places; not a number where there are none.
template <class Chosen>
double mean_where(const Samples& samples, const ParticleField& field, const Chosen& chosen) {
  double sum = 0, count = 0;
  for (Eigen::Index p = 0; p < samples.size(); ++p)
    if (chosen(Vec2(samples.x.col(p)))) {
      sum += field(samples, p);
      ++count;
    }
  return sum / count;
}

/// A profile from samples.
using Measure = std::function<Profile(const Samples&)>;

/// A field at each particle, in the order of the particles, weighted by the particle's volume [m²].
inline Measure per_particle(ParticleField field) {
  return [field = std::move(field)](const Samples& samples) {
    const Scalars volumes = samples.volumes();
    Profile profile;
    for (Eigen::Index p = 0; p < samples.size(); ++p) {
      profile.at.push_back(samples.x(1, p));
      profile.value.push_back(field(samples, p));
      profile.weight.push_back(volumes(p));
    }
    return profile;
  };
}

inline double velocity_x(const Samples& samples, Eigen::Index particle) { return samples.v(0, particle); }    // m/s
inline double velocity_y(const Samples& samples, Eigen::Index particle) { return samples.v(1, particle); }    // m/s
inline double pressure(const Samples& samples, Eigen::Index particle) { return samples.pressure(particle); }  // Pa

}  // namespace touchstone::vnv

#pragma once
#include "vnv/measures/profile.hpp"

#include <utility>

namespace touchstone::vnv {

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

}  // namespace touchstone::vnv

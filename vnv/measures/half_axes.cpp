#include "vnv/measures/half_axes.hpp"

#include <cmath>

namespace touchstone::vnv {

HalfAxes half_axes(const Samples& samples) {
  const double mass = samples.mass.sum();
  const Vec2 centre = samples.x * samples.mass.matrix() / mass;
  const Vectors from = samples.x.colwise() - centre;
  const Vectors weighted = from * samples.mass.matrix().asDiagonal();
  const Mat2 moments = weighted.lazyProduct(from.transpose()) / mass;  // a general product takes longer to compile
  const double middle = moments.trace() / 2, half = std::hypot((moments(0, 0) - moments(1, 1)) / 2, moments(0, 1));
  return {2 * std::sqrt(middle + half), 2 * std::sqrt(middle - half)};
}

}  // namespace touchstone::vnv

#include "vnv/run/state_check.hpp"

#include "solvers/stepping/diverged.hpp"

#include <cmath>

namespace touchstone::vnv {

StateCheck::StateCheck(const Medium& medium, const Samples& at_start)
    : medium_(medium), particles_(at_start.size()), mass_(at_start.mass.sum()) {}

void StateCheck::require(const Samples& s, long step) const {
  const auto refuse = [&](Eigen::Index p, const char* quantity, double value, std::string expected) {
    const Vec2 place = p < s.size() ? Vec2(s.x.col(p)) : Vec2(Vec2::Constant(NAN));
    throw Diverged({step, s.time, p, place, quantity, value, std::move(expected)});
  };
  const double speed_limit = fastest * medium_.sound_speed, low = least_density * medium_.density,
               high = greatest_density * medium_.density;
  double energy = 0;  // J/m
  for (Eigen::Index p = 0; p < s.size(); ++p) {
    // Written so that what is not a number is refused.
    if (!s.x.col(p).allFinite()) refuse(p, "distance from the origin [m]", s.x.col(p).norm(), "a finite number");
    const double square = s.v.col(p).squaredNorm();
    if (!(square <= speed_limit * speed_limit))
      refuse(p, "speed [m/s]", std::sqrt(square), fmt::format("at most {:g} times the speed of sound", fastest));
    if (!(s.density[p] >= low && s.density[p] <= high))
      refuse(p, "density [kg/m³]", s.density[p], fmt::format("{:g} to {:g}", low, high));
    energy += s.mass[p] * square / 2;
  }
  const auto of_all = [&](const char* quantity, double value, std::string expected) {
    Eigen::Index fastest_one = 0;
    if (s.size() > 0) s.v.colwise().squaredNorm().maxCoeff(&fastest_one);
    refuse(fastest_one, quantity, value, std::move(expected));
  };
  if (s.size() != particles_)
    of_all("particles", static_cast<double>(s.size()), fmt::format("{} as at the start", particles_));
  const double mass = s.mass.sum(), most = most_energy * mass_ * medium_.sound_speed * medium_.sound_speed / 2;
  if (!(std::abs(mass - mass_) <= 1e-9 * mass_))
    of_all("mass [kg/m]", mass, fmt::format("{:g} as at the start", mass_));
  if (!(energy <= most))
    of_all("kinetic energy of all [J/m]", energy,
           fmt::format("at most {:g}, as if all moved at twice the speed of sound", most));
}

}  // namespace touchstone::vnv

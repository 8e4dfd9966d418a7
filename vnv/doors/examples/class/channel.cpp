// SPDX-License-Identifier: MIT
/// Plane Poiseuille flow by finite differences: of second order in space, explicit in time.

#include <touchstone/solver.hpp>

#include <algorithm>

using namespace touchstone::client;

class Channel {
 public:
  explicit Channel(const Scene& scene)
      : start_(scene.start), dy_(scene.spacing), nu_(scene["nu"]), F_(scene["F"]), u_(size_t(scene["H"] / dy_ + 0.5)) {}

  void step(double at_most) {
    const double dt = std::min(at_most, 0.25 * dy_ * dy_ / nu_);
    std::vector<double> next = u_;
    for (size_t k = 0; k < u_.size(); ++k) {
      const double below = k > 0 ? u_[k - 1] : -u_[k], above = k + 1 < u_.size() ? u_[k + 1] : -u_[k];  // no slip
      next[k] += dt * (F_ + nu_ * (above - 2 * u_[k] + below) / (dy_ * dy_));
    }
    u_ = next;
    time_ += dt;
  }
  double time() const { return time_; }

  Samples samples() const {
    Samples now{.x = start_.x, .y = start_.y};
    for (const double y : start_.y) now.v_x.push_back(u_[size_t(y / dy_)]);
    return now;
  }

 private:
  Samples start_;
  double dy_, nu_, F_;
  std::vector<double> u_;  // m/s  at the middle of each row
  double time_ = 0;
};

int main(int count, char** words) { return run<Channel>(count, words); }

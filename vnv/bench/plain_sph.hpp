#pragma once
#include "vnv/bench/plain_cells.hpp"
#include "vnv/bench/plain_flow.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace touchstone::bench {

/// Smoothed particle hydrodynamics as textbooks have it (Monaghan 1992; Morris, Fox & Zhu 1997): for each particle a
/// loop over all its neighbours; cubic spline with a support of 2.4 spacings, which is 20 neighbours; continuity,
/// conservative pressure and laminar viscosity; the midpoint rule. Behind the plates of a channel stand dummies that
/// mirror the velocity of the particle whose sum they enter; a tank has no walls here: its column is for timing alone.
class PlainSph {
 public:
  struct Particle {
    double x, y, vx = 0, vy = 0;              // m, m/s
    double density;                           // kg/m³
    double pressure_term = 0;                 // m⁴/s² kg  P / rho²
    double ax = 0, ay = 0, density_rate = 0;  // m/s², kg/m³ s
  };

  PlainSph(const PlainFlow& flow, double spacing, double time_step)
      : flow_(flow),
        dt_(time_step),
        h_(1.2 * spacing),
        skin_(0.1 * spacing),
        period_(flow.shape == PlainFlow::Shape::channel ? flow.size.x() : std::numeric_limits<double>::infinity()) {
    const Lattice points = flow.lattice(spacing);
    mass_ = flow.density * points.volume();
    for (const Vectors places = points.places(); const auto& x : places.colwise())
      particles_.push_back({.x = x.x(), .y = x.y(), .density = flow.density});
    if (flow.shape == PlainFlow::Shape::channel) lay_out_dummies(points);
    find_neighbours();
    find_rates();
  }

  void step() {
    if (moved_too_far()) find_neighbours();
    start_ = particles_;
    find_rates();
    advance(dt_ / 2);
    find_rates();
    advance(dt_);
  }

  /// The right-hand side of all particles.
  void find_rates() {
    for (Particle& p : particles_) p.pressure_term = flow_.pressure(p.density) / (p.density * p.density);
    for (std::size_t i = 0; i < particles_.size(); ++i) sum_over_fluid(i);
    for (std::size_t i = 0; i < particles_.size(); ++i) sum_over_dummies(i);
  }

  const std::vector<Particle>& particles() const { return particles_; }
  double neighbours() const {  // per particle, of those listed
    return static_cast<double>(neighbour_.size()) / static_cast<double>(particles_.size());
  }

 private:
  static constexpr double support = 2;  // h

  void lay_out_dummies(const Lattice& points) {
    for (long layer = 0; layer < 3; ++layer)
      for (long column = 0; column < points.columns; ++column)
        for (long row : {-1 - layer, points.rows + layer}) dummies_.push_back(points.place(column, row));
  }

  /// A distance along x to the nearest image [m].
  double nearest(double x) const { return x > period_ / 2 ? x - period_ : x < -period_ / 2 ? x + period_ : x; }

  /// W'(r) / r of the cubic spline [m⁻⁴].
  double slope(double r) const {
    const double q = r * per_h_;
    if (q < 1) return steepness_ * (2.25 * q - 3) * per_h_;
    if (q < 2) return -0.75 * steepness_ * (2 - q) * (2 - q) / r;
    return 0;
  }

  void sum_over_fluid(std::size_t self) {
    Particle& i = particles_[self];
    double ax = flow_.force.x(), ay = flow_.force.y(), density_rate = 0;
    const double nu = flow_.viscosity / flow_.density, eta2 = 0.01 * h_ * h_;
    for (int k = first_[self]; k < first_[self + 1]; ++k) {
      const Particle& j = particles_[neighbour_[k]];
      const double x = nearest(i.x - j.x), y = i.y - j.y, r2 = x * x + y * y;
      if (r2 >= support * support * h_ * h_) continue;
      const double vx = i.vx - j.vx, vy = i.vy - j.vy, m_slope = mass_ * slope(std::sqrt(r2));
      const double push = -(i.pressure_term + j.pressure_term) * m_slope;
      const double drag = 4 * nu * r2 * m_slope / ((i.density + j.density) * (r2 + eta2));
      ax += push * x + drag * vx;
      ay += push * y + drag * vy;
      density_rate += m_slope * (vx * x + vy * y);
    }
    i.ax = ax;
    i.ay = ay;
    i.density_rate = density_rate;
  }

  /// Dummies have the pressure and density of the particle whose sum they enter and, at their distance from the wall,
  /// its velocity mirrored (Morris, Fox & Zhu 1997, section 2.7).
  void sum_over_dummies(std::size_t self) {
    Particle& i = particles_[self];
    const double nu = flow_.viscosity / flow_.density, eta2 = 0.01 * h_ * h_;
    for (int k = first_dummy_[self]; k < first_dummy_[self + 1]; ++k) {
      const Vec2& dummy = dummies_[near_dummy_[k]];
      const double x = nearest(i.x - dummy.x()), y = i.y - dummy.y(), r2 = x * x + y * y;
      if (r2 >= support * support * h_ * h_) continue;
      const double from_wall = y > 0 ? i.y : flow_.size.y() - i.y;
      const double mirror = std::min(2.5, std::abs(y) / from_wall), m_slope = mass_ * slope(std::sqrt(r2));
      const double push = -2 * i.pressure_term * m_slope, drag = 2 * nu * r2 * m_slope / (i.density * (r2 + eta2));
      i.ax += push * x + drag * mirror * i.vx;
      i.ay += push * y + drag * mirror * i.vy;
      i.density_rate += m_slope * mirror * (i.vx * x + i.vy * y);
    }
  }

  /// From the start of the step.
  void advance(double dt) {
    for (std::size_t i = 0; i < particles_.size(); ++i) {
      Particle& p = particles_[i];
      p.x = start_[i].x + dt * p.vx;
      p.y = start_[i].y + dt * p.vy;
      p.vx = start_[i].vx + dt * p.ax;
      p.vy = start_[i].vy + dt * p.ay;
      p.density = start_[i].density + dt * p.density_rate;
    }
  }

  bool moved_too_far() const {
    for (std::size_t i = 0; i < particles_.size(); ++i) {
      const double x = nearest(particles_[i].x - listed_at_[i].x()), y = particles_[i].y - listed_at_[i].y();
      if (x * x + y * y > 0.25 * skin_ * skin_) return true;
    }
    return false;
  }

  void find_neighbours() {
    listed_at_.clear();
    for (Particle& p : particles_) {
      if (p.x >= period_) p.x -= period_;
      if (p.x < 0 && std::isfinite(period_)) p.x += period_;
      listed_at_.emplace_back(p.x, p.y);
    }
    list_near(listed_at_, first_, neighbour_);
    list_near(dummies_, first_dummy_, near_dummy_);
  }

  /// For each particle those of `places` that are near, and not at its own place.
  void list_near(const std::vector<Vec2>& places, std::vector<int>& first, std::vector<int>& near) const {
    const double reach = support * h_ + skin_;
    const PlainCells cells(places, reach, period_);
    first.assign(1, 0);
    near.clear();
    for (const Particle& p : particles_) {
      cells.visit_near({p.x, p.y}, [&](int j) {
        const double x = nearest(p.x - places[j].x()), y = p.y - places[j].y(), r2 = x * x + y * y;
        if (r2 > 0 && r2 < reach * reach) near.push_back(j);
      });
      first.push_back(static_cast<int>(near.size()));
    }
  }

  PlainFlow flow_;
  double dt_, h_, skin_, period_;                                                   // s, m
  double per_h_ = 1 / h_, steepness_ = 10 / (7 * std::numbers::pi * h_ * h_ * h_);  // 1/m, 1/m³
  double mass_;                                                                     // kg/m  of each
  std::vector<Particle> particles_, start_;
  std::vector<Vec2> dummies_, listed_at_;  // m
  std::vector<int> first_, neighbour_, first_dummy_, near_dummy_;
};

}  // namespace touchstone::bench

#pragma once
/// Right data of every flow, as tests make and spoil them.

#include "reference/elliptic_drop.hpp"
#include "solvers/lattice.hpp"
#include "vnv/doors/testing.hpp"
#include "vnv/files/tables.hpp"
#include "vnv/flows/dam_break.hpp"
#include "vnv/flows/gravity_wave.hpp"
#include "vnv/measures/centrelines.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace touchstone::vnv::doors {

inline double parameter(const Flow& flow, const std::string& name) {
  return std::ranges::find(flow.parameters, name, &Parameter::name)->value;
}

/// The front of the experiment by Lobovský et al., a little ahead as those of our own methods, at T.
inline double front_at_scaled(double T) {
  static const DataTable table = read_table(data_folder() / "experiments" / "lobovsky_2014_front_600.csv");
  static const FrontHistory front{table.numbers("T [-]"), table.numbers("L [-]")};
  const double within = std::clamp(T, front.T.front(), front.T.back());
  return T > 0 ? std::min(2.683, front_at(front, within) + std::min(0.08, T / 10)) : 1;
}

/// Of a rotating patch at the start, between the places of a grid: its series is slow beside the sides.
inline Scalars first_pressure(const Flow& flow, const Vectors& places) {
  constexpr int fine = 64;
  static std::map<std::pair<double, double>, Eigen::MatrixXd> known;
  const double side = parameter(flow, "L");
  Eigen::MatrixXd& nodes = known[{side, parameter(flow, "omega")}];
  if (nodes.size() == 0) {
    nodes.setZero(fine + 1, fine + 1);
    for (int i = 1; i < fine; ++i)
      for (int j = 1; j < fine; ++j)
        nodes(i, j) = flow.start.pressure_at(side * Vec2(1.0 * i / fine - 0.5, 1.0 * j / fine - 0.5));
  }
  Scalars found(places.cols());
  for (Eigen::Index p = 0; p < places.cols(); ++p) {
    const Vec2 at = ((places.col(p) / side).array() + 0.5) * fine;
    const int i = std::clamp(static_cast<int>(at.x()), 0, fine - 1),
              j = std::clamp(static_cast<int>(at.y()), 0, fine - 1);
    const double a = at.x() - i, b = at.y() - j;
    found[p] =
        std::lerp(std::lerp(nodes(i, j), nodes(i + 1, j), a), std::lerp(nodes(i, j + 1), nodes(i + 1, j + 1), a), b);
  }
  return found;
}

/// A flow at a time on a lattice with so many across, each of whose rows is moved at the start by up to `shaken` of a
/// spacing along both axes; with an error of second order. What is not known exactly is as near as is known: between
/// the places of tables, on a patch whose corners are on their paths, as a block of water.
inline Samples right_of(const Flow& flow, double across, double t, double shaken = 0, unsigned seed = 1) {
  const Lattice regular = lattice(flow.filled, flow.across / across);
  Vectors at_rest = regular.places();
  std::mt19937 draw(seed);
  std::uniform_real_distribution<double> any(-shaken, shaken);
  for (Eigen::Index p = 0; p < at_rest.cols() && shaken > 0; ++p)
    at_rest.col(p) += regular.step.cwiseProduct(Vec2(any(draw), any(draw)));
  const Vectors start = flow.start.places_on(at_rest);
  const double second_order = 1 + 0.5 / (across * across);
  Samples s{.time = t, .x = start};
  s.v = Vectors::Zero(2, s.x.cols());
  s.pressure = Scalars::Zero(s.size());
  s.density = Scalars::Constant(s.size(), flow.fluid.density);
  s.mass = s.density * regular.volume();
  set_exact_fields(flow, s);
  if (flow.name == "cavity") {
    const int Re = static_cast<int>(parameter(flow, "Re"));
    static std::map<int, std::pair<ConvergedProfile, ConvergedProfile>> known;
    const auto of = [Re](Centreline::Direction direction) { return ConvergedProfile(data_folder(), direction, Re); };
    if (!known.contains(Re)) known.emplace(Re, std::pair(of(Centreline::vertical), of(Centreline::horizontal)));
    const auto& [u, v] = known.at(Re);
    const double L = parameter(flow, "L"), V = parameter(flow, "V");
    for (Eigen::Index p = 0; p < s.size(); ++p) s.v.col(p) = V * Vec2(u(s.x(1, p) / L), v(s.x(0, p) / L));
  } else if (flow.name == "standing_wave") {
    auto wave = flow.oracle<reference::StandingWave>();
    const auto amplitude = [exact = wave](double at) {
      return exact.a * std::cos(exact.omega() * at) * std::exp(-exact.decay_rate() * at);
    };
    constexpr double soon = 1e-4;  // s
    wave.a = amplitude(t + soon);
    s.v = gravity_wave::heaped(wave, at_rest);
    wave.a = amplitude(t - soon);
    s.v = (s.v - gravity_wave::heaped(wave, at_rest)) / (2 * soon);
    wave.a = amplitude(t);
    s.x = gravity_wave::heaped(wave, at_rest);
    for (Eigen::Index p = 0; p < s.size(); ++p)
      s.pressure[p] = flow.fluid.density * wave.g * (wave.h - at_rest(1, p));
  } else if (flow.name == "elliptic_drop") {
    const auto now = flow.oracle<reference::EllipticDrop>().at(t);
    s.x = start.array().colwise() * Eigen::Array2d(now.a, now.b) / parameter(flow, "R");
    s.x.row(0) *= std::lerp(1, second_order, parameter(flow, "s") * t);
    for (Eigen::Index p = 0; p < s.size(); ++p) {
      s.v.col(p) = now.s * Vec2(s.x(0, p), -s.x(1, p));
      s.pressure[p] = std::max(0.0, now.p(s.x(0, p), s.x(1, p)));
    }
  } else if (flow.name == "rotating_patch") {
    const double omega = parameter(flow, "omega"), turn = omega * t, stretch = std::sqrt(1 + turn * turn) - 1,
                 corner = parameter(flow, "L") / std::numbers::sqrt2;
    const Mat2 turned = Eigen::Rotation2Dd(-std::atan(turn)).toRotationMatrix();
    for (Eigen::Index p = 0; p < s.size(); ++p) {  // corners on their free paths, and the middle as it was
      const Vec2 x = start.col(p);
      s.x.col(p) = (1 + stretch * std::pow(x.norm() / corner, 4)) * (turned * x);
    }
    s.pressure = first_pressure(flow, start) / (1 + turn * turn);
    const double at_start = start.squaredNorm(), now = s.x.squaredNorm(),
                 turning = omega * at_start / now,  // keeps the angular momentum, and what spreads the energy
        spreading = std::sqrt(std::max(0.0, omega * omega * at_start / now - turning * turning));
    for (Eigen::Index p = 0; p < s.size(); ++p)
      s.v.col(p) = turning * Vec2(s.x(1, p), -s.x(0, p)) + spreading * s.x.col(p);
    s.v.colwise() -= s.v.rowwise().mean().eval();
  } else if (flow.name == "dam_break") {
    const double g = parameter(flow, "g"), h0 = parameter(flow, "h0"), l0 = parameter(flow, "l0"),
                 T = t * std::sqrt(g * h0) / l0, front = front_at_scaled(T), soon = 0.02,
                 rate = T > soon ? (front_at_scaled(T + soon) - front_at_scaled(T - soon)) / (2 * soon) * T / t : 0;
    s.x.row(0) *= front, s.x.row(1) /= front;  // a block that keeps its area
    s.v.row(0) = s.x.row(0) * rate / front, s.v.row(1) = -s.x.row(1) * rate / front;
    // A block whose end is as fast as the tongue of a dam would have more energy than its weight gives.
    const double given = g * h0 / 2 * (1 - 1 / front), moving = s.v.squaredNorm() / 2 / static_cast<double>(s.size());
    if (moving > given) s.v *= std::sqrt(given / moving);
    for (Eigen::Index p = 0; p < s.size(); ++p) s.pressure[p] = flow.fluid.density * g * (h0 / front - s.x(1, p));
  }
  s.v *= second_order, s.pressure *= second_order;
  return s;
}

}  // namespace touchstone::vnv::doors

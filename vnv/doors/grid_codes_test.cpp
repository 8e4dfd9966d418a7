/// Causes are planted into codes of finite differences, whose errors are orderly, and diagnosed: whether the right one
/// is named and its interval holds the truth, and how wide it is beside the actual error. The day's test draws few;
/// TOUCHSTONE_GRIDS=400 draws so many, by TOUCHSTONE_SEED, and prints the table of README.md.

#include "vnv/doors/diagnosis/diagnosis.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <numbers>
#include <random>

namespace touchstone::vnv::doors {
namespace grid_codes_test {

using Generator = std::mt19937_64;

double between(Generator& random, double low, double high) { return std::uniform_real_distribution(low, high)(random); }

/// dv/dt = F + nu d²v/dy² by central differences on cells, Euler's steps forward (theta 0) or backward (1), or Crank
/// and Nicolson's (1/2); walls by values in a cell behind each, which say that it stands so many spacings further out.
struct GridCode {
  double height, viscosity, force, lower, upper;  // m, m²/s, m/s², m/s
  bool periodic, upper_slips;
  double theta, courant;  // of steps: nu dt / h²
  double walls_out;       // spacings
  bool nodes;             // values stand on the walls, not half a spacing off

  std::size_t size(int across) const { return static_cast<std::size_t>(nodes && !periodic ? across + 1 : across); }
  double place(int across, std::size_t i) const {
    return height / across * (static_cast<double>(i) + (nodes && !periodic ? 0 : 0.5));
  }

  /// v after a time, a step of which is as long as the others but for the last ones.
  std::vector<double> run(int across, std::vector<double> v, double time) const {
    const double h = height / across, most = courant * h * h / viscosity;
    const auto steps = std::max(1.0, std::ceil(time / most * (1 - 1e-12)));
    for (double k = 0; k < steps; ++k) v = stepped(v, h, time / steps);
    return v;
  }

 private:
  double inner(double behind) const { return -(0.5 - walls_out) / (0.5 + walls_out) * behind; }

  /// The matrix of a step, v' = v + dt (theta L v' + (1 - theta) L v + b), by Gauss's elimination of three diagonals.
  std::vector<double> stepped(const std::vector<double>& v, double h, double dt) const {
    const std::size_t n = v.size();
    const double r = viscosity * dt / (h * h);
    std::vector<double> low(n, 1), mid(n, -2), high(n, 1), extra(n, 0);
    double corner = 0;
    if (periodic) {
      corner = 1;
    } else if (nodes) {
      mid[0] = mid[n - 1] = low[n - 1] = high[0] = 0;
      if (upper_slips) mid[n - 1] = -2, low[n - 1] = 2;
    } else {
      mid[0] += inner(1), extra[0] = lower * (1 - inner(1));
      if (upper_slips)
        mid[n - 1] += 1;
      else
        mid[n - 1] += inner(1), extra[n - 1] = upper * (1 - inner(1));
    }
    low[0] = high[n - 1] = 0;
    const auto held = [&](std::size_t i) { return nodes && !periodic && (i == 0 || (i == n - 1 && !upper_slips)); };
    std::vector<double> right(n), a(n), b(n), c(n);
    for (std::size_t i = 0; i < n; ++i) {
      const double before = i > 0 ? v[i - 1] : v[n - 1], after = i + 1 < n ? v[i + 1] : v[0];
      const double neighbours = (i > 0 ? low[i] : corner) * before + (i + 1 < n ? high[i] : corner) * after;
      right[i] = v[i] + (1 - theta) * r * (neighbours + mid[i] * v[i]) + r * extra[i] + (held(i) ? 0 : dt * force);
      a[i] = -theta * r * low[i], b[i] = 1 - theta * r * mid[i], c[i] = -theta * r * high[i];
    }
    if (!periodic) return solved(a, b, c, right);
    if (theta == 0) return right;
    // Sherman and Morrison's formula for the corners
    const double w = -theta * r, g = -b[0];
    std::vector<double> u(n, 0);
    u[0] = g, u[n - 1] = w;
    b[0] -= g, b[n - 1] -= w * w / g;
    const std::vector<double> x = solved(a, b, c, right), z = solved(a, b, c, u);
    const double factor = (x[0] + w / g * x[n - 1]) / (1 + z[0] + w / g * z[n - 1]);
    std::vector<double> all(n);
    for (std::size_t i = 0; i < n; ++i) all[i] = x[i] - factor * z[i];
    return all;
  }
  static std::vector<double> solved(const std::vector<double>& a, std::vector<double> b, const std::vector<double>& c,
                                    std::vector<double> d) {
    const std::size_t n = b.size();
    for (std::size_t i = 1; i < n; ++i) b[i] -= a[i] / b[i - 1] * c[i - 1], d[i] -= a[i] / b[i - 1] * d[i - 1];
    for (std::size_t i = n; i-- > 0;) d[i] = (d[i] - (i + 1 < n ? c[i] * d[i + 1] : 0)) / b[i];
    return d;
  }
};

struct Case {
  std::string flow;
  Cause cause = Cause::viscosity;
  double value = 0;  // as a fraction, spacings or seconds
  std::vector<int> across{};
  double theta = 0, courant = 0;
  bool nodes = false;
};

std::string name_of(Cause cause) {
  return cause == Cause::viscosity ? "viscosity"
         : cause == Cause::force   ? "force"
         : cause == Cause::walls   ? "both walls"
                                   : "time";
}

const std::map<std::string, std::map<std::string, double>> settings{
    {"poiseuille", {{"H", 1}, {"L", 0.1}, {"nu", 0.1}, {"F", 0.1}}},
    {"couette", {{"H", 1}, {"L", 0.1}, {"nu", 0.1}, {"V", 0.1}}},
    {"stokes_first", {{"H", 1}, {"L", 0.1}, {"nu", 0.1}, {"V", 0.1}}},
    {"shear_wave", {}},
};

Case drawn(Generator& random) {
  const auto pick = [&](const auto& all) {
    return all[std::uniform_int_distribution<std::size_t>(0, all.size() - 1)(random)];
  };
  Case one;
  one.flow = pick(std::vector<std::string>{"poiseuille", "couette", "stokes_first", "shear_wave"});
  std::vector<Cause> causes{Cause::viscosity, Cause::viscosity, Cause::lead};
  if (one.flow == "poiseuille") causes.push_back(Cause::force);
  if (one.flow == "poiseuille" || one.flow == "couette") causes.push_back(Cause::walls);
  one.cause = pick(causes);
  one.nodes = one.cause != Cause::walls && between(random, 0, 1) < 0.4;
  const double sign = between(random, 0, 1) < 0.5 ? -1 : 1;
  const Flow flow = flow_named(one.flow, Settings(settings.at(one.flow)));
  one.value = one.cause == Cause::walls  ? (sign < 0 ? -0.2 : pick(std::vector{0.3, 0.5}))
              : one.cause == Cause::lead ? -flow.judged.times.front() * between(random, 0.1, 0.3)
                                         : sign * between(random, 0.03, 0.06);
  one.theta = one.cause == Cause::walls && sign < 0 ? 0.5 : pick(std::vector{0., 0., 0.5, 1.});
  one.courant = one.theta == 0  ? between(random, 0.1, 0.5)
                : one.theta < 1 ? between(random, 0.3, 2)
                                : between(random, 0.1, 0.5);
  std::vector<int> all{24, 32, 48, 64};
  std::ranges::shuffle(all, random);
  all.resize(std::uniform_int_distribution<std::size_t>(1, 4)(random));
  std::ranges::sort(all);
  one.across = all;
  return one;
}

std::vector<Samples> run_of(const Case& one, const Flow& flow, int across) {
  const double nu = flow.fluid.viscosity / flow.fluid.density;
  std::map<std::string, double> set = settings.at(one.flow);
  const bool periodic = one.flow == "shear_wave";
  const double wall = one.flow == "stokes_first" ? set.at("V") : 0, lid = one.flow == "couette" ? set.at("V") : 0;
  const GridCode code{.height = flow.across,
                      .viscosity = nu * (one.cause == Cause::viscosity ? 1 + one.value : 1),
                      .force = flow.drive.amplitude.x() * (one.cause == Cause::force ? 1 + one.value : 1),
                      .lower = wall,
                      .upper = lid,
                      .periodic = periodic,
                      .upper_slips = one.flow == "stokes_first",
                      .theta = one.theta,
                      .courant = one.courant,
                      .walls_out = one.cause == Cause::walls ? one.value : 0,
                      .nodes = one.nodes && !periodic};
  const std::size_t n = code.size(across);
  std::vector<double> v(n, 0);
  if (periodic)
    for (std::size_t i = 0; i < n; ++i) v[i] = flow.start.velocity_at({0, code.place(across, i)}).x();
  else if (code.nodes)
    v.front() = wall, v.back() = one.flow == "couette" ? lid : 0;
  const double h = flow.across / across;
  const int columns = std::max(1, static_cast<int>(std::lround(flow.filled.size().x() / h)));
  std::vector<Samples> all;
  double now = 0;
  for (const double time : flow.judged.times) {
    const double until = time + (one.cause == Cause::lead ? one.value : 0);
    v = code.run(across, v, until - now);
    now = until;
    Samples s{.time = time};
    s.x = s.v = Vectors::Zero(2, static_cast<Eigen::Index>(n) * columns);
    s.mass = s.density = s.pressure = Scalars::Ones(s.size());
    for (Eigen::Index p = 0; p < s.size(); ++p) {
      const auto i = static_cast<std::size_t>(p / columns);
      s.x.col(p) =
          Vec2((static_cast<double>(p % columns) + 0.5) / columns * flow.filled.size().x(), code.place(across, i));
      s.v(0, p) = v[i];
    }
    all.push_back(std::move(s));
  }
  return all;
}

struct Found {
  int levels = 0, right = 0, offered = 0, inside = 0;
  std::vector<double> wide;  // half-widths over actual errors

  void operator+=(const Found& o) {
    levels += o.levels, right += o.right, offered += o.offered, inside += o.inside;
    wide.insert(wide.end(), o.wide.begin(), o.wide.end());
  }
};

double median(std::vector<double> all) {
  if (all.empty()) return 0;
  std::ranges::sort(all);
  return all[all.size() / 2];
}

std::string in_words(const Found& f) {
  return fmt::format(
      "{:4} levels: right cause {:.1f} %, truth inside {:.1f} % of {}, median half-width {:.2f} of the actual error",
      f.levels, 100. * f.right / std::max(1, f.levels), 100. * f.inside / std::max(1, f.offered), f.offered,
      median(f.wide));
}

Found found_of(const Case& one, bool verbose) {
  const Flow flow = flow_named(one.flow, Settings(settings.at(one.flow)));
  std::vector<std::vector<Samples>> runs;
  for (const int across : one.across) runs.push_back(run_of(one, flow, across));
  std::vector<Diagnosed> levels;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    levels.push_back({.samples = {}, .spacing = flow.across / one.across[k]});
    for (const Samples& s : runs[k]) levels.back().samples.push_back(&s);
  }
  Found found;
  const double unit = one.cause == Cause::viscosity || one.cause == Cause::force ? 0.01 : 1;
  const std::vector<Diagnosis> all = diagnose(flow.exact[0], levels, flow.domain);
  for (std::size_t k = 0; k < all.size(); ++k) {
    ++found.levels;
    bool right = false, inside = true;
    for (const Explanation& e : all[k].explanations)
      for (const FittedCause& c : e.causes)
        if (e.named && !right && c.cause == name_of(one.cause)) {
          right = true;
          ++found.offered;
          inside = std::abs(c.value - one.value / unit) <= c.half_width;
          found.inside += inside;
          found.wide.push_back(c.half_width / std::abs(c.value - one.value / unit));
        }
    found.right += right;
    if (verbose && !(right && inside))
      fmt::print("{} {} planted {:.4g}, {} of {} levels, theta {} courant {:.2f} {}: {}\n", one.flow,
                 name_of(one.cause), one.value / unit, one.across[k], one.across.size(), one.theta, one.courant,
                 one.nodes ? "nodes" : "cells", all[k].sentence);
  }
  return found;
}

TEST(GridCodes, AreToldWhatWasPlantedWithinAnInterval) {
  const char* many = std::getenv("TOUCHSTONE_GRIDS");
  const char* seed = std::getenv("TOUCHSTONE_SEED");
  const int count = many ? std::atoi(many) : 20;
  Generator random(seed ? static_cast<unsigned>(std::atoi(seed)) : 5);
  std::map<std::string, Found> parts;
  Found all;
  for (int k = 0; k < count; ++k) {
    const Case one = drawn(random);
    const Found found = found_of(one, std::getenv("TOUCHSTONE_PLANTS_VERBOSE") != nullptr);
    all += found, parts[one.flow] += found, parts[name_of(one.cause)] += found;
    parts[fmt::format("{} resolutions", one.across.size())] += found;
    parts[fmt::format("{}, {}", one.across.size() > 1 ? "several" : "one", one.flow)] += found;
  }
  if (many)
    for (const auto& [name, found] : parts) fmt::print("{:21} {}\n", name, in_words(found));
  if (many) fmt::print("{:21} {}\n", "all", in_words(all));
  EXPECT_GE(all.right, 0.95 * all.levels) << in_words(all);
  EXPECT_GE(all.inside, 0.9 * all.offered) << in_words(all);
  EXPECT_LE(median(all.wide), 3) << in_words(all);
}

}  // namespace grid_codes_test
}  // namespace touchstone::vnv::doors

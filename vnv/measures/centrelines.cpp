#include "vnv/measures/centrelines.hpp"

#include "solvers/quadratic_fit.hpp"
#include "vnv/files/tables.hpp"
#include "vnv/judge/norms.hpp"

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace touchstone::vnv {

namespace {

/// How much the middle of a fit leans on few rows, by the squares of its weights: 1 for the mean of all of them, 2 to 4
/// for a fit on a lattice, infinite for rows that do not tell six factors apart. Takes the sum over the rows of weight
/// times the products of two monomials.
double leaning_of(const Eigen::Matrix<double, 6, 6>& moments) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> of(moments);
  const double all = moments(0, 0);
  if (!(of.eigenvalues().minCoeff() > 1e-10 * all)) return INFINITY;
  return all * (of.eigenvectors().row(0).transpose().array().square() / of.eigenvalues().array()).sum();
}

struct LocalFit {
  double value;
  bool is_sound;
};

/// By the rows in the upright ellipse with these half axes [m].
LocalFit fitted_within(const Samples& samples, const ParticleField& field, const Vec2& place, const Vec2& reach) {
  using Fit = QuadraticFit<double, 1>;
  Fit::Sums sums{};
  Eigen::Matrix<double, 6, 6> moments = Eigen::Matrix<double, 6, 6>::Zero();
  for (Eigen::Index p = 0; p < samples.size(); ++p) {
    const Vec2 way = (samples.x.col(p) - place).cwiseQuotient(reach);
    const double left = 1 - way.squaredNorm();
    if (left <= 0) continue;
    const Fit::Sums terms = Fit::terms(left * left, way.x(), way.y(), {field(samples, p)});
    for (std::size_t s = 0; s < Fit::count; ++s) sums[s] += terms[s];
    const Eigen::Vector<double, 6> at{1, way.x(), way.y(), way.x() * way.x(), way.x() * way.y(), way.y() * way.y()};
    moments += left * left * at * at.transpose();
  }
  constexpr double most = 100;  // particles that mix lean by up to 20 or so
  return {Fit::of(sums)[0][0], leaning_of(moments) < most};
}

/// How far apart [m] rows are along x and along y, about the one that is closest to a place: on an upright grid, the
/// smaller of the gaps on its two sides.
Vec2 gaps_at(const Samples& samples, const Vec2& place) {
  Eigen::Index closest = 0;
  const auto away = [&](Eigen::Index p) { return (samples.x.col(p) - place).squaredNorm(); };
  for (Eigen::Index p = 1; p < samples.size(); ++p)
    if (away(p) < away(closest)) closest = p;
  Vec2 gaps = Vec2::Constant(INFINITY);
  for (Eigen::Index p = 0; p < samples.size(); ++p) {
    const Vec2 way = (samples.x.col(p) - samples.x.col(closest)).cwiseAbs();
    if (way.x() > way.y()) gaps.x() = std::min(gaps.x(), way.x());
    if (way.y() > way.x()) gaps.y() = std::min(gaps.y(), way.y());
  }
  return gaps;
}

}  // namespace

double fitted_at(const Samples& samples, const ParticleField& field, const Vec2& place, double reach) {
  const LocalFit round = fitted_within(samples, field, place, Vec2::Constant(reach));
  if (round.is_sound) return round.value;
  const Vec2 gaps = gaps_at(samples, place);
  for (const double many : {2.5, 3.0, 3.5, 4.0, 5.0, 6.0}) {
    const LocalFit stretched = fitted_within(samples, field, place, many * gaps);
    if (stretched.is_sound) return stretched.value;
  }
  return not_a_number;
}

Quantity norm_of(std::string_view norm, Centreline::Direction direction) {
  return {fmt::format("{} {}", norm,
                      direction == Centreline::vertical ? "v_x, vertical centreline" : "v_y, horizontal centreline"),
          "%", Kind::norm};
}

Centreline ghia_centreline(const std::filesystem::path& data, Centreline::Direction direction, int Re) {
  const bool is_vertical = direction == Centreline::vertical;
  const std::string at = is_vertical ? "y [-]" : "x [-]", velocity = is_vertical ? "u [-]" : "v [-]";
  const DataTable table =
      read_table(data / "papers" /
                 (is_vertical ? "ghia_1982_vertical_centreline.csv" : "ghia_1982_horizontal_centreline.csv"))
          .only("Re", std::to_string(Re))
          .only("entry", "sound");
  Centreline line{direction, {}, {}};
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const double place = table.numbers(at)[k];
    if (place == 0 || place == 1) continue;  // held by the wall
    line.at.push_back(place);
    line.velocity.push_back(table.numbers(velocity)[k]);
  }
  return line;
}

double Cavity::velocity_at(const Samples& samples, Centreline::Direction direction, double at, double spacing) const {
  const bool is_vertical = direction == Centreline::vertical;
  const Vec2 place = side * (is_vertical ? Vec2(0.5, at) : Vec2(at, 0.5));
  return fitted_at(samples, is_vertical ? velocity_x : velocity_y, place, 2.5 * spacing) / lid_speed;
}

double Cavity::mean_velocity_at(const Run& run, Centreline::Direction direction, double at, double spacing) const {
  const double first = run.samples.back().time - span * (1 + 1e-9);
  double sum = 0;
  int count = 0;
  for (const Samples& samples : run.samples) {
    if (samples.time < first) continue;
    sum += velocity_at(samples, direction, at, spacing);
    ++count;
  }
  return sum / count;
}

std::vector<Value> Cavity::compare(const Level& level, const Run& run, const Centreline& line) const {
  if (!run.summary.finished) return {};
  // Norms are relative to the truth: with one that is the lid's speed everywhere they are relative to it.
  const std::vector<double> lid(line.at.size(), 1), equal = lid;
  std::vector<double> found;
  for (std::size_t k = 0; k < lid.size(); ++k)
    found.push_back(mean_velocity_at(run, line.direction, line.at[k], level.spacing) + lid[k] - line.velocity[k]);
  const auto error = [&](const char* norm, double value) {
    return Value{level.name, level.spacing, run.summary.end_time, norm_of(norm, line.direction), 100 * value};
  };
  return {error("L2", relative_l2(found, lid, equal)), error("Linf", relative_linf(found, lid))};
}

}  // namespace touchstone::vnv

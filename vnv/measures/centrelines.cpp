#include "vnv/measures/centrelines.hpp"

#include "solvers/quadratic_fit.hpp"
#include "vnv/files/tables.hpp"
#include "vnv/judge/norms.hpp"

#include <fmt/format.h>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <optional>

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

namespace {

std::string velocity_on(Centreline::Direction direction) {
  return direction == Centreline::vertical ? "u [-]" : "v [-]";
}

DataTable table_of_ghia(const std::filesystem::path& data, Centreline::Direction direction, int Re) {
  return read_table(data / "papers" /
                    (direction == Centreline::vertical ? "ghia_1982_vertical_centreline.csv"
                                                       : "ghia_1982_horizontal_centreline.csv"))
      .only("Re", std::to_string(Re));
}

/// Its rows between the walls, which hold the fluid beside them.
Centreline between_walls(const DataTable& table, Centreline::Direction direction) {
  Centreline line{direction, {}, {}};
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const double place = table.numbers(direction == Centreline::vertical ? "y [-]" : "x [-]")[k];
    if (place == 0 || place == 1) continue;
    line.at.push_back(place);
    line.velocity.push_back(table.numbers(velocity_on(direction))[k]);
  }
  return line;
}

}  // namespace

Centreline ghia_centreline(const std::filesystem::path& data, Centreline::Direction direction, int Re) {
  return between_walls(table_of_ghia(data, direction, Re).only("entry", "sound"), direction);
}

ConvergedProfile::ConvergedProfile(const std::filesystem::path& data, Centreline::Direction direction, int Re) {
  const DataTable table = read_table(data / "computed" / "cavity_profiles.csv").only("Re", std::to_string(Re));
  at_ = table.numbers("s [-]"), velocity_ = table.numbers(velocity_on(direction));
  const auto of = fmt::format("{}.{}", velocity_on(direction)[0], Re);
  const auto half_width = table.provenance().uncertainty.find(of);
  if (half_width == table.provenance().uncertainty.end())
    throw BadData(table.file(), 0, fmt::format("no uncertainty '{}'", of));
  half_width_ = half_width->second.value;
}

double ConvergedProfile::operator()(double at) const {
  double sum = 0, weights = 0;
  for (std::size_t k = 0; k < at_.size(); ++k) {
    if (at == at_[k]) return velocity_[k];
    const double weight = (k % 2 ? -1 : 1) * (k == 0 || k + 1 == at_.size() ? 0.5 : 1) / (at - at_[k]);
    sum += weight * velocity_[k];
    weights += weight;
  }
  return sum / weights;
}

Centreline converged_centreline(const std::filesystem::path& data, Centreline::Direction direction, int Re) {
  Centreline line = between_walls(table_of_ghia(data, direction, Re), direction);
  const ConvergedProfile profile(data, direction, Re);
  std::ranges::transform(line.at, line.velocity.begin(), profile);
  return line;
}

const std::array<Extremum, 3>& extrema() {
  static const std::array<Extremum, 3> all{{{"smallest v_x", Centreline::vertical, -1},
                                            {"largest v_y", Centreline::horizontal, 1},
                                            {"smallest v_y", Centreline::horizontal, -1}}};
  return all;
}

Peak peak_of(const std::function<double(double at)>& profile, const Extremum& which, double nearest) {
  constexpr int parts = 200, coarse = 4;
  const int first = std::max(1, static_cast<int>(std::ceil(nearest * parts - 1e-9))), last = parts - first;
  std::array<std::optional<double>, parts + 1> known;
  bool is_number = true;
  const auto height = [&](int k) {
    if (!known[k]) known[k] = which.sign * profile(1.0 * k / parts);
    is_number &= !std::isnan(*known[k]);
    return *known[k];
  };
  const auto best_of = [&](int from, int to, int step) {
    int best = from;
    for (int k = from; k <= to; k += step)
      if (height(k) > height(best)) best = k;
    return best;
  };
  const int near = best_of(first, last, coarse),
            best = best_of(std::max(near - coarse, first), std::min(near + coarse, last), 1);
  const double before = height(best - 1), after = height(best + 1), bend = before - 2 * height(best) + after,
               off = bend < 0 ? std::clamp((before - after) / (2 * bend), -1.0, 1.0) : 0;
  if (!is_number) return {not_a_number, not_a_number};
  return {which.sign * (height(best) - (before - after) * off / 4), (best + off) / parts};
}

Peak converged_peak(const std::filesystem::path& data, const Extremum& which, int Re) {
  const DataTable row =
      read_table(data / "computed" / "cavity_extrema.csv").only("Re", std::to_string(Re)).only("quantity", which.name);
  return {row.numbers("value [-]").front(), row.numbers("at [-]").front()};
}

Quantity error_of(const Extremum& which) {
  return {fmt::format("error of the {}, {} centreline", which.name,
                      which.direction == Centreline::vertical ? "vertical" : "horizontal"),
          "%", Kind::error};
}
Quantity shift_of(const Extremum& which) {
  return {fmt::format("shift of the {}, {} centreline", which.name,
                      which.direction == Centreline::vertical ? "vertical" : "horizontal"),
          "%", Kind::error};
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

std::vector<Value> Cavity::compare(const Level& level, const Run& run, const Extremum& which, const Peak& exact) const {
  if (!run.summary.finished) return {};
  // Nearer to a wall a fit of second degree has too few rows; no peak is.
  const double nearest = std::clamp(1.5 * level.spacing / side, 0.02, 0.08);
  const Peak found =
      peak_of([&](double at) { return mean_velocity_at(run, which.direction, at, level.spacing); }, which, nearest);
  const auto off = [&](const Quantity& quantity, double by) {
    return Value{level.name, level.spacing, run.summary.end_time, quantity, 100 * std::abs(by)};
  };
  return {off(error_of(which), found.velocity - exact.velocity), off(shift_of(which), found.at - exact.at)};
}

}  // namespace touchstone::vnv

#include "vnv/measures/centrelines.hpp"

#include "solvers/quadratic_fit.hpp"
#include "vnv/files/tables.hpp"
#include "vnv/judge/norms.hpp"

#include <fmt/format.h>

namespace touchstone::vnv {

double fitted_at(const Samples& samples, const Field& field, const Vec2& place, double reach) {
  using Fit = QuadraticFit<double, 1>;
  Fit::Sums sums{};
  for (Eigen::Index p = 0; p < samples.size(); ++p) {
    const Vec2 way = (samples.x.col(p) - place) / reach;
    const double left = 1 - way.squaredNorm();
    if (left <= 0) continue;
    const Fit::Sums terms = Fit::terms(left * left, way.x(), way.y(), {field(samples, p)});
    for (std::size_t s = 0; s < Fit::count; ++s) sums[s] += terms[s];
  }
  return Fit::of(sums)[0][0];
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
      read_table(
          data / "papers" / (is_vertical ? "ghia_1982_vertical_centreline.csv" : "ghia_1982_horizontal_centreline.csv"),
          {"Re", at, velocity, "entry"})
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

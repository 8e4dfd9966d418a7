#include "solvers/lattice.hpp"
#include "vnv/doors/judge.hpp"
#include "vnv/doors/testing.hpp"
#include "vnv/files/tables.hpp"
#include "vnv/flows/dam_break.hpp"
#include "vnv/flows/gravity_wave.hpp"
#include "vnv/measures/centrelines.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace touchstone::vnv::doors {
namespace wrong_solvers_test {

/// The state of a flow at a time on a lattice with so many across: what a solver answers.
using Answer = std::function<Samples(const Flow&, double across, double t)>;

double parameter(const Flow& flow, const std::string& name) {
  return std::ranges::find(flow.parameters, name, &Parameter::name)->value;
}

/// Rows at the start, at a time, with what is exact of their fields where that is known in full.
Samples with_exact_fields(const Flow& flow, const Vectors& places, double volume, double t) {
  Samples s{.time = t, .x = places};
  s.v = Vectors::Zero(2, s.x.cols());
  s.pressure = Scalars::Zero(s.size());
  s.density = Scalars::Constant(s.size(), flow.fluid.density);
  s.mass = s.density * volume;
  set_exact_fields(flow, s);
  return s;
}

/// The front of the experiment by Lobovský et al., a little ahead as those of our own methods, at T.
double front_at_scaled(double T) {
  static const DataTable table = read_table(data_folder() / "experiments" / "lobovsky_2014_front_600.csv",
                                            {"T [-]", "L [-]", "t [s]", "x_gate [m]", "at_wall [-]"});
  static const FrontHistory front{table.numbers("T [-]"), table.numbers("L [-]")};
  const double within = std::clamp(T, front.T.front(), front.T.back());
  return std::min(2.683, front_at(front, within) + std::min(0.08, T / 10));
}

/// What is linear between the places of a centreline, from the wall at rest to `last` at the other end.
class Along {
 public:
  Along(Centreline::Direction direction, double last) {
    const Centreline line = ghia_centreline(data_folder(), direction, 100);
    for (std::size_t k = 0; k < line.at.size(); ++k) values_[line.at[k]] = line.velocity[k];
    values_[0] = 0, values_[1] = last;
  }
  double operator()(double at) const {
    const auto after = values_.lower_bound(at);
    if (after == values_.begin()) return after->second;
    const auto before = std::prev(after);
    return std::lerp(before->second, after->second, (at - before->first) / (after->first - before->first));
  }

 private:
  std::map<double, double> values_{};
};

/// Of a rotating patch at the start, by its places: its series is slow beside the sides.
const Scalars& first_pressure(const Flow& flow, const Vectors& places) {
  static std::map<Eigen::Index, Scalars> known;
  Scalars& found = known[places.cols()];
  if (found.size() == 0) {
    found.resize(places.cols());
    for (Eigen::Index p = 0; p < places.cols(); ++p) found[p] = flow.start.pressure_at(places.col(p));
  }
  return found;
}

Samples right_of(const Flow& flow, double across, double t) {
  const Lattice regular = lattice(flow.filled, flow.across / across);
  const Vectors start = flow.start.places_on(regular.places());
  const double second_order = 1 + 0.5 / (across * across);
  Samples s = with_exact_fields(flow, start, regular.volume(), t);
  if (flow.name == "cavity") {
    static const Along u(Centreline::vertical, 1), v(Centreline::horizontal, 0);
    for (Eigen::Index p = 0; p < s.size(); ++p) s.v.col(p) = Vec2(u(s.x(1, p)), v(s.x(0, p)));
  } else if (flow.name == "standing_wave") {
    gravity_wave::Wave wave;
    wave.g = parameter(flow, "g");
    wave.a *= std::cos(wave.exact().omega() * t) * std::exp(-wave.exact().decay_rate() * t);
    const Vectors at_rest = regular.places();
    s.x = wave.heaped(at_rest);
    for (Eigen::Index p = 0; p < s.size(); ++p) s.pressure[p] = 1000 * wave.g * (wave.depth - at_rest(1, p));
  } else if (flow.name == "elliptic_drop") {
    const auto now = reference::EllipticDrop{.R = parameter(flow, "R"), .s0 = parameter(flow, "s"), .rho = 1000}.at(t);
    s.x = start.array().colwise() * Eigen::Array2d(now.a, now.b) / parameter(flow, "R");
    for (Eigen::Index p = 0; p < s.size(); ++p) {
      s.v.col(p) = now.s * Vec2(s.x(0, p), -s.x(1, p));
      s.pressure[p] = std::max(0.0, now.p(s.x(0, p), s.x(1, p)));
    }
  } else if (flow.name == "rotating_patch") {
    const double turn = parameter(flow, "omega") * t, stretch = std::sqrt(1 + turn * turn) - 1,
                 corner = parameter(flow, "L") / std::numbers::sqrt2;
    const Mat2 turned = Eigen::Rotation2Dd(-std::atan(turn)).toRotationMatrix();
    for (Eigen::Index p = 0; p < s.size(); ++p) {  // corners on their free paths, and the middle as it was
      const Vec2 x = start.col(p);
      s.x.col(p) = (1 + stretch * std::pow(x.norm() / corner, 4)) * (turned * x);
    }
    s.pressure = first_pressure(flow, start) / (1 + turn * turn);
    const double at_start = start.squaredNorm(), now = s.x.squaredNorm(), omega = parameter(flow, "omega"),
                 turning = omega * at_start / now,  // keeps the angular momentum, and what spreads the energy
        spreading = std::sqrt(std::max(0.0, omega * omega * at_start / now - turning * turning));
    for (Eigen::Index p = 0; p < s.size(); ++p)
      s.v.col(p) = turning * Vec2(s.x(1, p), -s.x(0, p)) + spreading * s.x.col(p);
  } else if (flow.name == "dam_break") {
    const double g = parameter(flow, "g"), h0 = parameter(flow, "h0"), l0 = parameter(flow, "l0"),
                 front = front_at_scaled(t * std::sqrt(g * h0) / l0);
    s.x.row(0) *= front, s.x.row(1) /= front;  // a block that keeps its area
    for (Eigen::Index p = 0; p < s.size(); ++p) s.pressure[p] = 1000 * g * (h0 / front - s.x(1, p));
  }
  s.v *= second_order, s.pressure *= second_order;
  return s;
}

struct Asked {
  std::vector<double> across, times;
};
Asked asked_of(const Flow& flow) {
  const auto every = [](double step, double end) {
    std::vector<double> times;
    for (int k = 0; k * step <= end * (1 + 1e-9); ++k) times.push_back(k * step);
    return times;
  };
  if (flow.name == "standing_wave") return {{40, 64, 104}, every(0.125, 4)};
  if (flow.name == "elliptic_drop") return {{12, 20, 30}, {0, 0.4, 0.8}};
  if (flow.name == "rotating_patch") return {{20, 40, 80}, {0, 0.5, 1}};
  if (flow.name == "dam_break") return {{15, 30, 45}, flow.judged.times};
  if (flow.name == "hydrostatic") return {{10, 20, 40}, {0, 0.5, 1, 2}};
  if (flow.name == "cavity") return {{24, 48, 96}, {12}};
  return {{10, 20, 40}, flow.judged.times};
}

/// The claims that an answer does not keep, without any option.
std::string complaints(const Flow& judged_by, const Answer& answer) {
  const auto [across, times] = asked_of(judged_by);
  Given given;
  given.fields = {"particles", "velocity", velocity_along_x, "pressure", "mass", "density"};
  for (const double n : across) {
    GivenLevel& level = given.levels.emplace_back(GivenLevel{.spacing = judged_by.across / n});
    for (const double t : times) {
      Samples s = answer(judged_by, n, t);
      s.time = t;
      level.at.emplace(t, std::move(s));
    }
  }
  std::string all;
  const Record record = judge_given(judged_by, std::move(given), {}).record;
  for (const Verdict& v : record.verdicts)
    if (v.outcome != Outcome::holds) all += v.sentence + "\n";
  return all;
}

Flow with(const Flow& flow, const std::string& name, double factor) {
  std::map<std::string, double> set;
  for (const Parameter& p : flow.parameters) set[p.name] = p.value * (p.name == name ? factor : 1);
  return flow_named(flow.name, Settings(set));
}

/// Solvers that must not pass, of a flow.
std::vector<std::pair<std::string, Answer>> wrong_of(const Flow& flow) {
  const bool has_free_surface = flow.has_free_surface(), is_at_rest = flow.name == "hydrostatic",
             is_channel = flow.is_uniform_along_x, is_steady = flow.name == "cavity";
  const bool has_pressure =
      is_at_rest || has_free_surface || flow.name == "taylor_green" || flow.name == "manufactured";
  std::vector<std::pair<std::string, Answer>> all;
  const auto changed = [&](const std::string& name, const std::function<void(Samples&)>& change) {
    all.emplace_back(name, [=](const Flow& f, double n, double t) {
      Samples s = right_of(f, n, t);
      change(s);
      return s;
    });
  };
  if (is_steady)
    changed("at rest", [](Samples& s) { s.v.setZero(); });
  else if (!is_at_rest)
    all.emplace_back("frozen at the start", [](const Flow& f, double n, double) { return right_of(f, n, 0); });
  if (has_free_surface && !is_at_rest)
    all.emplace_back("moving twice as fast", [](const Flow& f, double n, double t) {
      Samples s = right_of(f, n, 2 * t);
      s.v *= 2;
      return s;
    });
  else if (!is_at_rest)
    changed("moving twice as fast", [](Samples& s) { s.v *= 2; });
  if (flow.name == "rotating_patch" || flow.name == "elliptic_drop")
    changed("with twice its velocity", [](Samples& s) { s.v *= 2; });
  for (const char* force : {"F", "g"})
    if (std::ranges::find(flow.parameters, force, &Parameter::name) != flow.parameters.end())
      for (const double factor : {0.6, 1.2})
        all.emplace_back(fmt::format("{} times {}", factor, force),
                         [=](const Flow& f, double n, double t) { return right_of(with(f, force, factor), n, t); });
  if (has_pressure) {
    changed("without pressure", [](Samples& s) { s.pressure.setZero(); });
    changed("with a reversed pressure", [](Samples& s) { s.pressure *= -1; });
  }
  if (!is_at_rest && flow.name != "standing_wave" && flow.name != "dam_break")  // whose velocity nothing judges
    changed("with half its velocity across it", [](Samples& s) { s.v.row(1) = s.v.row(0) / 2; });
  if (is_at_rest) changed("moving", [](Samples& s) { s.v.setConstant(1); });
  if (is_channel)
    all.emplace_back("with walls 5 % of the gap out", [](const Flow& f, double n, double t) {
      Changes by;
      by(Cause::floor) = 0.05 * f.across;
      Samples s = right_of(f, n, t);
      const FieldTruth moved = f.exact[0].with(by);
      for (Eigen::Index p = 0; p < s.size(); ++p) s.v.col(p) = moved(s.x.col(p), t);
      return s;
    });
  if (is_channel || flow.name == "standing_wave" || flow.name == "rotating_patch" || flow.name == "elliptic_drop" ||
      flow.name == "taylor_green" || flow.name == "shear_wave" || flow.name == "manufactured")
    all.emplace_back("with time 10 % late", [](const Flow& f, double n, double t) { return right_of(f, n, 0.9 * t); });
  if (flow.name == "dam_break")
    changed("running backwards", [](Samples& s) {
      const double front = s.x.row(0).maxCoeff() / 0.6;
      s.x.row(0) /= front * front, s.x.row(1) *= std::min(front * front, 1.9);
    });
  return all;
}

class WrongSolvers : public testing::TestWithParam<std::string> {};

TEST_P(WrongSolvers, DoNotPassAndTheRightOneDoes) {
  const Flow flow = flow_named(GetParam());
  EXPECT_EQ(complaints(flow, right_of), "") << "right";
  for (const auto& [name, answer] : wrong_of(flow)) EXPECT_NE(complaints(flow, answer), "") << name;
}

INSTANTIATE_TEST_SUITE_P(OfEachFlow, WrongSolvers, testing::ValuesIn(flow_names()),
                         [](const auto& one) { return one.param; });

}  // namespace wrong_solvers_test
}  // namespace touchstone::vnv::doors

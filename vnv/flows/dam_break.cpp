/// A column of water that collapses in a tank [Sun et al., section 3.3].

#include "vnv/flows/dam_break.hpp"
#include "vnv/measures/decay.hpp"
#include "vnv/measures/motion.hpp"
#include "vnv/measures/roughness.hpp"

#include <functional>

namespace touchstone::vnv::flows {
namespace {

const Quantity mass_over_time{"relative change of the mass since the first time", "", Kind::invariant},
    energy{"kinetic and potential energy over that at the start"};

}  // namespace

Flow dam_break(Settings& set) {
  using namespace vnv::dam_break;
  const double l0 = set.positive("l0", column.x(), "m", "length of the column");
  const double h0 = set.positive("h0", column.y(), "m", "height of the column");
  const double H = set.positive("H", tank.y(), "m", "height of the domain");
  const double L = set.positive("L", tank.x(), "m", "length of the tank");
  const double g = set.positive("g", vnv::dam_break::g, "m/s²", "gravity, down");
  const Newtonian fluid = fluid_of(set, water.density, water.sound_speed(), "without pressure");
  const double rho = fluid.density;
  const DamFront dam{.column_length = l0,
                     .column_height = h0,
                     .tank_length = L,
                     .tank_height = H,
                     .density = rho,
                     .gravity = g,
                     .slab = l0 / 30};
  const bool is_published = Vec2(l0, h0) == column && Vec2(L, H) == tank;     // those of Lobovský et al.
  const double scale = dam_break::front.scaled_time(1) / dam.scaled_time(1);  // of times
  Flow flow;
  const auto scene = collapse({l0, h0}, {L, H}, fluid, g);
  flow.domain = scene.domain;
  flow.fluid = scene.fluid;
  flow.filled = scene.filled;
  flow.walls = scene.walls;
  flow.drive.amplitude = scene.body_force.per_mass;
  flow.across = l0;
  flow.judged.title = "Dam break";
  flow.judged.description =
      "A column of water at the left end of a tank collapses under gravity from t = 0; L = l / l0 and T = t sqrt(g h0) "
      "/ l0. The oracles are the experiments with columns of the same aspect ratio: Lobovský et al. (2014), h0 = l0 "
      "and l0 / 2, Martin & Moyce (1952), h0 = l0 and 2 l0, Koshizuka & Oka (1995), h0 = 2 l0; and Ritter's bound "
      "dL/dT = 2. The position of a front depends on its definition: five definitions are used.";
  flow.judged.times = {0.32 * scale, 0.41 * scale, 0.46 * scale, 0.5 * scale};
  flow.judged.monitor = monitored(dam);
  flow.judged.monitor.interval *= scale;
  if (is_published)
    flow.judged.plots = {[](const Results&, Record& record) { record.diagrams.push_back(vnv::dam_break::work); }};
  flow.judged.claims = {
      between(mass_over_time, -1e-6, 1e-6, theory("masses are constant; files in single precision")),
      between(dam.lost, 0, 0, theory("water does not cross walls")),
      at_least(dam.least_lead, 0,
               literature("the time origin of such an experiment is uncertain by 0.3 in T (Martin & Moyce 1952)"))};
  const Quantity mean{"mean pressure over rho g h0 / 2"};
  flow.aside = {between(mean, 0.1, 1.5, theory("the pressure carries the weight of the water, and moves it")),
                moves_by_its_velocity(),
                at_most(energy, 1.05, theory("nothing drives the water but its weight"))};
  for (const char* experiment : {"Lobovský et al. 2014", "Koshizuka & Oka 1995"})
    flow.of_resolved.push_back(at_most(
        dam.rms_of(dam.of_thin_slab, experiment), 0.17,
        literature("the experiments of two authors with the same column differ by this much, one by Martin & Moyce "
                   "(1952)")));
  const auto near_experiment = [dam](double limit) {
    return at_most(
        dam.largest_error, limit,
        literature("two experiments with the same column differ by 0.17, and fronts of our own methods by up to "
                   "0.1 from that of the gate; a slab of two spacings ends 1.5 of them earlier or later"));
  };
  flow.of_resolved.push_back(near_experiment(0.22));
  flow.of_coarse = [=](double across) { return std::vector{near_experiment(0.17 + 1.5 / across)}; };
  flow.resolved = 30;
  /// Their mass, or their number: cells and nodes have none to lose.
  const auto kept = [dam](bool is_number) -> Measurement {
    return [=](const Level& level, const Run& run) {
      std::vector<Value> found = dam.kept(level, run);
      std::erase_if(found, [&](const Value& value) { return (value.quantity == dam.lost) != is_number; });
      if (!is_number)
        found.push_back({level.name, level.spacing, run.summary.end_time, mass_over_time,
                         run.samples.back().mass.sum() / run.samples.front().mass.sum() - 1});
      return found;
    };
  };
  constexpr Span at_any_times{INFINITY, 0, 1};
  flow.measured = {
      {{}, [dam](const Level& level, const Run& run) { return dam.positions(level, run.samples.back()); }},
      {{}, kept(false), Span{0, 0, 2}, "mass"},
      {{"particles"}, kept(true), Span{0, 0, 2}, "the number of particles"},
      {{"velocity"},
       part_of_motion({.of = [](const Vec2& x) { return x.x(); }, .slope = [](const Vec2&) { return Vec2(1, 0); }}),
       Span{INFINITY, 0, 2},
       "the motion of the water"},
      {{"velocity"},
       of_each_sample(energy,
                      [=](const Samples& s) {
                        const double falls = g * (s.mass * s.x.row(1).transpose().array()).sum();
                        return (kinetic_energy(s) + falls) / (s.mass.sum() * g * h0 / 2);
                      })},
      {{}, std::bind_front(&DamFront::lead, dam), at_any_times, "the lead of the front"},
      {{}, std::bind_front(&DamFront::off, dam), at_any_times, "the error of the front"},
      {{},
       [=](const Level& level, const Run& run) {
         std::vector<Value> found = dam.against_experiments(level, run);
         if (is_published) std::ranges::copy(dam.against_lobovsky(level, run), std::back_inserter(found));
         return found;
       },
       Span{0.5 * scale, 0.5 * scale, 20},
       "the front"},
      {{"pressure"}, roughness_of("pressure", vnv::pressure, "rho g h0", rho * g * h0)},
      {{"pressure"}, [dam, found = mean_pressure(mean, rho * g * h0 / 2)](const Level& level, const Run& run) {
         const bool has_begun = dam.scaled_time(run.samples.back().time) >= 1;  // without pressure
         return has_begun ? found(level, run) : std::vector<Value>{};
       }}};
  return flow;
}

}  // namespace touchstone::vnv::flows

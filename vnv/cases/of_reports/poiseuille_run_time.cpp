/// Work-precision diagram of start-up plane Poiseuille flow [Sun et al., section 3.1], at the paper's bulk modulus.

#include "vnv/bench/in_turn.hpp"
#include "vnv/bench/plain_musl.hpp"
#include "vnv/flows/channels/channel_run_time.hpp"
#include "vnv/record/record.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::channel;

namespace {

const WorkStudy study = [] {
  WorkStudy varied = start_up_study(1 * mm);
  varied.budget = 40;
  return varied;
}();

Claim price_at_most(double target, double seconds, Author author) {
  return at_most(price_of(study.diagram(), target), seconds, std::move(author));
}

std::vector<WorkPoint> elsewhere() {
  std::vector<WorkPoint> points = published_work("poiseuille");
  const std::vector<WorkPoint> peers = peers_in_poiseuille_flow();
  points.insert(points.end(), peers.begin(), peers.end());
  return points;
}

/// The cheapest reference loop for an error of 1 %: 12 cells across, one particle in each, steps of 70 us. It
/// takes 0.04 s where the goal of 0.03 s was set; relative to it, on the same machine, the goal is three quarters.
const Quantity beside_plain_loop{"CPU time to 1 % over that of the reference loop", "", Kind::cost};
std::vector<Value> price_beside_a_plain_loop(const Results& results, const Record& record) {
  if (results.method.name != "mpm") return {};
  const auto scene = scene_of<Newtonian, Uniform>(flow_named("poiseuille"));
  const auto to_one_second = [&] {
    bench::PlainMusl loop(bench::plain(scene), H / 12, H / 12, 70 * us);
    for (long step = 0; step < std::lround(1 / (70 * us)); ++step) loop.step();
  };
  const double plain = bench::time_in_turn({to_one_second}, {.seconds = 0}).of(0);
  for (const Value& found : prices(study.diagram(), study.times)(results, record))
    if (found.quantity == price_of(study.diagram(), 1))
      return {{"", not_a_number, 1, beside_plain_loop, found.value / plain}};
  return {};
}

}  // namespace

Case vnv::the_case() {
  const Claim as_m1 = price_at_most(3, 92, literature("Sun et al., table 3, M1: 200000 steps of 0.46 ms for 3.34 %")),
              as_s1 = price_at_most(3, 1006, literature("Sun et al., table 3, S1: 200000 steps of 5.03 ms for 4.39 %"));
  Case declared = error_against_run_time_in<Uniform>(
      "Poiseuille flow: work-precision diagram",
      "The start-up of plane Poiseuille flow from rest to 1 s, at the paper's bulk modulus: each method is run over "
      "resolutions, points per cell or smoothing lengths, and time steps up to beyond the largest stable one. Methods "
      "are compared by the cost of a given error, the larger of those at 0.1 and 1 s: at 1 s the profile is a "
      "parabola, which fits of second degree represent exactly.",
      flow_named("poiseuille"), study, elsewhere(),
      {{"mpm", {as_m1, at_most(beside_plain_loop, 0.75, baseline("goal: 0.03 s where a plain loop takes 0.04 s"))}},
       {"sph_difference", {as_s1}},
       {"sph_regularised", {as_s1, price_at_most(1, 2, baseline("goal: the best of other codes takes 83 s"))}}});
  declared.findings.push_back(price_beside_a_plain_loop);
  return declared;
}

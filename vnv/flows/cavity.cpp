/// A square box whose lid slides over the fluid in it [Ghia, Ghia & Shin 1982; Botella & Peyret 1998].

#include "solvers/walls/no_slip.hpp"
#include "vnv/flows/lid_driven.hpp"
#include "vnv/judge/norms.hpp"
#include "vnv/measures/steadiness.hpp"

#include <fmt/format.h>

namespace touchstone::vnv::flows {

Flow cavity(Settings& set) {
  using namespace lid_driven;
  const double L = set.positive("L", lid_driven::cavity.side, "m", "side of the box");
  const double V = set.positive("V", lid_driven::cavity.lid_speed, "m/s", "velocity of the lid from t = 0 on");
  Flow flow;
  flow.fluid = fluid_of(set, 1000, 5, "at rest");
  const double Re = set.positive("Re", tabulated[0].Re, "-", "Reynolds number V L / nu: 100, 400 or 1000");
  const auto* const known = std::ranges::find(tabulated, Re, &Tabulated::Re);
  if (known == tabulated.end()) throw std::invalid_argument(fmt::format("Re = {:g}, expected 100, 400 or 1000", Re));
  const Cavity box{.side = L, .lid_speed = V, .span = steady_for * L / V};
  const double end = known->end * L / V, last = box.span;  // s
  flow.filled = {.high = {L, L}};
  flow.domain = {.box = flow.filled};
  flow.fluid.viscosity = flow.fluid.density * V * L / Re;
  // Where walls meet the last one holds: the lid reaches from wall to wall.
  flow.walls = {floor_at(0, no_slip()), left_at(0, no_slip()), right_at(L, no_slip()), ceiling_at(L, no_slip({V, 0}))};
  flow.across = L;
  flow.judged.title = "Lid-driven cavity";
  flow.judged.description =
      "The lid of a square box slides from t = 0, at full speed over its whole length. When the flow is steady, "
      "velocities on both centrelines, averaged over the last 5 L / V, and from 50 across on their extrema are compared with those of the "
      "steady flow, computed to 1e-5 of the lid's speed by Chebyshev collocation (Botella & Peyret 1998). Profiles are "
      "compared at the places in the tables of Ghia, Ghia & Shin (1982), which are themselves up to 1 % of the lid's "
      "speed off.";
  for (const int before : {5, 4, 3, 2, 1, 0}) flow.judged.times.push_back(end - before * last / 5);
  flow.judged.monitor = kinetic_energy_every(output_interval * L / V);
  flow.judged.plots = {lid_driven::work()};
  flow.of_resolved = within(2, converged);
  // A peak is one point of a profile: half as much again. Where it is, a flat one hardly says.
  std::ranges::copy(peaks_within(3, 2, converged), std::back_inserter(flow.of_resolved));
  flow.resolved = 100;
  flow.of_coarse = [](double across) {  // as fine as 2 % at 100 across, with room for first order with twice that error
    return within(
        std::max(2.0, 150 / across),
        literature("Botella & Peyret 1998; Marchi, Suero & Araki 2009; our own methods are up to 5.9 % off at 24 "
                   "across"));
  };
  const Quantity fastest{"largest speed over that of the lid"};
  flow.aside = {at_most(fastest, 2, theory("nothing drives a fluid faster than the lid; twice that is no overshoot"))};
  flow.measured = {{{"velocity"},
                    of_run(fastest,
                           [=](const Run& run) {
                             double largest = 0;
                             for (const Samples& s : run.samples)
                               largest = norms::larger_magnitude(largest, s.v.colwise().norm().maxCoeff());
                             return largest / V;
                           }),
                    Span{INFINITY, 0, 1},
                    "the speed"},
                   {{"velocity"},
                    [=](const Level& level, const Run& run) { return against_converged(level, run, box, known->Re); },
                    Span{INFINITY, end, 1},
                    "the steady flow"},
                   {{"velocity"},
                    [=](const Level&, const Run& run) { return unsteadiness_of(run, 0, last); },
                    Span{end - last, end, 2, true},
                    "how steady the flow is"}};
  return flow;
}

}  // namespace touchstone::vnv::flows

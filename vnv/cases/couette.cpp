/// Start-up of plane Couette flow [Sun et al., section 3.2]. Water at rest between two plates, of which the upper one
/// slides at a constant velocity from t = 0; at 1 s the profile is the straight line to four digits.

#include "reference/couette.hpp"
#include "solvers/walls/no_slip.hpp"
#include "vnv/flows/channel.hpp"

#include <cmath>

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::channel;

namespace {

constexpr double V = 0.1 * mm;  // m/s

const Scene<Newtonian> scene{
    .domain = {.box = gap, .periodic_x = true},
    .fluid = water,
    .filled = gap,
    .walls = {floor_at(0, no_slip()), ceiling_at(H, no_slip({V, 0}))},
};

const reference::Couette exact{.H = H, .V = V, .nu = water.kinematic_viscosity()};

/// L2 [%] of steady flow whose rows of particles are alternately too fast and too slow, by as much as the flow gains
/// over half a cell: what a reset wall leaves with one particle per cell (see mpm::VelocityReset).
const double alternating = 100 * std::sqrt(3) * (H / 40) / (2 * H);

/// Mean velocity of the rows within a fortieth of the gap around the middle.
double middle_velocity(const Samples& samples) {
  double sum = 0, count = 0;
  for (Eigen::Index p = 0; p < samples.size(); ++p)
    if (std::abs(samples.x(1, p) - H / 2) < H / 40) {
      sum += samples.v(0, p);
      ++count;
    }
  return sum / count;
}

}  // namespace

Case vnv::the_case() {
  Case declared = {
      .title = "Start-up of plane Couette flow",
      .description =
          "Water at rest between two plates 1 mm apart, the upper of which slides at 0.1 mm/s from t = 0. The "
          "oracle is the exact series of Morris, Fox & Zhu (1997), by Fourier terms late and by images early.",
      .times = {0.05, 0.1, 0.2, 1, 10},
      .watch = {.every = 0.02,
                .see = [](const Samples& s) { return std::vector{middle_velocity(s)}; },
                .quantities = {{"velocity in the middle", "m/s"}}},
      .measurements = {norms_of("v_x, row means", by_rows, exact), norms_of("v_x, per particle", by_particles, exact),
                       [](const Level& level, const Run& run) { return growth_of(level, run, exact); }},
      .claims = {},
      .methods =
          {{
               .name = "mpm",
               .description = mpm_words + moving_words,
               .run = mpm_with<mpm::PrescribedMotion>(scene),
               .levels = mpm_levels(1, 1),
               .ladders = mpm_ladders(),
               .claims =
                   {at_most(l2, 0.04, baseline("an independent prototype of the same scheme gave 0.03"))
                        .on("M2")
                        .at(0.1),
                    at_most(l2_rows, 0.40, literature("Sun et al., table 4, M2")).on("M2").at(1),
                    order_between(grid, l2, 1.8, 2.3, theory("linear hats, central quadrature: order 2")).at(0.1)},
           },
           {
               .name = "mpm_reset",
               .description = mpm_words + reset_words,
               .run = mpm_with<mpm::VelocityReset>(scene),
               .levels = mpm_levels(0, 1),
               .ladders = mpm_ladders(),
               .claims =
                   {between(
                        l2_rows, 0.99 * alternating, 1.01 * alternating,
                        theory("rows alternate by V cell / 2H, invisible to every node; table 4 gives 1.08 % for M1"))
                        .on("M1")
                        .at(1),
                    order_between(grid, linf, 0.8, 1.2,
                                  theory("a reset wall acts up to half a cell into the fluid: order 1 at the wall"))
                        .at(1),
                    between(l2_rows, 0.40 / 1.5, 0.40 * 1.5, literature("Sun et al., table 4, M2, within 1.5"))
                        .on("M2")
                        .at(1)},
           },
           {
               .name = "mpm_unfelt",
               .description = mpm_words +
                              "Here the held node transmits no wall acceleration: particles next to a wall that starts "
                              "impulsively never feel it. Kept to show that the suite detects it.",
               .run = mpm_with<mpm::PrescribedVelocity>(scene),
               .levels =
                   {{.name = "M2", .spacing = H / 80, .cell = H / 40, .acceptance = 0.1, .report = 1, .nightly = 1}},
               .claims = {at_least(l2, 5, theory("the impulse of the wall is missing")).on("M2").at(0.1)},
           },
           {
               .name = "sph",
               .description = sph_printed_words + conservative_words,
               .run = channel::sph_as_printed(scene),
               .levels = printed_levels(0),
               .ladders = sph_ladders({"S1", "S2", "S3", "S4"}),
               .claims = {between(l2_rows, 1.35, 5,
                                  theory("an elastic particle lattice: above Sun et al., table 4, S1"))
                              .on("S1")
                              .at(1),
                          order_between(spacing_ladder, l2_rows, -0.6,
                                        0, theory("the error grows: the lattice is elastic at any spacing"))
                              .at(1)
                              .over(3)},
               .tolerance = stretched,
               .relative_cost = 100,
           },
           {
               .name = "sph_difference",
               .description = sph_printed_words + difference_words,
               .run = channel::sph_as_printed<sph::PressureDifference>(scene),
               .levels = difference_levels(),
               .ladders = sph_ladders({"S1", "S2"}),
               .claims = at_most_the_papers("4", {1.35, 0.68}, 'S'),
               .tolerance = stretched,
               .relative_cost = 30,
           },
           {
               .name = "sph_regularised",
               .description = sph_regularised_words,
               .run = sph_with_transport_velocity(scene),
               .levels = regularised_levels(),
               .ladders = sph_ladders({"S1", "S2", "S3"}),
               .claims = {at_most(l2, 0.2, baseline("the regularised method is required to stay within 0.2 %"))
                              .on("S1")
                              .at(1),
                          at_most(l2, 0.2, baseline("the same at 10 s")).on("S1").at(10),
                          at_most(growth, 1.25,
                                  theory("steady flow: no growth other than from particles passing each other"))
                              .on("S1")
                              .at(10)},
               .tolerance = stretched,
               .relative_cost = 40,
           }},
      .plots = {profiles({"profile",
                          "Velocity profiles",
                          "Row means at 3200 particles. Reproduces figure 8(b) of Sun et al.",
                          {"y [mm]", 1e3},
                          {"v_x [mm/s]", 1e3}},
                         by_rows, exact, H, {"M2", "S2"}),
                over_time({"history",
                           "Centreline velocity over time",
                           "Reproduces figure 8(a) of Sun et al.",
                           {"t [s]"},
                           {"v_x [mm/s]", 1e3}},
                          0, {"M2", "S1"}),
                exact_over_time(
                    "history", [](double t) { return exact(H / 2, t); }, 2)},
  };
  for (const Method& method : second_order_methods(
           scene,
           {order_at_least(ladder_across, l2, 1.9, 1.6, theory("fits and differences of second order")).at(0.1).over(5),
            a_share_of_the_papers(20, 1.08, "table 4, M1").on("M1"),
            a_share_of_the_papers(20, 0.40, "table 4, M2").on("M2")},
           {order_at_least(ladder_across, l2, 1.8, 1.5, theory("fits of second degree")).at(0.1).over(5),
            a_share_of_the_papers(10, 1.35, "table 4, S1").on("S1")}))
    declared.methods.push_back(method);
  return with_plots(std::move(declared), figures("couette", "9", "4"));
}

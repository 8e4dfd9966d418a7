/// Start-up of plane Poiseuille flow [Sun et al., section 3.1]. Water at rest between two plates is subject to a body
/// force along x from t = 0; at 1 s the profile is the steady parabola to four digits.

#include "reference/poiseuille.hpp"
#include "solvers/forces/uniform.hpp"
#include "solvers/walls/no_slip.hpp"
#include "vnv/flows/channel.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::channel;

namespace {

constexpr double F = 8 * mm;  // m/s²  table 1

const Scene<Newtonian, Uniform> scene{
    .domain = {.box = gap, .periodic_x = true},
    .fluid = water,
    .filled = gap,
    .walls = {floor_at(0, no_slip()), ceiling_at(H, no_slip())},
    .body_force = {{F, 0}},
};

const reference::Poiseuille exact{.H = H, .F = F, .nu = water.kinematic_viscosity()};

double largest_velocity(const Samples& samples) { return samples.v.row(0).maxCoeff(); }

}  // namespace

Case vnv::the_case() {
  Case declared{
      .title = "Start-up of plane Poiseuille flow",
      .description =
          "Water at rest between two plates 1 mm apart is driven by a body force of 8 mm/s² along them from t = 0. The "
          "oracle is the exact series of Morris, Fox & Zhu (1997), as a Fourier series at late and by images at early times.",
      .times = {0.05, 0.1, 0.2, 1, 10},
      .watch = {.every = 0.02,
                .see = [](const Samples& s) { return std::vector{largest_velocity(s)}; },
                .quantities = {{"largest velocity", "m/s"}}},
      .measurements = {norms_of("v_x, row means", by_rows, exact), norms_of("v_x, per particle", by_particles, exact),
                       [](const Level& level, const Run& run) { return growth_of(level, run, exact); }},
      .claims = {},
      .methods =
          {{
               .name = "mpm",
               .description = mpm_words + moving_words,
               .run = mpm_with<mpm::PrescribedMotion>(scene),
               .levels = mpm_levels(1, 10),
               .ladders = mpm_ladders(),
               .claims =
                   {at_most(l2, 0.07, baseline("an independent prototype of the same scheme gave 0.064"))
                        .on("M2")
                        .at(1),
                    at_most(linf, 0.08, baseline("an independent prototype of the same scheme gave 0.068"))
                        .on("M2")
                        .at(1),
                    order_between(grid, l2, 1.9, 2.1, theory("linear shape functions, central quadrature: order 2"))
                        .at(1),
                    order_between(grid, linf, 1.9, 2.1, theory("linear shape functions, central quadrature: order 2"))
                        .at(1)},
           },
           {
               .name = "mpm_reset",
               .description = mpm_words + reset_words,
               .run = mpm_with<mpm::VelocityReset>(scene),
               .levels = mpm_levels(0, 1),
               .ladders = mpm_ladders(),
               .claims = {order_between(
                              grid, linf, 0.8, 1.2,
                              theory("a reset wall acts up to half a cell into the fluid: order 1 at the wall"))
                              .at(1),
                          between(l2_rows, 3.34 / 1.5, 3.34 * 1.5, literature("Sun et al., table 3, M1, within 1.5"))
                              .on("M1")
                              .at(1),
                          between(l2_rows, 1.59 / 1.5, 1.59 * 1.5, literature("Sun et al., table 3, M2, within 1.5"))
                              .on("M2")
                              .at(1)},
           },
           {
               .name = "sph",
               .description = sph_printed_words + conservative_words,
               .run = channel::sph_as_printed(scene),
               .levels = printed_levels(1),
               .ladders = sph_ladders({"S1", "S2", "S3", "S4"}),
               .claims = at_most_the_papers("3", {4.39, 2.33, 1.63}, 'S') +
                         order_between(spacing_ladder, l2_rows, 0, 0.5,
                                       theory("stalls: the lattice is elastic at any spacing"))
                             .at(1),
               .tolerance = stretched,
               .relative_cost = 100,
           },
           {
               .name = "sph_difference",
               .description = sph_printed_words + difference_words,
               .run = channel::sph_as_printed<sph::PressureDifference>(scene),
               .levels = difference_levels(),
               .ladders = sph_ladders({"S1", "S2"}),
               .claims = at_most_the_papers("3", {4.39, 2.33}, 'S'),
               .tolerance = stretched,
               .relative_cost = 30,
           },
           {
               .name = "sph_regularised",
               .description = sph_regularised_words,
               .run = sph_with_transport_velocity(scene),
               .levels = regularised_levels(),
               .ladders = sph_ladders({"S1", "S2", "S3"}),
               .claims =
                   {at_most(l2, 0.5, baseline("a prototype with mirrored wall velocities gave 0.39")).on("S1").at(1),
                    at_most(l2, 0.5, baseline("the same at 10 s")).on("S1").at(10),
                    at_most(growth, 1.25, theory("steady flow: no growth other than from particles passing each other"))
                        .on("S1")
                        .at(10)},
               .tolerance = stretched,
               .relative_cost = 40,
           }},
      .plots = {profiles({"profile",
                          "Velocity profiles",
                          "Row means at 3200 particles. Reproduces figure 5(b) of Sun et al.",
                          {"y [mm]", 1e3},
                          {"v_x [mm/s]", 1e3}},
                         by_rows, exact, H, {"M2", "S2"}),
                over_time({"history",
                           "Maximum velocity over time",
                           "Reproduces figure 5(a) of Sun et al.",
                           {"t [s]"},
                           {"v_x [mm/s]", 1e3}},
                          0, {"M2", "S1"}),
                exact_over_time(
                    "history", [](double t) { return exact(H / 2, t); }, 2)},
  };
  for (const Method& method : second_order_methods(
           scene,
           {order_at_least(ladder_across, l2, 1.9, 1.6, theory("fits and differences of second order")).at(0.1).over(5),
            a_share_of_the_papers(20, 3.34, "table 3, M1").on("M1"),
            a_share_of_the_papers(20, 1.59, "table 3, M2").on("M2")},
           {order_at_least(ladder_across, l2, 1.8, 1.5, theory("fits of second degree")).at(0.1).over(5),
            a_share_of_the_papers(10, 4.39, "table 3, S1").on("S1")}))
    declared.methods.push_back(method);
  return with_plots(std::move(declared), figures("poiseuille", "6", "3"));
}

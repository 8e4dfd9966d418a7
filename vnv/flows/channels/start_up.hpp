#pragma once
/// The two start-up flows of Sun et al.: models of table 2, tables and figures, and the case of each but for what is
/// claimed of it alone.

#include "vnv/files/tables.hpp"
#include "vnv/flows/channels/driven_channel.hpp"

#include <map>

namespace touchstone::vnv::channel {

// Ladders, by what they refine.
inline const std::string points_per_cell = "points per cell, cells of 0.025 mm";
inline const std::string grid = "grid at 4 points per cell";
inline const std::string spacing_ladder = "spacing at fixed h / spacing";

/// One of the two as the paper has it, and how far its case goes.
struct PaperFlow {
  std::string name;          // "poiseuille", as in the tables and of the flow itself
  int table;                 // of errors and cost
  int figure;                // of profiles and history; the next one is of errors and cost
  std::string monitored;     // "Maximum velocity"
  double nightly_of_M2 = 1;  // s
  double report_of_S3 = 0;   // s  of SPH as printed
};

/// How much larger an error is at 10 s than at 1 s, for runs that go so far.
inline const Quantity growth{"L2 v_x, per particle, at 10 s over that at 1 s", "", Kind::value, Better::smaller};

/// The rows of tables 3 and 4 of Sun et al. for one flow and one of its methods, "MPM" or "SPH".
DataTable published(const std::string& flow, const std::string& method);

/// At most the L2 error that the paper has for a model at 1 s, or that divided by `divided_by`.
Claim at_most_the_papers(const PaperFlow& flow, const std::string& model, int divided_by = 1);
/// Within a factor of 1.5 of it.
Claim near_the_papers(const PaperFlow& flow, const std::string& model);

/// M1 to M4 of table 2, and 10, 20, 40, 80 cells across at 4 per cell; M2 belongs to both. How far a report runs the
/// finest and a night M2 [s].
std::vector<Level> mpm_levels(double finest_report, double nightly_of_M2);
/// Particles across, of which 40 and 80 are models of table 2.
std::vector<Level> levels_with_models(char series, const std::vector<Across>& all);

/// All of a case: `follow` is monitored, the claims of each method go before those of both flows.
Case start_up_case(const PaperFlow& flow, std::function<double(const Samples&)> follow,
                   std::vector<Method> methods, const std::map<std::string, std::vector<Claim>>& claims);

/// Its methods, with the claims that both flows make of them.
template <class SceneOfChannel>
std::vector<Method> start_up_methods(const SceneOfChannel& scene, const PaperFlow& flow) {
  const std::vector<Ladder> mpm_ladders{{points_per_cell, {"M1", "M2", "M3", "M4"}},
                                        {grid, {"G10", "G20", "M2", "G80"}}};
  const auto ladder = [](const std::vector<std::string>& levels) {
    return std::vector<Ladder>{{spacing_ladder, levels}};
  };
  return {
      {.name = "mpm",
       .family = Family::mpm,
       .description = mpm_words + moving_words,
       .run = mpm_with<mpm::PrescribedMotion>(scene),
       .levels = mpm_levels(1, flow.nightly_of_M2),
       .ladders = mpm_ladders},
      {.name = "mpm_reset",
       .family = Family::mpm,
       .description = mpm_words + reset_words,
       .run = mpm_with<mpm::VelocityReset>(scene),
       .levels = mpm_levels(0, 1),
       .ladders = mpm_ladders,
       .claims = {order_between(grid, linf, 0.8, 1.2,
                                theory("a reset wall acts up to half a cell into the fluid: order 1 at the wall"))
                      .of_formal_order(1)
                      .at(1),
                  near_the_papers(flow, "M2")}},
      {.name = "sph",
       .family = Family::sph,
       .description = sph_printed_words + conservative_words,
       .run = sph_as_printed(scene),
       .levels = {{.name = "S1", .spacing = H / 40, .acceptance = 0.2, .report = 1, .nightly = 1},
                  {.name = "S2", .spacing = H / 80, .acceptance = 0.05, .report = 1, .nightly = 1},
                  {.name = "S3", .spacing = H / 120, .report = flow.report_of_S3, .nightly = 1},
                  {.name = "S4", .spacing = H / 160, .nightly = 1}},
       .ladders = ladder({"S1", "S2", "S3", "S4"}),
       .tolerance = stretched,
       .relative_cost = 100},
      {.name = "sph_difference",
       .family = Family::sph,
       .description = sph_printed_words + difference_words,
       .run = sph_as_printed<sph::PressureDifference>(scene),
       .levels = {{.name = "S1", .spacing = H / 40, .acceptance = 0.2, .report = 1, .nightly = 1},
                  {.name = "S2", .spacing = H / 80, .nightly = 0.2}},
       .ladders = ladder({"S1", "S2"}),
       .claims = {at_most_the_papers(flow, "S1"), at_most_the_papers(flow, "S2")},
       .tolerance = stretched,
       .relative_cost = 30},
      {.name = "sph_regularised",
       .family = Family::sph,
       .description = sph_regularised_words,
       .run = sph_with_transport_velocity(scene),
       .levels = {{.name = "S1", .spacing = H / 40, .acceptance = 0.2, .report = 1, .nightly = 10},
                  {.name = "S2", .spacing = H / 80, .acceptance = 0.05, .report = 0.2, .nightly = 0.2},
                  {.name = "S3", .spacing = H / 120, .nightly = 0.2}},
       .ladders = ladder({"S1", "S2", "S3"}),
       .claims = {at_most(growth, 1.25, baseline("steady flow: no growth other than from particles passing each other"))
                      .on("S1")
                      .at(10)},
       .tolerance = stretched,
       .relative_cost = 40},
      // At times that 0.05 s divides.
      with_ladder(levels_with_models(
                      'M', {{20, 0.1, 0, 0.1}, {28, 0.1, 0, 0.1}, {40, 0, 0, 1}, {56, 0, 0, 0.1}, {80, 0, 0, 1}}),
                  mpm_least_squares(scene, 0.05),
                  {order_at_least(ladder_across, l2, 1.9, 1.6, theory("fits and differences of second order"))
                       .of_formal_order(2)
                       .at(0.1)
                       .with_at_least_levels(5),
                   at_most_the_papers(flow, "M1", 20), at_most_the_papers(flow, "M2", 20)}),
      with_ladder(levels_with_models(
                      'S', {{14, 0.1, 0, 0.1}, {20, 0.1, 0, 0.1}, {28, 0, 0, 0.1}, {40, 0, 0, 1}, {56, 0, 0, 0.1}}),
                  sph_second_order(scene, 0.05),
                  {order_at_least(ladder_across, l2, 1.8, 1.5, theory("fits of second degree"))
                       .of_formal_order(2)
                       .at(0.1)
                       .with_at_least_levels(5),
                   at_most_the_papers(flow, "S1", 10)})};
}

}  // namespace touchstone::vnv::channel

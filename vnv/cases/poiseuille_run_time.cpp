/// What an error costs in start-up plane Poiseuille flow [Sun et al., section 3.1], at the paper's bulk modulus.

#include "reference/poiseuille.hpp"
#include "solvers/forces/uniform.hpp"
#include "solvers/walls/no_slip.hpp"
#include "vnv/channel_run_time.hpp"

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

Claim price_at_most(double target, double seconds, Author author) {
  return at_most(price_of(work_diagram(), target), seconds, std::move(author));
}

std::vector<WorkPoint> elsewhere() {
  std::vector<WorkPoint> points = published_work("poiseuille");
  const std::vector<WorkPoint> peers = peers_in_poiseuille_flow();
  points.insert(points.end(), peers.begin(), peers.end());
  return points;
}

}  // namespace

Case vnv::the_case() {
  const Claim as_m1 = price_at_most(3, 92, literature("Sun et al., table 3, M1: 200000 steps of 0.46 ms for 3.34 %")),
              as_s1 = price_at_most(3, 1006, literature("Sun et al., table 3, S1: 200000 steps of 5.03 ms for 4.39 %"));
  Case declared = error_against_run_time_in(
      scene, exact, elsewhere(),
      {{"mpm", {as_m1, price_at_most(1, 0.03, baseline("goal: a plain loop does it in 0.04 s"))}},
       {"mpm_reset", {as_m1}},
       {"mpm_float", {as_m1}},
       {"mpm_affine", {as_m1}},
       {"sph_regularised_float", {as_s1}},
       {"sph_one_evaluation", {as_s1}},
       {"sph", {as_s1}},
       {"sph_difference", {as_s1}},
       {"sph_regularised", {as_s1, price_at_most(1, 2, baseline("goal: the best of other codes takes 83 s"))}}});
  declared.title = "Poiseuille flow: error against run time";
  declared.description =
      "The start-up of plane Poiseuille flow from rest to 1 s, at the paper's bulk modulus: each method over resolutions "
      "and over time steps, from the paper's 5 us up to nearly the longest that it can bear. A method is worth what its "
      "error costs.";
  return declared;
}

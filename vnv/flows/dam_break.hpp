#pragma once
/// The dam break of Sun et al., section 3.3: a column of water collapses in a tank.

#include "solvers/fluids/newtonian.hpp"
#include "solvers/fluids/tait.hpp"
#include "solvers/forces/uniform.hpp"
#include "solvers/walls/free_slip.hpp"
#include "vnv/flows/dams/dam_front.hpp"
#include "vnv/flows/flow.hpp"
#include "vnv/record/record.hpp"

namespace touchstone::vnv::dam_break {

inline constexpr double g = 9.8;  // m/s²
inline constexpr Tait water{.density = 1000, .bulk_modulus = 0.36 * MPa};

/// A column at the left end of a tank, both so long and high [m].
template <class FluidLaw = Tait>
Scene<FluidLaw, Uniform> collapse(const Vec2& column, const Vec2& tank, const FluidLaw& fluid = water,
                                  double gravity = g) {
  return {.domain = {.box = {.high = tank}},
          .fluid = fluid,
          .filled = {.high = column},
          .walls = {floor_at(0, free_slip()), left_at(0, free_slip()), right_at(tank.x(), free_slip())},
          .body_force = {{0, -gravity}}};
}

/// The column and tank of Lobovský et al. (2014), which Sun et al. compute.
inline const Vec2 column{0.6, 0.6}, tank{1.61, 1.2};  // m
inline constexpr double cell = 0.02;                  // m
inline const DamFront front{.column_length = column.x(),
                            .column_height = column.y(),
                            .tank_length = tank.x(),
                            .tank_height = tank.y(),
                            .density = water.density,
                            .gravity = g,
                            .slab = cell};

/// How far the front of a method may be from the experiment.
inline const Claim near_the_experiment =
    at_most(DamFront::rms, 0.12,
            baseline("an independent prototype of MPM as printed differed by 0.09 from Lobovský et al. 2014"));

/// What an error of the front costs, read as every code's can be: a slab is blind to a sheet of single particles.
inline const WorkDiagram work{
    .id = "work",
    .title = "Work-precision diagram of the front",
    .caption =
        "RMS error of L for T in [1, 1.5], without time shift, front as 99.5th percentile of the water, against the "
        "CPU seconds from rest to t = 0.5 s. No method models the gate of the experiment: a difference of a few "
        "hundredths remains at any resolution.",
    .quantity = DamFront::rms_of_percentile,
    .targets = {}};

/// What is followed of a front.
inline Monitor monitored(const DamFront& of) {
  return {.interval = 0.01,
          .evaluate = [of](const Samples& s) { return of.monitored(s); },
          .quantities = DamFront::quantities};
}

/// A case of this dam break, which follows its front.
inline Case front_followed(std::string title, std::string description) {
  return {.title = std::move(title),
          .description = std::move(description),
          .times = {0.5},
          .monitor = monitored(front),
          .measurements = {[](const Level& level, const Run& run) { return front.compare(level, run); }},
          .methods = {}};
}

}  // namespace touchstone::vnv::dam_break

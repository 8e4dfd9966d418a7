#pragma once
/// The dam break of Lobovský et al. (2014) with what their rig has: a gate that is drawn up, level gauges along the
/// tank and pressure sensors in its far wall. Plane: neither the breadth of the tank, 0.15 m, nor air is modelled.

#include "vnv/flows/dams/dam.hpp"
#include "vnv/measures/impact.hpp"

#include <array>
#include <cmath>

namespace touchstone::vnv::gated_dam {

inline constexpr double column_length = 0.6, tank_length = 1.61;  // m
inline constexpr std::array gauges{0.3, 0.865, 1.114, 1.3625};    // m  H1 to H4, from the back wall
inline constexpr std::array sensors{0.003, 0.015, 0.030, 0.080};  // m  P1 to P4, above the floor
inline constexpr double sensor_diameter = 4.2e-3;                 // m
/// How far gauges and sensors may stand off their places [m], to either side.
inline constexpr double gauge_uncertainty = 1e-3, sensor_uncertainty = 0.5e-3;
/// By how much the clocks of front and pressures may differ [s].
inline constexpr double clock_uncertainty = 27e-3;

/// What a computation takes from the experiment, and what it chooses, the bulk modulus.
struct Inputs {
  double height = 0.3;            // m    H
  double length = column_length;  // m
  double gate_speed = 3.46;       // m/s  of its lower edge, the mean until it leaves the water
  /// How it comes to that speed: 0, at once; 1, evenly over all of the way, from rest at t = 0.
  double gate_acceleration = 0.5;
  double density = 997;          // kg/m³
  double gravity = 9.81;         // m/s²
  double bulk_modulus = 0.36e6;  // Pa   K of Tait's law: sound at 50 m/s, 17 times as fast as the front

  /// Of the lower edge of the gate above the floor [m].
  double gate_edge(double time) const {
    const double way = gate_speed * time;
    return way * (1 - gate_acceleration + gate_acceleration * way / height);
  }
  double unit_of_time() const { return std::sqrt(height / gravity); }     // s   T_H = t sqrt(g/H)
  double unit_of_pressure() const { return density * gravity * height; }  // Pa  rho g H
  /// What the column loses until it lies flat in the tank [J/m].
  double fall() const { return fall_of(density, gravity, length, height, tank_length); }
};
inline constexpr Inputs filled_300{}, filled_600{.height = 0.6, .gate_speed = 4.53};

/// Water under its own weight behind the gate, in a tank so high that no splash leaves it.
Scene<Tait, Uniform> collapse(const Inputs& inputs);

/// Skin friction of the floor and of the side walls, as a flat plate as long as the column has it at the front's speed,
/// 2 m/s (Re = 1.2e6): 0.664 Re^(-1/2) if all of it is laminar, 0.0592 Re^(-1/5) if all is turbulent (Schlichting,
/// Boundary-Layer Theory), and their middle.
inline constexpr double laminar_friction = 0.0006, middle_friction = 0.002, turbulent_friction = 0.0036;
inline const SkinFriction friction{.coefficient = middle_friction, .layer = 7.5e-3, .breadth = 0.15};

/// How deep water is where a front is that all resolutions have in common: sqrt(sigma / (rho g)) with 0.072 N/m.
/// Surface tension, which is not modelled, rounds the tip below it.
inline constexpr double capillary_length = 2.7e-3;  // m

/// What is followed, SI.
namespace column {
inline constexpr std::size_t kinetic = 0, potential = 1, elastic = 2,  // J/m
    front_slab = 3,                                                    // m  half-full slab of two spacings
    front_percentile = 4,                                              // m  99.5th percentile of the volume
    front_of_film = 5,                                                 // m   half-full slab of two capillary lengths
    level = 6,                          // m   of each gauge at its place, before and behind it
    patch = level + 3 * gauges.size(),  // Pa  of each sensor: mean over a patch of the wall, at its place, below, above
    fit = patch + 3 * sensors.size(),   // Pa  the same by an affine fit read at the wall
    count = fit + 3 * sensors.size();
}  // namespace column
extern const Monitor monitored;

/// What was observed of a dam break, computed or measured, in the numbers of the experiment, over T_H.
struct Observed {
  Series front;                                    // x/H from the gate
  std::array<Series, gauges.size()> levels{};      // h/H
  std::array<Series, sensors.size()> pressures{};  // p/(rho g H)
};

/// Which of the followed columns, and whose place: nominal, or off it by its uncertainty to one side or the other.
struct ReadOut {
  std::size_t front = column::front_slab, pressures = column::fit, place = 0;
};
Observed observed_in(const Run& run, const Inputs& inputs, const ReadOut& read_out = {});

/// The experiment at H = 0.3 m: front, levels of one of two runs, pressures of one event.
Observed measured_300(int run = 1);
/// Percentiles 2.5 %, 50 % and 97.5 % over 100 repeats of p/(rho g H) at P2 over T_H, each with its name.
std::vector<std::pair<std::string, Series>> band_of_P2();
/// The same percentiles of the first peak of p/(rho g H) at P1 to P3.
std::vector<std::vector<double>> peaks_of_repeats();

/// Of a pressure p/(rho g H) over T_H, impulse over 100 ms. An impact is above a tenth of the weight of the column.
Impact impact_on(const Series& pressure);

/// A pressure at P2 whose clock is set by its arrival to that of the median of the repeats: by 27 ms at most, as much
/// as the clocks are uncertain.
Series aligned_by_arrival(const Series& pressure);

/// Inputs of data/experiments/lobovsky_2014_inputs_*.csv that no run has to vary.
inline const std::string clock_of_front = "start of front and levels", clock_of_pressures = "start of pressures",
                         place_of_gauges = "place of level gauges", height_of_sensors = "height of pressure sensors";

/// A number that computed and measured dam breaks have, and what is known of the measured one.
struct Observable {
  Quantity quantity;
  std::function<double(const Observed&)> of;
  double measured;               // D
  double standard;               // u_D; not a number: unknown
  std::string basis;             // of u_D
  double useful;                 // the uncertainty up to which agreement says something
  std::string clock{}, place{};  // inputs that say whose start and whose place it depends on; empty: on none
};
/// Of the experiment at H = 0.3 m, and the front at H = 0.6 m. Throw BadData for data that cannot be read.
std::vector<Observable> observables_300();
std::vector<Observable> observables_600();

/// What all runs of H = 0.3 m or of 0.6 m are compared by: RMS of front and levels, what is read of the impact, the
/// share of time inside the band of P2, and how much energy the run makes.
std::vector<Value> compared(const Inputs& inputs, const Level& level, const Run& run);

inline const Quantity front_rms{"RMS error of front x/H, clocks as they are", "", Kind::error},
    front_speed_error{"relative error of the front speed, T_H from 1 to 1.58", "%", Kind::deviation},
    levels_rms{"RMS error of levels h/H at H2 to H4, before the return wave", "", Kind::error},
    pressure_rms{"RMS error of p/(rho g H) at P2, T_H 2.4 to 6, aligned by arrival", "", Kind::error},
    inside_band{"fraction of T_H 2.4 to 6 within the 95 % band of P2, aligned by arrival", "", Kind::value,
                Better::larger},
    energy_left{"mechanical energy over the fall at the end"};

}  // namespace touchstone::vnv::gated_dam

#pragma once
/// A flow apart from any method: its scene, its oracle, what is measured of it and what is claimed of any method that
/// computes it, at parameters that its user sets.

#include "solvers/fluids/newtonian.hpp"
#include "solvers/forces/force_field.hpp"
#include "solvers/forces/oscillating.hpp"
#include "solvers/forces/uniform.hpp"
#include "solvers/scene.hpp"
#include "vnv/case.hpp"
#include "vnv/measures/coverage.hpp"
#include "vnv/measures/field_errors.hpp"
#include "vnv/measures/norms_of.hpp"

#include <algorithm>
#include <any>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace touchstone::vnv {

/// One number of a flow.
struct Parameter {
  std::string name, unit, words;
  double value;
  bool is_published = true;  // nothing else was set
};

/// The parameters that a user sets, by name; each other one has the value of the published flow.
class Settings {
 public:
  explicit Settings(std::map<std::string, double> set = {}) : set_(std::move(set)) {}

  /// The value of a parameter. Throws std::invalid_argument for one that is not finite.
  double operator()(const std::string& name, double published, const std::string& unit, const std::string& words);
  /// The same, above zero.
  double positive(const std::string& name, double published, const std::string& unit, const std::string& words);

  /// All that were asked for. Throws std::invalid_argument for one that was set and that the flow does not have.
  const std::vector<Parameter>& all_of(std::string_view flow) const;

 private:
  std::map<std::string, double> set_;
  std::vector<Parameter> asked_{};
};

/// A body force [m/s²]: an amplitude times cos(angular frequency t), or a formula where it depends on the place: lines
/// "name = expression" of x, y, t, pi and the flow's parameters, of which the last two are its components b_x and b_y;
/// and what it is at some places and times, by which a program tests what it made of them.
struct Drive {
  Vec2 amplitude = Vec2::Zero();
  double angular_frequency = 0;                       // 1/s
  std::function<Vec2(const Vec2& x, double t)> at{};  // where it depends on the place
  std::vector<std::string> formula{};
  std::vector<std::array<double, 5>> examples{};  // x [m], y [m], t [s], b_x and b_y [m/s²]
};

/// The field of a velocity of which no more than its component along x need be there.
inline const std::string velocity_along_x = "velocity along x";

/// A sample that is no farther from a time than this part of it is one of that time.
inline constexpr double time_tolerance = 0.01;

/// What a measurement over time needs.
struct Span {
  double first, last;      // s  files at or before, at or after
  std::size_t least;       // times
  bool is_steady = false;  // then as long before a later last time
};

/// What may be wrong with a flow. By how much: viscosity, force, gravity, sound speed, amplitude and parameters as
/// fractions of the right one, walls [m] outward, the slip length [m], the time [s] by which it is ahead, a mean in the
/// unit of the field over that of its norm.
enum class Cause {
  viscosity,
  force,
  gravity,
  sound_speed,
  floor,
  ceiling,
  walls,
  slip,
  lead,
  amplitude,
  mean_x,
  mean_y,
  parameter  // and those after it: of a flow in formulas, the first and further ones that may be wrong
};
inline constexpr std::size_t most_parameters_in_doubt = 8;
constexpr Cause cause_of_parameter(std::size_t k) {
  return static_cast<Cause>(static_cast<std::size_t>(Cause::parameter) + k);
}

/// By how much each of them is wrong.
class Changes {
 public:
  double operator()(Cause cause) const { return by_[static_cast<std::size_t>(cause)]; }
  double& operator()(Cause cause) { return by_[static_cast<std::size_t>(cause)]; }
  /// So many times the right one, for what is never zero or less, whatever a fit tries.
  double factor(Cause cause) const { return std::max(1e-6, 1 + (*this)(cause)); }

 private:
  std::array<double, static_cast<std::size_t>(Cause::parameter) + most_parameters_in_doubt> by_{};
};

/// The exact field at a place and a time: a velocity [m/s], or a pressure [Pa] and zero.
using FieldTruth = std::function<Vec2(const Vec2& x, double t)>;

/// Another flow that may have been computed instead.
struct Instead {
  std::string cause, sentence;  // "free slip", "the fluid slips freely along both walls"
  FieldTruth truth;
};

/// A field whose exact solution is known, and what it would be of a flow in which something is wrong.
struct Exact {
  std::string field;                               // "velocity", "pressure"
  std::vector<std::string> norms;                  // names of the quantities that are norms of its error
  int components = 1;                              // along x; or along x and y
  bool less_mean = false;                          // only differences matter
  std::vector<Cause> causes;                       // that `with` knows; lead, amplitude and mean apply to each field
  std::function<FieldTruth(const Changes&)> with;  // lead, amplitude and mean left aside
  std::vector<Instead> instead{};
  std::vector<std::string> parameters{};  // names of those that `Cause::parameter` and those after it are
  double period = 0;  // s  of what has always oscillated, before t = 0 too; 0: nothing is known before t = 0
};

/// A measurement and the fields that it reads besides places.
struct Measured {
  std::vector<std::string> fields;  // "velocity", `velocity_along_x`, "pressure"; "particles": says nothing of a mesh
  Measurement measurement;
  std::optional<Span> over{};  // none: made at each time by itself
  std::string name{};          // of what is measured over time
};

struct Flow {
  std::string name{};
  std::vector<Parameter> parameters{};
  Case judged{};  // title, description, times, claims and figures; no methods
  std::vector<Measured> measured{};
  std::vector<Exact> exact{};
  std::any exact_solution{};         // of reference/, whole
  double across{};                   // m  the length that a resolution is counted over
  std::vector<Claim> aside{};        // claims besides those in `judged`, which much that is not this flow keeps, too
  std::vector<Claim> of_resolved{};  // claims of levels with so many particles across
  double resolved = INFINITY;
  std::function<std::vector<Claim>(double across)> of_coarse{};  // claims of levels with fewer

  Domain domain{};
  Newtonian fluid{};  // inviscid where its viscosity is zero
  Box filled{};
  std::string shape{};  // what of the box is filled, where it is not all of it
  double area{};        // m²  that is filled; zero: all of the box
  std::vector<Wall> walls{};
  double wall_frequency = 0;  // 1/s  walls move with their velocity times cos(frequency t)
  Drive drive{};
  Start start{};
  std::function<Region(double t)> region{};  // of the fluid at a time [s], where its surface is known exactly
  std::vector<std::string> formulas{};       // of a flow in formulas: its exact fields, line by line, of x, y and t
  std::string residual{};                    // and how well they solve the equation that it names
  bool is_uniform_along_x = false;           // so that the length of its period is free

  /// The name by which records of it are compared: with each parameter that is not the published one,
  /// "poiseuille_H=1_F=1e-05_nu=15e-3".
  std::string case_name() const;
  /// The title with these parameters: "Start-up of plane Poiseuille flow, H = 1 m".
  std::string title() const;
  /// The value of a parameter. Throws std::out_of_range for one that there is not.
  double operator[](std::string_view parameter) const;

  /// Its exact fields; the last is the velocity along x of what is uniform along x, over y [m]. Throw std::logic_error
  /// where none is known.
  VelocityTruth velocity() const;
  PressureTruth pressure() const;
  Truth along_x() const;
  /// The exact solution that it was made with. Throws std::bad_any_cast for another.
  template <class Oracle>
  const Oracle& oracle() const {
    return std::any_cast<const Oracle&>(exact_solution);
  }

  double filled_area() const { return area > 0 ? area : filled.size().prod(); }  // m²
  /// Where the fluid is at a time [s], if that is known exactly of any method.
  std::optional<Region> region_at(double t) const;
  /// Whether the fluid may be elsewhere than where it started.
  bool has_free_surface() const { return filled.low != domain.box.low || filled.high != domain.box.high; }
};

/// A fluid by its density [kg/m³] and speed of sound [m/s] without pressure and its kinematic viscosity [m²/s].
Newtonian fluid_of(double rho, double c, double nu = 0);
/// An inviscid one whose density [kg/m³] and speed of sound [m/s] in a state a user may set.
Newtonian fluid_of(Settings& set, double rho, double c, const std::string& state = "at zero pressure");

/// The scene of a flow as a solver takes it, with the fluid's law and the force that its types say. Throws
/// std::logic_error where the flow has a viscosity or a force for which they have no room.
template <class FluidLaw = Newtonian, class Force = NoForce>
Scene<FluidLaw, Force> scene_of(const Flow& flow) {
  const bool is_steady = flow.drive.angular_frequency == 0 && !flow.drive.at;
  Scene<FluidLaw, Force> scene{.domain = flow.domain,
                               .fluid = flow.fluid,
                               .filled = flow.filled,
                               .walls = flow.walls,
                               .start = flow.start};
  bool has_room = is_steady && (std::is_same_v<FluidLaw, Newtonian> || flow.fluid.viscosity == 0);
  if constexpr (std::is_same_v<Force, Uniform>) scene.body_force = {flow.drive.amplitude};
  if constexpr (std::is_same_v<Force, NoForce>) has_room &= flow.drive.amplitude.isZero(0);
  if constexpr (std::is_same_v<Force, ForceField>) {
    has_room = true;
    scene.body_force = flow.drive.at ? ForceField{flow.drive.at}
                                     : ForceField{Oscillating{flow.drive.amplitude, flow.drive.angular_frequency}};
  }
  if (!has_room)
    throw std::logic_error(flow.name + ": a scene of this type lacks a force or the viscosity of the flow");
  return scene;
}

/// A number of each sample of a run, and one of a whole run.
Measurement of_each_sample(const Quantity& quantity, std::function<double(const Samples&)> found);
Measurement of_run(const Quantity& quantity, std::function<double(const Run&)> found);
/// The same of a run that reached its end.
Measurement of_finished_run(const Quantity& quantity, std::function<double(const Run&)> found);

/// The ladder of a code that is judged: the files given, by their spacing.
inline const std::string ladder_of_files = "spacing";

/// What a flow with an exact solution claims of any method: it is consistent, so that its error in `quantity` falls at
/// first order at least, once three resolutions are there.
Claim is_consistent(const Quantity& quantity);

/// What each flow with a known pressure claims of any method: at least half of it is found, and no more than one and a
/// half, whatever the noise. None, or one of the wrong sign, is not the pressure of the flow.
Claim has_its_pressure();

/// A flow by the name of its source, vnv/flows/NAME.cpp, which defines flows::NAME.
struct NamedFlow {
  std::string name;
  Flow (*at)(Settings&);
};
const std::vector<NamedFlow>& all_flows();  // the build writes this list
/// Their names.
std::vector<std::string> flow_names();

/// A flow that has been made with these settings, by this name.
Flow finished(Flow flow, const std::string& name, const Settings& settings);

/// A flow at its settings. Throws std::invalid_argument for a name or a setting that there is not.
Flow flow_named(const std::string& name, Settings settings = Settings());

}  // namespace touchstone::vnv

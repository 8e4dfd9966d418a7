#pragma once
/// A flow apart from any method: its scene, its oracle, what is measured of it and what is claimed of any method that
/// computes it, at parameters that its user sets.

#include "solvers/fluids/newtonian.hpp"
#include "solvers/scene.hpp"
#include "vnv/case.hpp"
#include "vnv/measures/field_errors.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::vnv::doors {

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

/// A body force [m/s²]: an amplitude times cos(angular frequency t), or a formula.
struct Drive {
  Vec2 amplitude = Vec2::Zero();
  double angular_frequency = 0;  // 1/s
  std::string formula{};         // where it depends on the place
};

/// A measurement and the fields that it reads besides places.
struct Measured {
  std::vector<std::string> fields;  // "velocity", "pressure"
  Measurement measurement;
};

struct Flow {
  std::string name{};
  std::vector<Parameter> parameters{};
  Case judged{};  // title, description, times, claims and figures; no methods
  std::vector<Measured> measured{};
  double across{};  // m  the length that a resolution is counted over

  Domain domain{};
  Newtonian fluid{};  // inviscid where its viscosity is zero
  Box filled{};
  std::vector<Wall> walls{};
  double wall_frequency = 0;  // 1/s  walls move with their velocity times cos(frequency t)
  Drive drive{};
  Start start{};

  /// The name by which records of it are compared: with each parameter that is not the published one,
  /// "poiseuille_H=1_F=1e-05_nu=15e-3".
  std::string case_name() const;
  /// The title with these parameters: "Start-up of plane Poiseuille flow, H = 1 m".
  std::string title() const;
};

/// Of a scene all but its body force, which a flow says in words.
template <class Force>
void set_scene(Flow& flow, const Scene<Newtonian, Force>& scene) {
  flow.domain = scene.domain;
  flow.fluid = scene.fluid;
  flow.filled = scene.filled;
  flow.walls = scene.walls;
  flow.start = scene.start;
}

/// The ladder of a code that is judged: the files given, by their spacing.
inline const std::string ladder_of_files = "spacing";

/// What a flow with an exact solution claims of any method: it is consistent, so that its error in `quantity` falls at
/// first order at least, once three resolutions are there.
Claim is_consistent(const Quantity& quantity);

/// Names of all flows.
std::vector<std::string> flow_names();

/// A flow at its settings. Throws std::invalid_argument for a name or a setting that there is not.
Flow flow_named(const std::string& name, Settings settings = Settings());

}  // namespace touchstone::vnv::doors

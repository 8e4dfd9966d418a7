#pragma once
/// The validation of a method by the dam break with its gate, after ASME V&V 20-2009: for each observable the
/// comparison error E = S - D beside the uncertainties of numbers, inputs and data.
///
/// S is the median over starts that differ by a hundredth of a spacing, since the flow is chaotic after the impact. To
/// the uncertainty of numbers belong resolution, bulk modulus and the number of starts; to that of inputs each input of
/// its file in data/experiments, by runs at both ends of its half width or, for clocks and places, by
/// what a run would have shown then or there.

#include "vnv/flows/dams/gated_dam.hpp"
#include "vnv/judge/validation.hpp"

#include <map>

namespace touchstone::vnv::gated_dam {

/// One filling of the tank, what was measured of it, and how well its inputs are known.
struct Experiment {
  Inputs inputs;
  std::string inputs_file;  // in data/experiments
  std::function<std::vector<Observable>()> observables;
  double end;  // s  past all observables
};
extern const Experiment with_300, with_600;

/// From how many starts a method runs, at each number of particles across H; and with something varied, at which.
struct Starts {
  std::map<int, int> of_across{{20, 16}, {40, 16}, {80, 16}, {160, 4}, {320, 1}};
  int varied = 2, across_varied = 80;
};

/// Makes a method for a scene; where the second is none, there are no runs with skin friction.
struct MethodOn {
  std::function<Method(const Scene<Tait, Uniform>&)> without_friction;
  std::function<Method(const Scene<Tait, SkinFriction>&)> with_friction{};
};

/// The method from all starts as it is, and with each input varied, the bulk modulus doubled, an error of the model
/// planted, or skin friction. In the suite `validation` alone.
Method validated(const Experiment& experiment, const MethodOn& method_on, const Starts& starts = {});

/// The runs as they are at the number of particles across H that has most starts, of several the finest, for which all
/// finished: two at the least, or none.
std::vector<const Run*> ensemble_of(const Results& results);

/// Those with skin friction, if all finished.
inline constexpr std::array friction_coefficients{laminar_friction, middle_friction, turbulent_friction};
std::vector<const Run*> runs_with_friction(const Results& results, double coefficient);

/// By what fraction of itself a median moves: from the second finest grid to the finest, by a doubled bulk modulus, and
/// from one operator of the sensor to the other. Not numbers but for pressures.
struct Moves {
  double grid = not_a_number, modulus = not_a_number, sensor = not_a_number;

  bool converged() const {
    constexpr double most = 0.1;
    return std::abs(grid) <= most && std::abs(modulus) <= most && std::abs(sensor) <= most;
  }
};

/// What came of it for one observable.
struct ValidatedObservable {
  Observable observable;
  double simulated;
  Validation validation;
  double by_resolution = not_a_number, by_modulus = not_a_number, by_starts = 0;  // parts of u_num
  std::string rule{};                                                             // of the first
  std::vector<std::pair<std::string, double>> inputs{};                           // what each input adds to u_input
  std::vector<std::pair<std::string, double>> planted{};  // by how much each planted error moves S
  std::vector<std::pair<double, double>> by_friction{};   // the same of skin friction, by its coefficient
  Moves moves{};
};
std::vector<ValidatedObservable> judgements(const Results& results, const Experiment& experiment);

/// A case whose tables are these judgements and whose findings are E of each observable and how all came out together.
Case validation_by(const Experiment& experiment, std::string title, std::string description,
                   std::vector<Method> methods, std::vector<Claim> claims);
inline const Quantity agreeing{"observables that agree within 2 u_val", "", Kind::count, Better::larger},
    planted_noticed{"planted model errors that move an observable by more than 2 u_val", "", Kind::count,
                    Better::larger},
    model_errors{"observables with an error of the model", "", Kind::count, Better::smaller},
    converged_pressures{"pressures that grid, bulk modulus and sensor operator each move by 10 % at most", "",
                        Kind::count, Better::larger},
    numbers_over_data{"largest u_num over u_D, of front and levels", "", Kind::value, Better::smaller};

}  // namespace touchstone::vnv::gated_dam

#pragma once
/// The validation of a method by the dam break with its gate at H = 0.3 m, after ASME V&V 20-2009: for each observable
/// the comparison error E = S - D beside the uncertainties of numbers, inputs and data.
///
/// S is the median over starts that differ by a hundredth of a spacing, since the flow is chaotic after the impact. To
/// the uncertainty of numbers belong resolution, bulk modulus and the number of starts; to that of inputs each input of
/// data/experiments/lobovsky_2014_inputs_300.csv, by runs at both ends of its half width or, for clocks and places, by
/// what a run would have shown then or there.

#include "vnv/flows/gated_dam.hpp"
#include "vnv/judge/validation.hpp"

#include <map>

namespace touchstone::vnv::gated_dam {

inline constexpr double end_of_validation = 1.3;  // s  T_H = 7.4, past all observables

/// From how many starts a method runs, at each number of particles across H, and 40 across with something varied.
struct Starts {
  std::map<int, int> of_across{{20, 16}, {40, 16}, {80, 16}, {160, 4}};
  int varied = 4;
};

/// Makes a method for a scene; where the second is none, there are no runs with skin friction.
struct MethodOn {
  std::function<Method(const Scene<Tait, Uniform>&)> without_friction;
  std::function<Method(const Scene<Tait, SkinFriction>&)> with_friction{};
};

/// The method from all starts as it is, and 40 across with each input varied, the bulk modulus doubled, or an error of
/// the model planted; 40 and 80 across with skin friction. In the suite `validation` alone.
Method validated(const MethodOn& method_on, const Starts& starts = {});

/// The runs as they are at the number of particles across H that has most starts, of several the finest, for which all
/// finished: two at the least, or none.
std::vector<const Run*> ensemble_of(const Results& results);

/// What came of it for one observable.
struct Judgement {
  Observable observable;
  double simulated;
  Validation validation;
  double by_resolution = not_a_number, by_modulus = not_a_number, by_starts = 0;  // parts of u_num
  std::string rule{};                                                             // of the first
  std::vector<std::pair<std::string, double>> inputs{};                           // what each input adds to u_input
  std::vector<std::pair<std::string, double>> planted{};  // by how much each planted error moves S
  double by_friction = not_a_number;                      // by how much skin friction does, at the finest that has it
};
std::vector<Judgement> judgements(const Results& results);

/// A table of all observables with the words of the standard, one of what each input contributes, and one of what
/// planted errors of the model move beyond the uncertainty.
Plot validation_tables();

/// E of each observable, and what is claimed of all together.
std::vector<Value> validation_values(const Results& results, const Record& record);
inline const Quantity agreeing{"observables that agree within 2 u_val", "", Kind::count, Better::larger},
    planted_noticed{"planted model errors that move an observable by more than 2 u_val", "", Kind::count,
                    Better::larger},
    numbers_over_data{"largest u_num over u_D, of front and levels", "", Kind::value, Better::smaller};

}  // namespace touchstone::vnv::gated_dam

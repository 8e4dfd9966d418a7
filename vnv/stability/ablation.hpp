#pragma once
/// What a method needs in a scene: each variant lacks one ingredient, or has another in its place, by type; its error,
/// its largest stable step and its cost are set beside those of the whole method.

#include "vnv/case.hpp"
#include "vnv/stability/critical_step.hpp"

#include <functional>
#include <string>
#include <vector>

namespace touchstone::vnv {

/// The name of the whole method among its variants, which are called "without artificial viscosity" and the like.
inline const std::string unabridged = "complete";

/// A method, whole or without one ingredient.
struct Variant {
  std::string name;
  std::function<Run(const Level&, const Schedule&)> run;
};

/// What a variant came to.
struct Outcomes {
  bool finished = true;
  double error = not_a_number;
  double critical_step = not_a_number;      // s
  double per_particle_step = not_a_number;  // s  CPU time
};

/// "accuracy", "stability", "accuracy and stability" or "neither": what the ingredient that a variant lacks is needed
/// for. Needed for accuracy: without it the error grows by more than a tenth. Needed for stability: without it the run
/// does not end, or the critical step falls by more than a twentieth.
std::string needed_for(const Outcomes& whole_method, const Outcomes& without);

inline const Quantity critical_step_found{"largest stable time step", "us", Kind::stability_limit};

/// A variant whose solver is made for a level and a time step [s]: a run of it and, in the same process but not on its
/// account, its critical step.
template <class MakeSolver>
Variant variant(std::string name, double time_step, const StepSearch& search, MakeSolver solver) {
  return {std::move(name), [=](const Level& level, const Schedule& when) {
            const SolverWith solver_with = [&](double step) { return solver(level, step); };
            Run run = simulate([&] { return solver_with(time_step); }, when);
            run.add(critical_step_found, largest_step(solver_with, search) / us);
            return run;
          }};
}

/// A method whose levels are its variants, all at the resolution of `level`.
Method ablation(Method method, const Level& level, const std::vector<Variant>& variants);

/// A row for each variant: error at the end of the whole method's run, critical step and cost, their changes, and what
/// that which is missing is needed for. The variants `with_more` have an ingredient that the whole method has not:
/// there it is the whole method that lacks it. A second table, by another quantity, wants another id.
Plot ablation_table(Quantity quantity, std::vector<std::string> with_more = {}, std::string id = "ablation");

}  // namespace touchstone::vnv

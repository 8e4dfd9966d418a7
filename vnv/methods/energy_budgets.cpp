#include "vnv/methods/energy_budgets.hpp"

#include "solvers/mpm/plain/with_budget.hpp"
#include "solvers/mpm/shapes/b_spline.hpp"
#include "solvers/mpm/shapes/linear_hat.hpp"
#include "solvers/sph/free_surface/kick_drift_kick_with_budget.hpp"
#include "vnv/methods/sph_of_parts.hpp"

namespace touchstone::vnv {

namespace {

std::vector<double> parts_in(const EnergyBudget& budget) {
  return {budget.pressure, budget.gravity,  budget.viscosity, budget.smoothing,
          budget.walls,    budget.transfer, budget.shifting,  budget.residual()};
}

/// The same method by a solver that keeps an energy budget: make(level, time step) returns it and where its budget is.
template <class Make>
Method with_budget(Method method, const Make& make) {
  method.description += " This version of the solver keeps an energy budget and is slower.";
  method.run = [make, own_step = method.time_step](const Level& level, Schedule when) {
    const auto budget = std::make_shared<std::shared_ptr<const EnergyBudget>>();
    when.monitor.evaluate = [budget, evaluate = when.monitor.evaluate](const Samples& samples) {
      std::vector<double> row = evaluate(samples);
      const std::vector<double> parts = parts_in(**budget);
      row.insert(row.end(), parts.begin(), parts.end());
      return row;
    };
    return simulate(
        [&] {
          auto [solver, of_it] = make(level, level.step_or(own_step(level)));
          *budget = of_it;
          return Simulation(std::move(solver));
        },
        when, Stepping::adaptive);
  };
  return method;
}

template <class Of>
Method sph_with_budget(const Method& method, const Scene<Tait, Uniform>& scene) {
  return with_budget(method, [=](const Level& level, double time_step) {
    auto solver = sph_solver<Of, sph::KickDriftKickWithBudget, sph::PartsWithBudget>(scene, level, time_step, {});
    const std::shared_ptr<const EnergyBudget> budget = solver.integrator().budget;
    return std::pair(std::move(solver), budget);
  });
}

template <class Shape, class Transfer, class Density>
Method mpm_with_budget(const Method& method, const Scene<Tait, Uniform>& scene) {
  return with_budget(method, [=](const Level& level, double time_step) {
    mpm::WithBudget<Shape, Transfer, Density> solver(
        scene, {.cell = level.cell, .spacing = level.spacing, .time_step = time_step});
    const std::shared_ptr<const EnergyBudget> budget = solver.budget;
    return std::pair(std::move(solver), budget);
  });
}

}  // namespace

std::vector<Method> methods_with_energy_budget(const Scene<Tait, Uniform>& scene, double output_interval) {
  using Spline = mpm::BSpline<2>;
  return {mpm_with_budget<Spline, mpm::Apic, mpm::AffineDensity>(mpm_apic(scene, output_interval), scene),
          mpm_with_budget<Spline, mpm::Xpic<5>, mpm::AffineDensity>(mpm_xpic(scene, output_interval), scene),
          mpm_with_budget<mpm::LinearHat, mpm::Flip, mpm::CarriedDensity>(mpm_as_printed(scene, output_interval, 0.2),
                                                                          scene),
          sph_with_budget<OfDelta>(sph_delta(scene, output_interval), scene),
          sph_with_budget<OfShifted>(sph_shifted(scene, output_interval), scene),
          sph_with_budget<OfCorrected>(sph_corrected(scene, output_interval), scene)};
}

}  // namespace touchstone::vnv

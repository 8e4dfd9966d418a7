#pragma once
/// A simulation by any method, as the harness drives it.

#include "solvers/samples.hpp"
#include "solvers/scene.hpp"
#include "solvers/stepping/extremes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace touchstone::vnv {

/// What the fluid of a simulation is like at rest.
struct Medium {
  double density;      // kg/m³
  double sound_speed;  // m/s
};

/// Where the fluid of a simulation may be, and what of it is filled at the start.
struct Room {
  Domain domain{};
  Box filled{};

  bool is_full() const { return filled.low == domain.box.low && filled.high == domain.box.high; }
};

/// Any solver of solvers/, its type forgotten: what runs it is compiled once. A step costs one virtual call more.
class Simulation {
 public:
  template <class Solver>
  requires(!std::same_as<Solver, Simulation>) Simulation(Solver solver)  // implicit: a solver is a simulation
      : solver_(std::make_unique<SolverOf<Solver>>(std::move(solver))) {}

  void step() { solver_->step(); }  // throws Diverged
  double time() const { return solver_->time(); }
  double time_step() const { return solver_->time_step(); }
  long steps() const { return solver_->steps(); }
  long particles() const { return solver_->particles(); }
  long boundary_particles() const { return solver_->boundary_particles(); }
  Samples samples() const { return solver_->samples(); }  // throws Diverged
  Medium medium() const { return solver_->medium(); }
  Room room() const { return solver_->room(); }
  /// No signal is faster [m/s]. Cheap.
  double fastest_signal() const { return solver_->fastest_signal(); }
  /// Signals, sound with the flow that carries it, are faster than this [m/s] at a fraction of the particles only. As
  /// dear as samples.
  double signal_speed(double share) const { return solver_->signal_speed(share); }
  /// The length [s] of the steps to come.
  void change_time_step(double time_step) { solver_->change_time_step(time_step); }

 private:
  struct AnySolver {
    virtual ~AnySolver() = default;
    virtual void step() = 0;
    virtual double time() const = 0;
    virtual double time_step() const = 0;
    virtual long steps() const = 0;
    virtual long particles() const = 0;
    virtual long boundary_particles() const = 0;
    virtual Samples samples() const = 0;
    virtual Medium medium() const = 0;
    virtual Room room() const = 0;
    virtual double fastest_signal() const = 0;
    virtual double signal_speed(double share) const = 0;
    virtual void change_time_step(double time_step) = 0;
  };
  template <class Solver>
  struct SolverOf final : AnySolver {
    explicit SolverOf(Solver s) : solver(std::move(s)) {}
    void step() override { solver.step(); }
    double time() const override { return solver.time(); }
    double time_step() const override { return solver.time_step(); }
    long steps() const override { return solver.steps(); }
    long particles() const override { return solver.particles(); }
    long boundary_particles() const override { return solver.boundary_particles(); }
    Samples samples() const override { return solver.samples(); }
    Medium medium() const override { return {solver.scene().fluid.density, solver.scene().fluid.sound_speed()}; }
    Room room() const override { return {solver.scene().domain, solver.scene().filled}; }
    double fastest_signal() const override { return signal_speed_of(solver.extremes()); }
    double signal_speed(double share) const override {
      const Samples all = solver.samples();
      std::vector<double> speeds;
      for (Eigen::Index p = 0; p < all.size(); ++p) {
        const double speed = signal_speed_of({all.v.col(p).norm(), all.density[p]});
        speeds.push_back(std::isnan(speed) ? std::numeric_limits<double>::infinity() : speed);
      }
      const auto exceeding = static_cast<std::ptrdiff_t>(share * static_cast<double>(speeds.size()));
      std::ranges::nth_element(speeds, speeds.begin() + exceeding, std::greater{});
      return speeds[exceeding];
    }
    double signal_speed_of(const Extremes& e) const { return touchstone::signal_speed(solver.scene().fluid, e); }
    void change_time_step(double time_step) override { solver.change_time_step(time_step); }
    Solver solver;
  };

  std::unique_ptr<AnySolver> solver_;
};

/// Makes the same simulation each time it is called, bit by bit.
using MakeSimulation = std::function<Simulation()>;

}  // namespace touchstone::vnv

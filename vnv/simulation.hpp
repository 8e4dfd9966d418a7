#pragma once
/// A simulation by any method, as the harness drives it.

#include "solvers/samples.hpp"
#include "solvers/scene.hpp"

#include <functional>
#include <memory>
#include <utility>

namespace touchstone::vnv {

/// What the fluid of a simulation is like at rest.
struct Medium {
  double density;      // kg/m³
  double sound_speed;  // m/s
};

/// Any solver of solvers/, its type forgotten: what runs it is compiled once. A step costs one virtual call more.
class Simulation {
 public:
  template <class Solver>
  requires(!std::same_as<Solver, Simulation>) Simulation(Solver solver)  // implicit: a solver is a simulation
      : solver_(std::make_unique<Of<Solver>>(std::move(solver))) {}

  void step() { solver_->step(); }  // throws Diverged
  double time() const { return solver_->time(); }
  double time_step() const { return solver_->time_step(); }
  long steps() const { return solver_->steps(); }
  long particles() const { return solver_->particles(); }
  long boundary_particles() const { return solver_->boundary_particles(); }
  Samples samples() const { return solver_->samples(); }  // throws Diverged
  Medium medium() const { return solver_->medium(); }

 private:
  struct Any {
    virtual ~Any() = default;
    virtual void step() = 0;
    virtual double time() const = 0;
    virtual double time_step() const = 0;
    virtual long steps() const = 0;
    virtual long particles() const = 0;
    virtual long boundary_particles() const = 0;
    virtual Samples samples() const = 0;
    virtual Medium medium() const = 0;
  };
  template <class Solver>
  struct Of final : Any {
    explicit Of(Solver s) : solver(std::move(s)) {}
    void step() override { solver.step(); }
    double time() const override { return solver.time(); }
    double time_step() const override { return solver.time_step(); }
    long steps() const override { return solver.steps(); }
    long particles() const override { return solver.particles(); }
    long boundary_particles() const override { return solver.boundary_particles(); }
    Samples samples() const override { return solver.samples(); }
    Medium medium() const override { return {solver.scene().fluid.density, solver.scene().fluid.sound_speed()}; }
    Solver solver;
  };

  std::unique_ptr<Any> solver_;
};

/// Makes the same simulation each time it is called, bit by bit.
using MakeSimulation = std::function<Simulation()>;

}  // namespace touchstone::vnv

#include "vnv/methods/energy_books.hpp"

#include "solvers/mpm/composed/booked.hpp"
#include "solvers/mpm/composed/densities/affine_density.hpp"
#include "solvers/mpm/composed/transfers/apic.hpp"
#include "solvers/mpm/composed/transfers/flip.hpp"
#include "solvers/mpm/composed/transfers/xpic.hpp"
#include "solvers/mpm/shapes/b_spline.hpp"
#include "solvers/mpm/shapes/linear_hat.hpp"
#include "solvers/sph/free_surface/booked_kick_drift_kick.hpp"
#include "vnv/methods/sph_of_parts.hpp"

namespace touchstone::vnv {

namespace {

std::vector<double> parts_in(const EnergyBook& book) {
  return {book.pressure, book.gravity,  book.viscosity, book.smoothing,
          book.walls,    book.transfer, book.shifting,  book.residual()};
}

/// The same method by a solver that keeps a book: make(level, time step) returns it and where its book is.
template <class Make>
Method with_book(Method method, const Make& make) {
  method.description += " This version of the solver keeps an energy budget and is slower.";
  method.run = [make, own_step = method.time_step](const Level& level, Schedule when) {
    const auto book = std::make_shared<std::shared_ptr<const EnergyBook>>();
    when.watch.see = [book, see = when.watch.see](const Samples& samples) {
      std::vector<double> row = see(samples);
      const std::vector<double> parts = parts_in(**book);
      row.insert(row.end(), parts.begin(), parts.end());
      return row;
    };
    return simulate(
        [&] {
          auto [solver, of_it] = make(level, level.step_or(own_step(level)));
          *book = of_it;
          return Simulation(std::move(solver));
        },
        when, Stepping::adaptive);
  };
  return method;
}

template <class Of>
Method sph_with_book(const Method& method, const Scene<Tait, Uniform>& scene) {
  return with_book(method, [=](const Level& level, double time_step) {
    auto solver = sph_solver<Of, sph::BookedKickDriftKick, sph::Booked>(scene, level, time_step, {});
    const std::shared_ptr<const EnergyBook> book = solver.integrator().book;
    return std::pair(std::move(solver), book);
  });
}

template <class Shape, class Transfer, class Density>
Method mpm_with_book(const Method& method, const Scene<Tait, Uniform>& scene) {
  return with_book(method, [=](const Level& level, double time_step) {
    mpm::Booked<Shape, Transfer, Density> solver(
        scene, {.cell = level.cell, .spacing = level.spacing, .time_step = time_step});
    const std::shared_ptr<const EnergyBook> book = solver.book;
    return std::pair(std::move(solver), book);
  });
}

}  // namespace

std::vector<Method> methods_with_books(const Scene<Tait, Uniform>& scene, double output_interval) {
  using Spline = mpm::BSpline<2>;
  return {
      mpm_with_book<Spline, mpm::Apic, mpm::AffineDensity>(mpm_apic(scene, output_interval), scene),
      mpm_with_book<Spline, mpm::Xpic<5>, mpm::AffineDensity>(mpm_xpic(scene, output_interval), scene),
      mpm_with_book<mpm::LinearHat, mpm::Flip, mpm::CarriedDensity>(mpm_as_printed(scene, output_interval, 0.2), scene),
      sph_with_book<OfDelta>(sph_delta(scene, output_interval), scene),
      sph_with_book<OfShifted>(sph_shifted(scene, output_interval), scene),
      sph_with_book<OfCorrected>(sph_corrected(scene, output_interval), scene)};
}

}  // namespace touchstone::vnv

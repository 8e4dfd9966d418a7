#pragma once
/// Slopes and integrals by GSL, with which the tests ask an oracle for its equation.

#include <gsl/gsl_deriv.h>
#include <gsl/gsl_integration.h>

#include <memory>

namespace touchstone::reference {

/// Refers to f, which must outlive it.
template <class Function>
gsl_function as_gsl(Function& f) {
  return {.function = [](double x, void* p) -> double { return (*static_cast<Function*>(p))(x); }, .params = &f};
}

using Difference = int(const gsl_function*, double x, double step, double* result, double* error);

/// df/dx at x, from places within `step` of it: on both sides, or on one with gsl_deriv_forward or gsl_deriv_backward.
template <class Function>
double slope(Function f, double x, double step, Difference difference = gsl_deriv_central) {
  const gsl_function function = as_gsl(f);
  double result, error;
  difference(&function, x, step, &result, &error);
  return result;
}

/// The integral of f from low to high, to ten digits.
template <class Function>
double integral(Function f, double low, double high) {
  constexpr size_t intervals = 1000;
  const std::unique_ptr<gsl_integration_workspace, decltype(&gsl_integration_workspace_free)> space(
      gsl_integration_workspace_alloc(intervals), gsl_integration_workspace_free);
  const gsl_function function = as_gsl(f);
  double result, error;
  gsl_integration_qag(&function, low, high, 0, 1e-10, intervals, GSL_INTEG_GAUSS41, space.get(), &result, &error);
  return result;
}

}  // namespace touchstone::reference

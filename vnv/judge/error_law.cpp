#include "vnv/judge/error_law.hpp"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace touchstone::vnv {
namespace {

/// What is searched for: order, log of the scale, log of the floor. Logs keep the last two positive.
enum Parameter { order, log_scale, log_floor, parameters };

struct Ladder {
  std::vector<double> log_spacing;  // over the finest
  std::vector<double> log_error;
};

Ladder ladder_of(const std::vector<double>& spacings, const std::vector<double>& errors) {
  Ladder ladder;
  for (std::size_t i = 0; i < spacings.size(); ++i) {
    ladder.log_spacing.push_back(std::log(spacings[i] / spacings.back()));
    ladder.log_error.push_back(std::log(errors[i]));
  }
  return ladder;
}

int residuals(const gsl_vector* at, void* data, gsl_vector* out) {
  const Ladder& ladder = *static_cast<const Ladder*>(data);
  for (std::size_t i = 0; i < ladder.log_error.size(); ++i) {
    const double above = gsl_vector_get(at, log_scale) + gsl_vector_get(at, order) * ladder.log_spacing[i],
                 floor = gsl_vector_get(at, log_floor);
    const double law = std::max(above, floor) + std::log1p(std::exp(-std::abs(above - floor)));  // of the sum
    gsl_vector_set(out, i, law - ladder.log_error[i]);
  }
  return GSL_SUCCESS;
}

int slopes(const gsl_vector* at, void* data, gsl_matrix* out) {
  const Ladder& ladder = *static_cast<const Ladder*>(data);
  for (std::size_t i = 0; i < ladder.log_error.size(); ++i) {
    const double above = gsl_vector_get(at, log_scale) + gsl_vector_get(at, order) * ladder.log_spacing[i];
    const double fraction = 1 / (1 + std::exp(gsl_vector_get(at, log_floor) - above));  // that is not floor
    gsl_matrix_set(out, i, order, fraction * ladder.log_spacing[i]);
    gsl_matrix_set(out, i, log_scale, fraction);
    gsl_matrix_set(out, i, log_floor, 1 - fraction);
  }
  return GSL_SUCCESS;
}

struct Free {
  void operator()(gsl_multifit_nlinear_workspace* w) const { gsl_multifit_nlinear_free(w); }
  void operator()(gsl_matrix* m) const { gsl_matrix_free(m); }
};

/// GSL would end the program where a search finds no way on.
class NoAbort {
 public:
  NoAbort() : before_(gsl_set_error_handler_off()) {}
  ~NoAbort() { gsl_set_error_handler(before_); }
  NoAbort(const NoAbort&) = delete;
  NoAbort& operator=(const NoAbort&) = delete;

 private:
  gsl_error_handler_t* before_;
};

std::optional<ErrorLaw> search(Ladder& ladder, const std::array<double, parameters>& start) {
  const std::size_t levels = ladder.log_error.size();
  gsl_multifit_nlinear_parameters settings = gsl_multifit_nlinear_default_parameters();
  gsl_multifit_nlinear_fdf problem{};
  problem.f = residuals;
  problem.df = slopes;
  problem.n = levels;
  problem.p = parameters;
  problem.params = &ladder;
  const std::unique_ptr<gsl_multifit_nlinear_workspace, Free> work(
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &settings, levels, parameters));
  const gsl_vector_const_view from = gsl_vector_const_view_array(start.data(), parameters);
  gsl_multifit_nlinear_init(&from.vector, &problem, work.get());
  constexpr double tolerance = 1e-10;
  int why = 0;
  if (gsl_multifit_nlinear_driver(200, tolerance, tolerance, 0, nullptr, nullptr, &why, work.get()) != GSL_SUCCESS)
    return std::nullopt;

  const std::unique_ptr<gsl_matrix, Free> covariance(gsl_matrix_alloc(parameters, parameters));
  gsl_multifit_nlinear_covar(gsl_multifit_nlinear_jac(work.get()), 0, covariance.get());
  const gsl_vector* const found = gsl_multifit_nlinear_position(work.get());
  ErrorLaw law;
  gsl_blas_ddot(gsl_multifit_nlinear_residual(work.get()), gsl_multifit_nlinear_residual(work.get()), &law.squares);
  const double freedom = static_cast<double>(levels - parameters);
  const auto half_width = [&](Parameter p) {
    return gsl_cdf_tdist_Pinv(0.975, freedom) *
           std::sqrt(law.squares / freedom * gsl_matrix_get(covariance.get(), p, p));
  };
  law.order = gsl_vector_get(found, order);
  law.order_half_width = half_width(order);
  law.floor = std::exp(gsl_vector_get(found, log_floor));
  law.floor_half_width = law.floor * half_width(log_floor);
  if (!std::isfinite(law.order_half_width) || !std::isfinite(law.floor_half_width)) return std::nullopt;
  return law;
}

}  // namespace

std::optional<ErrorLaw> fit_law_with_floor(const std::vector<double>& spacings, const std::vector<double>& errors) {
  const auto has_log = [](double value) { return value > 0 && std::isfinite(value); };
  if (errors.size() <= parameters || !std::ranges::all_of(errors, has_log)) return std::nullopt;
  const NoAbort guard;
  Ladder ladder = ladder_of(spacings, errors);
  const double least = *std::ranges::min_element(errors);
  std::optional<ErrorLaw> best;
  for (const double guess : {1.0, 2.0, 4.0})
    for (const double fraction : {0.9, 0.5, 0.1}) {
      const auto law = search(ladder, {guess, std::log((1 - fraction) * least), std::log(fraction * least)});
      if (law && law->order > 0 && (!best || law->squares < best->squares)) best = law;
    }
  return best;
}

}  // namespace touchstone::vnv

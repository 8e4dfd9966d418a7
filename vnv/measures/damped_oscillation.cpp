#include "vnv/measures/damped_oscillation.hpp"

#include <gsl/gsl_multimin.h>

#include <Eigen/Cholesky>

#include <cmath>
#include <memory>

namespace touchstone::vnv {

DampedOscillation fit_damped_oscillation(const std::vector<double>& times, const std::vector<double>& values,
                                         double omega_near) {
  struct DecayingWave {
    Eigen::Map<const Eigen::ArrayXd> t, value;

    struct Fitted {
      Eigen::Vector3d factors;
      double misfit;
    };
    Fitted fitted(double omega, double decay) const {
      Eigen::MatrixX3d shapes(t.size(), 3);
      shapes.col(0) = (-decay * t).exp() * (omega * t).cos();
      shapes.col(1) = (-decay * t).exp() * (omega * t).sin();
      shapes.col(2).setOnes();
      // The shapes are far from each other: the normal equations lose no digit that matters.
      const Eigen::Matrix3d moments = shapes.transpose().lazyProduct(shapes);
      const Eigen::Vector3d sums = shapes.transpose().lazyProduct(value.matrix());
      const Eigen::Vector3d factors = moments.ldlt().solve(sums);
      return {factors, (shapes.lazyProduct(factors) - value.matrix()).squaredNorm()};
    }
  };
  const auto count = static_cast<Eigen::Index>(values.size());
  const DecayingWave wave{{times.data(), count}, {values.data(), count}};
  if (count < 6 || !wave.value.allFinite()) return {};

  gsl_multimin_function misfit{
      [](const gsl_vector* at, void* data) {
        return static_cast<const DecayingWave*>(data)->fitted(gsl_vector_get(at, 0), gsl_vector_get(at, 1)).misfit;
      },
      2, const_cast<DecayingWave*>(&wave)};
  const std::unique_ptr<gsl_vector, decltype(&gsl_vector_free)> start(gsl_vector_calloc(2), gsl_vector_free),
      size(gsl_vector_alloc(2), gsl_vector_free);
  gsl_vector_set(start.get(), 0, omega_near);
  gsl_vector_set_all(size.get(), omega_near / 20);
  const std::unique_ptr<gsl_multimin_fminimizer, decltype(&gsl_multimin_fminimizer_free)> search(
      gsl_multimin_fminimizer_alloc(gsl_multimin_fminimizer_nmsimplex2, 2), gsl_multimin_fminimizer_free);
  gsl_multimin_fminimizer_set(search.get(), &misfit, start.get(), size.get());
  constexpr int most_steps = 500;
  for (int k = 0; k < most_steps; ++k) {
    if (gsl_multimin_fminimizer_iterate(search.get()) != GSL_SUCCESS) return {};
    if (gsl_multimin_fminimizer_size(search.get()) < 1e-7 * omega_near) {
      const double omega = gsl_vector_get(search->x, 0), decay = gsl_vector_get(search->x, 1);
      return {.omega = omega, .decay = decay, .at_start = wave.fitted(omega, decay).factors[0]};
    }
  }
  return {};
}

}  // namespace touchstone::vnv

#pragma once
#include "reference/refuse.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <numbers>

namespace touchstone::reference {

/// Steady flow in a unit square whose lid, y = 1, slides along +x at speed 1, by Chebyshev collocation of the stream
/// function psi of degree N in x and y: u = psi_y, v = -psi_x, and
///     laplacian² psi = Re (psi_y laplacian psi_x - psi_x laplacian psi_y),
/// psi = 0 and no slip on all walls. What the lid's speed jumps by at either end is Stokes flow between a wall and a
/// blade that scrapes it (Taylor 1962; Batchelor 1967, section 4.8), psi ~ r f(theta). It is subtracted, as by Botella
/// & Peyret (Comput. Fluids 27, 1998, 421), so that what is left is smooth enough for a polynomial. Newton's method
/// starts at rest or at the flow of a smaller Reynolds number. Memory grows as N^4, time as N^6: 5 s at N = 48, 1 min
/// at 64. Throws std::domain_error unless Re is positive, 8 <= N <= 128, and Newton's method converges.
class LidDrivenCavity {
 public:
  LidDrivenCavity(double Re, int N) : LidDrivenCavity(Re, N, Matrix::Zero(N + 1, N + 1)) {}
  /// From the flow of another Reynolds number, of the same degree.
  LidDrivenCavity(double Re, const LidDrivenCavity& start) : LidDrivenCavity(Re, start.N_, start.psi_) {}

  double u(double x, double y) const {
    return weights(x).dot(psi_ * D_.transpose() * weights(y)) + scraped(x, y).psi_y;
  }
  double v(double x, double y) const { return -weights(x).dot(D_ * psi_ * weights(y)) - scraped(x, y).psi_x; }

 private:
  using Matrix = Eigen::MatrixXd;
  using Vector = Eigen::VectorXd;

  /// A stream function and its derivatives at a point.
  struct Local {
    double psi = 0, psi_x = 0, psi_y = 0, laplacian_x = 0, laplacian_y = 0;
  };

  /// Stokes flow between a wall along a = 0 and a plane along b = 0 that moves at speed 1 along a; no slip on both.
  static Local scraper(double a, double b) {
    constexpr double pi = std::numbers::pi, C = 1 / (1 - pi * pi / 4), D = C * pi / 2, B = -D * pi / 2;
    const double theta = std::atan2(b, a), r2 = a * a + b * b, g = C * a + D * b;
    const double laplacian = 2 * (D * a - C * b) / r2;
    return {B * b + g * theta, C * theta - g * b / r2, B + D * theta + g * a / r2, 2 * (D - laplacian * a) / r2,
            -2 * (C + laplacian * b) / r2};
  }
  /// Of both ends of the lid; the ends themselves have no value.
  static Local scraped(double x, double y) {
    if (y == 1 && (x == 0 || x == 1)) return {};
    const Local left = scraper(x, 1 - y), right = scraper(1 - x, 1 - y);
    return {-left.psi - right.psi, right.psi_x - left.psi_x, left.psi_y + right.psi_y,
            right.laplacian_x - left.laplacian_x, left.laplacian_y + right.laplacian_y};
  }

  LidDrivenCavity(double Re, int N, Matrix start) : N_(N), x_(N + 1), D_(N + 1, N + 1), psi_(std::move(start)) {
    require_positive("LidDrivenCavity", {{"Re", Re}});
    if (N < 8 || N > 128) refuse("LidDrivenCavity", "N", N, "a degree of 8 to 128");
    differentiate();
    solve(Re);
  }

  /// Nodes and the matrix of the first derivative, by the cosines' differences as products and rows that sum to 0.
  void differentiate() {
    constexpr double pi = std::numbers::pi;
    for (int i = 0; i <= N_; ++i) {
      x_[i] = (1 + std::cos(pi * i / N_)) / 2;
      for (int j = 0; j <= N_; ++j)
        if (i != j)
          D_(i, j) = scale(j) / scale(i) / (std::sin(pi * (i + j) / (2 * N_)) * std::sin(pi * (j - i) / (2 * N_)));
      D_(i, i) = 0;
      D_(i, i) = -D_.row(i).sum();
    }
  }
  double scale(int i) const { return (i % 2 ? -1 : 1) * (i == 0 || i == N_ ? 0.5 : 1); }

  /// Of the values at the nodes, in a polynomial's value at s (barycentric: Berrut & Trefethen 2004).
  Vector weights(double s) const {
    Vector weights(N_ + 1);
    for (int i = 0; i <= N_; ++i) {
      if (s == x_[i]) return Vector::Unit(N_ + 1, i);
      weights[i] = scale(i) / (s - x_[i]);
    }
    return weights / weights.sum();
  }

  void solve(double Re) {
    const int n = N_ + 1;
    const Matrix D2 = D_ * D_, D3 = D2 * D_, D4 = D2 * D2;
    const auto of_scraped = [&](double Local::*member) {
      return Matrix::NullaryExpr(n, n, [&, member](auto i, auto j) { return scraped(x_[i], x_[j]).*member; }).eval();
    };
    const Matrix psi_0 = of_scraped(&Local::psi), psi_x_0 = of_scraped(&Local::psi_x),
                 psi_y_0 = of_scraped(&Local::psi_y), laplacian_x_0 = of_scraped(&Local::laplacian_x),
                 laplacian_y_0 = of_scraped(&Local::laplacian_y);
    Matrix jacobian(n * n, n * n);
    Vector residual(n * n);
    for (int iteration = 0; iteration < 30; ++iteration) {
      const Matrix psi_x = D_ * psi_ + psi_x_0, psi_y = psi_ * D_.transpose() + psi_y_0;
      const Matrix laplacian_x = D3 * psi_ + D_ * psi_ * D2.transpose() + laplacian_x_0;
      const Matrix laplacian_y = psi_ * D3.transpose() + D2 * psi_ * D_.transpose() + laplacian_y_0;
      const Matrix bilaplacian = D4 * psi_ + psi_ * D4.transpose() + 2 * D2 * psi_ * D2.transpose();
      jacobian.setZero();
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
          const int row = j * n + i, wall_i = i == 1 ? 0 : N_, wall_j = j == 1 ? 0 : N_;
          const auto by = [&](int p, int q) -> double& { return jacobian(row, q * n + p); };
          if (i % N_ == 0 || j % N_ == 0) {  // no flow through the walls
            by(i, j) = 1;
            residual[row] = psi_(i, j) + psi_0(i, j);
          } else if (i == 1 || i == N_ - 1) {  // the nodes beside them state no slip
            for (int p = 0; p < n; ++p) by(p, j) = D_(wall_i, p);
            residual[row] = psi_x(wall_i, j);
          } else if (j == 1 || j == N_ - 1) {
            for (int q = 0; q < n; ++q) by(i, q) = D_(wall_j, q);
            residual[row] = psi_y(i, wall_j) - (wall_j == 0 ? 1 : 0);
          } else {
            residual[row] = bilaplacian(i, j) / Re - psi_y(i, j) * laplacian_x(i, j) + psi_x(i, j) * laplacian_y(i, j);
            for (int q = 0; q < n; ++q)
              for (int p = 0; p < n; ++p)
                by(p, q) = 2 * D2(i, p) * D2(j, q) / Re - psi_y(i, j) * D_(i, p) * D2(j, q) +
                           psi_x(i, j) * D2(i, p) * D_(j, q);
            for (int p = 0; p < n; ++p) {
              by(p, j) += D4(i, p) / Re - psi_y(i, j) * D3(i, p) + laplacian_y(i, j) * D_(i, p);
              by(i, p) += D4(j, p) / Re + psi_x(i, j) * D3(j, p) - laplacian_x(i, j) * D_(j, p);
            }
          }
        }
      const Vector change = Eigen::PartialPivLU<Eigen::Ref<Matrix>>(jacobian).solve(residual);
      psi_ -= change.reshaped(n, n);
      if (change.cwiseAbs().maxCoeff() < 1e-9) return;  // it squares: the next one would be round-off
    }
    refuse("LidDrivenCavity", "Re", Re, "one that Newton's method reaches from its start");
  }

  int N_;
  Vector x_;    // from 1 down to 0
  Matrix D_;    // derivative at the nodes
  Matrix psi_;  // (i, j): at x_i, y_j, less what is scraped
};

}  // namespace touchstone::reference

#pragma once
#include "reference/refuse.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <numbers>
#include <optional>

namespace touchstone::reference {

/// Steady flow in a unit square whose lid, y = 1, slides along +x at speed 1, by Chebyshev collocation of the stream
/// function psi of degree N in x and y: u = psi_y, v = -psi_x, and
///     laplacian² psi = Re (psi_y laplacian psi_x - psi_x laplacian psi_y),
/// psi = 0 and no slip on all walls. What the lid's speed jumps by at either end is Stokes flow between a wall and a
/// blade that scrapes it (Taylor 1962; Batchelor 1967, section 4.8), psi ~ r f(theta). It is subtracted, as by Botella
/// & Peyret (Comput. Fluids 27, 1998, 421), so that what is left is smooth enough for a polynomial. Newton's method
/// starts at rest or at the flow of another Reynolds number or degree. Memory grows as N^4, time as N^6: 1 s at N = 48,
/// 1 min at 96. Throws std::domain_error unless Re is positive, 8 <= N <= 128, and Newton's method converges.
class LidDrivenCavity {
 public:
  LidDrivenCavity(double Re, int N) : LidDrivenCavity(Re, N, Matrix::Zero(N + 1, N + 1)) {}
  /// From the flow of another Reynolds number or degree.
  LidDrivenCavity(double Re, int N, const LidDrivenCavity& start) : LidDrivenCavity(Re, N, start.at_nodes_of(N)) {}

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
      x_[i] = node(i, N_);
      for (int j = 0; j <= N_; ++j)
        if (i != j)
          D_(i, j) = scale(j) / scale(i) / (std::sin(pi * (i + j) / (2 * N_)) * std::sin(pi * (j - i) / (2 * N_)));
      D_(i, i) = 0;
      D_(i, i) = -D_.row(i).sum();
    }
    D2_ = D_ * D_, D3_ = D2_ * D_, D4_ = D2_ * D2_;
  }
  static double node(int i, int N) { return (1 + std::cos(std::numbers::pi * i / N)) / 2; }
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

  /// What is left at the nodes of another degree.
  Matrix at_nodes_of(int N) const {
    if (N == N_) return psi_;
    Matrix to(N + 1, N_ + 1);
    for (int i = 0; i <= N; ++i) to.row(i) = weights(node(i, N)).transpose();
    return to * psi_ * to.transpose();
  }

  /// A stream function and its derivatives at the nodes.
  struct Nodal {
    Matrix psi, psi_x, psi_y, laplacian_x, laplacian_y;
  };
  Nodal scraped_at_nodes() const {
    const auto of = [&](double Local::*member) -> Matrix {
      return Matrix::NullaryExpr(N_ + 1, N_ + 1, [&, member](auto i, auto j) { return scraped(x_[i], x_[j]).*member; });
    };
    return {of(&Local::psi), of(&Local::psi_x), of(&Local::psi_y), of(&Local::laplacian_x), of(&Local::laplacian_y)};
  }
  Nodal with(const Nodal& scraped) const {
    return {psi_ + scraped.psi, D_ * psi_ + scraped.psi_x, psi_ * D_.transpose() + scraped.psi_y,
            D3_ * psi_ + D_ * psi_ * D2_.transpose() + scraped.laplacian_x,
            psi_ * D3_.transpose() + D2_ * psi_ * D_.transpose() + scraped.laplacian_y};
  }

  bool is_wall(int i) const { return i % N_ == 0; }
  bool is_beside_wall(int i) const { return i == 1 || i == N_ - 1; }
  int wall_beside(int i) const { return i == 1 ? 0 : N_; }

  /// No flow through the walls; the nodes beside them state no slip; in the others, the equation.
  Matrix residual(const Nodal& at, double Re) const {
    // What is scraped is biharmonic.
    const Matrix bilaplacian = D4_ * psi_ + psi_ * D4_.transpose() + 2 * D2_ * psi_ * D2_.transpose();
    Matrix residual(N_ + 1, N_ + 1);
    for (int j = 0; j <= N_; ++j)
      for (int i = 0; i <= N_; ++i) {
        if (is_wall(i) || is_wall(j))
          residual(i, j) = at.psi(i, j);
        else if (is_beside_wall(i))
          residual(i, j) = at.psi_x(wall_beside(i), j);
        else if (is_beside_wall(j))
          residual(i, j) = at.psi_y(i, wall_beside(j)) - (wall_beside(j) == 0 ? 1 : 0);
        else
          residual(i, j) =
              bilaplacian(i, j) / Re - at.psi_y(i, j) * at.laplacian_x(i, j) + at.psi_x(i, j) * at.laplacian_y(i, j);
      }
    return residual;
  }

  /// Of the residual by the values at the nodes, both column by column.
  void linearise(const Nodal& at, double Re, Matrix& jacobian) const {
    const int n = N_ + 1;
    jacobian.setZero();
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const auto by = [&](int p, int q) -> double& { return jacobian(j * n + i, q * n + p); };
        if (is_wall(i) || is_wall(j)) {
          by(i, j) = 1;
        } else if (is_beside_wall(i)) {
          for (int p = 0; p < n; ++p) by(p, j) = D_(wall_beside(i), p);
        } else if (is_beside_wall(j)) {
          for (int q = 0; q < n; ++q) by(i, q) = D_(wall_beside(j), q);
        } else {
          const double psi_x = at.psi_x(i, j), psi_y = at.psi_y(i, j);
          for (int q = 0; q < n; ++q)
            for (int p = 0; p < n; ++p)
              by(p, q) = 2 * D2_(i, p) * D2_(j, q) / Re - psi_y * D_(i, p) * D2_(j, q) + psi_x * D2_(i, p) * D_(j, q);
          for (int p = 0; p < n; ++p) {
            by(p, j) += D4_(i, p) / Re - psi_y * D3_(i, p) + at.laplacian_y(i, j) * D_(i, p);
            by(i, p) += D4_(j, p) / Re + psi_x * D3_(j, p) - at.laplacian_x(i, j) * D_(j, p);
          }
        }
      }
  }

  /// Newton's method, which keeps its factors as long as they take a tenth of what is left: these cost nearly all of
  /// it.
  void solve(double Re) {
    const int n = N_ + 1;
    const Nodal of_scraped = scraped_at_nodes();
    Matrix jacobian(n * n, n * n);
    std::optional<Eigen::PartialPivLU<Eigen::Ref<Matrix>>> factors;
    double last = 0;
    for (int iteration = 0; iteration < 60; ++iteration) {
      const Nodal at = with(of_scraped);
      if (!factors) {
        linearise(at, Re, jacobian);
        factors.emplace(jacobian);
      }
      const Vector change = factors->solve(residual(at, Re).reshaped());
      psi_ -= change.reshaped(n, n);
      const double size = change.cwiseAbs().maxCoeff();
      if (size < 1e-10) return;
      if (!(size < last / 10)) factors.reset();
      last = size;
    }
    refuse("LidDrivenCavity", "Re", Re, "one that Newton's method reaches from its start");
  }

  int N_;
  Vector x_;                 // from 1 down to 0
  Matrix D_, D2_, D3_, D4_;  // derivatives at the nodes
  Matrix psi_;               // (i, j): at x_i, y_j, less what is scraped
};

}  // namespace touchstone::reference

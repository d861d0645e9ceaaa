// Implements decompositions by those of Eigen, which are instantiated here alone.

#include "analysis/numbers/dense.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>

namespace asperity {

CholeskyFactors::CholeskyFactors(const Eigen::MatrixXd& a) : factors_(a) {}

bool CholeskyFactors::is_positive_definite() const { return factors_.info() == Eigen::Success; }

double CholeskyFactors::log_determinant() const {
  return 2.0 * factors_.matrixLLT().diagonal().array().log().sum();
}

Eigen::VectorXd CholeskyFactors::solved(const Eigen::VectorXd& b) const {
  return factors_.solve(b);
}

Eigen::MatrixXd CholeskyFactors::solved_columns(const Eigen::MatrixXd& b) const {
  return factors_.solve(b);
}

Eigen::MatrixXd CholeskyFactors::inverse() const {
  return solved_columns(Eigen::MatrixXd::Identity(factors_.rows(), factors_.cols()));
}

SymmetricFactors::SymmetricFactors(const Eigen::MatrixXd& a) : factors_(a) {}

Eigen::VectorXd SymmetricFactors::pivots() const { return factors_.vectorD(); }

Eigen::VectorXd SymmetricFactors::solved(const Eigen::VectorXd& b) const {
  return factors_.solve(b);
}

Eigen::MatrixXd SymmetricFactors::inverse() const {
  return factors_.solve(Eigen::MatrixXd::Identity(factors_.rows(), factors_.cols()));
}

LeastSquaresFactors::LeastSquaresFactors(const Eigen::MatrixXd& a) : factors_(a) {}

Eigen::Index LeastSquaresFactors::rank() const { return factors_.rank(); }

Eigen::MatrixXd LeastSquaresFactors::basis() const {
  return factors_.householderQ() * Eigen::MatrixXd::Identity(factors_.rows(), factors_.rank());
}

Eigen::VectorXd LeastSquaresFactors::solved(const Eigen::VectorXd& b) const {
  return factors_.solve(b);
}

Eigen::MatrixXd LeastSquaresFactors::solved_columns(const Eigen::MatrixXd& b) const {
  return factors_.solve(b);
}

EigenAxes eigen_axes(const Eigen::MatrixXd& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric);
  return {.values = solver.eigenvalues(),
          .vectors = solver.eigenvectors(),
          .has_converged = solver.info() == Eigen::Success};
}

Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly)
      .eigenvalues();
}

SingularValues singular_value_decomposition(const Eigen::MatrixXd& a) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(a, Eigen::ComputeThinU | Eigen::ComputeThinV);
  return {.values = svd.singularValues(), .u = svd.matrixU(), .v = svd.matrixV()};
}

Eigen::VectorXd singular_values(const Eigen::MatrixXd& a) {
  return Eigen::JacobiSVD<Eigen::MatrixXd>(a).singularValues();
}

Eigen::VectorXd solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return a.partialPivLu().solve(b);
}

Eigen::MatrixXd inverse(const Eigen::MatrixXd& a) { return a.inverse(); }

Eigen::Index rank(const Eigen::MatrixXd& a) { return Eigen::FullPivLU<Eigen::MatrixXd>(a).rank(); }

}  // namespace asperity

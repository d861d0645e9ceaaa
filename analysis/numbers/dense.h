// Decompositions of matrices whose size is known only when they are made: Eigen's, compiled in one source.

#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/QR>

namespace asperity {

/// A = L·Lᵀ of a symmetric positive definite matrix.
class CholeskyFactors final {
 public:
  CholeskyFactors() = default;
  explicit CholeskyFactors(const Eigen::MatrixXd& a);

  /// Nothing below is defined where it is false.
  bool is_positive_definite() const;
  double log_determinant() const;
  /// A⁻¹·b.
  Eigen::VectorXd solved(const Eigen::VectorXd& b) const;
  /// A⁻¹·B.
  Eigen::MatrixXd solved_columns(const Eigen::MatrixXd& b) const;
  Eigen::MatrixXd inverse() const;

 private:
  Eigen::LLT<Eigen::MatrixXd> factors_{};
};

/// A = PᵀL·D·LᵀP of a symmetric matrix that may be indefinite.
class SymmetricFactors final {
 public:
  explicit SymmetricFactors(const Eigen::MatrixXd& a);

  /// The diagonal of D.
  Eigen::VectorXd pivots() const;
  Eigen::VectorXd solved(const Eigen::VectorXd& b) const;
  Eigen::MatrixXd inverse() const;

 private:
  Eigen::LDLT<Eigen::MatrixXd> factors_;
};

/// A·P = Q·R: linear equations by least squares.
class LeastSquaresFactors final {
 public:
  explicit LeastSquaresFactors(const Eigen::MatrixXd& a);

  Eigen::Index rank() const;
  /// An orthonormal basis of the space of A's columns.
  Eigen::MatrixXd basis() const;
  /// The x with the least |A·x − b|.
  Eigen::VectorXd solved(const Eigen::VectorXd& b) const;
  Eigen::MatrixXd solved_columns(const Eigen::MatrixXd& b) const;

 private:
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors_;
};

/// A = V·diag(values)·Vᵀ of a symmetric matrix: eigenvalues in ascending order, their vectors the columns of V.
struct EigenAxes {
  Eigen::VectorXd values{};
  Eigen::MatrixXd vectors{};
  bool has_converged = true;
};
EigenAxes eigen_axes(const Eigen::MatrixXd& symmetric);
/// Without the vectors.
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric);

/// A = U·diag(values)·Vᵀ with as many columns as there are values, in descending order.
struct SingularValues {
  Eigen::VectorXd values{};
  Eigen::MatrixXd u{};
  Eigen::MatrixXd v{};
};
SingularValues singular_value_decomposition(const Eigen::MatrixXd& a);
/// Without the vectors.
Eigen::VectorXd singular_values(const Eigen::MatrixXd& a);

/// Of a square matrix, by elimination with pivots: A⁻¹·b and A⁻¹ of a regular one, and the rank of any.
Eigen::VectorXd solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
Eigen::MatrixXd inverse(const Eigen::MatrixXd& a);
Eigen::Index rank(const Eigen::MatrixXd& a);

}  // namespace asperity

// The place of a value in a matrix, as text for messages.

#pragma once

#include <cmath>
#include <string>

#include <Eigen/Core>

namespace asperity {

/// "row 2, column 0", counted from 0, of the first value that `is_wrong` holds for; empty if there is none.
template <class Matrix, class Predicate>
std::string place_of_first(const Matrix& matrix, const Predicate& is_wrong) {
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    for (Eigen::Index column = 0; column < matrix.cols(); ++column) {
      if (is_wrong(matrix(row, column))) {
        return "row " + std::to_string(row) + ", column " + std::to_string(column);
      }
    }
  }
  return {};
}

/// The same for the first value that is not finite.
template <class Matrix>
std::string place_not_finite(const Matrix& matrix) {
  return place_of_first(matrix, [](double value) { return !std::isfinite(value); });
}

}  // namespace asperity

// Finds the first value, by rows.

#include "analysis/numbers/matrix_place.h"

#include <limits>

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(MatrixPlace, IsThatOfTheFirstByRows) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(3, 2);
  EXPECT_EQ(place_not_finite(matrix), "");
  matrix(2, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(place_not_finite(matrix), "row 2, column 0");
  matrix(1, 1) = std::numeric_limits<double>::infinity();
  EXPECT_EQ(place_not_finite(matrix), "row 1, column 1");
  matrix(0, 1) = -1.0;
  EXPECT_EQ(place_of_first(matrix, [](double value) { return value < 0.0; }), "row 0, column 1");
}

}  // namespace
}  // namespace asperity

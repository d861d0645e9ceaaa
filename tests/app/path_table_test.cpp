// Paths of a probe as tables: what is derived where a table leaves it out.

#include "app/records/path_table.h"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace asperity {
namespace {

constexpr double kTurning_rad_per_s = 0.7;

/// A slow turn about z, 1 ms a row; `sign` of the quaternion in each row.
std::vector<ProbeState> turning_path(const std::vector<int>& signs) {
  std::string tsv = "time_s\tx_m\ty_m\tz_m\tqw\tqx\tqy\tqz\n";
  for (std::size_t row = 0; row < signs.size(); ++row) {
    const double time_s = 1e-3 * static_cast<double>(row);
    const double half_rad = 0.5 * kTurning_rad_per_s * time_s;
    tsv += std::to_string(time_s) + "\t0\t0\t0\t" +
           std::to_string(signs[row] * std::cos(half_rad)) + "\t0\t0\t" +
           std::to_string(signs[row] * std::sin(half_rad)) + '\n';
  }
  return path_in(tsv, "path.tsv");
}

TEST(PathTable, DerivesTheSameTurnOfAQuaternionThatChangesItsSign) {
  const std::vector<ProbeState> plain = turning_path({1, 1, 1, 1, 1, 1, 1, 1});
  const std::vector<ProbeState> flipped = turning_path({1, 1, 1, -1, -1, 1, -1, 1});
  for (std::size_t row = 0; row < plain.size(); ++row) {
    const glm::dvec3& turning = flipped[row].angular_velocity_rad_per_s;
    EXPECT_EQ(turning, plain[row].angular_velocity_rad_per_s) << row;
    EXPECT_NEAR(turning.z, kTurning_rad_per_s, 5e-3) << row;  // six digits in the table
  }
}

}  // namespace
}  // namespace asperity

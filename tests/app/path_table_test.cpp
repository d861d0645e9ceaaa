// Paths of a probe as tables: what is derived where a table leaves it out.

#include "app/records/path_table.h"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/refusal.h"

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

TEST(PathTable, WarnsOfPositionsInMillimetres) {
  const std::string columns = "time_s\tx_m\ty_m\tz_m\n";
  const auto warning = [&](const std::string& rows) {
    return position_warning(path_in(columns + rows, "path.tsv"));
  };
  EXPECT_EQ(warning("0\t0.39\t0\t-0.0005\n0.001\t0\t0\t-0.4\n"), "");
  EXPECT_EQ(warning("0\t0.45\t0\t0\n0.001\t0.025\t0\t-0.5\n"),
            "z_m reaches -0.5 m, farther than a hand moves at a device; if the positions are in "
            "millimetres, divide them by 1000");
}

TEST(PathTable, StatesWhyACellIsNotANumber) {
  const auto refusal = [](const std::string& cell) {
    return refusal_of<std::runtime_error>([&] {
      path_in("time_s\tx_m\ty_m\tz_m\n0\t0\t0\t0\n0.001\t" + cell + "\t0\t0\n", "path.tsv");
    });
  };
  EXPECT_EQ(
      refusal("0,025"),
      "path.tsv:3: the column x_m has \"0,025\", with a decimal comma; write a decimal point");
  EXPECT_EQ(refusal("\u22120.1"),
            "path.tsv:3: the column x_m has \"\u22120.1\", with a minus sign (U+2212); write a "
            "hyphen (-) instead");
  EXPECT_EQ(refusal("left"),
            "path.tsv:3: the column x_m has \"left\", which is not a finite number; correct it");
  EXPECT_EQ(refusal("n/a"), "path.tsv:3: the column x_m has no number; enter one");
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

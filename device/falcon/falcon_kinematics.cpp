// Where a Falcon's grip is, from the angles of its arms, and what its motors do to push it.

#include "device/falcon/falcon_kinematics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace asperity::falcon {
namespace {

// Metres, named as in Stamper's figures; d stands for his d + e.
constexpr double a = 0.060;
constexpr double b = 0.1025;
constexpr double c = 0.01443;
constexpr double d = 0.01125 + 0.01125;
constexpr double f = -0.025;
constexpr double r = 0.040;
constexpr double s = -0.02309;
constexpr double kShoulder_m = r - c;  // from the axis, along a leg's radius
constexpr double kAside_m = s - f;     // across it
constexpr std::array<double, 3> kLegs_rad{105.0 * std::numbers::pi / 180.0,
                                          -15.0 * std::numbers::pi / 180.0,
                                          -135.0 * std::numbers::pi / 180.0};
constexpr double kAngleAtZeroCount_rad = 35.0 * std::numbers::pi / 180.0;
constexpr double kWordPerTorque = -10000.0;

constexpr int kMostSteps = 20;
constexpr double kSmallestStep_m = 1e-15;
constexpr double kLargestResidual_m = 1e-12;
// Below this the rods lie in a plane, or an arm and its rods in a line: no force could be given.
constexpr double kFlattest = 1e-3;

struct Leg {
  glm::dvec3 along{0.0};   // unit vector from the axis to the shoulder
  glm::dvec3 across{0.0};  // and across it
};

Leg leg(std::size_t i) noexcept {
  const double x = std::cos(kLegs_rad[i]);
  const double y = std::sin(kLegs_rad[i]);
  return {.along = {x, y, 0.0}, .across = {-y, x, 0.0}};
}

constexpr glm::dvec3 kUp{0.0, 0.0, 1.0};

struct Rod {
  glm::dvec3 direction{0.0};  // unit vector n from the elbow's knuckle to the grip's
  double too_long_m = 0.0;    // q − b
};

Rod rod(std::size_t i, double theta, const glm::dvec3& p) noexcept {
  const auto [along, across] = leg(i);
  const double u = glm::dot(p, along) - kShoulder_m - a * std::cos(theta);
  const double v = glm::dot(p, across) - kAside_m;
  const double w = p.z - a * std::sin(theta);
  const double rho = std::hypot(u, w);
  const double reach = rho - d;
  const double q = std::hypot(reach, v);
  return {.direction = reach / q * (u / rho * along + w / rho * kUp) + v / q * across,
          .too_long_m = q - b};
}

// x with rows[i]·x = right[i], by Cramer's rule; nothing where the rows lie in a plane.
std::optional<glm::dvec3> solution(const std::array<glm::dvec3, 3>& rows,
                                   const glm::dvec3& right) noexcept {
  const glm::dvec3 bc = glm::cross(rows[1], rows[2]);
  const double volume = glm::dot(rows[0], bc);
  if (!(std::abs(volume) > kFlattest)) return {};
  return (right.x * bc + right.y * glm::cross(rows[2], rows[0]) +
          right.z * glm::cross(rows[0], rows[1])) /
         volume;
}

// The outer of the two points at `radius_m` from three centres: along the line where the three
// meet in a point, in the frame that the centres span.
std::optional<glm::dvec3> outer_meeting_point(const std::array<glm::dvec3, 3>& centres,
                                              double radius_m) noexcept {
  const glm::dvec3 first = centres[1] - centres[0];
  const double i_length = glm::length(first);
  const glm::dvec3 i = first / i_length;
  const glm::dvec3 second = centres[2] - centres[0];
  const double second_along = glm::dot(i, second);
  const glm::dvec3 aside = second - second_along * i;
  const double j_length = glm::length(aside);
  const glm::dvec3 j = aside / j_length;
  const double x = 0.5 * i_length;
  const double y = (glm::dot(second, second) - 2.0 * second_along * x) / (2.0 * j_length);
  const double z_squared = radius_m * radius_m - x * x - y * y;
  if (!(z_squared > 0.0)) return {};
  const glm::dvec3 normal = glm::cross(i, j);
  const double outwards = normal.z > 0.0 ? 1.0 : -1.0;
  return centres[0] + x * i + y * j + outwards * std::sqrt(z_squared) * normal;
}

}  // namespace

ArmAngles_rad angles_at(const std::array<std::int16_t, 3>& counts) noexcept {
  ArmAngles_rad angles{};
  for (std::size_t i = 0; i < 3; ++i) angles[i] = kAngleAtZeroCount_rad + counts[i] * kCount_rad;
  return angles;
}

std::optional<glm::dvec3> position_m(const ArmAngles_rad& angles) noexcept {
  std::array<glm::dvec3, 3> elbows{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [along, across] = leg(i);
    elbows[i] = (kShoulder_m + a * std::cos(angles[i])) * along + kAside_m * across +
                a * std::sin(angles[i]) * kUp;
  }
  std::optional<glm::dvec3> p = outer_meeting_point(elbows, b + d);
  if (!p) return {};
  double residual_m = 0.0;
  for (int step = 0; step < kMostSteps; ++step) {
    std::array<glm::dvec3, 3> directions{};
    glm::dvec3 too_short{0.0};
    for (std::size_t i = 0; i < 3; ++i) {
      const Rod one = rod(i, angles[i], *p);
      directions[i] = one.direction;
      too_short[static_cast<int>(i)] = -one.too_long_m;
    }
    residual_m = glm::length(too_short);
    const std::optional<glm::dvec3> move = solution(directions, too_short);
    if (!move) return {};
    *p += *move;
    if (glm::length(*move) < kSmallestStep_m) break;
  }
  // Not a number fails this comparison too.
  if (!(residual_m < kLargestResidual_m)) return {};
  return p;
}

std::optional<glm::dvec3> torques_N_m(const ArmAngles_rad& angles, const glm::dvec3& position_m,
                                      const glm::dvec3& force_N) noexcept {
  // F = Σ τ_i n_i/(n_i·e_i): columns n_i and unknowns τ_i/(n_i·e_i).
  std::array<glm::dvec3, 3> rows{};
  glm::dvec3 leverage{0.0};
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 n = rod(i, angles[i], position_m).direction;
    const glm::dvec3 e = a * (-std::sin(angles[i]) * leg(i).along + std::cos(angles[i]) * kUp);
    leverage[static_cast<int>(i)] = glm::dot(n, e);
    for (int axis = 0; axis < 3; ++axis)
      rows[static_cast<std::size_t>(axis)][static_cast<int>(i)] = n[axis];
  }
  const std::optional<glm::dvec3> pushes_N = solution(rows, force_N);
  if (!pushes_N) return {};
  return *pushes_N * leverage;
}

MotorWords words_for(const glm::dvec3& torques_N_m) noexcept {
  const glm::dvec3 wanted = kWordPerTorque * torques_N_m;
  const double largest = std::max({std::abs(wanted.x), std::abs(wanted.y), std::abs(wanted.z)});
  MotorWords motors{};
  if (!std::isfinite(wanted.x) || !std::isfinite(wanted.y) || !std::isfinite(wanted.z)) {
    return {.words = {}, .part = 0.0};
  }
  if (largest > kLargestWord) motors.part = kLargestWord / largest;
  for (int i = 0; i < 3; ++i) {
    motors.words[static_cast<std::size_t>(i)] =
        static_cast<std::int16_t>(std::lround(motors.part * wanted[i]));
  }
  return motors;
}

}  // namespace asperity::falcon

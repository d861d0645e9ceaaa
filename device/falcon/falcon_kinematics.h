// Where a Falcon's grip is, from the angles of its arms, and what its motors do to push it.

#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <glm/vec3.hpp>

namespace asperity::falcon {

/// Three legs around the z axis, each an arm of length a that a motor turns by θ and a parallelogram
/// of rods of length b; where rods meet arm and grip there is a knuckle, together d = 22.5 mm long.
/// The parallelograms keep the grip from turning, so that each leg holds the grip's point p at
///
///   q(p, θ) = √( (ρ − d)² + V² ) = b,   ρ² = (U − a cos θ)² + (W − a sin θ)²
///
/// where U, V, W are p along the leg's radius (from the shoulder), across it, and along z. That is a
/// torus about the elbow, and a sphere of radius b only where there is no knuckle (d = 0).
///
/// `position_m` is exact, and a function of the three angles alone: it starts at the point where the
/// three spheres of radius b + d meet, in closed form, and refines it by Newton's method on the three
/// equations above until the step is below 1 fm. Nothing of the last reading enters, so it lags
/// behind nothing. The spheres alone would be off by millimetres at the edge of the workspace.
///
/// ∇q = n is the unit vector along a rod: a leg can only push along its rods. With e = dp/dθ of the
/// elbow, n·dp = n·e dθ; so F = Σ τ n/(n·e), and the torques for a force are this system's solution.
///
/// Frame: the machine's own. z out of the cone towards the hand, y up, x to the right as the hand
/// sees it; the origin in the plane of the shoulders. Metres, newtons.
///
/// Real-time: does not allocate, lock or throw.
///
/// [Stamper 1997] Stamper: A three degree of freedom parallel manipulator with only translational
/// degrees of freedom. The lengths are those that the open-source drivers use; no unit was measured.
using ArmAngles_rad = std::array<double, 3>;

/// The arms at encoder counts, which are zero at the end that homing finds.
ArmAngles_rad angles_at(const std::array<std::int16_t, 3>& counts) noexcept;
/// One count of an encoder.
inline constexpr double kCount_rad = (0.01425 / 0.110) * 2.0 * 3.14159265358979323846 / 1280.0;

/// Nothing for angles at which the legs do not meet, or meet where they cannot push.
std::optional<glm::dvec3> position_m(const ArmAngles_rad& angles) noexcept;

/// The motors' torques for `force_N` on the hand; nothing where the legs cannot give it.
std::optional<glm::dvec3> torques_N_m(const ArmAngles_rad& angles, const glm::dvec3& position_m,
                                      const glm::dvec3& force_N) noexcept;

/// The strongest word that a motor is given.
inline constexpr int kLargestWord = 4096;

struct MotorWords {
  std::array<std::int16_t, 3> words{};
  /// 1, or the part of the torques that fitted: all three are shortened alike, so that the force
  /// keeps its direction.
  double part = 1.0;
};

/// Torques in the motors' own units, −10 000 per N·m, never above kLargestWord; zero for torques that
/// are not finite.
MotorWords words_for(const glm::dvec3& torques_N_m) noexcept;

}  // namespace asperity::falcon

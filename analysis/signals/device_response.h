// Properties of a device from its motion under known forces: delay, mass, friction, damping, resonance.

#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace asperity {

/// Positions of a device along one axis and the forces on it, at the same times.
struct ForcedMotion {
  std::vector<double> time_s{};
  std::vector<double> position_m{};
  std::vector<double> force_N{};
};

/// The force of a slow sweep to and fro, from legs in both directions at one speed:
///
///   F = K·x + c ± H     + for rising positions, − for falling ones
///
/// H is Coulomb friction and every other resistance to motion at this speed.
struct SweepResponse {
  double speed_m_per_s = 0.0;      ///< the mean of the legs' speeds, slopes of position over time
  double resistance_N = 0.0;       ///< H
  double stiffness_N_per_m = 0.0;  ///< K, of everything that holds the device
  double offset_N = 0.0;           ///< c
};
/// Least squares over all samples. Empty if one direction is missing or a leg does not move.
/// Errors: std::invalid_argument for columns of one leg that differ in length.
std::optional<SweepResponse> sweep_response(const std::vector<ForcedMotion>& legs);

/// How uneven the motion of sweeps is: the standard deviation of the positions from the straight line of each leg, pooled.
/// A handle that swings on its support while it is swept has forces of inertia, which sweep_response would take for resistance.
/// Empty without a leg of three samples.
/// Errors: those of sweep_response.
std::optional<double> unevenness_m(const std::vector<ForcedMotion>& legs);

/// The resistance to motion, from sweeps at two speeds: H = F_c + b′·v. If positions are read L after the
/// force, then b′ = b + K·L with the damping b: at speed v the spring K is read at x − v·L, so that it appears to
/// take K·v·L more. A force that is held for T after its reading acts at x + v·T/2 in the mean: b′ = b + K·(L + T/2).
struct Resistance {
  double friction_N = 0.0;         ///< F_c, not below 0
  double growth_N_s_per_m = 0.0;   ///< b′
  double stiffness_N_per_m = 0.0;  ///< K, the mean of both sweeps
  double offset_N = 0.0;           ///< c, the mean of both sweeps
  double held_s = 0.0;             ///< T
  double damping_N_s_per_m(double delay_s) const noexcept {
    return growth_N_s_per_m - stiffness_N_per_m * (delay_s + 0.5 * held_s);
  }
};
/// Empty for equal speeds.
std::optional<Resistance> resistance_of(const SweepResponse& slow, const SweepResponse& fast);

/// One push by a force step on a device at rest, from the first tick with the force.
struct Push {
  double direction = 1.0;        ///< 1 or −1, along the axis
  double rested_at_m = 0.0;      ///< x₀, the position at rest
  std::vector<double> time_s{};  ///< from 0
  std::vector<double> position_m{};
  std::vector<double> force_N{};  ///< of each tick, held until the next
};

struct PushResponse {
  double delay_s = 0.0;  ///< L, from the onset of the force to that of the measured motion
  double mass_kg = 0.0;
};
/// The moving mass and the delay of the readings. With x the motion from rest x₀ and t the time since the onset of the
/// force, m·x″ = F − K·(x₀ + x) − c ∓ F_c − b·x′ integrates twice from rest to
///
///   m·x = ∬(F − K·x₀ − c ∓ F_c) − b·∫x − K·∬x,      measured L later
///
/// where everything except m and L is known from the sweeps. For each L, from 0 to half of the longest push in steps
/// of 0.05 ms, m is that of least squares; the L with the smallest residual is the result. Integration averages noise
/// and steps of the positions, which would hide the onset of a motion: 2 ms could not be distinguished from 3.
///
/// Empty for fewer than ten readings, or if nothing moves in the direction of the force.
/// Errors: std::invalid_argument for columns of one push that differ in length.
std::optional<PushResponse> push_response(const std::vector<Push>& pushes,
                                          const Resistance& resistance);

/// The standard deviation of positions around a smooth motion: residuals of cubics fitted by least squares to
/// windows of kSmoothWindow samples, pooled. Empty for fewer samples than a window.
/// Errors: those of sweep_response.
std::optional<double> position_error_m(const std::vector<ForcedMotion>& legs);
inline constexpr std::size_t kSmoothWindow = 64;

/// The standard deviation σ = q/√12 of errors by rounding to steps of q. A rounding error e is uniform over
/// [−q/2, q/2], so that σ² = ∫ e²/q de = q²/12.
double rounding_error_m(double step_m);
/// The step whose rounding has this error: q = √12·σ.
double step_of_rounding_m(double error_m);

/// The component A of a signal at one frequency, Re(A·exp(iωt)), in addition to a straight line: least
/// squares at the times given. Empty for fewer than eight samples.
std::optional<std::complex<double>> component_at(double frequency_Hz,
                                                 std::span<const double> time_s,
                                                 std::span<const double> values);

/// Positions over force at one frequency.
struct FrequencyResponse {
  double frequency_Hz = 0.0;
  double response_m_per_N = 0.0;  ///< |X/F|, amplitude over amplitude
};
/// |X/F| from `component_at` of positions and forces. Empty where one of them is, or |F| is below `least_force_N`: for
/// instance if a limiter removed the tone.
std::optional<FrequencyResponse> frequency_response(double frequency_Hz, const ForcedMotion& motion,
                                                    double least_force_N);

/// The frequency at which a device responds more strongly than its mass alone, for which ω²|X/F| = 1/m at all
/// frequencies: the largest ω²|X/F| if it is at least twice the median and not at an end of the list, refined
/// by a parabola over log f. Frequencies ascend. Empty if there is none.
std::optional<double> resonance_Hz(const std::vector<FrequencyResponse>& responses);

/// Whether positions vary more than those of a device at rest: by more than 0.1 mm and more than four of its steps q,
/// from the lowest to the highest.
bool is_swinging(std::span<const double> position_m, double step_m);

/// A push by a constant force on a mass that a spring holds.
struct HeldPush {
  double force_N = 0.0;
  double duration_s = 0.0;
  double mass_kg = 1.0;
  double stiffness_N_per_m = 0.0;
};
/// An estimate of its motion without friction: F·min(t²/2m, 1/K), the free motion ½(F/m)·t² or the deflection F/K of
/// the spring at equilibrium, whichever is smaller.
double motion_without_friction_m(const HeldPush& push);

/// Pushes of equal length with pauses of that length between them, alternately forward and backward: push k begins at
/// first_s + 2k·length_s.
struct PushTrain {
  double first_s = 0.0;
  double length_s = 0.0;
  int pushes = 0;
};
/// The mean motion during a push, in its direction: the mean position in the last `judged_s` of the push minus that in
/// the last `judged_s` before it. Pushes without readings in both are left out; empty if all are.
/// Errors: std::invalid_argument for columns that differ in length.
std::optional<double> mean_motion_m(const PushTrain& train, const ForcedMotion& motion,
                                    double judged_s);

/// Counts of which a mean motion consists.
struct MotionReadings {
  int pushes = 1;
  int each = 1;  ///< readings before each push, and at its end
};
/// Four standard errors of a mean motion of positions in steps of q: a larger motion is not explained by rounding.
/// The mean of n readings has the variance σ²/n, the difference of two such means 2σ²/n, its mean over k pushes
/// 2σ²/(nk), with σ of `rounding_error_m`.
double four_standard_errors_m(double step_m, const MotionReadings& readings);

}  // namespace asperity

// What the motion of a pushed device says about it: delay, mass, friction, damping, resonance.

#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace asperity {

/// How a device at rest answers to a force that is suddenly there.
struct PushResponse {
  double delay_s = 0.0;  ///< from the force's beginning to the motion's, as positions tell it
  double acceleration_m_per_s2 = 0.0;  ///< at that moment
};

/// Fits x(t) = 0 before the delay L and a₂τ² + a₃τ³ + … + a₆τ⁶ with τ = t − L after it, which is how the
/// motion of any smooth mechanism begins that is pushed at rest; the acceleration is 2a₂. Least squares over
/// all samples of all pushes together, L by steps of 0.05 ms from 0 to half of the longest time.
///
/// `since_push_s` and `moved_m` belong together, in any order; times below 0 are left out. Nothing for fewer
/// than ten samples, or where nothing moves forward.
/// Errors: std::invalid_argument when the spans differ in length.
std::optional<PushResponse> push_response(std::span<const double> since_push_s,
                                          std::span<const double> moved_m);

/// One leg of a slow sweep to and fro: the device moves at a steady speed, and the force that it takes.
struct SweepLeg {
  std::vector<double> time_s{};
  std::vector<double> position_m{};
  std::vector<double> force_N{};
};

/// What a sweep takes, from legs in both directions at one speed:
///
///   F = K·x + c ± H     + on the way up, − on the way back
///
/// H is Coulomb's friction and whatever else stands against motion at this speed.
struct SweepResponse {
  double speed_m_per_s = 0.0;      ///< mean of the legs' own, of positions over time
  double resistance_N = 0.0;       ///< H
  double stiffness_N_per_m = 0.0;  ///< K, of whatever holds the device
};
/// Least squares over all samples. Nothing where one direction is missing or nothing moves.
/// Errors: std::invalid_argument for columns of one leg that differ in length.
std::optional<SweepResponse> sweep_response(const std::vector<SweepLeg>& legs);

/// Resistance at two speeds, H = F_c + b·v.
struct Resistance {
  double friction_N = 0.0;         ///< F_c, not below 0
  double damping_N_s_per_m = 0.0;  ///< b
};
/// `delay_s` is that of positions behind the force: on a stiffness K it looks like a damping of K·delay,
/// which is taken out again. Nothing for equal speeds.
std::optional<Resistance> resistance_of(const SweepResponse& slow, const SweepResponse& fast,
                                        double delay_s);

/// The standard deviation of positions about a smooth motion: residuals of cubics fitted by least squares to
/// windows of kSmoothWindow samples, pooled. Nothing for fewer samples than a window.
/// Errors: as sweep_response.
std::optional<double> position_error_m(const std::vector<SweepLeg>& legs);
inline constexpr std::size_t kSmoothWindow = 64;

/// The component of a signal at one frequency, A in Re(A·exp(iωt)), beside a straight line: least
/// squares at the times given. Nothing for fewer than eight samples.
std::optional<std::complex<double>> component_at(double frequency_Hz,
                                                 std::span<const double> time_s,
                                                 std::span<const double> values);

/// Positions over force at one frequency.
struct FrequencyResponse {
  double frequency_Hz = 0.0;
  double response_m_per_N = 0.0;  ///< amplitude over amplitude
};
/// The frequency at which a device answers more than its mass alone would: the largest ω²|X/F| that is
/// at least twice the median of all of them and no end of the list, refined by a parabola over log f.
/// Frequencies ascend. Nothing where there is none.
std::optional<double> resonance_Hz(const std::vector<FrequencyResponse>& responses);

}  // namespace asperity

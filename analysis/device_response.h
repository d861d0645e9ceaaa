// What the motion of a pushed device says about it: delay, mass, friction, damping, resonance.

#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace asperity {

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
  double offset_N = 0.0;           ///< c
};
/// Least squares over all samples. Nothing where one direction is missing or nothing moves.
/// Errors: std::invalid_argument for columns of one leg that differ in length.
std::optional<SweepResponse> sweep_response(const std::vector<SweepLeg>& legs);

/// What stands against a device's motion, from sweeps at two speeds: H = F_c + b′·v, where positions
/// that are L behind the force make b′ = b + K·L of the damping b.
struct Resistance {
  double friction_N = 0.0;         ///< F_c, not below 0
  double growth_N_s_per_m = 0.0;   ///< b′
  double stiffness_N_per_m = 0.0;  ///< K, the mean of both sweeps
  double offset_N = 0.0;           ///< c, likewise
  double damping_N_s_per_m(double delay_s) const noexcept {
    return growth_N_s_per_m - stiffness_N_per_m * delay_s;
  }
};
/// Nothing for equal speeds.
std::optional<Resistance> resistance_of(const SweepResponse& slow, const SweepResponse& fast);

/// One sudden push of a device at rest, from the tick that first had the force on.
struct Push {
  double direction = 1.0;        ///< 1 or −1, along the axis
  double rested_at_m = 0.0;      ///< where it was read before
  std::vector<double> time_s{};  ///< from 0
  std::vector<double> position_m{};
  std::vector<double> force_N{};  ///< of each tick, held until the next
};

struct PushResponse {
  double delay_s = 0.0;  ///< L, from the force's beginning to the motion's, as positions tell it
  double mass_kg = 0.0;
};
/// What moves, and how late it is read. With x the motion since the rest x₀, in the time t of the force,
///
///   m·x = ∬(F − K·x₀ − c ∓ F_c) − b·∫x − K·∬x,      read L later
///
/// where all but m and L is known from the sweeps. For each L, from 0 to half of the longest push by steps
/// of 0.05 ms, m is that of least squares; the L that leaves least holds. Integrals smooth what noise and
/// steps the positions have; the beginning of a motion alone would not tell 2 ms from 3.
///
/// Nothing for fewer than ten readings, or where nothing moves forward.
/// Errors: std::invalid_argument for columns of one push that differ in length.
std::optional<PushResponse> push_response(const std::vector<Push>& pushes,
                                          const Resistance& resistance);

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

// Butterworth filters that run forward, sample by sample, and over whole signals.

#pragma once

#include <array>
#include <span>
#include <vector>

namespace asperity {

/// What may pass a filter. `order` is the slope of an edge in units of 6 dB per octave, 1 to 8; a
/// band-pass has it at both edges. At a cut-off the gain is √½ (−3.01 dB).
struct LowPass {
  int order = 2;
  double cutoff_Hz = 0.0;
};
struct HighPass {
  int order = 2;
  double cutoff_Hz = 0.0;
};
struct BandPass {
  int order = 2;
  double low_Hz = 0.0;
  double high_Hz = 0.0;
};

/// A Butterworth filter: the analogue prototype with poles on a circle, moved to its band, made
/// digital by the bilinear transform with its cut-offs kept in place, and run as a cascade of
/// second-order sections.
///
///   |H(f)|² = 1 / (1 + (w/w_c)²ᴺ), w = tan(π·f/rate), for a low-pass of order N.
///
/// It is causal: it runs forward only, starts at rest and delays what passes. The rate may be in
/// any unit that the cut-offs share; over distance it is samples per metre.
///
/// Errors: std::invalid_argument for an order outside 1 to 8, and for cut-offs that are not in
/// increasing order between 0 and half the rate.
///
/// Real-time: `next` and `reset` do not allocate, lock or throw.
class ButterworthFilter final {
 public:
  ButterworthFilter(const LowPass& band, double rate_Hz);
  ButterworthFilter(const HighPass& band, double rate_Hz);
  ButterworthFilter(const BandPass& band, double rate_Hz);

  double next(double sample) noexcept;
  /// Back to rest, as after construction.
  void reset() noexcept;

  /// |H| at a frequency.
  double gain(double frequency_Hz) const noexcept;

 private:
  // Transposed direct form II: y = b0·x + s0; s0 = b1·x − a1·y + s1; s1 = b2·x − a2·y.
  struct Section {
    std::array<double, 3> b{};
    std::array<double, 2> a{};
    std::array<double, 2> state{};
  };
  double rate_Hz_ = 0.0;
  std::vector<Section> sections_{};

  struct Prototype;
  void build(const Prototype& prototype);
};

/// The whole signal through the filter, from rest.
std::vector<double> filtered(ButterworthFilter filter, std::span<const double> signal);

/// The whole signal through a low-pass forward and then backward: without delay, with the gain |H|² of the filter (½ at its
/// cut-off). Both ends are extended by one period of the cut-off, reflected about the end in time and in value, so that a
/// signal with a constant slope passes unchanged there too.
///
/// Errors: as ButterworthFilter.
std::vector<double> filtered_without_delay(const LowPass& band, double rate_Hz,
                                           std::span<const double> signal);

}  // namespace asperity

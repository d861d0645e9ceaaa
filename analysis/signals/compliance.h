// Whether a hand did what it was asked to: quantities against a band, strokes, speed.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "analysis/numbers/summary.h"

namespace asperity {

/// What was asked of one quantity; an absent end is open, a present one belongs to the band.
struct AskedBand {
  std::optional<double> minimum{};
  std::optional<double> maximum{};
};

/// Whether a value belongs to the band.
bool is_inside(const AskedBand& band, double value) noexcept;

/// What one quantity was, and how often it was inside its band.
///
/// The live display and the later analysis call this with the same samples in the same order, as
/// they stand in the recording; then every number is the same to the bit (see Summary).
struct Compliance {
  Summary summary{};
  /// Samples inside divided by all samples; absent when the band is open at both ends.
  std::optional<double> fraction_inside{};
};

/// Nothing for no samples. Throws std::invalid_argument for a sample that is not finite and for a
/// band whose minimum is above its maximum or not a number.
std::optional<Compliance> compliance_of(std::span<const double> samples, const AskedBand& band);

/// How hard a hand presses on a surface whose texture makes the force ripple.
///
///   p_n = Σ w_i F_i / Σ w_i over the samples i = 1 … n of one contact,
///   w_i = dt_i · Π τ / (τ + dt_j) over j = i + 1 … n,
///
/// F_i the normal force in N, dt_i the time since the sample before in s, τ = 0.2 s: the mean of the
/// contact so far, of which the latest counts most. A steady force is known with its first sample;
/// a ripple of f Hz is left with 1 / (2π f τ) of its amplitude in a contact much longer than τ: 4 mm
/// felt at 60 mm/s ripple at 15 Hz, of which 5 % are left.
class PressingForce final {
 public:
  static constexpr double kMemory_s = 0.2;

  /// The force in N, this sample included. `duration_s` is positive.
  double take(double force_N, double duration_s) noexcept;
  /// The contact is over: the next sample begins another.
  void lift() noexcept { *this = {}; }

 private:
  double weighted_N_s_ = 0.0;
  double weight_s_ = 0.0;
};

/// One passage in one direction: samples `begin` to `end`, both included, of the position.
struct StrokePassage {
  std::size_t begin = 0;
  std::size_t end = 0;
  double length_m = 0.0;  ///< from turning point to turning point, positive forth and negative back
  /// Likewise, a rest at the first of them included; 0 where positions come without their times.
  double duration_s = 0.0;
  double rest_s = 0.0;  ///< what of that was before the hand left the turning point

  /// |length| / duration. Whether a hand glides, speeds up and slows down or follows a steady mark:
  /// as fast as it goes to and fro; a texture's ripple is in none of the two.
  double speed_m_per_s() const noexcept;
};

/// Cuts the position along the direction of stroking at its turning points, sample by sample.
///
/// A turning point is an extreme from which the hand has since come back by `least_length_m` or
/// more, so tremor and noise below that turn nothing. The first stroke begins at the extreme before
/// it. What is shorter than the least length is no stroke. Of equal extremes the first counts. One
/// contact per cutter: a lift is not a stroke.
class StrokeCutter final {
 public:
  static constexpr double kLeastLength_m = 5e-3;
  /// A hand that is as close as this to where it turned has not left it yet.
  static constexpr double kTurn_m = 1e-3;

  explicit StrokeCutter(double least_length_m = kLeastLength_m) noexcept
      : least_length_m_(least_length_m) {}

  /// The stroke whose end this sample shows, if it does. Times never go back.
  std::optional<StrokePassage> take(double position_m, std::int64_t time_ns) noexcept;
  /// The stroke that no turning point has ended, to the extreme that it has reached.
  std::optional<StrokePassage> under_way() const noexcept;
  /// When it reached that extreme; before the first stroke, when the contact began.
  std::int64_t reached_ns() const noexcept;

 private:
  struct Extreme {
    std::size_t sample = 0;
    double at_m = 0.0;
    std::int64_t time_ns = 0;
    std::int64_t left_ns = 0;  ///< the last time within kTurn_m of it
  };
  enum class Going { undecided, forth, back };
  static StrokePassage between(const Extreme& begin, const Extreme& end) noexcept;

  double least_length_m_ = kLeastLength_m;
  // Until the hand has gone the least length, both extremes may become the first turning point;
  // from then on one of them is where the stroke under way began, the other its far end.
  Going going_ = Going::undecided;
  std::size_t samples_ = 0;
  std::int64_t began_ns_ = 0;
  Extreme lowest_{};
  Extreme highest_{};
};

/// The strokes of one contact; the last one ends at the extreme that it reached.
///
/// Throws std::invalid_argument when least_length_m is not positive or a position not finite.
std::vector<StrokePassage> strokes_along(std::span<const double> position_m,
                                         double least_length_m = StrokeCutter::kLeastLength_m);

/// The strokes of a hand over one surface, contact after contact: what bands of speed, length and
/// number are held against, live and from the recording.
///
/// The speed is judged by the stroke. Strokes that the hand itself ended by turning round count; one
/// that was cut off by a lift has no speed of its own (how fast it was so far depends on where it was
/// cut), and counts only where its contact has no other. Its length and number count always.
///
/// Allocates as strokes are added.
class HandStrokes final {
 public:
  /// Longer than this no hand takes to turn round: it rests.
  static constexpr double kTurn_s = 0.75;

  /// `usual_length_m`: of a stroke, before there is one to go by; for `speed_to_tell` alone.
  explicit HandStrokes(double usual_length_m = 0.0) noexcept : usual_length_m_(usual_length_m) {}

  void take(double along_m, std::int64_t time_ns);
  /// The contact is over: the next sample begins another.
  void lift();

  /// Positive, one per stroke; as if the hand lifted now.
  std::vector<double> lengths_m() const;
  /// One per stroke that counts; as if the hand lifted now.
  std::vector<double> speeds_m_per_s() const;

  /// What is to be told of the speed now: 0 where the hand rests, and nothing while it has not
  /// stroked far enough to say. Until the half of a stroke the last one is told of, and from there on
  /// the stroke under way, as if it went on as the last one did:
  ///
  ///   L′ / (r + (t − r) · (T′ − r′) / (t′(l) − r′))
  ///
  /// l how far it has come in the time t, of which r before it left its turn; t′(l) the time in which
  /// the last one had come so far, r′ what of that was before it left, T′ its duration and L′ its
  /// length. So a hand is told the mean of a stroke from its half on, however it speeds up and slows
  /// down, if it does so every time, and whether or not it rested at its turns. A stroke that has no last one in its contact, or is
  /// longer than that, is told as l / t: half-way the mean of the whole, and then up to a fifth above
  /// it (minimum jerk; a sinusoid a seventh).
  std::optional<double> speed_to_tell_m_per_s() const noexcept;

 private:
  /// How far a stroke had come in a time, wherever it came farther than before.
  struct Progress {
    double length_m = 0.0;
    double duration_s = 0.0;
  };

  double usual_length_m_ = 0.0;
  std::vector<double> lengths_m_{};
  std::vector<double> speeds_m_per_s_{};
  std::optional<StrokePassage> last_{};  ///< that turned round, of this contact
  std::vector<Progress> last_progress_{};
  std::vector<Progress> progress_{};  ///< of the stroke under way
  StrokeCutter cutter_{};
  std::int64_t now_ns_ = 0;
};

/// How fast the probe moves along a surface: |v − (v·n)·n|, n the surface's outward unit normal.
double tangential_speed_m_per_s(const std::array<double, 3>& velocity_m_per_s,
                                const std::array<double, 3>& normal) noexcept;

}  // namespace asperity

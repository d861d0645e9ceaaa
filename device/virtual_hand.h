// A hand that strokes as people do, for the simulated device.

#pragma once

#include <array>
#include <atomic>
#include <cstdint>

#include <glm/vec3.hpp>

#include "analysis/numbers/random.h"

namespace asperity {

/// How a hand explores a surface. Deviations are between strokes, and never more than 2.5 standard
/// deviations.
struct HandHabits {
  static constexpr int kMostFurtherCentres = 3;

  glm::dvec3 centre_m{0.0};    ///< middle of the strokes, on the surface
  double direction_rad = 0.0;  ///< of the stroke, from +x towards +y
  double stroke_length_m = 0.060;
  double speed_m_per_s = 0.080;  ///< of the steady middle of a stroke
  /// Part of a stroke's time in which the hand gathers speed, and in which it slows down: above 0, and
  /// at most 0.5, where nothing of the stroke is steady. The mean of a stroke is 1 − gathering of its
  /// steady speed.
  double gathering = 0.15;
  double speed_variation = 0.15;  ///< standard deviation of a stroke's speed, as a fraction
  double normal_force_N = 1.0;
  double force_variation = 0.10;  ///< likewise, of its force
  double drift_m =
      0.004;  ///< standard deviation of a slow wander of the stroke's centre, across and along
  double lift_height_m = 0.010;  ///< how far above the surface the hand waits
  double approach_speed_m_per_s = 0.05;
  /// Surfaces side by side: after `strokes_at_a_centre` strokes the hand lifts and strokes about the next centre, in turn.
  std::array<glm::dvec3, kMostFurtherCentres> further_centres_m{};
  int further_centres = 0;  ///< how many of them there are
  int strokes_at_a_centre = 4;
};

/// What the hand is to do at one instant.
struct HandIntent {
  glm::dvec3 position_m{0.0};
  glm::dvec3 velocity_m_per_s{0.0};
  double press_N = 0.0;  ///< downward force in contact; 0 while lifted
  bool lifted = true;    ///< the hand holds a height; otherwise it presses
};

/// A hand's motion stands still in a gap between two readings beyond this: it does not stroke on while
/// the program is stopped.
inline constexpr std::int64_t kLongestGap_ns = 100'000'000;

/// Waits above the start of its first stroke, comes down, strokes to and fro along a line, lifts
/// again and returns above the start.
///
/// Each time that it comes down, it does so from rest above the start of the first stroke and with the same random
/// numbers, until `set_habits` gives others: its motion does not depend on what it did before. Surfaces that are
/// felt in one attempt are therefore felt in the same way, whatever their order.
///
/// A stroke starts and ends at rest and keeps its speed in between (`gathering`), as a rule for 70 % of
/// its time; its acceleration has no jumps. Each stroke draws its speed and force; the force changes over from
/// the last stroke's while the hand gathers speed. The hand comes down straight, touches at rest and then
/// presses, within 0.15 s; when it is to lift, it releases the surface within 0.15 s and rises, crosses to the
/// start and rests there for 0.3 s, in which the probe comes to rest. When it is to stroke earlier, it
/// does so after that. With further centres it lifts in the same way after its strokes about each of them,
/// and comes down over the next one.
///
/// What the caller may rely on: in contact, along the stroke the hand is never farther from the centre than
/// half the stroke's length and 2.5 drifts, across it never farther than 2.5 drifts (with
/// the defaults 40 mm and 10 mm). The motion is a function of the seed, the habits and the times of
/// the calls; how often `intent` is called in between does not move the strokes.
///
/// It also holds down the requested buttons of the handle, on which nothing of its motion depends.
///
/// Threads: `stroke`, `is_ready`, `lift`, `press`, `release` and `set_habits` from any thread; `intent` and
/// `take_buttons` from the one that reads the device.
///
/// Real-time: `intent` and `take_buttons` do not allocate, lock or throw.
class VirtualHand final {
 public:
  static constexpr int kButtons = 2;

  /// Errors: std::invalid_argument naming the habit that is not positive or finite (variations and
  /// the drift may be zero; a variation is at most 0.3, so that every stroke moves and presses), or beyond its number.
  VirtualHand(const HandHabits& habits, Random random);

  void stroke() noexcept { wants_contact_.store(true, std::memory_order_release); }
  /// Whether the hand rests above the start of its first stroke, from where `stroke` begins at once.
  bool is_ready() const noexcept { return is_ready_.load(std::memory_order_acquire); }
  void lift() noexcept { wants_contact_.store(false, std::memory_order_release); }
  /// Taken up when the hand next waits above the surface. Errors: as the constructor's.
  void set_habits(const HandHabits& habits, const Random& random);

  /// `button` counts from 1. Errors: std::invalid_argument where there is no such button.
  void press(int button);
  void release(int button);
  /// The buttons that are down, as a bit mask, and those that went down and up again since the last
  /// call: a press between two readings is seen in one of them.
  std::uint32_t take_buttons() noexcept;

  /// `time_ns` never goes back.
  HandIntent intent(std::int64_t time_ns) noexcept;

 private:
  enum class Phase { waiting, lowering, stroking, raising, crossing };
  /// From rest to rest along a straight line.
  struct Move {
    glm::dvec3 from_m{0.0};
    glm::dvec3 to_m{0.0};
    std::int64_t began_ns = 0;
    std::int64_t duration_ns = 1;
  };

  void advance_phase() noexcept;
  bool takes_up_new_habits() noexcept;
  void adopt(const HandHabits& habits) noexcept;
  void start_over() noexcept;
  void begin(Phase phase, const glm::dvec3& from_m, const glm::dvec3& to_m, double duration_s,
             std::int64_t began_ns) noexcept;
  void begin_lowering() noexcept;
  void begin_stroke(std::int64_t began_ns) noexcept;
  void begin_raising() noexcept;
  void begin_crossing() noexcept;
  void drift(double duration_s) noexcept;
  double variation(double standard_deviation) noexcept;
  const glm::dvec3& centre_m() const noexcept;
  glm::dvec3 stroke_end_m(double direction) const noexcept;
  glm::dvec3 above_start_m() const noexcept;
  bool rests_above_start() const noexcept;
  HandIntent moving() const noexcept;

  HandHabits habits_{};
  Random random_;
  std::atomic<bool> wants_contact_{false};
  std::atomic<std::uint32_t> buttons_down_{0};
  std::atomic<std::uint32_t> buttons_pressed_{0};  ///< since `take_buttons`

  HandHabits next_habits_{};
  std::atomic<bool> has_next_habits_{false};
  std::atomic_flag next_habits_in_use_{};

  bool started_ = false;
  std::int64_t last_ns_ = 0;
  std::int64_t clock_ns_ = 0;  ///< the hand's own: stands still in long gaps
  Phase phase_ = Phase::waiting;
  Move move_{};
  int centre_ = 0;              ///< of the present strokes: 0, or the number of a further one
  int strokes_here_ = 0;        ///< begun about it since the hand came down
  bool leaves_ = false;         ///< for the next centre
  glm::dvec2 along_{1.0, 0.0};  ///< the line of the strokes
  double direction_ = 1.0;      ///< of the present stroke, +1 or −1 along the line
  double drift_along_m_ = 0.0;
  double drift_across_m_ = 0.0;
  double grip_ = 0.0;  ///< 0 hovering, 1 pressing
  double last_force_N_ = 0.0;
  double stroke_force_N_ = 0.0;
  std::atomic<bool> is_ready_{true};
  Random first_random_;  ///< as it is when the hand comes down
  Random next_random_;   ///< of `next_habits_`
};

}  // namespace asperity

// A hand that strokes as people do, for the simulated device.

#include "device/virtual_hand.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <thread>

#include <glm/geometric.hpp>

#include "device/refusal.h"

namespace asperity {
namespace {

constexpr double kPressing_s = 0.15;       // from touching to the full force, and back
constexpr double kMostGathering = 0.5;     // of a move, half of which slows down
constexpr double kFarthest = 2.5;          // standard deviations; see HandHabits
constexpr double kDriftTime_s = 5.0;       // how long the centre of the strokes remembers
constexpr double kShortestMove_s = 0.050;  // nobody turns round sooner
constexpr double kLargestVariation = 0.3;  // 2.5 of these leave a quarter
constexpr double kCrossing_m_per_s = 0.2;  // in the air
// The probe is then within a nanometre of the hand, where SimulatedDevice lets it rest.
constexpr double kSettling_s = 0.3;

double seconds(std::int64_t duration_ns) noexcept {
  return static_cast<double>(duration_ns) * 1e-9;
}

// 0 to 1 with no slope at either end.
double smooth_step(double u) noexcept { return u * u * (3.0 - 2.0 * u); }

// How far a move of length 1 and duration 1 is, and how fast.
struct Progress {
  double way = 0.0;
  double speed = 0.0;
};

// The speed rises as a smooth step over `gathering`, stays, and falls likewise: the way gathered
// at part u of the rise is ∫(3u² − 2u³)du = u³ − u⁴/2.
Progress progress(double time, double gathering) noexcept {
  const double steady_speed = 1.0 / (1.0 - gathering);
  const auto rise = [gathering, steady_speed](double since) {
    const double u = since / gathering;
    return Progress{.way = steady_speed * gathering * (u * u * u - 0.5 * u * u * u * u),
                    .speed = steady_speed * smooth_step(u)};
  };
  if (time < gathering) {
    return rise(time);
  }
  if (time <= 1.0 - gathering) {
    return {.way = steady_speed * (time - 0.5 * gathering), .speed = steady_speed};
  }
  const Progress left = rise(1.0 - time);
  return {.way = 1.0 - left.way, .speed = left.speed};
}

// How long a move takes whose steady speed is `speed_m_per_s`.
double duration_s(double way_m, double speed_m_per_s, double gathering) noexcept {
  return way_m / (speed_m_per_s * (1.0 - gathering));
}

void check_variation(const char* field, double value) {
  require_not_negative(field, value);
  if (value > kLargestVariation) {
    refuse(field, value, "at most 0.3");
  }
}

std::uint32_t bit_of(int button) {
  if (button < 1 || button > VirtualHand::kButtons) {
    refuse("button of the virtual hand", button, "1 or 2");
  }
  return std::uint32_t{1} << (button - 1);
}

void check_habits(const HandHabits& habits) {
  const auto check_centre = [](const char* field, const glm::dvec3& centre_m) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!std::isfinite(centre_m[axis])) {
        refuse(field, centre_m[axis], "finite");
      }
    }
  };
  check_centre("centre_m of the virtual hand", habits.centre_m);
  if (habits.further_centres < 0 || habits.further_centres > HandHabits::kMostFurtherCentres) {
    refuse("further_centres of the virtual hand", habits.further_centres, "0 to 3");
  }
  for (int i = 0; i < habits.further_centres; ++i) {
    check_centre("further_centres_m of the virtual hand",
                 habits.further_centres_m[static_cast<std::size_t>(i)]);
  }
  require_positive("strokes_at_a_centre of the virtual hand", habits.strokes_at_a_centre);
  if (!std::isfinite(habits.direction_rad)) {
    refuse("direction_rad of the virtual hand", habits.direction_rad, "finite");
  }
  require_positive("stroke_length_m of the virtual hand", habits.stroke_length_m);
  require_positive("speed_m_per_s of the virtual hand", habits.speed_m_per_s);
  require_positive("gathering of the virtual hand", habits.gathering);
  if (habits.gathering > kMostGathering) {
    refuse("gathering of the virtual hand", habits.gathering, "at most 0.5");
  }
  check_variation("speed_variation of the virtual hand", habits.speed_variation);
  require_positive("normal_force_N of the virtual hand", habits.normal_force_N);
  check_variation("force_variation of the virtual hand", habits.force_variation);
  require_not_negative("drift_m of the virtual hand", habits.drift_m);
  require_positive("lift_height_m of the virtual hand", habits.lift_height_m);
  require_positive("approach_speed_m_per_s of the virtual hand", habits.approach_speed_m_per_s);
}

}  // namespace

VirtualHand::VirtualHand(const HandHabits& habits, Random random)
    : random_(random), first_random_(random), next_random_(random) {
  check_habits(habits);
  adopt(habits);
  move_.from_m = above_start_m();
  move_.to_m = move_.from_m;
  move_.began_ns = -move_.duration_ns;  // at rest from the beginning
}

void VirtualHand::set_habits(const HandHabits& habits, const Random& random) {
  check_habits(habits);
  // The other side holds this flag for the time of one copy and never waits for it.
  while (next_habits_in_use_.test_and_set(std::memory_order_acquire)) {
    std::this_thread::yield();
  }
  next_habits_ = habits;
  next_random_ = random;
  has_next_habits_.store(true, std::memory_order_relaxed);
  next_habits_in_use_.clear(std::memory_order_release);
}

// False when they are being written at this moment; the hand then waits for the next call.
bool VirtualHand::takes_up_new_habits() noexcept {
  if (next_habits_in_use_.test_and_set(std::memory_order_acquire)) {
    return false;
  }
  if (has_next_habits_.exchange(false, std::memory_order_relaxed)) {
    adopt(next_habits_);
    first_random_ = next_random_;
    centre_ = 0;
    start_over();
  }
  next_habits_in_use_.clear(std::memory_order_release);
  return true;
}

void VirtualHand::adopt(const HandHabits& habits) noexcept {
  habits_ = habits;
  along_ = {std::cos(habits.direction_rad), std::sin(habits.direction_rad)};
}

// What the hand does next does not depend on its earlier strokes.
void VirtualHand::start_over() noexcept {
  random_ = first_random_;
  direction_ = 1.0;
  drift_along_m_ = 0.0;
  drift_across_m_ = 0.0;
}

void VirtualHand::press(int button) {
  const std::uint32_t bit = bit_of(button);
  buttons_pressed_.fetch_or(bit, std::memory_order_relaxed);
  buttons_down_.fetch_or(bit, std::memory_order_relaxed);
}

void VirtualHand::release(int button) {
  buttons_down_.fetch_and(~bit_of(button), std::memory_order_relaxed);
}

std::uint32_t VirtualHand::take_buttons() noexcept {
  // Down is read first: a press in between is seen now or with the next reading, never lost.
  const std::uint32_t down = buttons_down_.load(std::memory_order_relaxed);
  return down | buttons_pressed_.exchange(0, std::memory_order_relaxed);
}

HandIntent VirtualHand::intent(std::int64_t time_ns) noexcept {
  if (!started_) {
    started_ = true;
    last_ns_ = time_ns;
  }
  const std::int64_t gap_ns = std::clamp(time_ns - last_ns_, std::int64_t{0}, kLongestGap_ns);
  last_ns_ = std::max(last_ns_, time_ns);
  clock_ns_ += gap_ns;
  if (phase_ == Phase::stroking) {
    const double change = seconds(gap_ns) / kPressing_s;
    const bool presses = !leaves_ && wants_contact_.load(std::memory_order_acquire);
    grip_ = std::clamp(presses ? grip_ + change : grip_ - change, 0.0, 1.0);
  }
  advance_phase();
  is_ready_.store(rests_above_start(), std::memory_order_release);
  return moving();
}

void VirtualHand::advance_phase() noexcept {
  const bool wants_contact = wants_contact_.load(std::memory_order_acquire);
  // Ends because every move lasts and a gap does not.
  for (;;) {
    const std::int64_t end_ns = move_.began_ns + move_.duration_ns;
    switch (phase_) {
      case Phase::waiting:
        if (!takes_up_new_habits()) {
          return;
        }
        if (move_.to_m != above_start_m()) {
          begin_crossing();
        } else if (wants_contact && rests_above_start()) {
          begin_lowering();
        } else {
          return;
        }
        break;
      case Phase::lowering:
        if (!wants_contact) {
          begin_raising();
        } else if (clock_ns_ >= end_ns) {
          begin_stroke(end_ns);
        } else {
          return;
        }
        break;
      case Phase::stroking:
        if ((!wants_contact || leaves_) && grip_ == 0.0) {
          begin_raising();
        } else if (leaves_) {
          return;  // at rest at the end of its last stroke, until the surface is released
        } else if (clock_ns_ >= end_ns) {
          if (wants_contact && habits_.further_centres > 0 &&
              strokes_here_ >= habits_.strokes_at_a_centre) {
            leaves_ = true;
            return;
          }
          begin_stroke(end_ns);
        } else {
          return;
        }
        break;
      case Phase::raising:
        if (clock_ns_ < end_ns) {
          return;
        }
        start_over();
        begin(Phase::waiting, move_.to_m, move_.to_m, kSettling_s, end_ns);
        break;
      case Phase::crossing:
        if (clock_ns_ < end_ns) {
          return;
        }
        begin(Phase::waiting, move_.to_m, move_.to_m, kSettling_s, end_ns);
        break;
    }
  }
}

void VirtualHand::begin(Phase phase, const glm::dvec3& from_m, const glm::dvec3& to_m,
                        double duration_s, std::int64_t began_ns) noexcept {
  phase_ = phase;
  move_ = {.from_m = from_m,
           .to_m = to_m,
           .began_ns = began_ns,
           .duration_ns = std::llround(1e9 * std::max(duration_s, kShortestMove_s))};
}

void VirtualHand::begin_lowering() noexcept {
  strokes_here_ = 0;
  stroke_force_N_ = 0.0;
  grip_ = 0.0;
  begin(Phase::lowering, move_.to_m, stroke_end_m(-direction_),
        duration_s(habits_.lift_height_m, habits_.approach_speed_m_per_s, habits_.gathering),
        clock_ns_);
}

void VirtualHand::begin_stroke(std::int64_t began_ns) noexcept {
  ++strokes_here_;
  const bool first = phase_ == Phase::lowering;
  if (!first) {
    drift(seconds(move_.duration_ns));
    direction_ = -direction_;
  }
  const double speed_m_per_s = habits_.speed_m_per_s * (1.0 + variation(habits_.speed_variation));
  const double force_N = habits_.normal_force_N * (1.0 + variation(habits_.force_variation));
  last_force_N_ = first ? force_N : stroke_force_N_;
  stroke_force_N_ = force_N;
  const glm::dvec3 from_m = move_.to_m;
  const glm::dvec3 to_m = stroke_end_m(direction_);
  begin(Phase::stroking, from_m, to_m,
        duration_s(glm::length(to_m - from_m), speed_m_per_s, habits_.gathering), began_ns);
}

void VirtualHand::begin_raising() noexcept {
  const glm::dvec3 from_m = moving().position_m;
  const glm::dvec3 to_m(from_m.x, from_m.y, centre_m().z + habits_.lift_height_m);
  if (leaves_) {
    centre_ = (centre_ + 1) % (habits_.further_centres + 1);
    leaves_ = false;
  }
  begin(Phase::raising, from_m, to_m,
        duration_s(std::abs(to_m.z - from_m.z), habits_.approach_speed_m_per_s, habits_.gathering),
        clock_ns_);
}

void VirtualHand::begin_crossing() noexcept {
  const glm::dvec3 from_m = moving().position_m;
  const glm::dvec3 to_m = above_start_m();
  begin(Phase::crossing, from_m, to_m,
        duration_s(glm::length(to_m - from_m), kCrossing_m_per_s, habits_.gathering), clock_ns_);
}

// The Ornstein–Uhlenbeck process seen at the strokes' beginnings: memory m and fresh noise
// √(1 − m²) keep the standard deviation. m = 1/(1 + T/τ) stands for e^(−T/τ), which libm rounds
// differently from one platform to the next.
void VirtualHand::drift(double duration_s) noexcept {
  const double memory = 1.0 / (1.0 + duration_s / kDriftTime_s);
  const double fresh_m = habits_.drift_m * std::sqrt(1.0 - memory * memory);
  drift_along_m_ = memory * drift_along_m_ + fresh_m * random_.normal();
  drift_across_m_ = memory * drift_across_m_ + fresh_m * random_.normal();
}

double VirtualHand::variation(double standard_deviation) noexcept {
  return standard_deviation * std::clamp(random_.normal(), -kFarthest, kFarthest);
}

const glm::dvec3& VirtualHand::centre_m() const noexcept {
  return centre_ == 0 ? habits_.centre_m
                      : habits_.further_centres_m[static_cast<std::size_t>(centre_ - 1)];
}

glm::dvec3 VirtualHand::stroke_end_m(double direction) const noexcept {
  const glm::dvec3 along(along_, 0.0);
  const glm::dvec3 across(-along_.y, along_.x, 0.0);
  const double farthest_m = kFarthest * habits_.drift_m;
  return centre_m() +
         (0.5 * direction * habits_.stroke_length_m +
          std::clamp(drift_along_m_, -farthest_m, farthest_m)) *
             along +
         std::clamp(drift_across_m_, -farthest_m, farthest_m) * across;
}

glm::dvec3 VirtualHand::above_start_m() const noexcept {
  return stroke_end_m(-direction_) + glm::dvec3(0.0, 0.0, habits_.lift_height_m);
}

bool VirtualHand::rests_above_start() const noexcept {
  return phase_ == Phase::waiting && move_.to_m == above_start_m() &&
         clock_ns_ >= move_.began_ns + move_.duration_ns;
}

HandIntent VirtualHand::moving() const noexcept {
  const double time = std::clamp(
      static_cast<double>(clock_ns_ - move_.began_ns) / static_cast<double>(move_.duration_ns), 0.0,
      1.0);
  const Progress now = progress(time, habits_.gathering);
  const glm::dvec3 way_m = move_.to_m - move_.from_m;
  HandIntent intent{.position_m = move_.from_m + now.way * way_m,
                    .velocity_m_per_s = now.speed / seconds(move_.duration_ns) * way_m};
  if (phase_ == Phase::stroking) {
    const double changed = smooth_step(std::min(1.0, time / habits_.gathering));
    intent.lifted = false;
    intent.press_N =
        smooth_step(grip_) * (last_force_N_ + changed * (stroke_force_N_ - last_force_N_));
  }
  return intent;
}

}  // namespace asperity

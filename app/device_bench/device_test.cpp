#include "app/device_bench/device_test.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "analysis/device_response.h"
#include "analysis/number_text.h"
#include "analysis/summary.h"
#include "app/session/rig/clock.h"
#include "app/study_files/program.h"
#include "app/words/coded_phrases.h"
#include "app/words/device_remarks.h"
#include "app/words/phrase.h"
#include "app/words/reason.h"
#include "device/refusal.h"

namespace asperity {
namespace {

using Status = DeviceItem::Status;
using Bound = DeviceItem::Bound;

constexpr int kAxes = 3;
constexpr std::array<const char*, kAxes> kAxisNames{"x", "y", "z"};
constexpr double kSettled_s = 0.15;  // after the fade in

constexpr const char* kWorkspace = "workspace_reached";

/// What was found of one quantity along three axes.
struct ByAxis {
  std::array<std::optional<double>, kAxes> values{};
  std::array<Phrase, kAxes> reasons{};  ///< why one is missing
  Phrase text{};

  bool has(int axis) const { return values[static_cast<std::size_t>(axis)].has_value(); }
  double of(int axis, double otherwise) const {
    return values[static_cast<std::size_t>(axis)].value_or(otherwise);
  }
  void set(int axis, double value) { values[static_cast<std::size_t>(axis)] = value; }
  void miss(int axis, const Phrase& reason) { reasons[static_cast<std::size_t>(axis)] = reason; }
};

/// Holds the handle softly where the stage began.
struct Hold {
  double stiffness_N_per_m = 200.0;
  double damping_N_s_per_m = 1.5;
  glm::dvec3 origin_m{0.0};

  void begin(double since_s, const ProbeState& probe) noexcept {
    if (since_s <= 0.0) origin_m = probe.position_m;
  }
  glm::dvec3 force_N(const ProbeState& probe) const noexcept {
    return stiffness_N_per_m * (origin_m - probe.position_m) -
           damping_N_s_per_m * probe.velocity_m_per_s;
  }
};

double mean_value(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Why a stage says nothing; empty when it does.
Phrase hindrance_of(const StageRecord& record, const DeviceStage& stage) {
  if (record.fault != Fault::none) {
    return phrase_of(DeviceRemark::took_force_away).with(phrase_of(record.fault));
  }
  if (record.ran_away) {
    return phrase_of(DeviceRemark::ran_away).with(fixed(1e3 * stage.reach_m, 0));
  }
  return {};
}

class DeviceTest final {
 public:
  DeviceTest(HapticDevice& device, const DeviceTestOptions& options, const std::stop_token& stop)
      : device_(device),
        options_(options),
        usual_{.rate_Hz = options.rate_Hz, .is_simulated = options.is_simulated},
        bench_(device, options.rate_Hz, stop, options.watch) {
    const DeviceCapability& capability = device.capability();
    has_motors_ = capability.actuated_degrees_of_freedom > 0;
    profile_.model = capability.model;
    profile_.not_known = capability.not_known;
    force_N_ = options.force_N;
    if (has_motors_) {
      force_N_ = std::min(force_N_, capability.peak_force_N);
      if (capability.continuous_force_N > 0.0) {
        force_N_ = std::min(force_N_, capability.continuous_force_N);
      }
      device.set_limits({.force_N = force_N_});
    }
  }

  DeviceProfile run() {
    time_it();
    make_it_let_go();
    measure_friction();
    measure_push();
    measure_resonance();
    measure_stiffness();
    measure_force_resolution();
    measure_workspace();
    profile_.force_N = has_motors_ ? force_N_ : 0.0;
    leave_out_unknown(profile_);
    return std::move(profile_);
  }

 private:
  void tell(DeviceTestPart part, std::string what, double done) const {
    if (options_.tell) options_.tell({.part = part, .what = std::move(what), .done = done});
  }
  void tell(DeviceTestPart part, const std::string& what, int axis, double done) const {
    if (!options_.tell) return;
    options_.tell({.part = part,
                   .axis = axis,
                   .what = what + kAxisNames[static_cast<std::size_t>(axis)],
                   .done = done});
  }

  // --- items -------------------------------------------------------------------------------------

  void judge(const std::string& name, std::optional<double> value, const Phrase& text,
             std::vector<double> by_axis = {}) {
    DeviceItem item{.name = name, .value = value, .by_axis = std::move(by_axis), .text = text};
    item.bound = device_quantity(name)->bound;
    const auto given = options_.limits.find(name);
    item.limit = given != options_.limits.end() ? given->second : usual_.of(name);
    if (value) {
      const bool is_kept = !item.limit || keeps(*value, item.bound, *item.limit);
      item.status = is_kept ? Status::pass : Status::fail;
    }
    profile_.items.push_back(std::move(item));
  }

  void judge(const std::string& name, const ByAxis& found) {
    const bool at_least = device_quantity(name)->bound == Bound::at_least;
    std::optional<double> worst{};
    std::vector<double> by_axis{};
    Phrase missing{};
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (const std::optional<double>& value = found.values[axis]) {
        by_axis.push_back(*value);
        const bool is_worse = !worst || (at_least ? *value < *worst : *value > *worst);
        if (is_worse) worst = value;
      } else if (!found.reasons[axis].empty()) {
        const Phrase reason =
            phrase_of(DeviceRemark::along).with(kAxisNames[axis], found.reasons[axis]);
        missing = with_semicolon(missing, reason);
      }
    }
    if (by_axis.size() != kAxes) by_axis.clear();
    judge(name, worst,
          missing.empty() ? found.text : phrase_of(DeviceRemark::not_measured).with(missing),
          std::move(by_axis));
  }

  void promise(const std::string& name, bool is_kept, const Phrase& text) {
    profile_.items.push_back(
        {.name = name, .status = is_kept ? Status::pass : Status::fail, .text = text});
  }

  void leave_out(const std::vector<std::string>& names, const Phrase& why) {
    for (const std::string& name : names) judge(name, {}, why);
  }

  /// Where its number would be of no use: there are no motors to find it with, or it would be none of the device that
  /// this one stands for.
  bool is_left_out(const std::string& name) {
    if (has_motors_ && !profile_.is_unknown(name)) return false;
    leave_out({name}, phrase_of(DeviceRemark::no_motors));  // or what leave_out_unknown says
    return true;
  }

  // --- timing ------------------------------------------------------------------------------------

  void time_it() {
    tell(DeviceTestPart::timing, "timing, without any force", 0.0);
    constexpr double kTimed_s = 2.0;
    constexpr double kWarm_s = 0.1;  // a thread's first wake-ups are its latest ones
    const StageRecord record = bench_.run({.duration_s = kTimed_s}, options_.timing);
    profile_.scheduling = record.scheduling;
    std::vector<double> lateness_s{};
    std::vector<double> time_s{};
    std::array<std::vector<double>, kAxes> positions_m{};
    double missed = 0.0;
    double strongest_N = 0.0;
    for (std::size_t i = 0; i < record.ticks.size(); ++i) {
      const TickRecord& tick = record.ticks[i];
      strongest_N = std::max(strongest_N, glm::length(tick.sent.force_N));
      if (record.time_s[i] < kWarm_s) continue;
      time_s.push_back(record.time_s[i]);
      lateness_s.push_back(std::max(0.0, static_cast<double>(tick.lateness_ns) * 1e-9));
      missed += tick.has(TickFlag::missed_deadline) ? 1.0 : 0.0;
      for (int axis = 0; axis < kAxes; ++axis) {
        positions_m[static_cast<std::size_t>(axis)].push_back(tick.probe.position_m[axis]);
      }
    }
    std::sort(lateness_s.begin(), lateness_s.end());
    const Phrase told = options_.is_simulated ? phrase_of(DeviceRemark::of_this_computer)
                                              : phrase_of(DeviceRemark::nothing_felt);
    const bool ticked = time_s.size() >= 2 && record.fault == Fault::none;
    const auto if_ticked = [&](double value) {
      return ticked ? std::optional(value) : std::nullopt;
    };
    const Phrase why =
        ticked ? told : phrase_of(DeviceRemark::did_not_run).with(phrase_of(record.fault));
    const auto at = [&](double p) { return ticked ? quantile(lateness_s, p) : 0.0; };
    const double lasted_s = ticked ? time_s.back() - time_s.front() : 1.0;
    judge("rate_Hz", if_ticked(static_cast<double>(time_s.size() - 1) / lasted_s), why);
    judge("lateness_p50_s", if_ticked(at(0.5)), why);
    judge("lateness_p99_s", if_ticked(at(0.99)), why);
    judge("lateness_max_s", if_ticked(at(1.0)), why);
    judge("missed_deadlines", if_ticked(missed), why);
    judge("force_zero_N", if_ticked(strongest_N), phrase_of(DeviceRemark::force_of_nothing));
    ByAxis noise{.text = phrase_of(DeviceRemark::noise)};
    for (int axis = 0; axis < kAxes; ++axis) {
      SweepLeg rest{};
      rest.position_m = positions_m[static_cast<std::size_t>(axis)];
      rest.time_s = time_s;
      rest.force_N.resize(time_s.size());
      if (const auto error_m = position_error_m({rest}); error_m && ticked) {
        noise.set(axis, *error_m);
      } else {
        noise.miss(axis, phrase_of(DeviceRemark::too_few_readings));
      }
    }
    judge("position_noise_m", noise);
  }

  // --- safety ------------------------------------------------------------------------------------

  static constexpr double kGentle_N = 0.5;

  void make_it_let_go() {
    const std::vector<std::string> names{"limiter", "zero_after_stop", "zero_after_not_finite",
                                         "zero_without_heartbeat"};
    if (!has_motors_) {
      for (const std::string& name : names) {
        profile_.items.push_back({.name = name, .text = phrase_of(DeviceRemark::no_motors)});
      }
      return;
    }
    tell(DeviceTestPart::safety,
         "safety: a limit, a stop, a force that is not a number, and a missing heartbeat", 0.05);
    const double limit_N = std::min(kGentle_N, force_N_);
    device_.set_limits({.force_N = limit_N});
    check_limiter(limit_N);
    check_stop();
    check_not_finite();
    check_silence();
    device_.set_limits({.force_N = force_N_});
  }

  static glm::dvec3 sideways_N(double force_N) { return {force_N, 0.0, 0.0}; }

  void check_limiter(double limit_N) {
    const StageRecord record = bench_.run(
        {.duration_s = kSettled_s,
         .force_N = [limit_N](double, const ProbeState&) { return sideways_N(10.0 * limit_N); }},
        options_.timing);
    double strongest_N = 0.0;
    bool limited = false;
    for (const TickRecord& tick : record.ticks) {
      strongest_N = std::max(strongest_N, glm::length(tick.sent.force_N));
      limited = limited || tick.has(TickFlag::limited_force);
    }
    promise("limiter", limited && strongest_N <= limit_N,
            phrase_of(DeviceRemark::limited)
                .with(fixed(10.0 * limit_N, 1), fixed(limit_N, 1), fixed(strongest_N, 3)));
  }

  /// Whether there was a force, and none from the first latched tick on.
  static bool lets_go(const StageRecord& record) {
    bool pushed = false;
    bool latched = false;
    for (const TickRecord& tick : record.ticks) {
      const double sent_N = glm::length(tick.sent.force_N);
      latched = latched || tick.has(TickFlag::fault_latched);
      if (latched && sent_N > 0.0) return false;
      pushed = pushed || sent_N > 0.0;
    }
    return pushed && latched;
  }

  void check_stop() {
    const StageRecord record = bench_.run(
        {.duration_s = 2.0 * kSettled_s,
         .force_N = [](double, const ProbeState&) { return sideways_N(0.5 * kGentle_N); },
         .conduct =
             [](ServoLoop& loop, double since_s) {
               if (since_s > kSettled_s) loop.emergency_stop();
             }},
        options_.timing);
    promise("zero_after_stop", record.fault == Fault::emergency_stop && lets_go(record),
            phrase_of(DeviceRemark::stopped));
  }

  void check_not_finite() {
    const StageRecord record = bench_.run(
        {.duration_s = 2.0 * kSettled_s,
         .force_N =
             [](double since_s, const ProbeState&) {
               return since_s < kSettled_s ? sideways_N(0.5 * kGentle_N)
                                           : sideways_N(std::numeric_limits<double>::quiet_NaN());
             }},
        options_.timing);
    promise("zero_after_not_finite", record.fault == Fault::not_finite && lets_go(record),
            phrase_of(DeviceRemark::no_number));
  }

  void check_silence() {
    ServoSettings servo{};
    servo.heartbeat_timeout_s = 0.5;
    servo.heartbeat_fade_s = 0.2;
    constexpr double kEnd_s = 1.2;
    const StageRecord record = bench_.run(
        {.duration_s = kEnd_s,
         .force_N = [](double, const ProbeState&) { return sideways_N(0.5 * kGentle_N); },
         .servo = servo,
         .falls_silent_at_s = 2.0 * kSettled_s},
        options_.timing);
    const bool was_there =
        std::any_of(record.ticks.begin(), record.ticks.end(),
                    [](const TickRecord& tick) { return glm::length(tick.sent.force_N) > 0.0; });
    const bool is_gone =
        !record.ticks.empty() && glm::length(record.ticks.back().sent.force_N) == 0.0 &&
        std::any_of(record.ticks.begin(), record.ticks.end(), [](const TickRecord& tick) {
          return tick.has(TickFlag::heartbeat_lost) && glm::length(tick.sent.force_N) == 0.0;
        });
    promise("zero_without_heartbeat", was_there && is_gone && record.fault == Fault::none,
            phrase_of(DeviceRemark::silent).with(fixed(ServoSettings{}.heartbeat_timeout_s, 0)));
  }

  // --- mechanics ---------------------------------------------------------------------------------

  /// The legs of a sweep at one speed; the record may say why there are none.
  std::vector<SweepLeg> sweep(int axis, double speed_m_per_s, int rounds, Phrase& hindrance) {
    constexpr double kAmplitude_m = 0.008;
    constexpr double kPull_N_per_m = 400.0;
    const double quarter_s = kAmplitude_m / speed_m_per_s;
    // From the middle to one end, to and fro, and back to the middle.
    const double duration_s = kSettled_s + (4.0 * rounds + 2.0) * quarter_s;
    const auto target_m = [=](double since_s) {
      const double t = (since_s - kSettled_s) / quarter_s;
      if (t <= 0.0 || t >= 4.0 * rounds + 2.0) return 0.0;
      if (t <= 1.0) return kAmplitude_m * t;
      if (t >= 4.0 * rounds + 1.0) return kAmplitude_m * (4.0 * rounds + 2.0 - t);
      const double in_round = std::fmod(t - 1.0, 4.0);
      return kAmplitude_m * (in_round < 2.0 ? 1.0 - in_round : in_round - 3.0);
    };
    DeviceStage stage{.duration_s = duration_s};
    Hold hold{};
    stage.force_N = [=](double since_s, const ProbeState& probe) mutable {
      hold.begin(since_s, probe);
      glm::dvec3 force_N = hold.force_N(probe);
      force_N[axis] =
          kPull_N_per_m * (hold.origin_m[axis] + target_m(since_s) - probe.position_m[axis]) -
          hold.damping_N_s_per_m * probe.velocity_m_per_s[axis];
      return force_N;
    };
    const StageRecord record = bench_.run(stage, options_.mechanics);
    hindrance = hindrance_of(record, stage);
    std::vector<SweepLeg> legs(static_cast<std::size_t>(2 * rounds));
    std::size_t limited = 0;
    std::size_t used = 0;
    for (std::size_t i = 0; i < record.ticks.size(); ++i) {
      const double in_legs = ((record.time_s[i] - kSettled_s) / quarter_s - 1.0) / 2.0;
      if (in_legs < 0.0 || in_legs >= 2.0 * rounds) continue;
      const double leg = std::floor(in_legs);
      // The first half of a leg: what turns round, and the travel of the pull through friction.
      constexpr double kFrom = 0.5;
      constexpr double kTo = 0.97;
      if (in_legs - leg < kFrom || in_legs - leg > kTo) continue;
      const TickRecord& tick = record.ticks[i];
      SweepLeg& to = legs[static_cast<std::size_t>(leg)];
      to.time_s.push_back(record.time_s[i]);
      to.position_m.push_back(tick.probe.position_m[axis]);
      to.force_N.push_back(tick.sent.force_N[axis]);
      limited += tick.has(TickFlag::limited_force) ? 1 : 0;
      ++used;
    }
    if (hindrance.empty() && 20 * limited > used) {
      hindrance = phrase_of(DeviceRemark::did_not_follow).with(fixed(force_N_, 1));
    }
    return legs;
  }

  void measure_friction() {
    if (!has_motors_) return;
    constexpr double kSlow_m_per_s = 0.010;
    constexpr double kFast_m_per_s = 0.040;
    constexpr double kMoved_m_per_s = 0.0005;  // slower, the handle sticks
    for (int axis = 0; axis < kAxes; ++axis) {
      tell(DeviceTestPart::sweeps, "slow and faster sweeps along ", axis, 0.1 + 0.08 * axis);
      Phrase hindrance{};
      const std::vector<SweepLeg> slow = sweep(axis, kSlow_m_per_s, 1, hindrance);
      const auto slowly = sweep_response(slow);
      if (hindrance.empty() && (!slowly || slowly->speed_m_per_s < kMoved_m_per_s)) {
        hindrance = phrase_of(DeviceRemark::did_not_move);
      }
      if (hindrance.empty()) {
        const auto faster = sweep_response(sweep(axis, kFast_m_per_s, 3, hindrance));
        if (hindrance.empty() && faster) {
          resistances_[static_cast<std::size_t>(axis)] = resistance_of(*slowly, *faster);
        }
      }
      if (hindrance.empty() && !resistance(axis))
        hindrance = phrase_of(DeviceRemark::sweeps_say_nothing);
      sweep_hindrances_[static_cast<std::size_t>(axis)] = hindrance;
      if (!hindrance.empty()) {
        resistances_[static_cast<std::size_t>(axis)].reset();
        resolution_.miss(axis, hindrance);
        continue;
      }
      if (const auto error_m = position_error_m(slow)) {
        resolution_.set(axis, std::sqrt(12.0) * *error_m);
      }
    }
  }

  /// Nothing where the sweeps were no use.
  const std::optional<Resistance>& resistance(int axis) const {
    return resistances_[static_cast<std::size_t>(axis)];
  }
  double friction_N(int axis) const {
    return resistance(axis) ? resistance(axis)->friction_N : 0.0;
  }
  double held_by_N_per_m(int axis) const {
    return resistance(axis) ? std::max(0.0, resistance(axis)->stiffness_N_per_m) : 0.0;
  }

  void push(int axis, ByAxis& latency, ByAxis& mass) {
    if (!resistance(axis)) {
      latency.miss(axis, sweep_hindrances_[static_cast<std::size_t>(axis)]);
      mass.miss(axis, sweep_hindrances_[static_cast<std::size_t>(axis)]);
      return;
    }
    constexpr int kPushes = 12;
    constexpr double kRest_s = 0.25;
    constexpr double kPush_s = 0.030;
    constexpr double kPeriod_s = kRest_s + kPush_s;
    constexpr std::size_t kBefore = 20;  // ticks
    const double push_N = std::min(0.8 * force_N_, friction_N(axis) + 1.0);
    const auto pushed_N = [=](double since_s) {
      const double t = since_s - kSettled_s;
      const double number = std::floor(t / kPeriod_s);
      if (t < 0.0 || number >= kPushes || t - number * kPeriod_s < kRest_s) return 0.0;
      return std::fmod(number, 2.0) == 0.0 ? push_N : -push_N;
    };
    DeviceStage stage{.duration_s = kSettled_s + kPushes * kPeriod_s + 0.1};
    Hold hold{};
    stage.force_N = [=](double since_s, const ProbeState& probe) mutable {
      hold.begin(since_s, probe);
      glm::dvec3 force_N = hold.force_N(probe);
      force_N[axis] += pushed_N(since_s);
      return force_N;
    };
    const StageRecord record = bench_.run(stage, options_.mechanics);
    const Phrase hindrance = hindrance_of(record, stage);
    if (!hindrance.empty()) {
      latency.miss(axis, hindrance);
      mass.miss(axis, hindrance);
      return;
    }
    std::vector<Push> pushes{};
    for (std::size_t i = kBefore; i < record.ticks.size(); ++i) {
      const double force_N = pushed_N(record.time_s[i]);
      if (force_N == 0.0 || pushed_N(record.time_s[i - 1]) != 0.0) continue;
      Push one{.direction = std::copysign(1.0, force_N)};
      // The tick of the push itself was read before its force.
      for (std::size_t j = i - kBefore + 1; j <= i; ++j) {
        one.rested_at_m += record.ticks[j].probe.position_m[axis] / kBefore;
      }
      for (std::size_t j = i; j < record.ticks.size() && pushed_N(record.time_s[j]) == force_N;
           ++j) {
        one.time_s.push_back(record.time_s[j] - record.time_s[i]);
        one.position_m.push_back(record.ticks[j].probe.position_m[axis]);
        one.force_N.push_back(record.ticks[j].sent.force_N[axis]);
      }
      pushes.push_back(std::move(one));
    }
    const auto response = push_response(pushes, *resistance(axis));
    if (!response) {
      latency.miss(axis, phrase_of(DeviceRemark::push_did_not_move).with(fixed(push_N, 1)));
      mass.miss(axis, latency.reasons[static_cast<std::size_t>(axis)]);
      return;
    }
    latency.set(axis, response->delay_s);
    mass.set(axis, response->mass_kg);
  }

  void measure_push() {
    ByAxis latency{.text = phrase_of(DeviceRemark::latency)};
    mass_.text = phrase_of(DeviceRemark::mass);
    ByAxis friction{.text = phrase_of(DeviceRemark::friction)};
    ByAxis damping{.text = phrase_of(DeviceRemark::damping)};
    resolution_.text = phrase_of(DeviceRemark::position_step);
    if (!has_motors_) {
      leave_out({"friction_N", "damping_N_s_per_m", "position_resolution_m", "latency_s",
                 "moving_mass_kg"},
                phrase_of(DeviceRemark::no_motors));
      return;
    }
    for (int axis = 0; axis < kAxes; ++axis) {
      tell(DeviceTestPart::pushes, "sudden pushes along ", axis, 0.36 + 0.04 * axis);
      push(axis, latency, mass_);
      if (!resistance(axis)) {
        friction.miss(axis, sweep_hindrances_[static_cast<std::size_t>(axis)]);
        damping.miss(axis, sweep_hindrances_[static_cast<std::size_t>(axis)]);
        continue;
      }
      friction.set(axis, resistance(axis)->friction_N);
      damping.set(axis, std::max(0.0, resistance(axis)->damping_N_s_per_m(latency.of(axis, 0.0))));
    }
    judge("friction_N", friction);
    judge("damping_N_s_per_m", damping);
    judge("position_resolution_m", resolution_);
    judge("latency_s", latency);
    judge("moving_mass_kg", mass_);
  }

  void measure_resonance() {
    if (is_left_out("resonance_Hz")) return;
    constexpr double kLowest_Hz = 8.0;
    constexpr int kTones = 24;
    const double highest_Hz = std::min(200.0, 0.2 * options_.rate_Hz);
    struct ResonanceTone {
      double frequency_Hz = 0.0;
      double begins_s = 0.0;
      double judged_from_s = 0.0;
      double ends_s = 0.0;
    };
    std::vector<ResonanceTone> tones{};
    double now_s = kSettled_s;
    for (int i = 0; i < kTones; ++i) {
      const double f_Hz = kLowest_Hz * std::pow(highest_Hz / kLowest_Hz, i / (kTones - 1.0));
      const double judged_s = std::max(0.15, 2.0 / f_Hz);
      const double before_s = std::max(0.10, 1.0 / f_Hz);
      tones.push_back({f_Hz, now_s, now_s + before_s, now_s + before_s + judged_s});
      now_s = tones.back().ends_s;
    }
    ByAxis found{.text = phrase_of(DeviceRemark::resonance)};
    for (int axis = 0; axis < kAxes; ++axis) {
      tell(DeviceTestPart::tones, "tones along ", axis, 0.48 + 0.05 * axis);
      const double tone_N = std::min(0.7 * force_N_, friction_N(axis) + 0.7);
      DeviceStage stage{.duration_s = now_s + 0.05};
      Hold hold{};
      stage.force_N = [=, &tones](double since_s, const ProbeState& probe) mutable {
        hold.begin(since_s, probe);
        glm::dvec3 force_N = hold.force_N(probe);
        for (const ResonanceTone& tone : tones) {
          if (since_s < tone.begins_s || since_s >= tone.ends_s) continue;
          force_N[axis] += tone_N * std::sin(2.0 * std::numbers::pi * tone.frequency_Hz *
                                             (since_s - tone.begins_s));
        }
        return force_N;
      };
      const StageRecord record = bench_.run(stage, options_.mechanics);
      const Phrase hindrance = hindrance_of(record, stage);
      if (!hindrance.empty()) {
        found.miss(axis, hindrance);
        continue;
      }
      std::vector<FrequencyResponse> responses{};
      for (const ResonanceTone& tone : tones) {
        std::vector<double> time_s{};
        std::vector<double> position_m{};
        std::vector<double> force_N{};
        for (std::size_t i = 0; i < record.ticks.size(); ++i) {
          if (record.time_s[i] < tone.judged_from_s || record.time_s[i] >= tone.ends_s) continue;
          time_s.push_back(record.time_s[i]);
          position_m.push_back(record.ticks[i].probe.position_m[axis]);
          force_N.push_back(record.ticks[i].sent.force_N[axis]);
        }
        const auto moved = component_at(tone.frequency_Hz, time_s, position_m);
        const auto pushed = component_at(tone.frequency_Hz, time_s, force_N);
        if (!moved || !pushed || std::abs(*pushed) < 0.05 * tone_N) continue;
        responses.push_back({tone.frequency_Hz, std::abs(*moved) / std::abs(*pushed)});
      }
      profile_.responses.push_back({kAxisNames[static_cast<std::size_t>(axis)], responses});
      if (const auto frequency_Hz = resonance_Hz(responses)) {
        found.set(axis, *frequency_Hz);
      } else {
        found.miss(
            axis,
            phrase_of(DeviceRemark::no_resonance).with(fixed(kLowest_Hz, 0), fixed(highest_Hz, 0)));
      }
    }
    judge("resonance_Hz", found);
  }

  /// Whether a spring of that stiffness makes the handle swing by itself after a small kick.
  bool swings(int axis, double stiffness_N_per_m, Phrase& hindrance) {
    constexpr double kKick_m = 0.3e-3;
    constexpr double kKicked_s = 0.05;
    constexpr double kEnd_s = 0.45;
    constexpr double kWatched_s = 0.1;
    constexpr double kFar_m = 3e-3;
    DeviceStage stage{.duration_s = kEnd_s, .reach_m = kFar_m};
    Hold hold{};
    stage.force_N = [=](double since_s, const ProbeState& probe) mutable {
      hold.begin(since_s, probe);
      glm::dvec3 force_N = hold.force_N(probe);
      const bool kicked = since_s >= kSettled_s && since_s < kSettled_s + kKicked_s;
      force_N[axis] = stiffness_N_per_m *
                      (hold.origin_m[axis] + (kicked ? kKick_m : 0.0) - probe.position_m[axis]);
      return force_N;
    };
    const StageRecord record = bench_.run(stage, options_.mechanics);
    if (record.ran_away) return true;
    hindrance = hindrance_of(record, stage);
    double low_m = std::numeric_limits<double>::infinity();
    double high_m = -low_m;
    for (std::size_t i = 0; i < record.ticks.size(); ++i) {
      if (record.time_s[i] < kEnd_s - kWatched_s || record.time_s[i] > kEnd_s) continue;
      low_m = std::min(low_m, record.ticks[i].probe.position_m[axis]);
      high_m = std::max(high_m, record.ticks[i].probe.position_m[axis]);
    }
    constexpr double kStill_m = 0.1e-3;
    return high_m - low_m > std::max(kStill_m, 4.0 * resolution_.of(axis, 0.0));
  }

  void measure_stiffness() {
    if (is_left_out("stiffness_N_per_m")) return;
    constexpr double kSoftest_N_per_m = 250.0;
    constexpr int kLevels = 11;  // by √2, up to 8000 N/m
    ByAxis found{.text = phrase_of(DeviceRemark::stiffest)};
    for (int axis = 0; axis < kAxes; ++axis) {
      tell(DeviceTestPart::springs, "increasingly stiff springs along ", axis, 0.63 + 0.04 * axis);
      Phrase hindrance{};
      for (int level = 0; level < kLevels && hindrance.empty(); ++level) {
        const double stiffness_N_per_m = kSoftest_N_per_m * std::pow(2.0, 0.5 * level);
        if (swings(axis, stiffness_N_per_m, hindrance)) {
          if (level == 0) hindrance = phrase_of(DeviceRemark::swings_at_once);
          break;
        }
        if (hindrance.empty()) found.set(axis, stiffness_N_per_m);
      }
      if (!found.has(axis)) found.miss(axis, hindrance);
    }
    judge("stiffness_N_per_m", found);
  }

  /// How far small pushes move the handle, on the average, in their own direction.
  std::optional<double> moved_by(int axis, double push_N, Phrase& hindrance) {
    constexpr int kPushes = 6;
    constexpr double kHalf_s = 0.060;
    constexpr double kJudged_s = 0.010;
    const auto pushed_N = [=](double since_s) {
      const double t = (since_s - kSettled_s) / kHalf_s;
      const double number = std::floor(t);
      if (t < 0.0 || number >= 2.0 * kPushes || std::fmod(number, 2.0) != 0.0) return 0.0;
      return std::fmod(number, 4.0) == 0.0 ? push_N : -push_N;
    };
    DeviceStage stage{.duration_s = kSettled_s + 2.0 * kPushes * kHalf_s};
    Hold hold{.stiffness_N_per_m = kSoftHold_N_per_m};
    stage.force_N = [=](double since_s, const ProbeState& probe) mutable {
      hold.begin(since_s, probe);
      glm::dvec3 force_N = hold.force_N(probe);
      force_N[axis] += pushed_N(since_s);
      return force_N;
    };
    const StageRecord record = bench_.run(stage, options_.mechanics);
    hindrance = hindrance_of(record, stage);
    if (!hindrance.empty()) return {};
    const auto mean_near_m = [&](double end_s) -> std::optional<double> {
      std::vector<double> near_m{};
      for (std::size_t i = 0; i < record.ticks.size(); ++i) {
        if (record.time_s[i] > end_s - kJudged_s && record.time_s[i] <= end_s) {
          near_m.push_back(record.ticks[i].probe.position_m[axis]);
        }
      }
      if (near_m.empty()) return {};
      return mean_value(near_m);
    };
    double sum_m = 0.0;
    int counted = 0;
    for (int number = 0; number < kPushes; ++number) {
      const double begins_s = kSettled_s + 2.0 * number * kHalf_s;
      const auto before_m = mean_near_m(begins_s);
      const auto after_m = mean_near_m(begins_s + kHalf_s);
      if (!before_m || !after_m) continue;
      sum_m += (number % 2 == 0 ? 1.0 : -1.0) * (*after_m - *before_m);
      ++counted;
    }
    if (counted == 0) return {};
    return sum_m / counted;
  }

  void measure_force_resolution() {
    if (is_left_out("force_resolution_N")) return;
    constexpr double kWeakest_N = 0.002;
    constexpr double kPushed_s = 0.060;
    ByAxis found{.text = phrase_of(DeviceRemark::weakest)};
    for (int axis = 0; axis < kAxes; ++axis) {
      tell(DeviceTestPart::small_pushes, "increasingly strong small pushes along ", axis,
           0.75 + 0.08 * axis);
      Phrase hindrance = phrase_of(DeviceRemark::nothing_moves_it).with(fixed(0.8 * force_N_, 1));
      for (double push_N = kWeakest_N; push_N <= 0.8 * force_N_; push_N *= std::numbers::sqrt2) {
        Phrase trouble{};
        const auto moved_m = moved_by(axis, push_N, trouble);
        if (!trouble.empty()) {
          hindrance = trouble;
          break;
        }
        // A quarter of what the push would do without friction tells a motion from a creep, and four
        // standard errors of six times two means of ten readings tell it from noise.
        const double expected_m =
            push_N * std::min(0.5 * kPushed_s * kPushed_s / mass_.of(axis, 1e-9),
                              1.0 / (kSoftHold_N_per_m + held_by_N_per_m(axis)));
        const double noise_m = resolution_.of(axis, 0.0) / std::sqrt(12.0) * 4.0 / std::sqrt(30.0);
        if (moved_m && *moved_m > std::max(0.25 * expected_m, noise_m)) {
          found.set(axis, push_N);
          break;
        }
      }
      if (!found.has(axis)) found.miss(axis, hindrance);
    }
    judge("force_resolution_N", found);
  }

  void measure_workspace() {
    if (!(options_.workspace_s > 0.0)) {
      judge(kWorkspace, {}, phrase_of(DeviceRemark::nobody_moved_it));
      return;
    }
    tell(DeviceTestPart::workspace,
         "now move the handle along all borders of its workspace, for " +
             fixed(options_.workspace_s, 0) + " s",
         0.99);
    const StageRecord record = bench_.run({.duration_s = options_.workspace_s}, options_.mechanics);
    if (record.ticks.empty()) {
      judge(kWorkspace, {}, phrase_of(DeviceRemark::no_readings));
      return;
    }
    glm::dvec3 low_m = record.ticks.front().probe.position_m;
    glm::dvec3 high_m = low_m;
    for (const TickRecord& tick : record.ticks) {
      low_m = glm::min(low_m, tick.probe.position_m);
      high_m = glm::max(high_m, tick.probe.position_m);
    }
    profile_.reached_minimum_m = low_m;
    profile_.reached_maximum_m = high_m;
    const DeviceCapability& capability = device_.capability();
    const glm::dvec3 share =
        (high_m - low_m) / (capability.workspace_maximum_m - capability.workspace_minimum_m);
    judge(kWorkspace, std::min({share.x, share.y, share.z}), phrase_of(DeviceRemark::share_reached),
          {share.x, share.y, share.z});
  }

  static constexpr double kSoftHold_N_per_m = 100.0;

  HapticDevice& device_;
  const DeviceTestOptions& options_;
  UsualLimits usual_;
  DeviceBench bench_;
  bool has_motors_ = true;
  double force_N_ = 0.0;
  std::array<std::optional<Resistance>, kAxes> resistances_{};
  std::array<Phrase, kAxes> sweep_hindrances_{};
  ByAxis resolution_{};
  ByAxis mass_{};
  DeviceProfile profile_{};
};

}  // namespace

DeviceProfile test_device(HapticDevice& device, const DeviceTestOptions& options,
                          const std::stop_token& stop) {
  require_positive("rate_Hz", options.rate_Hz);
  require_positive("force_N", options.force_N);
  for (const auto& [name, limit] : options.limits) {
    const DeviceQuantity* const quantity = device_quantity(name);
    if (quantity == nullptr || !quantity->takes_limit) {
      std::string all{};
      for (const DeviceQuantity& one : device_quantities()) {
        if (!one.takes_limit) continue;
        all += (all.empty() ? "" : ", ") + std::string(one.name);
      }
      throw std::invalid_argument("there is no item \"" + name +
                                  "\" that could have a limit; there are: " + all);
    }
  }
  DeviceProfile profile = DeviceTest(device, options, stop).run();
  const DeviceCapability& capability = device.capability();
  const ProgramIdentity program = this_program();
  profile.name = capability.name;
  profile.serial = capability.serial;
  profile.workspace_minimum_m = capability.workspace_minimum_m;
  profile.workspace_maximum_m = capability.workspace_maximum_m;
  profile.is_simulated = options.is_simulated;
  profile.measured_utc = SystemClock(0).utc();
  profile.program_version = program.version;
  profile.program_commit = program.commit;
  profile.rate_Hz = options.rate_Hz;
  return profile;
}

}  // namespace asperity

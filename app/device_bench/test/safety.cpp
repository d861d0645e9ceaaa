// Provokes limiter, stop, non-finite forces and silence, and checks that the force becomes zero.

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "analysis/numbers/number_text.h"
#include "app/device_bench/test/device_test_parts.h"
#include "app/words/device_remarks.h"

namespace asperity {
namespace {

constexpr double kGentle_N = 0.5;

glm::dvec3 sideways_N(double force_N) { return {force_N, 0.0, 0.0}; }

/// Stores whether a safeguard acted, with `expected` as the fault at the end. After a standstill, for which a busy computer
/// is enough, the safeguard was not put to the test.
void judge_safeguard(DeviceTestRun& run, const std::string& name, const StageRecord& record,
                     Fault expected, bool has_acted, const Phrase& text) {
  if (record.fault == Fault::standstill) {
    run.profile().items.push_back(
        {.name = name, .text = phrase_of(DeviceRemark::not_measured).with(blocker_of(record, {}))});
    return;
  }
  const bool is_met = record.fault == expected && has_acted;
  run.judge_met(name, is_met, is_met ? text : phrase_of(DeviceRemark::did_not_act).with(text));
}

void check_limiter(DeviceTestRun& run, double limit_N) {
  const StageRecord record =
      run.time({.duration_s = kSettled_s, .force_N = [limit_N](double, const ProbeState&) {
                  return sideways_N(10.0 * limit_N);
                }});
  double strongest_N = 0.0;
  bool limited = false;
  for (const TickRecord& tick : record.ticks) {
    strongest_N = std::max(strongest_N, glm::length(tick.sent.force_N));
    limited = limited || tick.has(TickFlag::limited_force);
  }
  run.judge_met("limiter", limited && strongest_N <= limit_N,
                phrase_of(DeviceRemark::limited)
                    .with(fixed(10.0 * limit_N, 1), fixed(limit_N, 1), fixed(strongest_N, 3)));
}

// Whether there was a force, and none from the first tick with the latched fault on.
bool becomes_zero(const StageRecord& record) {
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

void check_stop(DeviceTestRun& run) {
  const StageRecord record =
      run.time({.duration_s = 2.0 * kSettled_s,
                .force_N = [](double, const ProbeState&) { return sideways_N(0.5 * kGentle_N); },
                .conduct =
                    [](ServoLoop& loop, double since_s) {
                      if (since_s > kSettled_s) loop.emergency_stop();
                    }});
  judge_safeguard(run, "zero_after_stop", record, Fault::emergency_stop, becomes_zero(record),
                  phrase_of(DeviceRemark::stopped));
}

void check_not_finite(DeviceTestRun& run) {
  const StageRecord record =
      run.time({.duration_s = 2.0 * kSettled_s, .force_N = [](double since_s, const ProbeState&) {
                  return since_s < kSettled_s
                             ? sideways_N(0.5 * kGentle_N)
                             : sideways_N(std::numeric_limits<double>::quiet_NaN());
                }});
  judge_safeguard(run, "zero_after_not_finite", record, Fault::not_finite, becomes_zero(record),
                  phrase_of(DeviceRemark::no_number));
}

void check_silence(DeviceTestRun& run) {
  ServoSettings servo{};
  servo.heartbeat_timeout_s = 0.5;
  servo.heartbeat_fade_s = 0.2;
  constexpr double kEnd_s = 1.2;
  const StageRecord record =
      run.time({.duration_s = kEnd_s,
                .force_N = [](double, const ProbeState&) { return sideways_N(0.5 * kGentle_N); },
                .servo = servo,
                .falls_silent_at_s = 2.0 * kSettled_s});
  const bool was_there =
      std::any_of(record.ticks.begin(), record.ticks.end(),
                  [](const TickRecord& tick) { return glm::length(tick.sent.force_N) > 0.0; });
  const bool is_gone =
      !record.ticks.empty() && glm::length(record.ticks.back().sent.force_N) == 0.0 &&
      std::any_of(record.ticks.begin(), record.ticks.end(), [](const TickRecord& tick) {
        return tick.has(TickFlag::heartbeat_lost) && glm::length(tick.sent.force_N) == 0.0;
      });
  judge_safeguard(
      run, "zero_without_heartbeat", record, Fault::none, was_there && is_gone,
      phrase_of(DeviceRemark::silent).with(fixed(ServoSettings{}.heartbeat_timeout_s, 0)));
}

}  // namespace

void check_safety(DeviceTestRun& run) {
  const std::vector<std::string> names{"limiter", "zero_after_stop", "zero_after_not_finite",
                                       "zero_without_heartbeat"};
  if (!run.has_motors()) {
    for (const std::string& name : names) {
      run.profile().items.push_back({.name = name, .text = phrase_of(DeviceRemark::no_motors)});
    }
    return;
  }
  run.announce(DeviceTestPart::safety,
               "safety: a limit, a stop, a force that is not finite, and a missing heartbeat",
               0.05);
  const double limit_N = std::min(kGentle_N, run.force_N());
  run.device().set_limits({.force_N = limit_N});
  check_limiter(run, limit_N);
  check_stop(run);
  check_not_finite(run);
  check_silence(run);
  run.device().set_limits({.force_N = run.force_N()});
}

}  // namespace asperity

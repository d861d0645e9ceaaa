// Measures rate, lateness, missed deadlines and position noise of a loop without force.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "analysis/numbers/summary.h"
#include "app/device_bench/test/device_test_parts.h"
#include "app/words/device_remarks.h"
#include "app/words/reason.h"

namespace asperity {

void measure_timing(DeviceTestRun& run) {
  run.announce(DeviceTestPart::timing, "timing, at zero force", 0.0);
  constexpr double kTimed_s = 2.0;
  constexpr double kWarm_s = 0.1;  // the first wake-ups of a thread are the latest ones
  const StageRecord record = run.time({.duration_s = kTimed_s});
  run.profile().scheduling = record.scheduling;
  std::vector<double> lateness_s{};
  std::vector<double> time_s{};
  std::array<std::vector<double>, kTestedAxes> positions_m{};
  double missed = 0.0;
  double strongest_N = 0.0;
  for (std::size_t i = 0; i < record.ticks.size(); ++i) {
    const TickRecord& tick = record.ticks[i];
    strongest_N = std::max(strongest_N, glm::length(tick.sent.force_N));
    if (record.time_s[i] < kWarm_s) continue;
    time_s.push_back(record.time_s[i]);
    lateness_s.push_back(std::max(0.0, static_cast<double>(tick.lateness_ns) * 1e-9));
    missed += tick.has(TickFlag::missed_deadline) ? 1.0 : 0.0;
    for (int axis = 0; axis < kTestedAxes; ++axis) {
      positions_m[static_cast<std::size_t>(axis)].push_back(tick.probe.position_m[axis]);
    }
  }
  std::sort(lateness_s.begin(), lateness_s.end());
  const Phrase remark = run.options().is_simulated ? phrase_of(DeviceRemark::of_this_computer)
                                                   : phrase_of(DeviceRemark::nothing_felt);
  const bool ticked = time_s.size() >= 2 && record.fault == Fault::none;
  const auto if_ticked = [&](double value) { return ticked ? std::optional(value) : std::nullopt; };
  const Phrase why =
      ticked ? remark : phrase_of(DeviceRemark::did_not_run).with(phrase_of(record.fault));
  const auto at = [&](double p) { return ticked ? quantile(lateness_s, p) : 0.0; };
  const double lasted_s = ticked ? time_s.back() - time_s.front() : 1.0;
  run.judge("rate_Hz", if_ticked(static_cast<double>(time_s.size() - 1) / lasted_s), why);
  run.judge("lateness_p50_s", if_ticked(at(0.5)), why);
  run.judge("lateness_p99_s", if_ticked(at(0.99)), why);
  run.judge("lateness_max_s", if_ticked(at(1.0)), why);
  run.judge("missed_deadlines", if_ticked(missed), why);
  run.judge("force_zero_N", if_ticked(strongest_N), phrase_of(DeviceRemark::force_of_nothing));
  ByAxis noise{.text = phrase_of(DeviceRemark::noise)};
  for (int axis = 0; axis < kTestedAxes; ++axis) {
    ForcedMotion rest{};
    rest.position_m = positions_m[static_cast<std::size_t>(axis)];
    rest.time_s = time_s;
    rest.force_N.resize(time_s.size());
    if (const auto error_m = position_error_m({rest}); error_m && ticked) {
      noise.set(axis, *error_m);
    } else {
      noise.miss(axis, phrase_of(DeviceRemark::too_few_readings));
    }
  }
  run.judge("position_noise_m", noise);
}

}  // namespace asperity

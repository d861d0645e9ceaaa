// Measures the response of each axis to tones up to 200 Hz, and derives the resonance.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "app/device_bench/test/device_test_parts.h"
#include "app/words/device_remarks.h"

namespace asperity {

void measure_tones(DeviceTestRun& run, const Sweeps& sweeps) {
  if (run.is_left_out("resonance_Hz")) return;
  constexpr double kLowest_Hz = 8.0;
  constexpr int kTones = 24;
  constexpr double kLeastOfTone = 0.05;  // of its amplitude, after the limiter
  const double highest_Hz = std::min(200.0, 0.2 * run.options().rate_Hz);
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
  for (int axis = 0; axis < kTestedAxes; ++axis) {
    run.announce(DeviceTestPart::tones, "tones along ", axis, 0.48 + 0.05 * axis);
    const double tone_N = std::min(0.7 * run.force_N(), sweeps.friction_N(axis) + 0.7);
    DeviceStage stage{.duration_s = now_s + 0.05};
    Hold hold{};
    stage.force_N = [=, &tones](double since_s, const ProbeState& probe) mutable {
      glm::dvec3 force_N = hold.force_N(since_s, probe);
      for (const ResonanceTone& tone : tones) {
        if (since_s < tone.begins_s || since_s >= tone.ends_s) continue;
        force_N[axis] += tone_N * std::sin(2.0 * std::numbers::pi * tone.frequency_Hz *
                                           (since_s - tone.begins_s));
      }
      return force_N;
    };
    const StageRecord record = run.move(stage);
    const Phrase blocker = blocker_of(record, stage);
    if (!blocker.empty()) {
      found.miss(axis, blocker);
      continue;
    }
    std::vector<FrequencyResponse> responses{};
    for (const ResonanceTone& tone : tones) {
      ForcedMotion judged{};
      for (std::size_t i = 0; i < record.ticks.size(); ++i) {
        if (record.time_s[i] < tone.judged_from_s || record.time_s[i] >= tone.ends_s) continue;
        judged.time_s.push_back(record.time_s[i]);
        judged.position_m.push_back(record.ticks[i].probe.position_m[axis]);
        judged.force_N.push_back(record.ticks[i].sent.force_N[axis]);
      }
      if (const auto response =
              frequency_response(tone.frequency_Hz, judged, kLeastOfTone * tone_N)) {
        responses.push_back(*response);
      }
    }
    run.profile().responses.push_back(
        {kTestedAxisNames[static_cast<std::size_t>(axis)], responses});
    if (const auto frequency_Hz = resonance_Hz(responses)) {
      found.set(axis, *frequency_Hz);
    } else {
      found.miss(
          axis,
          phrase_of(DeviceRemark::no_resonance).with(fixed(kLowest_Hz, 0), fixed(highest_Hz, 0)));
    }
  }
  run.judge("resonance_Hz", found);
}

}  // namespace asperity

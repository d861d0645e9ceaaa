// States a planned sample as one sentence, for an ethics form or a preregistration.

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/power/assumption.h"
#include "app/power/curve/planned_sample.h"
#include "app/power/curve/power_tally.h"

namespace asperity {

/// Of one effect.
struct PlannedStudy {
  std::string protocol{};                 ///< "amplitude_jnd 1.0"
  std::string program{};                  ///< "Asperity 0.2.0"
  std::vector<Assumption> assumptions{};  ///< with which the studies were simulated
  bool is_on_physics = false;  ///< by the protocol's virtual observers, without assumptions
  std::vector<std::string>
      stated_effects{};              ///< the names of those that the researcher stated; empty: all
  std::vector<PowerCurve> curves{};  ///< of this effect
  std::int64_t runs = 0;
  SampleRules rules{};
};

/// Whether an effect was taken from a pilot: its source begins with "pilot". The estimate of a pilot varies, and one that was
/// selected because it was significant is too large on average, so that a sample planned with it is too small.
bool is_from_pilot(const Assumption& assumption);

/// The curve on which the sample depends: of the tests that the effects to be detected concern, which are the stated ones, or otherwise
/// all, as far as their value is not that without an effect (of all tests where they concern none, and never a whole family), the one that needs most participants for this power; of several that do not reach it, the one with the
/// lowest power at the largest number. Null without a test.
const PowerCurve* deciding_curve(const PlannedStudy& study, double power);

/// "A sample of 24 participants has a power of at least 80 % to detect …": α and the correction, the effect with its unit, value
/// without an effect and source, the test, the smallest number with its Monte-Carlo interval and the number of simulated studies,
/// the standard deviations of the effects with their sources, the numbers to recruit. Where no number has the power: what the
/// largest one has. Empty without a test.
std::string ethics_sentence(const PlannedStudy& study, double power);

}  // namespace asperity

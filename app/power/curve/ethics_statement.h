// States a planned sample in a few sentences, for an ethics form or a preregistration.

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "app/power/assumption.h"
#include "app/power/curve/planned_sample.h"
#include "app/power/curve/power_tally.h"

namespace asperity {

/// With one combination of effects.
struct PlannedStudy {
  std::string protocol{};                 ///< "amplitude_jnd 1.0"
  std::string program{};                  ///< "Asperity 0.2.0"
  std::vector<Assumption> assumptions{};  ///< with which the studies were simulated
  bool is_on_physics = false;  ///< by the protocol's virtual observers, without assumptions
  std::vector<std::string>
      stated_effects{};              ///< the names of those that the researcher stated; empty: all
  std::vector<PowerCurve> curves{};  ///< of these effects
  std::int64_t runs = 0;
  SampleRules rules{};
};

/// Whether an effect was taken from a pilot: its source begins with "pilot". The estimate of a pilot varies, and one that was
/// selected because it was significant is too large on average, so that a sample planned with it is too small.
bool is_from_pilot(const Assumption& assumption);

/// An effect that is to be detected, with the test on which its sample depends: of the tests that the effect concerns, the one that
/// needs the most participants for the power; of several that do not reach it, the one with the lowest power at the largest number.
struct PlannedEffect {
  const Assumption* effect =
      nullptr;  ///< null: that of the stimuli on virtual observers, which all tests concern
  const PowerCurve* curve = nullptr;
  std::size_t tests = 0;  ///< that the effect concerns
};

/// The stated effects, or otherwise all, without those whose value is that without an effect and those that no curve concerns. They
/// refer to the study.
std::vector<PlannedEffect> planned_effects(const PlannedStudy& study, double power);

/// Of these effects the one that needs the most participants: it determines the sample. Null where there are none.
const PlannedEffect* deciding_effect(const std::vector<PlannedEffect>& effects, double power,
                                     const SampleRules& rules);

/// In this order: the planned number of participants, how it was determined and with how many simulated studies; for every effect its
/// value, unit, value without an effect and source, its statistical test with sides, α and correction, the smallest number of
/// participants and the estimated power with their Monte-Carlo intervals, and which effect determines the sample; the standard
/// deviations with their sources; the number to recruit. If an effect does not reach the power, there is no planned number, and the
/// power with the largest number is stated in its place. Empty without effects.
std::string ethics_statement(const PlannedStudy& study, double power);

}  // namespace asperity

// Remarks in a device's profile: how the number of an item was measured, or why there is none, and
// the known traits.

#pragma once

#include <vector>

#include "analysis/words/phrase.h"
#include "app/words/phrase_of_error.h"
#include "device/device_trait.h"

namespace asperity {

/// Sentences and parts of sentences: "Not measured: along x the handle did not move; along y …".
enum class DeviceRemark {
  took_force_away,
  ran_away,
  along,
  not_measured,
  of_this_computer,
  nothing_felt,
  did_not_run,
  force_of_nothing,
  noise,
  too_few_readings,
  no_motors,
  limited,
  stopped,
  no_number,
  silent,
  did_not_act,
  did_not_follow,
  did_not_move,
  swings_in_sweeps,
  sweeps_say_nothing,
  push_did_not_move,
  swings_before_pushes,
  latency,
  mass,
  friction,
  damping,
  position_step,
  resonance,
  no_resonance,
  stiffest,
  swings_at_once,
  weakest,
  nothing_moves_it,
  nobody_moved_it,
  no_readings,
  share_reached,
  not_known,
};
/// The phrase with placeholders, which the measurement fills.
Phrase phrase_of(DeviceRemark remark);

/// All remarks, each with its code.
std::vector<Phrase> coded_remarks();

/// "moving mass"
Phrase phrase_of(DeviceTrait trait);
/// "friction, damping"
Phrase listed_traits(const std::vector<DeviceTrait>& traits);

}  // namespace asperity

// Checks that the sounds of a session can be heard: masking noise, cues and tones.

#pragma once

#include "app/session/sound/sound.h"
#include "app/tasks/checks/session_check.h"
#include "protocols/design/protocol.h"

namespace asperity {

SessionCheck noise_check(const CheckInputs& inputs, const Protocol& protocol);

/// The noise that a protocol requires; kind `none` if it requires none.
MaskingNoise declared_noise(const Protocol& protocol);

/// The largest permitted difference between the measured and the declared level.
inline constexpr double kNoiseTolerance_dBA = 2.0;

}  // namespace asperity

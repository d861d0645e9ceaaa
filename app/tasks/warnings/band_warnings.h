// Compares the frequencies of textures that change with time with the rate of the servo loop.

#pragma once

#include <string>
#include <vector>

#include "app/session/stimulus_builder.h"
#include "app/tasks/warnings/checked_protocol.h"
#include "protocols/file/diagnostic.h"

namespace asperity {

/// A warning for every stimulus whose force changes with time at frequencies above half the servo rate, such as noise that
/// takes new values more often than the loop runs: the loop renders one value per tick, so that the power of the texture lies
/// at lower frequencies than its parameters state (1.6 times the RMS from 5 to 200 Hz for 1 kHz noise at 400 Hz), and a
/// session at another rate renders another texture.
///
/// Textures that vary with place are not compared: their frequencies depend on the speed of the hand. Stimuli whose files
/// are not available are left out (StimulusBuilder::can_make). The files have been checked before.
std::vector<Diagnostic> warnings_about_bands(const CheckedProtocol& checked,
                                             StimulusBuilder& builder);

}  // namespace asperity

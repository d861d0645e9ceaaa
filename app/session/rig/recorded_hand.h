// A recording of a session as a hand for the device "replay".

#pragma once

#include <filesystem>
#include <vector>

#include "device/probe_state.h"

namespace asperity {

/// The probe's states in every tick of a recording, as they were recorded: those before a surface, between
/// two and after the last as well. Times are the recording's.
///
/// Errors: ResultsError for what is no recording of this program; std::runtime_error for one without ticks.
std::vector<ProbeState> recorded_hand(const std::filesystem::path& recording);

}  // namespace asperity

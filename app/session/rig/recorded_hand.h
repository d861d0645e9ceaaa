// Reads a recording of a session as a hand for the device "replay".

#pragma once

#include <filesystem>
#include <vector>

#include "device/probe_state.h"

namespace asperity {

/// The probe's states in every tick of a recording, as recorded, including those before, between
/// and after the surfaces. Times are the recording's.
///
/// Errors: ResultsError for a file that is not a recording of this program; std::runtime_error for
/// a recording without ticks.
std::vector<ProbeState> recorded_hand(const std::filesystem::path& recording);

}  // namespace asperity

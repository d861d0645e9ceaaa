// Takes the probe states of a recording, and drops a second state with the same time.

#include "app/session/rig/recorded_hand.h"

#include <stdexcept>

#include "app/session/rig/recording_columns.h"
#include "results_schema/recording.h"

namespace asperity {

std::vector<ProbeState> recorded_hand(const std::filesystem::path& recording) {
  std::vector<ProbeState> states{};
  for (const TickRecord& tick : records_of(read_recording(recording), recording)) {
    // Of two ticks with the same time the first counts; a device gives one state at a time.
    if (states.empty() || tick.probe.time_ns > states.back().time_ns) states.push_back(tick.probe);
  }
  if (states.empty()) {
    throw std::runtime_error("the recording " + recording.string() +
                             " has no ticks to replay; choose another recording");
  }
  return states;
}

}  // namespace asperity

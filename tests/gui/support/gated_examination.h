// Examinations of stimuli that wait until a test lets them end.

#pragma once

#include <algorithm>
#include <atomic>
#include <memory>
#include <stop_token>
#include <thread>

#include "app/gui/base/stimulus_examiner.h"

namespace asperity {

/// Shared with the workers of the examiner, which may outlive the test.
struct GatedExamination {
  std::atomic<bool> is_open{false};
  std::atomic<bool> is_deaf{false};  ///< a stop does not end them
  std::atomic<int> begun{0};
  std::atomic<int> running{0};
  std::atomic<int> most_running{0};
  std::atomic<int> stopped{0};

  bool has_begun(int count) const { return begun == count && running == 1; }
  bool has_stopped(int count) const { return stopped == count && running == 0; }
};

/// Each finds the warning "the gate is open" on line 1.
inline StimulusExaminer::Examine examine_through(const std::shared_ptr<GatedExamination>& gate) {
  return [gate](const Protocol&, const std::stop_token& stop) {
    ++gate->begun;
    gate->most_running = std::max(gate->most_running.load(), ++gate->running);
    while (!gate->is_open && (gate->is_deaf || !stop.stop_requested())) std::this_thread::yield();
    if (stop.stop_requested()) ++gate->stopped;
    --gate->running;
    return StimulusExamination{.warnings = {{.message = "the gate is open"}}};
  };
}

}  // namespace asperity

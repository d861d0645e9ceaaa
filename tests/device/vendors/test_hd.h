// What tests arrange and see of the stand-in for OpenHaptics' libHD.

#pragma once

#include <atomic>
#include <mutex>
#include <string>
#include <vector>

namespace asperity::test_hd {

/// Its scheduler has a thread of its own, as libHD's does: everything here is held with `mutex`, save the atomics.
struct Bench {
  std::mutex mutex{};
  bool is_attached = true;
  double transform[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  int buttons = 0;
  int actuated_degrees = 3;
  double peak_force_N = 3.3;
  double workspace_mm[6] = {-160.0, -60.0, -70.0, 160.0, 120.0, 50.0};
  unsigned int calibration = 0x5000;
  std::vector<unsigned int> errors{};  ///< the stack that hdGetError takes the latest from
  unsigned int error_of_each_begin = 0;
  unsigned int error_of_each_end = 0;
  bool calibrates = true;         ///< when hdUpdateCalibration asks it to
  bool refuses_to_start = false;  ///< the scheduler
  bool never_calls = false;       ///< the scheduler, though it has started
  bool gives_force = false;       ///< force output is on

  std::atomic<int> made_current{0};
  std::atomic<int> frames{0};
  std::atomic<bool> hangs{
      false};  ///< the scheduler's thread, between two frames; hdDisable waits for it
  std::atomic<bool> is_hanging{false};
  int disorders = 0;  ///< frames in frames, forces outside of one, ends without a beginning
  double force_N[3] = {9.0, 9.0, 9.0};
  double torque[3] = {9.0, 9.0, 9.0};
  double strongest_N = 0.0;
  unsigned long rate_Hz = 1000;
  std::vector<std::string> calls{};  ///< those that open, switch, start and stop
};

}  // namespace asperity::test_hd

// Exported by the stand-in.
using TestHdBench = asperity::test_hd::Bench* (*)();
/// Ends the scheduler's thread, whatever it does, and starts the bench anew.
using TestHdReset = void (*)();

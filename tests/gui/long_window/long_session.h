// Sessions in real time that end after so many seconds, with windows and without.

#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/gui/long_window/frame_times.h"

namespace asperity {

/// How the servo kept time in all attempts of a session, tick by tick.
struct ServoTimes {
  std::size_t ticks = 0;
  int attempts = 0;
  std::int64_t missed_deadlines = 0;
  std::int64_t lost_records = 0;
  double lateness_p50_s = 0.0;
  double lateness_p99_s = 0.0;
  double lateness_maximum_s = 0.0;
  double span_s = 0.0;  ///< from the beginning of the first attempt to the end of the last
  std::string scheduling{};
};

struct LongSession {
  std::string trouble{};  ///< why it did not go as planned; empty: it did
  double load = 0.0;      ///< of the machine in the minute before
  ServoTimes servo{};
  FrameTimes::Seen window{};  ///< of a session without windows: empty
  FrameTimes::Seen mirror{};
};

/// The demonstration study with one protocol more, protocols/long.json: its selection task with a
/// scene, over and over, without screens and breaks, for `duration_s` and more.
std::filesystem::path make_long_study(const std::filesystem::path& folder, double duration_s);

/// A simulated session of protocols/long.json in real time, asked to end after the trial in which
/// `duration_s` are over; aborted, with its trouble, where it does not end by itself.
///
/// With windows: the study window, and the session window with its plots and its mirror, by the
/// same way as in the program. `participant` must be new in the study.
LongSession run_with_windows(const std::filesystem::path& study, const std::string& participant,
                             double duration_s);
LongSession run_headless(const std::filesystem::path& study, const std::string& participant,
                         double duration_s);

}  // namespace asperity

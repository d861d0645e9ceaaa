// One line of the checklist before a session, and what the checks need to know of the session.

#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/words/phrase.h"
#include "app/device_bench/tried_device.h"
#include "app/session/rehearsal/rehearsal_memory.h"
#include "app/session/sound/sound.h"
#include "app/tasks/run_session.h"
#include "protocols/file/diagnostic.h"

namespace asperity {

/// One line of the checklist.
struct SessionCheck {
  enum class State {
    fine,
    look,  ///< the session can start, and the experimenter should know this
    stop,  ///< the session cannot start
  };
  std::string id{};  ///< e.g. "disk", for programs
  Phrase title{};
  State state = State::fine;
  Phrase text{};    ///< the result
  Phrase remedy{};  ///< what the experimenter should do; empty if fine
  /// Warnings about the protocol, which follow the text; a window shows them by their places in the form.
  std::vector<Diagnostic> warnings{};
};

/// The planned session, and the results that the caller has already.
struct CheckInputs {
  std::filesystem::path study{};
  std::filesystem::path protocol{};
  /// Of the protocol that was shown; empty if there is nothing to compare with.
  std::string protocol_sha256{};
  std::string participant{};
  SessionMode mode = SessionMode::run;
  bool resume = false;
  std::optional<std::int64_t> resumed_session{};  ///< see RunInputs
  std::string late_reason{};                      ///< see RunInputs
  RunPacing pacing = RunPacing::real_time;
  std::string device = "simulated";  ///< see RunInputs
  std::string device_name{};         ///< its name in the list of devices; empty: `device`
  DriverOptions driver_options{};    ///< of the session; stated in the command that measures
  /// Why the search for devices found this one unusable; empty if it is usable.
  std::string device_blocker{};
  DeviceTrial trial = try_device;
  /// The last trial of an attached device, which the program opens only on request. Null if it was not tried.
  std::shared_ptr<const TriedDevice> tried{};
  /// The last comparison with the device, so that it is not repeated; may be null.
  std::shared_ptr<RehearsalMemory> rehearsal{};
  MaskingNoise noise{};     ///< the noise that will be played, with its measured level
  bool sound_card = false;  ///< whether there is a sound output
  int screens = 1;
};

/// A line without a remedy.
inline SessionCheck fine_check(const Phrase& text) { return {.text = text}; }

}  // namespace asperity

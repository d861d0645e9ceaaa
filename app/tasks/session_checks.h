// Can this session begin? What is looked at before a person sits down.

#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "app/device_bench/tried_device.h"
#include "app/session/rehearsal/rehearsal.h"
#include "app/session/sound/sound.h"
#include "app/tasks/run_session.h"
#include "app/words/phrase.h"
#include "protocols/design/protocol.h"
#include "renderers/force/force_model.h"

namespace asperity {

/// One line of the checklist.
struct SessionCheck {
  enum class State {
    fine,
    look,  ///< the session can begin, and the experimenter should know this
    stop,  ///< it cannot
  };
  std::string id{};  ///< "disk", for programs
  Phrase title{};
  State state = State::fine;
  Phrase text{};    ///< what was found
  Phrase remedy{};  ///< what to do about it; empty when fine
};

/// Results that the caller has already.
struct CheckInputs {
  std::filesystem::path study{};
  std::filesystem::path protocol{};
  /// Of the protocol that the person was shown; empty: nothing to compare with.
  std::string protocol_sha256{};
  std::string participant{};
  SessionMode mode = SessionMode::run;
  bool resume = false;
  std::optional<std::int64_t> resumed_session{};  ///< see RunInputs
  std::string late_reason{};                      ///< see RunInputs
  RunPacing pacing = RunPacing::real_time;
  std::string device = "simulated";  ///< see RunInputs
  std::string device_name{};         ///< as the user chose it in a list; empty: as `device`
  DriverOptions
      driver_options{};  ///< that the session's driver is told; here for the command that measures
  /// From the search for devices: why this one cannot be used. Empty: it can.
  std::string device_hindrance{};
  DeviceTrial trial = try_device;
  /// Of an attached device, which is opened by a person's wish alone: what it did then. Null: not yet.
  std::shared_ptr<const TriedDevice> tried{};
  /// Warnings of the last comparison with the device, so that they are not found again; may be null.
  std::shared_ptr<RehearsalMemory> rehearsal{};
  MaskingNoise noise{};     ///< what will be played, and the level that a person has measured
  bool sound_card = false;  ///< there is a sound output
  int screens = 1;
};

/// Looks at everything, in the order in which a person would mend it: "protocol", "participant",
/// "study", "disk", "stimuli", "device", "calibration", "rehearsal" (one line for each way in which the
/// device falls short of the plan, as the study's profile of it says), "force_zero", "rate", "screens",
/// "masking_noise". A protocol that cannot be read is the only line.
///
/// In real time the servo loop really runs, for some 0.3 s, on a device that the program has itself. An
/// attached one is left alone: without `tried` there is no "force_zero" and no "rate", and "device" keeps the
/// session from starting. `drivers` are those of the session. Where `stop` is requested, the rest is left out.
/// `progress` is told how far the comparison with the device is, 0 to 1. Never throws for what it finds.
std::vector<SessionCheck> check_session(const CheckInputs& inputs, const ModelRegistry& models,
                                        const std::stop_token& stop,
                                        const std::function<void(double)>& progress = {},
                                        const DriverRegistry& drivers = built_in_drivers());

/// The noise that a protocol asks for; kind `none` when it asks for none.
MaskingNoise declared_noise(const Protocol& protocol);

/// A measured level counts as the declared one within this.
inline constexpr double kNoiseTolerance_dBA = 2.0;

/// What the recordings of one session take at most, before compression.
double recording_bytes(const Protocol& protocol);

struct DiskSpace {
  double wanted_bytes = 0.0;  ///< for one session
  double free_bytes = 0.0;
};
/// Without its id and title.
SessionCheck disk_check(const DiskSpace& space);

/// The protocol file is no longer the one that was checked.
class ProtocolChangedSinceCheck final : public PhrasedError {
  using PhrasedError::PhrasedError;
};

/// Compares the file with the SHA-256 of its content when it was checked.
///
/// Errors: ProtocolChangedSinceCheck; ResultsError when there is no such file.
void require_unchanged(const std::filesystem::path& protocol, const std::string& sha256);

/// The first eight digits of a SHA-256, for people.
std::string short_hash(const std::string& sha256);

}  // namespace asperity

// Conditions of a session: the device, the noise and the eye mask, as its rows record them.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/words/phrase.h"
#include "device/device_capability.h"
#include "protocols/design/protocol.h"
#include "results_schema/study.h"

namespace asperity {

/// A device as the store describes it.
struct RecordedDevice {
  std::string text{};  ///< driver and model, as SessionRow::device
  std::string name{};  ///< the driver's; empty where the store has no capability record
  std::string model{};
  std::string serial{};
  std::optional<bool> has_motors{};  ///< absent where the store has no capability record

  /// The simulated hand that moves it: "virtual" for the simulated device, "recorded" for a
  /// replayed recording; empty: the participant's hand.
  std::string hand_of_program() const;
  /// "falcon Novint Falcon, serial number 042"
  std::string full_text() const;
  /// Compares driver, model and serial number, as far as both are stored.
  bool is_same_as(const RecordedDevice& other) const;
};

/// `record_json` as SessionRow::device_json; missing members stay empty.
RecordedDevice recorded_device(const std::string& text, const std::string& record_json);
RecordedDevice recorded_device(const DeviceCapability& device);

/// The noise that masks the sound of the device, as far as the rows document it.
struct RecordedNoise {
  enum class Source {
    not_played,    ///< the program played none, and none was attested
    elsewhere,     ///< played by another source; it was measured at the ear and attested
    program,       ///< played by the program; an attempt during which it failed does not count
    not_recorded,  ///< nothing is stored about it, or the stored description does not state it
  };
  Source source = Source::not_recorded;
  std::optional<double> measured_dBA{};  ///< at the ear
  std::string verified_by{};
};

/// The program and pacing of a stretch of a session, as text.
struct RecordedProgram {
  std::string program{};  ///< "asperity 0.2.0, commit 5979704d1215"
  std::string instruction_set{};
  std::string os{};
  std::string pacing{};  ///< "real_time, scheduling none"
  /// The compute device that evaluated the contacts of two textured bodies; empty: the processor.
  std::string compute{};
};

/// A stretch of uninterrupted running: its conditions are constant.
struct RecordedStretch {
  int segment = 1;  ///< as AttemptRow::segment
  RecordedDevice device{};
  RecordedProgram program{};
  RecordedNoise noise{};
  /// The participant or experimenter confirmed that it was put on.
  bool eye_mask_confirmed = false;
};

/// The stretches in which an attempt was made, in order; all of them where none was. Never empty.
std::vector<RecordedStretch> recorded_stretches(const SessionRow& session,
                                                const std::vector<EventRow>& events,
                                                const std::vector<AttemptRow>& attempts);

/// The device of the last stretch for which one is recorded.
RecordedDevice last_recorded_device(const Study& study, const SessionRow& session);

/// Why the responses of a participant on a device are not study data, and what to do about it:
/// parts of sentences.
struct StudyDataBlocker {
  Phrase problem{};
  Phrase remedy{};
};
/// The participant does not hold the device, or it gives no force and the protocol does not declare
/// `device.input_only`. Nothing where neither applies.
std::optional<StudyDataBlocker> study_data_blocker(const Protocol& protocol,
                                                   const RecordedDevice& device);

/// The event that a session which is resumed on another device stores before `session_resumed`:
/// text as SessionRow::device, data the capability record.
inline constexpr const char* kDeviceChanged = "device_changed";
/// The event of a session that is resumed later than the protocol allows: text the reason, data
/// `age_hours` since it last ran and `maximum_age_hours`. Before `session_resumed`.
inline constexpr const char* kResumedLate = "resumed_late";

}  // namespace asperity

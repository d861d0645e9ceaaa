// Under which conditions a session ran: what its rows record of the device, the noise and the eye mask.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/words/phrase.h"
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

  /// Which hand of the program moves it: "virtual" of the simulated device, "recorded" of a replayed
  /// recording; empty: the participant's.
  std::string hand_of_program() const;
  /// "falcon Novint Falcon, serial number 042"
  std::string full_text() const;
  /// Driver, model and serial number, as far as both are stored.
  bool is_same_as(const RecordedDevice& other) const;
};

/// `record_json` as SessionRow::device_json; what it lacks stays empty.
RecordedDevice recorded_device(const std::string& text, const std::string& record_json);
RecordedDevice recorded_device(const DeviceCapability& device);

/// What the rows support about the noise that covers the device.
struct RecordedNoise {
  enum class Source {
    not_played,    ///< the program played none, and nobody attested any
    elsewhere,     ///< not played by the program; it was measured at the ear and attested
    program,       ///< played by the program; an attempt during which it failed does not count
    not_recorded,  ///< the stored description does not state it
    not_stored,    ///< nothing is stored of it, as asperity 0.1.0 did at a terminal
  };
  Source source = Source::not_stored;
  std::optional<double> measured_dBA{};  ///< at the ear
  std::string verified_by{};
};

/// What ran a stretch of a session, in words.
struct RecordedProgram {
  std::string program{};  ///< "asperity 0.1.0, commit 5979704d1215"
  std::string instruction_set{};
  std::string os{};
  std::string pacing{};  ///< "real_time, scheduling none"
};

/// A stretch of uninterrupted running: its conditions do not change.
struct RecordedStretch {
  int segment = 1;  ///< as AttemptRow::segment
  std::optional<RecordedDevice>
      device{};  ///< absent: asperity 0.1.0 resumed it and did not record it
  RecordedProgram program{};
  RecordedNoise noise{};
  bool eye_mask_confirmed = false;     ///< it was confirmed that it was put on
  bool judges_rendered_force = false;  ///< the hand's normal force was that of the renderer
};

/// Those in which an attempt was made, in order; all of them where none was. Never empty.
std::vector<RecordedStretch> recorded_stretches(const SessionRow& session,
                                                const std::vector<EventRow>& events,
                                                const std::vector<AttemptRow>& attempts);

/// That of the last stretch whose device is recorded.
RecordedDevice last_recorded_device(const Study& study, const SessionRow& session);

/// Why answers that a person gives on a device are no study data, and what to do about it: parts of sentences.
struct StudyDataBlocker {
  Phrase problem{};
  Phrase remedy{};
};
/// The participant does not hold the device, or it gives no force and the protocol does not declare `device.input_only`.
/// Nothing where neither is so.
std::optional<StudyDataBlocker> study_data_blocker(const Protocol& protocol,
                                                   const RecordedDevice& device);
/// The same for a session that is begun or, with its row in the store, resumed. Asperity 0.1.0 began sessions on such
/// devices: these are resumed on one.
std::optional<StudyDataBlocker> study_data_blocker(const Protocol& protocol,
                                                   const RecordedDevice& device,
                                                   const std::optional<SessionRow>& unfinished);

/// The event that a session which is resumed on another device stores before `session_resumed`: text as
/// SessionRow::device, data the capability record.
inline constexpr const char* kDeviceChanged = "device_changed";
/// The event of a session that is resumed later than the protocol has it: text the reason, data `age_hours` since it last
/// ran and `maximum_age_hours`. Before `session_resumed`.
inline constexpr const char* kResumedLate = "resumed_late";

}  // namespace asperity

// Reads session and events as JSON, and follows changes of device through stretches.

#include "app/records/session_conditions.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/profiles/device_kind.h"
#include "app/session/session_compute.h"
#include "app/session/session_setup.h"

namespace asperity {

namespace {

constexpr std::string_view kReplayedRecording = "replay";  // the name of its driver

nlohmann::json object_of(const std::string& text) {
  nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  return json.is_object() ? json : nlohmann::json::object();
}

template <class Value>
std::optional<Value> stored_value(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || found->is_null()) return {};
  try {
    return found->get<Value>();
  } catch (const nlohmann::json::exception&) {
    return {};
  }
}

/// Reads the event `masking_noise`.
RecordedNoise noise_of(const std::string& data_json) {
  const nlohmann::json data = object_of(data_json);
  RecordedNoise noise{};
  noise.measured_dBA = stored_value<double>(data, "measured_dBA");
  noise.verified_by = stored_value<std::string>(data, "verified_by").value_or("");
  const auto kind = stored_value<std::string>(data, "kind");
  const auto heard = stored_value<bool>(data, "heard");
  using Origin = RecordedNoise::Source;
  if (!kind || !heard) {
    noise.source = Origin::not_recorded;
  } else if (*kind == "none") {
    noise.source = Origin::not_played;
  } else if (*heard) {
    noise.source = Origin::program;
  } else {
    noise.source =
        noise.measured_dBA && !noise.verified_by.empty() ? Origin::elsewhere : Origin::not_played;
  }
  return noise;
}

RecordedProgram program_of(const SessionRow& session) {
  return {.program = "asperity " + session.program_version + ", commit " + session.program_commit +
                     ", " + session.program_build,
          .instruction_set = session.instruction_set,
          .os = session.os,
          .pacing = session.pacing + ", scheduling " + session.scheduling};
}

/// From the event with which a stretch begins; missing members are taken from the session.
RecordedProgram program_of(const SessionRow& session, const nlohmann::json& event) {
  const auto stored = [&event](const char* key, const std::string& of_session) {
    return stored_value<std::string>(event, key).value_or(of_session);
  };
  RecordedProgram program = program_of(session);
  const std::string version = stored("program_version", session.program_version);
  const std::string commit = stored("program_commit", session.program_commit);
  const bool is_same = version == session.program_version && commit == session.program_commit &&
                       stored("program_sha256", session.program_sha256) == session.program_sha256;
  if (!is_same) program.program = "asperity " + version + ", commit " + commit;
  program.instruction_set = stored("instruction_set", session.instruction_set);
  program.os = stored("os", session.os);
  program.pacing =
      stored("pacing", session.pacing) + ", scheduling " + stored("scheduling", session.scheduling);
  if (const auto device = stored_compute(event)) program.compute = described(*device);
  return program;
}

/// `device`, unless this event changed the session's device.
void follow_device(const EventRow& event, RecordedDevice& device) {
  if (event.kind == kDeviceChanged) device = recorded_device(event.text, event.data_json);
}

Phrase remedy_for_study_data(const Protocol& protocol) {
  return protocol.input_only
             ? phrase("StudyData",
                      "try the session out in Pilot, or choose a device that a participant holds")
             : phrase("StudyData",
                      "try the session out in Pilot, or choose a device with motors; if the study "
                      "needs no force, set device.input_only to true in the "
                      "protocol, which allows a device without motors");
}

}  // namespace

std::string RecordedDevice::hand_of_program() const {
  if (kind_of_device(name) == DeviceKind::simulated) return "virtual";
  return name == kReplayedRecording ? "recorded" : "";
}

std::string RecordedDevice::full_text() const {
  return serial.empty() ? text : text + ", serial number " + serial;
}

bool RecordedDevice::is_same_as(const RecordedDevice& other) const {
  if (name.empty() || other.name.empty()) return text == other.text;
  return name == other.name && model == other.model && serial == other.serial;
}

RecordedDevice recorded_device(const std::string& text, const std::string& record_json) {
  const nlohmann::json record = object_of(record_json);
  RecordedDevice device{};
  device.text = text;
  device.name = stored_value<std::string>(record, "name").value_or("");
  device.model = stored_value<std::string>(record, "model").value_or("");
  device.serial = stored_value<std::string>(record, "serial").value_or("");
  if (const auto motors = stored_value<int>(record, "actuated_degrees_of_freedom")) {
    device.has_motors = *motors > 0;
  }
  return device;
}

RecordedDevice recorded_device(const DeviceCapability& device) {
  return {.text = device_text(device),
          .name = device.name,
          .model = device.model,
          .serial = device.serial,
          .has_motors = device.actuated_degrees_of_freedom > 0};
}

std::vector<RecordedStretch> recorded_stretches(const SessionRow& session,
                                                const std::vector<EventRow>& events,
                                                const std::vector<AttemptRow>& attempts) {
  RecordedDevice device = recorded_device(session.device, session.device_json);
  std::vector<RecordedStretch> stretches{};
  for (const EventRow& event : events) {
    follow_device(event, device);
    if (event.kind == "session_began" || event.kind == "session_resumed") {
      const nlohmann::json data = object_of(event.data_json);
      RecordedStretch& stretch = stretches.emplace_back();
      stretch.segment =
          stored_value<int>(data, "segment").value_or(static_cast<int>(stretches.size()));
      stretch.program = program_of(session, data);
      stretch.device = device;
    } else if (!stretches.empty()) {
      if (event.kind == "masking_noise") stretches.back().noise = noise_of(event.data_json);
      if (event.kind == "mask_on") stretches.back().eye_mask_confirmed = true;
    }
  }
  if (stretches.empty()) stretches.push_back({.device = device, .program = program_of(session)});
  std::vector<RecordedStretch> used{};
  for (RecordedStretch& stretch : stretches) {
    const auto in_it = [&stretch](const AttemptRow& attempt) {
      return attempt.segment == stretch.segment;
    };
    if (std::none_of(attempts.begin(), attempts.end(), in_it)) continue;
    for (const AttemptRow& attempt : attempts) {
      if (!in_it(attempt)) continue;
      for (const EventRow& event : attempt.events) {
        if (event.kind == "mask_on") stretch.eye_mask_confirmed = true;
      }
    }
    used.push_back(stretch);
  }
  return used.empty() ? stretches : used;
}

RecordedDevice last_recorded_device(const Study& study, const SessionRow& session) {
  RecordedDevice device = recorded_device(session.device, session.device_json);
  for (const EventRow& event : study.events(session.id)) follow_device(event, device);
  return device;
}

std::optional<StudyDataBlocker> study_data_blocker(const Protocol& protocol,
                                                   const RecordedDevice& device) {
  const std::string hand = device.hand_of_program();
  if (!hand.empty()) {
    return StudyDataBlocker{
        (hand == "virtual"
             ? phrase("StudyData",
                      "a virtual hand holds the device \"%1\", so that no participant would feel "
                      "the surfaces")
             : phrase("StudyData",
                      "a recorded hand holds the device \"%1\", so that no participant would feel "
                      "the surfaces"))
            .with(device.text),
        remedy_for_study_data(protocol)};
  }
  if (device.has_motors == false && !protocol.input_only) {
    return StudyDataBlocker{
        phrase("StudyData",
               "the device \"%1\" has no motors, so that no participant would feel the surfaces")
            .with(device.text),
        remedy_for_study_data(protocol)};
  }
  return {};
}

}  // namespace asperity

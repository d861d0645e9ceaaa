// Can this session begin? What is looked at before a person sits down.

#include "app/tasks/session_checks.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "analysis/number_text.h"
#include "app/device_bench/device_choice.h"
#include "app/records/session_conditions.h"
#include "app/session/rig/clock.h"
#include "app/session/rig/recording_columns.h"
#include "app/session/rig/rig.h"
#include "app/session/session_setup.h"
#include "app/session/stimulus_builder.h"
#include "app/tasks/label_notice.h"
#include "app/tasks/protocol_files.h"
#include "app/tasks/sitting.h"
#include "app/tasks/unfinished_session.h"
#include "app/words/device_remarks.h"
#include "app/words/reason.h"
#include "app/words/shell_word.h"
#include "app/words/time_ago.h"
#include "device/pointer_device.h"
#include "device/simulated_models.h"
#include "results_schema/atomic_file.h"
#include "results_schema/sha256.h"
#include "results_schema/study_sharing.h"

namespace asperity {

namespace {

using State = SessionCheck::State;

constexpr double kStoreBytes = 20e6;     // rows of a session, and what SQLite needs to write them
constexpr double kWantedSessions = 2.0;  // room for one more than this
constexpr double kSlowestRate = 0.9;     // of what the protocol asks for
constexpr const char* kStudyCheckLock = "session-check";

std::string bytes_text(double bytes) {
  if (bytes >= 1e9) return fixed(bytes * 1e-9, 1) + " GB";
  return fixed(bytes * 1e-6, 0) + " MB";
}

std::string time_text(double duration_s) {
  if (duration_s >= 1e-3) return fixed(duration_s * 1e3, 2) + " ms";
  return fixed(duration_s * 1e6, 0) + " µs";
}

SessionCheck fine(const Phrase& text) { return {.state = State::fine, .text = text}; }

// --- one check each ------------------------------------------------------------------------------

SessionCheck protocol_check(const CheckInputs& inputs, const Protocol& protocol) {
  SessionCheck check{};
  const std::string sha256 = sha256_of(protocol.source);
  if (!inputs.protocol_sha256.empty() && sha256 != inputs.protocol_sha256) {
    check.state = State::stop;
    check.text =
        phrase("SessionChecks",
               "The file has changed since it was chosen: its SHA-256 was %1 and is now %2.")
            .with(short_hash(inputs.protocol_sha256), short_hash(sha256));
    check.remedy =
        phrase("SessionChecks",
               "Choose the protocol again to read the new version, or restore the earlier file.");
    return check;
  }
  check.text = phrase("SessionChecks", "Valid, version %1, SHA-256 %2.")
                   .with(protocol.version, short_hash(sha256));
  return check;
}

Phrase holder_text(const LockHolder& holder) {
  if (holder.process.empty()) return holder.description;
  return phrase("SessionChecks", "process %1 on host %2, started %3")
      .with(holder.process, holder.host, holder.started_utc);
}

/// A label that names nobody yet, somebody who may begin, or somebody whose session goes on.
SessionCheck participant_check(const CheckInputs& inputs, const Protocol& protocol) {
  SessionCheck check{.state = State::stop};
  const bool is_virtual = inputs.mode == SessionMode::simulate;
  if (inputs.participant.empty()) {
    check.text = phrase("SessionChecks", "No participant has been chosen yet.");
    check.remedy = phrase("SessionChecks", "Choose a participant, or enter a new label.");
    return check;
  }
  if (const auto complaint = complaint_about_label(inputs.participant, is_virtual)) {
    check.text = complaint->as_sentence();
    check.remedy = phrase("SessionChecks", "Enter another label.");
    return check;
  }
  if (const auto holder =
          StudyLock::holder(inputs.study, Study::session_lock_name(inputs.participant))) {
    check.text = phrase("SessionChecks", "A session of %1 is running in %2.")
                     .with(inputs.participant, holder_text(*holder));
    check.remedy = phrase("SessionChecks", "Wait until it has ended, or stop it there.");
    return check;
  }
  const Study study = Study::open(inputs.study, Access::read_only);
  const std::optional<ParticipantRow> known = study.participant(inputs.participant);
  if (known && known->is_virtual != is_virtual) {
    check.text = (known->is_virtual ? phrase("SessionChecks", "%1 is a virtual participant.")
                                    : phrase("SessionChecks", "%1 is a human participant."))
                     .with(inputs.participant);
    check.remedy =
        known->is_virtual
            ? phrase("SessionChecks", "Choose a human participant, or switch to Simulate.")
            : phrase("SessionChecks",
                     "Use the label that the program assigns, or switch to Run or Pilot.");
    return check;
  }
  if (known && known->withdrawn) {
    check.text = phrase("SessionChecks", "%1 has withdrawn.").with(inputs.participant);
    check.remedy = phrase("SessionChecks", "Enter another label.");
    return check;
  }
  if (inputs.resume) {
    const std::optional<SessionRow> going_on =
        unfinished_row(study, protocol, inputs.participant, inputs.resumed_session);
    if (!going_on) {
      check.text = phrase("SessionChecks",
                          "%1 has no unfinished session of this protocol in its present form.")
                       .with(inputs.participant);
      check.remedy = phrase("SessionChecks", "Start a new session instead.");
      return check;
    }
    if (const auto late = late_resume(study, protocol, *going_on)) {
      check.text = complaint_about(*late).as_sentence();
      if (inputs.late_reason.empty()) {
        check.remedy = phrase("SessionChecks", "Enter the reason for resuming it.");
        return check;
      }
      check.state = State::look;
      check.remedy = phrase("SessionChecks", "The reason is stored and stated in the report.");
      return check;
    }
    check.state = State::fine;
    check.text = phrase("SessionChecks", "Session %1 can be resumed.")
                     .with(std::to_string(going_on->session));
    return check;
  }
  const auto [completed, unfinished] =
      sessions_of_participant(study, protocol, inputs.participant, inputs.mode);
  if (!is_virtual && unfinished) {
    check.text = phrase("SessionChecks", "Session %1 of this protocol is unfinished.")
                     .with(std::to_string(unfinished->session));
    check.remedy = phrase("SessionChecks", "Resume it; a new one can start when it is complete.");
    return check;
  }
  if (inputs.mode == SessionMode::run && completed >= protocol.sessions) {
    check.text =
        phrase("SessionChecks", "%1 has completed %2 of %3 planned sessions.")
            .with(inputs.participant, std::to_string(completed), std::to_string(protocol.sessions));
    check.remedy = phrase("SessionChecks", "Choose another participant.");
    return check;
  }
  if (const auto notice = label_notice(study, protocol, inputs.participant, inputs.mode)) {
    check.state = notice->is_planned ? State::fine : State::look;
    check.text = notice->text.as_sentence();
    check.remedy = notice->remedy;
    return check;
  }
  check.state = State::fine;
  check.text =
      (known ? phrase("SessionChecks",
                      "%1 is a participant of the study and has no session running elsewhere.")
             : phrase("SessionChecks", "%1 is new and has no session running elsewhere."))
          .with(inputs.participant);
  return check;
}

SessionCheck readable_study_check(const std::filesystem::path& study) {
  return {.state = State::look,
          .text = phrase("SessionChecks",
                         "On a local disk and writable. Every user of this computer can read it."),
          .remedy = phrase("SessionChecks", "To keep other users out, run: %1")
                        .with("chmod o-rwx " + shell_word(study.string()))};
}

SessionCheck study_check(const CheckInputs& inputs) {
  try {
    // Takes what a session takes: a lock that can be trusted, in a folder that can be written.
    const StudyLock lock(inputs.study, kStudyCheckLock);
    if (is_readable_by_others(inputs.study)) return readable_study_check(inputs.study);
    return fine(phrase("SessionChecks", "On a local disk and writable."));
  } catch (const ResultsError& error) {
    return {
        .state = State::stop,
        .text = phrase_of(error).as_sentence(),
        .remedy = phrase("SessionChecks", "Move the study to a writable folder on a local disk.")};
  }
}

Phrase files_in_words(std::size_t files, bool resume) {
  if (files == 0) return phrase("SessionChecks", "The protocol uses no files.");
  if (files == 1) {
    return resume ? phrase("SessionChecks", "1 file, the same as when the session began.")
                  : phrase("SessionChecks", "1 file, present and unchanged since it was made.");
  }
  return (resume ? phrase("SessionChecks", "%1 files, the same as when the session began.")
                 : phrase("SessionChecks", "%1 files, present and unchanged since they were made."))
      .with(std::to_string(files));
}

SessionCheck stimuli_check(const CheckInputs& inputs, const Protocol& protocol,
                           const ModelRegistry& models) {
  SessionCheck check{.state = State::stop};
  try {
    StimulusBuilder builder(models, inputs.study);
    load_protocol_to_run(inputs.protocol, inputs.study, builder, inputs.rehearsal.get());
  } catch (const ProtocolError& error) {
    for (const Diagnostic& problem : error.diagnostics()) {
      const Phrase sentence = Phrase(problem.message).as_sentence();
      check.text = check.text.empty() ? sentence : Phrase("%1 %2").with(check.text, sentence);
    }
    check.remedy = phrase("SessionChecks", "Restore the files in the study, or make them again.");
    return check;
  }
  const std::vector<StimulusFileRow> files = hash_files(protocol, inputs.study);
  if (inputs.resume) {
    const Study study = Study::open(inputs.study, Access::read_only);
    const SessionRow row =
        find_unfinished(study, protocol, inputs.participant, inputs.resumed_session);
    for (const StimulusFileRow& before : row.files) {
      const bool same = std::any_of(files.begin(), files.end(), [&before](const auto& file) {
        return file.path == before.path && file.sha256 == before.sha256;
      });
      if (same) continue;
      check.text = phrase("SessionChecks", "The file %1 has changed since session %2 began.")
                       .with(before.path, std::to_string(row.session));
      check.remedy =
          phrase("SessionChecks",
                 "Restore the earlier file; this session cannot be resumed with a different file.");
      return check;
    }
  }
  check.state = State::fine;
  check.text = files_in_words(files.size(), inputs.resume);
  return check;
}

/// What the device says of itself; nothing of one that nobody has opened yet.
std::optional<DeviceCapability> capability_of(const CheckInputs& inputs, const Protocol& protocol) {
  switch (kind_of_device(inputs.device)) {
    case DeviceKind::simulated:
      return SteppedRig(rig_settings_for(protocol, {}, inputs.device), 0).capability();
    case DeviceKind::pointer: {
      LatestValue<PointerSample> nobody{};
      return PointerDevice(nobody).capability();
    }
    case DeviceKind::attached:
      break;
  }
  if (inputs.tried == nullptr || !inputs.tried->failure.empty()) return {};
  return inputs.tried->capability;
}

bool has_motors(const DeviceCapability& device) { return device.actuated_degrees_of_freedom > 0; }

std::optional<SessionRow> resumed_row(const CheckInputs& inputs, const Protocol& protocol) {
  if (!inputs.resume) return {};
  return unfinished_row(Study::open(inputs.study, Access::read_only), protocol, inputs.participant,
                        inputs.resumed_session);
}

/// The device that an unfinished session last ran on, where it is another one than this; otherwise empty.
std::string other_device_before(const CheckInputs& inputs,
                                const std::optional<SessionRow>& unfinished,
                                const DeviceCapability& device) {
  if (!unfinished) return {};
  const RecordedDevice before =
      last_recorded_device(Study::open(inputs.study, Access::read_only), *unfinished);
  return before.is_same_as(recorded_device(device)) ? std::string() : before.full_text();
}

/// As the user knows the device.
std::string shown_device(const CheckInputs& inputs, const std::string& otherwise) {
  return inputs.device_name.empty() ? otherwise : inputs.device_name;
}

SessionCheck untried_device_check(const CheckInputs& inputs) {
  SessionCheck check{.state = State::stop};
  if (inputs.tried != nullptr) {
    check.text = inputs.tried->failure;
    check.remedy = phrase("SessionChecks", "Fix the problem, then try the device again.");
    return check;
  }
  check.text = phrase("SessionChecks", "“%1” has not been tried yet.")
                   .with(shown_device(inputs, inputs.device));
  check.remedy = phrase("SessionChecks",
                        "Press “Try this device” while its handle is not held: the device is "
                        "opened, and the servo loop runs for a third of a second without force.");
  return check;
}

SessionCheck device_check(const CheckInputs& inputs, const Protocol& protocol) {
  SessionCheck check{};
  if (!inputs.device_hindrance.empty()) {
    check.state = State::stop;
    check.text = inputs.device_hindrance;
    check.remedy =
        phrase("SessionChecks", "Fix the problem, then press “Rescan”; or choose another device.");
    return check;
  }
  const std::optional<DeviceCapability> device = capability_of(inputs, protocol);
  if (!device) return untried_device_check(inputs);
  const std::vector<Phrase> complaints = complaints_about_device(protocol, *device);
  if (!complaints.empty()) {
    check.state = State::stop;
    check.text = complaints.front().as_sentence();
    check.remedy = phrase("SessionChecks",
                          "Choose another device, or lower the requirements in the protocol.");
    return check;
  }
  const std::optional<SessionRow> unfinished = resumed_row(inputs, protocol);
  if (inputs.mode == SessionMode::run) {
    if (const auto blocker = study_data_blocker(protocol, recorded_device(*device), unfinished)) {
      check.state = State::stop;
      check.text = blocker->problem.as_sentence();
      check.remedy = blocker->remedy.as_sentence();
      return check;
    }
  }
  if (!has_motors(*device)) {
    check.text =
        phrase(
            "SessionChecks",
            "“%1” moves and presses the probe but exerts no force: the participant feels nothing.")
            .with(shown_device(inputs, device->name));
  } else {
    check.text =
        phrase("SessionChecks",
               "“%1” exerts up to %2 N at up to %3 Hz; the protocol requires %4 N at %5 Hz.")
            .with(shown_device(inputs, called(*device)), fixed(device->peak_force_N, 1),
                  fixed(device->maximum_rate_Hz, 0), fixed(protocol.force_limit_N, 1),
                  fixed(protocol.rate_Hz, 0));
  }
  const std::string before = other_device_before(inputs, unfinished, *device);
  if (!before.empty()) {
    check.state = State::look;
    check.text =
        phrase("SessionChecks", "%1 The session last ran on “%2”.").with(check.text, before);
    check.remedy = phrase("SessionChecks",
                          "Choose the device on which the session last ran, unless a change is "
                          "intended; a change is stored and stated in the report.");
  }
  if (inputs.mode == SessionMode::run && study_data_blocker(protocol, recorded_device(*device))) {
    check.state = State::look;
    check.text = phrase("SessionChecks",
                        "%1 The session began without a force that a participant could feel, and "
                        "is resumed in the same way; the report states this.")
                     .with(check.text);
    check.remedy = phrase("SessionChecks", "For new sessions choose a device with motors.");
  }
  return check;
}

// --- the device's profile ------------------------------------------------------------------------

/// Warnings of one kind are one line: the first, and how many stimuli it concerns beside.
std::vector<SessionCheck> lines_of(const std::vector<RehearsalWarning>& warnings) {
  std::vector<SessionCheck> lines{};
  std::vector<std::string> kinds{};
  for (const RehearsalWarning& warning : warnings) {
    if (std::find(kinds.begin(), kinds.end(), warning.id) != kinds.end()) continue;
    kinds.push_back(warning.id);
    const auto alike =
        std::count_if(warnings.begin(), warnings.end(),
                      [&warning](const RehearsalWarning& one) { return one.id == warning.id; });
    SessionCheck line{.id = "rehearsal",
                      .title = phrase("SessionChecks", "Rehearsal"),
                      .state = State::look,
                      .text = warning.text};
    if (alike > 1) {
      line.text = phrase("SessionChecks", "%1 The same applies to %2 more.")
                      .with(warning.text, std::to_string(alike - 1));
    }
    lines.push_back(line);
  }
  if (!lines.empty()) {
    lines.back().remedy = phrase("SessionChecks",
                                 "Choose another device, or stimuli that this one can render; "
                                 "otherwise these warnings are stored with the session.");
  }
  return lines;
}

bool is_of_limits(const RehearsalWarning& warning) {
  return warning.id.starts_with("limit_") || warning.id.starts_with("unmeasured_");
}

/// What the study knows of the device, and what of the plan is beyond that. As a session asks it, which
/// refuses what is refused here.
std::vector<SessionCheck> calibration_checks(const CheckInputs& inputs, const Protocol& protocol,
                                             const ModelRegistry& models,
                                             const std::stop_token& stop,
                                             const std::function<void(double)>& progress) {
  if (inputs.mode == SessionMode::simulate) {
    return {fine(phrase("SessionChecks", "Not needed: the simulated device has none."))};
  }
  WantedDevice wanted{.which = which_device(inputs.device),
                      .asked = inputs.device,
                      .options = as_command_options(inputs.driver_options)};
  const std::optional<DeviceCapability> device = capability_of(inputs, protocol);
  if (device) {
    wanted.which = {device->name, device->model, device->serial};
    wanted.has_motors = has_motors(*device);
  }
  StimulusBuilder builder(models, inputs.study);
  const Rehearse rehearse = [&](const DeviceProfile& profile) {
    return rehearse_once(inputs.rehearsal.get(), protocol, profile, inputs.study, builder,
                         {.stop = stop, .progress = progress});
  };
  const std::string now_utc = SystemClock(0).utc();
  const RehearsedDevice found = rehearsed_device(protocol, wanted, inputs.study, now_utc, rehearse);
  if (!found.profile) {
    const bool is_stand_in = device && !model_stood_for(device->model).empty();
    if (kind_of_device(inputs.device) == DeviceKind::simulated && !is_stand_in) {
      return {fine(phrase("SessionChecks", "Not needed: the simulated device has none."))};
    }
    if (device && !has_motors(*device)) {
      return {fine(phrase("SessionChecks", "Not needed: the device exerts no force."))};
    }
    return {{.state = State::look,
             .text = phrase("SessionChecks",
                            "The study has no profile of this device: whether it can render these "
                            "stimuli has not been checked."),
             .remedy = phrase("SessionChecks",
                              "Measure the device once while its handle is not held: asperity "
                              "device-test \"%1\" --study \"%2\"")
                           .with(inputs.device, inputs.study.string())}};
  }
  const Phrase age = phrase("SessionChecks", "Measured %1")
                         .with(time_ago(kHoursADay * age_days(*found.profile, now_utc)));
  const std::vector<SessionCheck> beyond = lines_of(found.warnings);
  // Its limits are compared first.
  const bool breaks_limits = !found.warnings.empty() && is_of_limits(found.warnings.front());
  const bool is_beyond = !found.warnings.empty() && !is_of_limits(found.warnings.back());
  const std::vector<DeviceTrait> uncompared = not_compared(found.profile->not_known);
  SessionCheck profile{};
  if (is_beyond) {
    profile.text =
        phrase("SessionChecks", "%1; some stimuli exceed the capabilities of the device.")
            .with(age);
  } else if (breaks_limits) {
    const Phrase text = uncompared.empty()
                            ? phrase("SessionChecks",
                                     "%1; every stimulus is within the capabilities of the device, "
                                     "but the device does not meet the protocol's limits.")
                            : phrase("SessionChecks",
                                     "%1; every stimulus is within the known capabilities of the "
                                     "device, but the device does not meet the protocol's limits.");
    profile.text = text.with(age);
  } else {
    const Phrase text =
        uncompared.empty()
            ? phrase("SessionChecks",
                     "%1; every stimulus is within the capabilities of the device.")
            : phrase("SessionChecks",
                     "%1; every stimulus is within the known capabilities of the device.");
    profile.text = text.with(age);
  }
  if (!uncompared.empty()) {
    profile.state = State::look;
    profile.text = phrase("SessionChecks", "%1 Unknown for %2 and not compared: %3.")
                       .with(profile.text, found.profile->stands_for(), listed_traits(uncompared));
    profile.remedy = phrase("SessionChecks", "Measure a real device as soon as one is available.");
  }
  // What breaks a limit of the protocol's has a line of its own.
  DeviceProfile unlimited = *found.profile;
  std::erase_if(unlimited.items, [&protocol](const DeviceItem& item) {
    return protocol.device_limits.contains(item.name);
  });
  if (failed_item(unlimited, protocol) != nullptr) {
    profile.state = State::look;
    profile.text = phrase("SessionChecks", "%1 The device failed an item of the measurement.")
                       .with(profile.text);
    profile.remedy =
        phrase("SessionChecks", "Check the profile of the device, and measure the device again.");
  }
  std::vector<SessionCheck> lines{profile};
  lines.insert(lines.end(), beyond.begin(), beyond.end());
  return lines;
}

// --- the loop ------------------------------------------------------------------------------------

TriedDevice try_loop(const CheckInputs& inputs, const Protocol& protocol,
                     const DriverRegistry& drivers) {
  LatestValue<PointerSample> nobody{};
  return inputs.trial(inputs.device, protocol, drivers, {.pointer = &nobody}, {});
}

/// The loop says nothing of a device that is not there, or that nobody has opened yet.
bool can_be_tried(const CheckInputs& inputs) {
  if (!inputs.device_hindrance.empty()) return false;
  if (inputs.pacing == RunPacing::stepped) return true;  // it has no loop of its own
  if (inputs.tried != nullptr) return inputs.tried->failure.empty();
  try {
    return kind_of_device(inputs.device) != DeviceKind::attached;
  } catch (const std::exception&) {
    return false;  // there is no such device, which its own line says
  }
}

struct LoopChecks {
  SessionCheck zero{};
  SessionCheck rate{};
};
LoopChecks loop_checks(const CheckInputs& inputs, const Protocol& protocol,
                       const DriverRegistry& drivers) {
  if (inputs.pacing == RunPacing::stepped) {
    return {fine(phrase("SessionChecks", "Not needed: no handle is held in a fast simulation.")),
            fine(phrase("SessionChecks", "Not needed: a fast simulation has its own clock."))};
  }
  const TriedDevice trial =
      inputs.tried != nullptr ? *inputs.tried : try_loop(inputs, protocol, drivers);
  if (!trial.failure.empty()) throw PhrasedError(trial.failure);
  const ServoQualityRow& quality = trial.quality;
  SessionCheck zero{};
  if (trial.fault != Fault::none) {
    zero.state = State::stop;
    zero.text =
        phrase("SessionChecks", "The device reported a fault: %1.").with(phrase_of(trial.fault));
    zero.remedy = phrase("SessionChecks", "Fix the device, then check again.");
  } else if (trial.strongest_N > 0.0) {
    zero.state = State::stop;
    zero.text =
        phrase("SessionChecks", "A force of %1 N was sent although no surface was presented.")
            .with(fixed(trial.strongest_N, 3));
    zero.remedy = phrase("SessionChecks",
                         "Release the handle, switch the device off and on, then check again.");
  } else {
    zero.text =
        phrase("SessionChecks", "Exactly 0 N in %1 ticks.").with(std::to_string(quality.ticks));
  }
  SessionCheck rate{};
  const double measured_Hz = quality.period_mean_s > 0.0 ? 1.0 / quality.period_mean_s : 0.0;
  rate.text =
      phrase("SessionChecks", "%1 of %2 Hz; period p99 %3, lateness p99 %4, missed deadlines: %5.")
          .with(fixed(measured_Hz, 0), fixed(protocol.rate_Hz, 0), time_text(quality.period_p99_s),
                time_text(quality.lateness_p99_s), std::to_string(quality.missed_deadlines));
  if (measured_Hz < kSlowestRate * protocol.rate_Hz) {
    rate.state = State::stop;
    rate.remedy =
        phrase("SessionChecks",
               "This computer is too slow or too busy: close other programs, then check again.");
  } else if (quality.missed_deadlines > 0 || quality.lateness_p99_s > 0.5 / protocol.rate_Hz) {
    rate.state = State::look;
    rate.remedy =
        phrase("SessionChecks",
               "Close other programs; a trial with more than %1 missed deadlines does not count.")
            .with(std::to_string(protocol.maximum_missed_deadlines));
  }
  return {zero, rate};
}

SessionCheck screens_check(const CheckInputs& inputs) {
  if (inputs.mode == SessionMode::simulate) {
    return fine(
        phrase("SessionChecks", "Not needed: no participant looks at the participant's window."));
  }
  if (inputs.screens >= 2) {
    return fine(phrase("SessionChecks", "%1 screens: one for each window.")
                    .with(std::to_string(inputs.screens)));
  }
  return {.state = State::look,
          .text = phrase(
              "SessionChecks",
              "One screen: the two windows are side by side, and the participant can see both."),
          .remedy = phrase("SessionChecks", "Connect a second screen for the participant.")};
}

SessionCheck noise_check(const CheckInputs& inputs, const Protocol& protocol) {
  // Silence says that all is right: who hears no tones is told so whatever the hand does.
  const bool guides_by_tones = std::any_of(
      protocol.explorations.begin(), protocol.explorations.end(),
      [](const auto& each) { return each.second.guidance == Exploration::Guidance::tones; });
  if (guides_by_tones && !inputs.sound_card && inputs.mode != SessionMode::simulate) {
    SessionCheck unheard{};
    unheard.state = inputs.mode == SessionMode::run ? State::stop : State::look;
    unheard.text =
        phrase("SessionChecks",
               "There is no sound output: the tones by which the protocol guides the hand cannot "
               "be heard, and silence would indicate that force and speed are correct.");
    unheard.remedy = phrase("SessionChecks", "Connect headphones, then check again.");
    return unheard;
  }
  const MaskingNoise declared = declared_noise(protocol);
  if (declared.kind == MaskingNoise::Kind::none) {
    const bool led_by_cues =
        protocol.vision == Vision::blindfold && inputs.mode != SessionMode::simulate;
    if (inputs.sound_card || !led_by_cues) {
      return fine(phrase("SessionChecks", "The protocol requires none."));
    }
    SessionCheck check{};
    check.state = State::look;
    check.text =
        phrase("SessionChecks",
               "There is no sound output: a participant who wears an eye mask hears no cues.");
    check.remedy =
        phrase("SessionChecks",
               "Connect headphones, then check again; or guide the participant by voice.");
    return check;
  }
  if (inputs.mode == SessionMode::simulate) {
    return fine(phrase("SessionChecks", "Not needed: no participant listens."));
  }
  SessionCheck check{};
  // A pilot may find out what the level has to be; study data needs it as declared.
  const State when_wrong = inputs.mode == SessionMode::run ? State::stop : State::look;
  // Without a sound output somebody has to have measured, and to answer for, what is heard instead.
  if (!inputs.sound_card && !inputs.noise.is_attested()) {
    check.state = when_wrong;
    check.text =
        phrase("SessionChecks",
               "There is no sound output: the noise that the protocol requires cannot be heard.");
    check.remedy = phrase("SessionChecks",
                          "Connect headphones, then check again; or play the noise from another "
                          "source, measure it at the ear, and enter the level and your name.");
    return check;
  }
  if (!inputs.noise.is_attested()) {
    check.state = when_wrong;
    check.text =
        inputs.noise.measured_dBA
            ? phrase("SessionChecks", "It is not stated who measured the level at the ear.")
            : phrase("SessionChecks", "The level at the ear was not measured.");
    check.remedy =
        phrase("SessionChecks",
               "Play the noise, measure it at the ear, and enter the level and your name.");
    return check;
  }
  const std::string measured_dBA = fixed(*inputs.noise.measured_dBA, 1);
  if (declared.declared_dBA &&
      std::abs(*inputs.noise.measured_dBA - *declared.declared_dBA) > kNoiseTolerance_dBA) {
    check.state = when_wrong;
    check.text =
        phrase("SessionChecks", "%1 dB(A) at the ear; the protocol requires %2 ± %3 dB(A).")
            .with(measured_dBA, fixed(*declared.declared_dBA, 1), fixed(kNoiseTolerance_dBA, 0));
    check.remedy = phrase("SessionChecks", "Change the gain and measure again.");
    return check;
  }
  if (!inputs.sound_card) {
    check.state = State::look;
    check.text = phrase("SessionChecks",
                        "There is no sound output here; the noise comes from another source, %1 "
                        "dB(A) at the ear, verified by %2.")
                     .with(measured_dBA, inputs.noise.verified_by);
    return check;
  }
  check.text = phrase("SessionChecks", "%1 dB(A) at the ear, verified by %2.")
                   .with(measured_dBA, inputs.noise.verified_by);
  return check;
}

SessionCheck disk_check_of(const CheckInputs& inputs, const Protocol& protocol) {
  std::error_code error{};
  const std::filesystem::space_info space = std::filesystem::space(inputs.study, error);
  if (error) {
    return {
        .state = State::look,
        .text = phrase("SessionChecks", "The free space cannot be determined: %1.")
                    .with(error.message()),
        .remedy = phrase("SessionChecks", "Make sure that the disk has room for the recordings.")};
  }
  return disk_check({.wanted_bytes = recording_bytes(protocol) + kStoreBytes,
                     .free_bytes = static_cast<double>(space.available)});
}

/// What goes wrong in looking is what was found.
template <class Look>
SessionCheck looked_at(const std::string& id, const Phrase& title, Look look) {
  SessionCheck check{};
  try {
    check = look();
  } catch (const std::exception& error) {
    check = {.state = State::stop,
             .text = phrase_of(error).as_sentence(),
             .remedy = phrase("SessionChecks", "Fix the problem, then check again.")};
  }
  check.id = id;
  check.title = title;
  return check;
}

}  // namespace

std::vector<SessionCheck> check_session(const CheckInputs& inputs, const ModelRegistry& models,
                                        const std::stop_token& stop,
                                        const std::function<void(double)>& progress,
                                        const DriverRegistry& drivers) {
  std::vector<SessionCheck> checks{};
  std::optional<Protocol> protocol{};
  checks.push_back(looked_at("protocol", phrase("SessionChecks", "Protocol"), [&] {
    protocol = load_protocol(inputs.protocol, models, inputs.study);
    return protocol_check(inputs, *protocol);
  }));
  if (!protocol) return checks;
  const auto add = [&](const std::string& id, const Phrase& title, auto look) {
    if (!stop.stop_requested()) checks.push_back(looked_at(id, title, look));
  };
  add("participant", phrase("SessionChecks", "Participant"),
      [&] { return participant_check(inputs, *protocol); });
  add("study", phrase("SessionChecks", "Study folder"), [&] { return study_check(inputs); });
  add("disk", phrase("SessionChecks", "Disk space"),
      [&] { return disk_check_of(inputs, *protocol); });
  add("stimuli", phrase("SessionChecks", "Stimuli"),
      [&] { return stimuli_check(inputs, *protocol, models); });
  add("device", phrase("SessionChecks", "Device"), [&] { return device_check(inputs, *protocol); });
  std::vector<SessionCheck> beyond{};
  add("calibration", phrase("SessionChecks", "Calibration"), [&] {
    std::vector<SessionCheck> lines = calibration_checks(inputs, *protocol, models, stop, progress);
    beyond.assign(lines.begin() + 1, lines.end());
    return lines.front();
  });
  checks.insert(checks.end(), beyond.begin(), beyond.end());
  std::optional<SessionCheck> rate{};  // found in the same few hundred ticks
  if (can_be_tried(inputs)) {
    add("force_zero", phrase("SessionChecks", "Force zero"), [&] {
      auto [zero, its_rate] = loop_checks(inputs, *protocol, drivers);
      rate = its_rate;
      return zero;
    });
  }
  if (rate) add("rate", phrase("SessionChecks", "Rate"), [&] { return *rate; });
  add("screens", phrase("SessionChecks", "Screens"), [&] { return screens_check(inputs); });
  add("masking_noise", phrase("SessionChecks", "Masking noise"),
      [&] { return noise_check(inputs, *protocol); });
  return checks;
}

MaskingNoise declared_noise(const Protocol& protocol) {
  MaskingNoise noise{};
  switch (protocol.masking_noise.kind) {
    case Protocol::Noise::Kind::none:
      noise.kind = MaskingNoise::Kind::none;
      break;
    case Protocol::Noise::Kind::white:
      noise.kind = MaskingNoise::Kind::white;
      break;
    case Protocol::Noise::Kind::pink:
      noise.kind = MaskingNoise::Kind::pink;
      break;
  }
  noise.declared_dBA = protocol.masking_noise.level_dBA;
  return noise;
}

double recording_bytes(const Protocol& protocol) {
  if (!protocol.record) return 0.0;
  // An attempt is recorded from its first pause to its answer: at most the whole session.
  constexpr double kBytesPerRecord = sizeof(std::int64_t) + kRecordingColumns * sizeof(float);
  const PlanCost cost = cost_of(protocol, make_plan(protocol, {1, 0}));
  return cost.total_s * protocol.rate_Hz * kBytesPerRecord;
}

SessionCheck disk_check(const DiskSpace& space) {
  SessionCheck check{};
  check.text = phrase("SessionChecks", "%1 free; this session requires at most %2.")
                   .with(bytes_text(space.free_bytes), bytes_text(space.wanted_bytes));
  if (space.free_bytes < space.wanted_bytes) {
    check.state = State::stop;
    check.remedy = phrase("SessionChecks", "Free some space on the disk of the study.");
  } else if (space.free_bytes < kWantedSessions * space.wanted_bytes) {
    check.state = State::look;
    check.remedy =
        phrase("SessionChecks",
               "Enough for this session, but hardly for another one: free some space soon.");
  }
  return check;
}

void require_unchanged(const std::filesystem::path& protocol, const std::string& sha256) {
  const std::string now = sha256_of_file(protocol);
  if (now == sha256) return;
  throw ProtocolChangedSinceCheck(
      phrase("SessionChecks",
             "the protocol %1 has changed since it was checked: its SHA-256 was %2 and is now %3; "
             "choose it again to read and check the new version")
          .with(protocol.string(), short_hash(sha256), short_hash(now)));
}

std::string short_hash(const std::string& sha256) { return sha256.substr(0, 8); }

}  // namespace asperity

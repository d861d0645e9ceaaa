// Holds the table of kinds with meaning, end, HED tags and public data.

#include "app/words/event_kinds.h"

#include <algorithm>
#include <array>

#include "results_schema/rows.h"

namespace asperity {

const std::vector<EventKind>& event_kinds() {
  static const std::vector<EventKind> kKinds{
      {.name = "session_began",
       .meaning = "the session began. Data: the program that runs this segment of the session; "
                  "`utc`, when it began; `device` as in `session`, and "
                  "`judged_force`, the normal force by which the exploration is assessed: `sent`, "
                  "or `rendered` for a device without motors; "
                  "`compute`, the `device`, `platform` and `driver` that evaluated the contacts of "
                  "two textured bodies, where it was not the processor",
       .hed = "Experiment-structure",
       .text_is_public = true,
       .public_data = {"program_version", "program_commit", "program_sha256", "instruction_set",
                       "pacing", "scheduling", "device", "judged_force", "compute", "segment"},
       .dating_data = {"program_version", "program_commit", "program_sha256", "instruction_set",
                       "compute"}},
      {.name = "session_resumed",
       .meaning = "the session was resumed after an interruption. Data: as in `session_began`",
       .hed = "Experiment-structure",
       .text_is_public = true,
       .public_data = {"program_version", "program_commit", "program_sha256", "instruction_set",
                       "pacing", "scheduling", "device", "judged_force", "compute", "segment"},
       .dating_data = {"program_version", "program_commit", "program_sha256", "instruction_set",
                       "compute"}},
      {.name = "resumed_late",
       .meaning =
           "the session was resumed later than the protocol allows (`resume.maximum_age_hours`); "
           "stored before `session_resumed`. Text: the experimenter's reason. Data: `age_hours`, "
           "the hours since the session last ran, and `maximum_age_hours`",
       .hed = "Experiment-structure",
       .public_data = {"age_hours", "maximum_age_hours"},
       .dating_data = {"age_hours"},
       .text_is_words = true},
      {.name = "device_changed",
       .meaning = "the session was resumed on a device other than the one on which it last ran; "
                  "stored before `session_resumed`. Text: as in `session.device`. Data: as in "
                  "`session.device_json`",
       .hed = "Experiment-control, Device",
       .text_is_public = true},
      {.name = "text_as_read",
       .meaning = "a text with placeholders, as this segment of the session shows it, in the "
                  "language of the session; the consent's, as the participant agreed to it before "
                  "the first segment. Data: `place`, its JSON pointer in the protocol",
       .hed = "Experiment-structure",
       .text_is_public = true,
       .public_data = {"place"}},
      {.name = "device_profile",
       .meaning = "the measured profile with which the device of this segment was compared. Text: "
                  "the device, its model and the time of measurement. Data: the profile",
       .hed = "Experiment-control, Device"},
      {.name = "plugin",
       .meaning =
           "a plug-in with a force model that this segment of the session loaded, whether or "
           "not its protocol uses it. Text: the model and its version. Data: `model`, "
           "`version`, `sha256` of the shared library, its name as `file`, and "
           "`declaration`, the parameters of the model",
       .hed = "Experiment-control",
       .text_is_public = true,
       .public_data = {"model", "version", "sha256"},
       .dating_data = {"version", "sha256"}},
      {.name = kDealtEvent,
       .meaning = "the study is divided among stations, and the group and the row of the "
                  "counterbalancing are those of this place in the whole study. Text and data: "
                  "`place`, from 1",
       .hed = "Experiment-control",
       .public_data = {"place"}},
      {.name = "rehearsal",
       .meaning = "a warning from the comparison of the plan with the measured device. Data: the "
                  "check, the stimulus, the requirement and the value of the device",
       .hed = "Experiment-control, Warning, Device",
       .text_is_public = true,
       .public_data = {"check", "stimulus", "asked", "device"}},
      {.name = "guidance",
       .meaning = "whether the participant saw and heard the guidance of the protocol: `given` or "
                  "`not_given`",
       .hed = "Experiment-control, Instructional",
       .text_is_public = true},
      {.name = "stimulus_wait",
       .meaning = "an attempt began late because its stimuli were not ready; not stored for delays "
                  "below 0.1 s. Data: `trial`, `attempt`, and `waited_s`",
       .hed = "Experiment-control",
       .public_data = {"trial", "attempt", "waited_s"}},
      {.name = "roughness_match",
       .meaning = "a block determined the amplitude at which the participant judged a stimulus as "
                  "rough as the reference. Text: the status, as in `presentations.tsv`. Data: "
                  "`block`, `stimulus`, `model`, `texture`, `relative_amplitude`, `status`, "
                  "`answers` and `reversals` of all tracks",
       .hed = "Experiment-control",
       .text_is_public = true,
       .public_data = {"block", "stimulus", "model", "texture", "relative_amplitude", "status",
                       "answers", "reversals"}},
      {.name = "session_completed",
       .meaning = "the session ended as planned. Text: the reason",
       .hed = "Experiment-structure",
       .text_is_words = true},
      {.name = "session_stopped",
       .meaning = "the session was stopped and can be resumed. Text: the reason",
       .hed = "Experiment-structure, Halt",
       .text_is_words = true},
      {.name = "session_failed",
       .meaning = "an error ended the session. Text: the error",
       .hed = "Experiment-structure, Mishap",
       .text_is_words = true},
      {.name = "phase",
       .meaning =
           "a phase of the session began: `ready`, `iti`, `fore`, `contact`, `response`, "
           "`feedback`, `rest`, `questions`, `paused`, `fault` or `ended`. Only for sessions that "
           "are shown in a window; `fore`, `contact` and `response` belong to their attempt",
       .hed = "Experiment-structure",
       .ended_by = {"phase"},
       .text_is_public = true},
      {.name = "check_passed",
       .meaning = "a check that the protocol requires was passed. Text: `device` or `force_zero`",
       .hed = "Experiment-control, Device",
       .text_is_public = true},
      {.name = "break_began",
       .meaning = "a break began",
       .hed = "Experiment-structure, (Experiment-participant, Rest)",
       .ended_by = {"break_ended"},
       .text_is_public = true},
      {.name = "break_ended",
       .meaning = "the break ended",
       .hed = "Experiment-structure",
       .text_is_public = true},
      {.name = "force_zeroed",
       .meaning = "the force was verified to be zero in a break",
       .hed = "Experiment-control, Device",
       .text_is_public = true},
      {.name = "drift_checked",
       .meaning = "the reading of the device was recorded in a break while nothing moved it. Text: "
                  "`hand_off` or `tip`. Data: `ticks`, `duration_s`, the mean `position_m`, "
                  "`noise_m`, `drift_m`, the distance `shift_m` from the first such check of the "
                  "session, and with the limit `limit_m` of the device whether noise and drift "
                  "`passed`",
       .hed = "Experiment-control, Device",
       .text_is_public = true,
       .public_data = {"ticks", "duration_s", "position_m", "noise_m", "drift_m", "shift_m",
                       "limit_m", "passed"}},
      {.name = "criterion_not_met",
       .meaning = "a block ended before its criterion was met. Text: the block",
       .hed = "Experiment-control",
       .text_is_public = true},
      {.name = "external_program",
       .meaning = "the program that states the levels of a run of a block was started. Text: its "
                  "name. Data: `block_ordinal`; `program`, `arguments` and `sha256`, the name of "
                  "its file, its arguments and the checksum of its file; `argument_sha256`, the "
                  "checksums of the arguments that are files; `log`, the file with what it wrote "
                  "to its standard error",
       .hed = "Experiment-control",
       .text_is_public = true,
       .public_data = {"block_ordinal", "program", "sha256"},
       .dating_data = {"sha256"}},
      {.name = "external_level",
       .meaning = "the external program stated a step of a track. Data: `block_ordinal`, `track` "
                  "and `step`; `stated`, the level as stated, and `level`, the nearest level of "
                  "the block, which is presented; or `end`, the end of the track",
       .hed = "Experiment-control",
       .public_data = {"block_ordinal", "track", "step", "stated", "level", "end"}},
      {.name = "external_program_failed",
       .meaning = "the external program failed, and the session waited or was stopped; or its "
                  "standard error could not be kept until it ended. Text: what failed",
       .hed = "Experiment-control, Warning",
       .text_is_words = true},
      {.name = "paused",
       .meaning = "the session was paused",
       .hed = "Experiment-control, Pause",
       .ended_by = {"resumed"},
       .text_is_public = true},
      {.name = "resumed",
       .meaning = "the pause ended",
       .hed = "Experiment-control",
       .text_is_public = true},
      {.name = "fault",
       .meaning =
           "a fault or the emergency stop set the force to zero; the trial that it "
           "interrupted is presented again. Text: the fault. Data, if a plug-in failed: `reason`, "
           "which contains its message",
       .hed = "Experiment-control, Mishap, Device",
       .ended_by = {"fault_cleared"},
       .text_is_public = true,
       .public_data = {"reason"}},
      {.name = "fault_cleared",
       .meaning = "the fault was cleared",
       .hed = "Experiment-control, Device",
       .text_is_public = true},
      {.name = "device_trouble",
       .meaning = "a problem that the device reported. Text: the message to the experimenter; "
                  "stored when the problem begins, when the message changes (at most every ten "
                  "seconds) and, as `device_well`, when the problem ends",
       .hed = "Experiment-control, Warning, Device",
       .ended_by = {"device_well", "device_trouble"}},
      {.name = "device_well",
       .meaning = "the device no longer reports a problem",
       .hed = "Experiment-control, Device",
       .text_is_public = true},
      {.name = "trial_repeated",
       .meaning = "the experimenter had the last trial repeated. Text: the reason. Data: the trial "
                  "and the attempt that was invalidated",
       .hed = "Experiment-control, (Experimenter, Repeat)",
       .public_data = {"trial", "attempt"},
       .text_is_words = true},
      {.name = "repeat_refused",
       .meaning = "there was no trial to repeat. Text: the reason",
       .hed = "Experiment-control",
       .text_is_public = true,
       .text_is_words = true},
      {.name = "masking_noise",
       .meaning = "the masking noise of the segment that begins. Data: `kind`, `gain`, the "
                  "declared and the measured level, `verified_by` (who measured the level) and the "
                  "sound output. Kind `none` with `heard` false: no sound could be played, for "
                  "example at a terminal",
       .hed = "Sensory-event, Auditory-presentation, Signal-noise",
       .text_is_public = true,
       .public_data = {"kind", "gain", "declared_dBA", "measured_dBA", "generator", "heard",
                       "rate_Hz", "buffer_s"},
       .dating_data = {"measured_dBA"}},
      {.name = "masking_noise_lost",
       .meaning = "the noise stopped during a trial, or could not be played when the next one was "
                  "to begin; the session was paused",
       .hed = "Experiment-control, Mishap, Signal-noise",
       .text_is_public = true},
      {.name = "masking_noise_missing",
       .meaning = "the noise could not start, because the sound card did not play; the session was "
                  "paused before its first trial, or before the first trial after it was resumed",
       .hed = "Experiment-control, Mishap, Signal-noise",
       .text_is_public = true},
      {.name = "mask_on",
       .meaning = "the participant confirmed that the eye mask is on",
       .hed = "Experiment-control",
       .ended_by = {"mask_off"},
       .text_is_public = true},
      {.name = "mask_off",
       .meaning = "the participant confirmed that the eye mask is off",
       .hed = "Experiment-control",
       .text_is_public = true},
      {.name = "experimenter_ready",
       .meaning = "the experimenter confirmed the action that the protocol requires before the "
                  "trial or in a drift check, or the result of this check. Text: the action or "
                  "the result",
       .hed = "Experiment-control, Experimenter",
       .text_is_public = true},
      {.name = "input",
       .meaning =
           "an input of the participant, such as `option 2`. Data: `source`, and for an "
           "input without effect the reason: `meant_for_an_earlier_scene`, `too_soon` "
           "(within 0.2 s of the question; a request to feel again within 1 s where "
           "feeling had ended without a request), `after_the_deadline`. What is done in a form "
           "(a question about the participant or the session) is `answer`, because only its "
           "answer is stored, with the responses",
       .hed = "Agent-action, Experiment-participant, Participant-response",
       .text_is_public = true,
       .public_data = {"source", "held_s", "meant_for_an_earlier_scene", "too_soon",
                       "after_the_deadline"}},
      {.name = "input_released",
       .meaning = "a key or button was released. Text: its name. Data: `held_s`, for how long it "
                  "was held",
       .hed = "Agent-action, Experiment-participant, Release",
       .text_is_public = true,
       .public_data = {"source", "held_s"}},
      {.name = "refused",
       .meaning =
           "an input was refused. Text: the message that was shown, in English. Data: the input",
       .hed = "Sensory-event, Visual-presentation, Feedback, Experiment-participant",
       .text_is_public = true,
       .public_data = {"input"}},
      {.name = "estimate_doubted",
       .meaning = "an estimate was re-elicited. Text: the number. Data: `estimate`, "
                  "`earlier_estimate` of the same stimulus in this session, `from_cue_s`",
       .hed = "Experiment-control, Repeat",
       .text_is_public = true,
       .public_data = {"estimate", "earlier_estimate", "from_cue_s"}},
      {.name = "note",
       .meaning = "the experimenter wrote a note. Text: the note",
       .hed = "Experiment-control, Experimenter, Note",
       .text_is_words = true},
      {.name = "unblinded",
       .meaning = "the experimenter displayed the names of the stimuli. Text: the reason",
       .hed = "Experiment-control, Experimenter",
       .ended_by = {"blinded_again"},
       .text_is_words = true},
      {.name = "blinded_again",
       .meaning = "the stimuli were hidden from the experimenter again",
       .hed = "Experiment-control, Experimenter",
       .text_is_public = true},
      {.name = "consent_seen",
       .meaning = "the participant's consent was witnessed. Text: by whom",
       .hed = "Experiment-control, Experimenter",
       .text_is_words = true},
      {.name = "focus_changed",
       .meaning = "the keyboard focus changed. Text: where key presses go from now on: "
                  "`participant`, `experimenter`, `experimenter, text field` or `another program`",
       .hed = "Experiment-control, Input-device",
       .text_is_public = true},
      {.name = "picture_unreadable",
       .meaning = "a picture could not be shown to the participant. Text: its name",
       .hed = "Experiment-control, Mishap, Image",
       .text_is_public = true},
      {.name = "screen_lost",
       .meaning = "the participant's screen was disconnected; the force was set to zero. Text: the "
                  "screen",
       .hed = "Experiment-control, Mishap, Display-device"},
      {.name = kMergedEvent,
       .meaning = "the session was merged into this study from another one; stored as its last "
                  "event, not for virtual participants. Text: the name of that study. Data: "
                  "`study`, the name; `created_utc`, when that study was created; `source`, its "
                  "number among the merged studies; `session_id`, the `id` of the session there",
       .hed = "Experiment-control",
       .public_data = {"source"}}};
  return kKinds;
}

const EventKind* event_kind(std::string_view name) {
  const std::vector<EventKind>& kinds = event_kinds();
  const auto found = std::find_if(kinds.begin(), kinds.end(),
                                  [name](const EventKind& kind) { return kind.name == name; });
  return found == kinds.end() ? nullptr : &*found;
}

bool ends_session(std::string_view kind) noexcept {
  constexpr std::array kEnds{"session_completed", "session_stopped", "session_failed"};
  return std::find(kEnds.begin(), kEnds.end(), kind) != kEnds.end();
}

std::string hed_tags(const EventKind& kind) {
  return "(" + std::string(kind.hed) + ", Label/" + std::string(kind.name) + ", {event})";
}

}  // namespace asperity

// Holds the table of codes and phrases, and of quantities and faults in them.

#include "app/words/reason.h"

#include <algorithm>
#include <cassert>

namespace asperity {

namespace {

struct ReasonWords {
  Reason reason{};
  const char* code = nullptr;
  Phrase words{};
};

const std::vector<ReasonWords>& all_reasons() {
  static const std::vector<ReasonWords> kReasons{
      {Reason::as_asked, "stop_requested", phrase("Reasons", "on request")},
      {Reason::as_asked_after_trial, "stop_requested_after_trial",
       phrase("Reasons", "on request, after the trial")},
      {Reason::as_asked_after_block, "stop_requested_after_block",
       phrase("Reasons", "on request, after the block")},
      {Reason::stopped_as_asked, "stopped_before_session", phrase("Reasons", "stopped on request")},
      {Reason::terminal_closed, "terminal_closed", phrase("Reasons", "the terminal was closed")},
      {Reason::window_closed, "window_closed", phrase("Reasons", "the window was closed")},
      {Reason::session_window_closed, "session_window_closed",
       phrase("Reasons", "the session window was closed")},
      {Reason::stopped_in_trial, "emergency_stop_in_trial",
       phrase("Reasons", "the emergency stop was pressed in trial %1")},
      {Reason::stopped_between_trials, "emergency_stop_between_trials",
       phrase("Reasons", "the emergency stop was pressed between trials")},
      {Reason::failed_in_trial, "device_failed_in_trial",
       phrase("Reasons", "a fault occurred in trial %1: %2")},
      {Reason::failed_between_trials, "device_failed_between_trials",
       phrase("Reasons", "a fault occurred between trials: %1")},
      {Reason::every_trial_stored, "finished_trials_stored",
       phrase("Reasons", "every completed trial is stored; resume with --resume")},
      {Reason::failed_repeatedly, "trial_failed_repeatedly",
       phrase("Reasons", "trial %1 failed %2 times in a row (%3)")},
      {Reason::criterion_not_met, "criterion_not_met",
       phrase("Reasons", "the criterion of the block \"%1\" was not met")},
      {Reason::stood_still, "servo_loop_standstills",
       phrase("Reasons",
              "the servo loop stalled for more than 50 ms, %1 times: the computer was suspended, "
              "the program was stopped, or other programs kept it from running")},
      {Reason::restart_program, "restart_program",
       phrase("Reasons", "end this program and start it again, then resume the session")},
      {Reason::external_program_failed, "external_program_failed",
       phrase("Reasons", "the levels could not be determined: %1")},
      {Reason::aborted, "aborted", phrase("Reasons", "aborted")},
      {Reason::emergency_stop, "emergency_stop_pressed",
       phrase("Reasons", "the emergency stop was pressed")},
      {Reason::noise_stopped, "masking_noise_stopped",
       phrase("Reasons", "the masking noise stopped")},
      {Reason::no_noise, "masking_noise_not_started",
       phrase("Reasons", "the masking noise could not start")},
      {Reason::missed_in_contact, "deadlines_missed_in_contact",
       phrase("Reasons", "deadlines missed in contact: %1, at most %2 allowed")},
      {Reason::gaps_in_contact, "gaps_in_contact",
       phrase("Reasons", "gaps between ticks in contact: %1, at most %2 allowed")},
      {Reason::lost_records, "records_lost",
       phrase("Reasons",
              "%1 of %3 ticks are missing from the recording, at most %2 allowed: the computer or "
              "its disk was busy for seconds, and force, speed and strokes of this attempt are not "
              "completely known; close other programs, and keep the study on a local disk")},
      {Reason::force_limited, "force_limited", phrase("Reasons", "ticks with limited force: %1")},
      {Reason::not_explored_as_asked, "exploration_not_compliant",
       phrase("Reasons", "not explored as instructed: %1")},
      {Reason::not_touched, "surface_not_touched", phrase("Reasons", "surface %1 was not touched")},
      {Reason::visited_too_rarely, "surface_visited_too_rarely",
       phrase("Reasons", "visits to surface %1: %2 of at least %3")},
      {Reason::plugin_failed, "plugin_failed",
       phrase("Reasons", "the plug-in of the force model %1 failed: %2")},
      {Reason::model_does_not_return, "model_does_not_return",
       phrase("Reasons", "a tick of the force model %1 did not return")},
      {Reason::driver_does_not_return, "driver_does_not_return",
       phrase("Reasons", "a tick did not return from the driver of the device")},
      {Reason::visit_cut_short, "visit_cut_short",
       phrase("Reasons",
              "a visit to surface %1 ended before the required number of strokes or contact time")},
      {Reason::buzz_too_strong, "buzz_too_strong",
       phrase("Reasons", "surface %1 vibrated: buzz %2, at most %3 allowed")},
      {Reason::set_aside, "trial_repeated", phrase("Reasons", "repeated by the experimenter: %1")},
      {Reason::not_ready, "device_not_ready", phrase("Reasons", "the device is not ready: %1")},
      {Reason::does_not_tick, "device_does_not_tick",
       phrase("Reasons", "its servo loop is not running")},
      {Reason::does_not_answer, "device_does_not_answer", phrase("Reasons", "it does not respond")},
      {Reason::position_jumped, "position_jumped",
       phrase("Reasons", "the position of the device jumped; home the device again")},
      {Reason::sends_force, "force_without_surface",
       phrase("Reasons", "a force is sent although there is no surface")},
      {Reason::none_given, "no_reason_given", phrase("Reasons", "no reason was given")},
      {Reason::nothing_to_repeat, "nothing_to_repeat",
       phrase("Reasons", "no trial has been answered or skipped yet")},
      {Reason::practice_is_repeated, "practice_is_repeated",
       phrase("Reasons", "practice trials are being repeated, and they do not count")},
      {Reason::agreement_witnessed, "agreement_witnessed",
       phrase("Reasons", "consent witnessed by %1")},
  };
  return kReasons;
}

const Phrase& quantity_of_surface() {
  static const Phrase kWords = phrase("Reasons", "%1 of surface %2").coded("quantity_of_surface");
  return kWords;
}

/// Codes as in ComplianceRow.
const std::vector<Phrase>& quantities() {
  static const std::vector<Phrase> kQuantities{
      phrase("Reasons", "normal force").coded("normal_force_N"),
      phrase("Reasons", "speed").coded("speed_m_per_s"),
      phrase("Reasons", "time in contact").coded("contact_s"),
      phrase("Reasons", "strokes").coded("strokes"),
      phrase("Reasons", "stroke length").coded("stroke_length_m")};
  return kQuantities;
}

Phrase words_of_fault(Fault fault) {
  switch (fault) {
    case Fault::none:
      return phrase("Reasons", "none");
    case Fault::emergency_stop:
      return phrase("Reasons", "emergency stop");
    case Fault::device_lost:
      return phrase("Reasons", "the device does not respond");
    case Fault::not_finite:
      return phrase("Reasons", "a force or position that is not a finite number");
    case Fault::workspace_left:
      return phrase("Reasons", "the probe left the workspace");
    case Fault::repeated_misses:
      return phrase("Reasons",
                    "too many missed deadlines within a second: the computer was busy, or the "
                    "servo rate is too high for it");
    case Fault::standstill:
      return phrase("Reasons", "the servo loop stalled for more than 50 ms");
  }
  return {};
}

}  // namespace

Phrase phrase_of(Reason reason) {
  const std::vector<ReasonWords>& all = all_reasons();
  const auto found = std::find_if(all.begin(), all.end(), [reason](const ReasonWords& words) {
    return words.reason == reason;
  });
  assert(found != all.end());
  return found->words.coded(found->code);
}

Phrase phrase_of(Fault fault) { return words_of_fault(fault).coded(name_of(fault)); }

Phrase failed_measure(const std::string& quantity, int surface) {
  const std::vector<Phrase>& all = quantities();
  const auto found = std::find_if(
      all.begin(), all.end(), [&quantity](const Phrase& one) { return one.code() == quantity; });
  return quantity_of_surface().with(found == all.end() ? Phrase(quantity) : *found,
                                    std::to_string(surface));
}

std::vector<Phrase> coded_reasons() {
  std::vector<Phrase> all = quantities();
  all.push_back(quantity_of_surface());
  all.push_back(phrase_of(Fault::none));
  for (const Fault fault : kFaults) all.push_back(phrase_of(fault));
  for (const ReasonWords& words : all_reasons()) all.push_back(words.words.coded(words.code));
  return all;
}

}  // namespace asperity

// Reasons why an attempt does not count or is flagged, and why a session ended.

#pragma once

#include <string>
#include <vector>

#include "analysis/words/phrase.h"
#include "app/words/phrase_of_error.h"
#include "renderers/servo/servo_loop.h"

namespace asperity {

/// The program's own reasons; a study stores their codes (app/words/coded_phrases.h).
enum class Reason {
  // of the end of a session
  as_asked,
  as_asked_after_trial,
  as_asked_after_block,
  stopped_as_asked,
  terminal_closed,
  window_closed,
  session_window_closed,
  stopped_in_trial,        ///< the emergency stop was pressed; which trial
  stopped_between_trials,  ///< the emergency stop was pressed
  failed_in_trial,         ///< the device; which trial, why
  failed_between_trials,   ///< the device; why
  every_trial_stored,
  failed_repeatedly,        ///< a trial; which, how many times, why
  criterion_not_met,        ///< of which block
  stood_still,              ///< the servo loop; how many times
  restart_program,          ///< what to do where a tick does not return
  external_program_failed,  ///< what failed
  // of either
  aborted,
  emergency_stop,
  noise_stopped,
  no_noise,
  // of an attempt
  missed_in_contact,      ///< deadlines; how many, how many are allowed
  gaps_in_contact,        ///< how many, how many are allowed
  lost_records,           ///< how many, how many are allowed
  force_limited,          ///< in how many ticks
  not_explored_as_asked,  ///< the measures that failed, by surface
  not_touched,            ///< which surface
  visited_too_rarely,     ///< which surface, visits, required visits
  visit_cut_short,  ///< which surface: its exposure ended before the required strokes or contact
  plugin_failed,    ///< which force model, its message
  model_does_not_return,   ///< from a tick; which force model
  driver_does_not_return,  ///< from a tick
  buzz_too_strong,  ///< which surface, its vibration relative to the texture force, the limit
  set_aside,        ///< why
  // of a device: its problem
  not_ready,  ///< the action that is or is not taken
  does_not_tick,
  does_not_answer,
  position_jumped,  ///< its readings stayed implausible
  sends_force,
  none_given,
  // of events
  nothing_to_repeat,
  practice_is_repeated,
  agreement_witnessed,  ///< name of the witness
};
Phrase phrase_of(Reason reason);
/// "the device does not respond"; its code is its name.
Phrase phrase_of(Fault fault);

/// "normal force of surface 2", a measure that did not comply with the instructed exploration;
/// quantities as in ComplianceRow.
Phrase failed_measure(const std::string& quantity, int surface);

/// All reasons declared here, each with its code.
std::vector<Phrase> coded_reasons();

}  // namespace asperity

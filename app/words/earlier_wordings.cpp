// Sentences of earlier versions, in their original wording, with their codes of today.

#include "app/words/earlier_wordings.h"

#include <array>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "app/words/phrase_registry.h"

namespace asperity {

namespace {

/// The place of a sentence: the same words may have another meaning elsewhere, or be typed text.
enum class Part {
  typed,     ///< not a text of the program: a name, a number
  reason,    ///< of an attempt, a decision or an event
  measures,  ///< separated by commas
  measure,
  quantity,
  remark,  ///< of a device profile
  axes,    ///< separated by semicolons
  axis,
};

struct EarlierWording {
  Part part{};
  std::string_view sentence{};  ///< with placeholders %1, %2, … in this order
  const char* code = nullptr;
  Part places = Part::typed;  ///< the content of the placeholders
};

// As stored by Asperity 0.1.0 and until schema version 6. These wordings never change.
constexpr auto kEarlierWordings = std::to_array<EarlierWording>({
    {Part::reason, "as asked", "stop_requested"},
    {Part::reason, "as asked, after the trial", "stop_requested_after_trial"},
    {Part::reason, "as asked, after the block", "stop_requested_after_block"},
    {Part::reason, "stopped as asked", "stopped_before_session"},
    {Part::reason, "the terminal was closed", "terminal_closed"},
    {Part::reason, "the window was closed", "window_closed"},
    {Part::reason, "the session window was closed", "session_window_closed"},
    {Part::reason, "the emergency stop was pressed in trial %1", "emergency_stop_in_trial",
     Part::reason},
    {Part::reason, "the emergency stop was pressed between trials",
     "emergency_stop_between_trials"},
    {Part::reason, "the device failed in trial %1: %2", "device_failed_in_trial", Part::reason},
    {Part::reason, "the device failed between trials: %1", "device_failed_between_trials",
     Part::reason},
    {Part::reason, "every finished trial is stored, go on with --resume", "finished_trials_stored"},
    {Part::reason, "trial %1 failed %2 times in a row (%3)", "trial_failed_repeatedly",
     Part::reason},
    {Part::reason, "the criterion of the block \"%1\" was not met", "criterion_not_met"},
    {Part::reason,
     "the servo loop stood still for more than 50 ms, %1 times: the computer was suspended, the "
     "program was stopped, or other programs kept it from running",
     "servo_loop_standstills", Part::reason},
    {Part::reason, "aborted", "aborted"},
    {Part::reason, "the emergency stop was pressed", "emergency_stop_pressed"},
    {Part::reason, "the masking noise stopped", "masking_noise_stopped"},
    {Part::reason, "the masking noise could not begin", "masking_noise_not_started"},
    {Part::reason, "deadlines missed in contact: %1, at most %2 allowed",
     "deadlines_missed_in_contact", Part::reason},
    {Part::reason, "%1 missed deadlines, at most %2 allowed", "deadlines_missed", Part::reason},
    {Part::reason, "%1 lost records, at most %2 allowed", "records_lost", Part::reason},
    {Part::reason, "force limited in %1 ticks", "force_limited", Part::reason},
    {Part::reason, "not explored as asked: %1", "exploration_not_compliant", Part::measures},
    {Part::reason, "surface %1 was not touched", "surface_not_touched", Part::reason},
    {Part::reason, "the device is not ready: %1", "device_not_ready", Part::reason},
    {Part::reason, "it does not tick", "device_does_not_tick"},
    {Part::reason, "it does not answer", "device_does_not_answer"},
    {Part::reason, "it is sent a force although there is no surface", "force_without_surface"},
    {Part::reason, "no reason was given", "no_reason_given"},
    {Part::reason, "no trial has been answered or skipped yet", "nothing_to_repeat"},
    {Part::reason, "agreement seen by %1", "agreement_witnessed"},
    {Part::reason, "emergency_stop", "emergency_stop"},
    {Part::reason, "device_lost", "device_lost"},
    {Part::reason, "not_finite", "not_finite"},
    {Part::reason, "workspace_left", "workspace_left"},
    {Part::reason, "repeated_misses", "repeated_misses"},
    {Part::reason, "standstill", "standstill"},
    {Part::reason, "The participant was distracted", "participant_distracted"},
    {Part::reason, "Wrong key pressed", "wrong_key"},
    {Part::reason, "The participant asks for it", "participant_asked"},
    {Part::reason, "The participant cannot answer", "participant_cannot_answer"},
    {Part::reason, "The participant does not want to go on", "participant_declines"},
    {Part::reason, "The participant wishes to stop", "participant_stops"},
    {Part::reason, "The participant is unwell", "participant_unwell"},
    {Part::reason, "Technical problem", "technical_problem"},
    {Part::reason, "Safety of the participant", "participant_safety"},
    {Part::reason, "Suspected fault of a stimulus", "stimulus_fault_suspected"},
    {Part::reason, "Not the experimenter of this study", "experimenter_not_involved"},
    {Part::reason, "The participant seemed distracted", "participant_seemed_distracted"},
    {Part::reason, "The hand slipped", "hand_slipped"},
    {Part::reason, "Somebody came in", "person_came_in"},
    {Part::reason, "The force felt wrong", "force_felt_wrong"},
    {Part::reason, "The participant took the answer back", "answer_retracted"},
    {Part::reason, "The participant withdrew consent", "consent_withdrawn"},
    {Part::reason, "The participant did not follow the instruction", "instruction_not_followed"},
    {Part::reason, "Interrupted", "interrupted"},
    {Part::reason, "Answered by mistake", "answered_by_mistake"},
    {Part::reason, "The device did not work as it should", "device_malfunction"},
    {Part::reason, "The surface was recognised by something other than touch",
     "surface_recognized_otherwise"},
    {Part::reason, "It was run to try things out", "test_run"},
    {Part::reason, "Excluded by mistake", "excluded_by_mistake"},
    {Part::reason, "The reason turned out not to hold", "exclusion_unfounded"},
    {Part::reason, "Pressed hard", "note_pressed_hard"},
    {Part::reason, "Lifted early", "note_lifted_early"},
    {Part::reason, "Grip changed", "note_grip_changed"},
    {Part::reason, "Hand slipped", "note_hand_slipped"},
    {Part::reason, "Hand is tired", "note_hand_tired"},
    {Part::reason, "Felt a jolt", "note_jolt"},
    {Part::reason, "Distracted", "note_distracted"},
    {Part::reason, "Had a question", "note_question"},
    {Part::reason, "Noise outside", "note_noise"},
    {Part::reason, "The participant was not eligible", "not_eligible"},
    {Part::reason, "The participant was withdrawn", "withdrawn"},
    {Part::reason, "Die Versuchsperson war abgelenkt", "participant_distracted"},
    {Part::reason, "Falsche Taste gedrückt", "wrong_key"},
    {Part::reason, "Die Versuchsperson bittet darum", "participant_asked"},
    {Part::reason, "Die Versuchsperson kann nicht antworten", "participant_cannot_answer"},
    {Part::reason, "Die Versuchsperson möchte nicht weitermachen", "participant_declines"},
    {Part::reason, "Die Versuchsperson möchte aufhören", "participant_stops"},
    {Part::reason, "Der Versuchsperson ist nicht wohl", "participant_unwell"},
    {Part::reason, "Technisches Problem", "technical_problem"},
    {Part::reason, "Sicherheit der Versuchsperson", "participant_safety"},
    {Part::reason, "Verdacht auf einen fehlerhaften Reiz", "stimulus_fault_suspected"},
    {Part::reason, "Nicht die Versuchsleitung dieser Studie", "experimenter_not_involved"},
    {Part::reason, "Die Versuchsperson wirkte abgelenkt", "participant_seemed_distracted"},
    {Part::reason, "Die Hand ist abgerutscht", "hand_slipped"},
    {Part::reason, "Jemand kam herein", "person_came_in"},
    {Part::reason, "Die Kraft fühlte sich falsch an", "force_felt_wrong"},
    {Part::reason, "Die Versuchsperson nahm die Antwort zurück", "answer_retracted"},
    {Part::reason, "Die Versuchsperson zog die Einwilligung zurück", "consent_withdrawn"},
    {Part::reason, "Die Versuchsperson folgte der Anweisung nicht", "instruction_not_followed"},
    {Part::reason, "Unterbrochen", "interrupted"},
    {Part::reason, "Aus Versehen beantwortet", "answered_by_mistake"},
    {Part::reason, "Das Gerät arbeitete nicht wie vorgesehen", "device_malfunction"},
    {Part::reason, "Die Oberfläche wurde an etwas anderem als der Berührung erkannt",
     "surface_recognized_otherwise"},
    {Part::reason, "Sie diente zum Ausprobieren", "test_run"},
    {Part::reason, "Aus Versehen ausgeschlossen", "excluded_by_mistake"},
    {Part::reason, "Der Grund hat sich nicht bestätigt", "exclusion_unfounded"},
    {Part::reason, "Fest gedrückt", "note_pressed_hard"},
    {Part::reason, "Früh gehoben", "note_lifted_early"},
    {Part::reason, "Umgegriffen", "note_grip_changed"},
    {Part::reason, "Abgerutscht", "note_hand_slipped"},
    {Part::reason, "Hand müde", "note_hand_tired"},
    {Part::reason, "Ruck gespürt", "note_jolt"},
    {Part::reason, "Abgelenkt", "note_distracted"},
    {Part::reason, "Hatte Frage", "note_question"},
    {Part::reason, "Lärm außen", "note_noise"},
    {Part::measure, "%1 of surface %2", "quantity_of_surface", Part::quantity},
    {Part::quantity, "normal_force_N", "normal_force_N"},
    {Part::quantity, "speed_m_per_s", "speed_m_per_s"},
    {Part::quantity, "contact_s", "contact_s"},
    {Part::quantity, "strokes", "strokes"},
    {Part::quantity, "stroke_length_m", "stroke_length_m"},
    {Part::remark, "the servo loop took the force away (%1)", "device_test_force_removed",
     Part::remark},
    {Part::remark, "the handle ran farther than %1 mm away, and the force was let go of",
     "device_test_handle_ran_away", Part::remark},
    {Part::axis, "along %1 %2", "device_test_along_axis", Part::remark},
    {Part::remark, "Not measured: %1.", "device_test_not_measured", Part::axes},
    {Part::remark, "Of a simulated device: it says something about this computer.",
     "device_test_simulated"},
    {Part::remark, "Nothing was felt.", "device_test_no_surface"},
    {Part::remark, "The loop did not run: %1", "device_test_loop_did_not_run", Part::remark},
    {Part::remark, "The strongest force with nothing to feel.",
     "device_test_force_without_surface"},
    {Part::remark, "Standard deviation of the positions of the handle at rest.",
     "device_test_position_noise"},
    {Part::remark, "there were too few readings", "device_test_too_few_readings"},
    {Part::remark, "It has no motors.", "device_test_no_motors"},
    {Part::remark, "Asked for %1 N at a limit of %2 N, at most %3 N was sent.",
     "device_test_force_limit", Part::remark},
    {Part::remark, "Stopped under a force, the device got exactly 0 N from the next tick on.",
     "device_test_zero_after_stop"},
    {Part::remark,
     "Asked for a force that is no number, the device got exactly 0 N in the same tick.",
     "device_test_zero_after_not_finite"},
    {Part::remark,
     "Without a sign of life from the program the force faded to 0 N (a session waits for %1 s).",
     "device_test_zero_without_heartbeat", Part::remark},
    {Part::remark, "the handle did not follow with %1 N", "device_test_did_not_follow",
     Part::remark},
    {Part::remark, "the handle did not move", "device_test_did_not_move"},
    {Part::remark, "the sweeps say nothing", "device_test_sweeps_inconclusive"},
    {Part::remark, "a push of %1 N did not move the handle", "device_test_push_did_not_move",
     Part::remark},
    {Part::remark, "From a sudden force to the motion that is read.", "device_test_latency"},
    {Part::remark, "Of the handle and what moves with it, from how a sudden force speeds it up.",
     "device_test_moving_mass"},
    {Part::remark, "Coulomb friction, from slow sweeps to and fro at two speeds.",
     "device_test_friction"},
    {Part::remark, "Growth of that resistance with speed.", "device_test_damping"},
    {Part::remark, "The step of positions that would make the errors found in a slow sweep.",
     "device_test_position_resolution"},
    {Part::remark, "The lowest frequency at which the handle answers twice as much as its mass.",
     "device_test_resonance"},
    {Part::remark, "there is none from %1 to %2 Hz", "device_test_no_resonance", Part::remark},
    {Part::remark,
     "The stiffest spring, up to 8000 N/m, on which the handle came to rest after a kick.",
     "device_test_stiffness"},
    {Part::remark, "already a spring of 250 N/m made the handle swing",
     "device_test_unstable_at_softest"},
    {Part::remark, "The weakest push, by steps of a factor √2, that moved the handle from rest.",
     "device_test_force_resolution"},
    {Part::remark, "no push up to %1 N moved the handle", "device_test_no_push_moved",
     Part::remark},
    {Part::remark, "Nobody moved the handle along the borders of its workspace.",
     "device_test_workspace_not_explored"},
    {Part::remark, "There were no readings.", "device_test_no_readings"},
    {Part::remark, "The least share of the declared workspace that the handle reached.",
     "device_test_workspace_reached"},
    {Part::remark, "Not known of %1, which the simulated device stands for.",
     "device_test_unknown_trait", Part::remark},
    {Part::remark, "emergency stop", "emergency_stop"},
    {Part::remark, "the device does not answer", "device_lost"},
    {Part::remark, "a force or position that is not a finite number", "not_finite"},
    {Part::remark, "the probe left the workspace", "workspace_left"},
    {Part::remark, "too many missed deadlines", "repeated_misses"},
    {Part::remark, "the servo loop stood still for more than 50 ms", "standstill"},
});

/// The content of the placeholders where `text` was made with these words; nothing where it was
/// not. Each placeholder matches the shortest possible text.
std::optional<std::vector<std::string>> places_in(std::string_view text, std::string_view words) {
  std::vector<std::string> places{};
  for (;;) {
    const std::size_t place = words.find('%');
    const std::string_view before = words.substr(0, place);
    if (!text.starts_with(before)) return {};
    text.remove_prefix(before.size());
    if (place == std::string_view::npos) break;
    words.remove_prefix(before.size() + 2);
    const std::string_view after = words.substr(0, words.find('%'));
    const bool is_last = after.size() == words.size();
    if (is_last && !text.ends_with(after)) return {};
    const std::size_t end = is_last ? text.size() - after.size() : text.find(after);
    if (end == std::string_view::npos) return {};
    places.emplace_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  if (!text.empty()) return {};
  return places;
}

std::optional<Phrase> found_as(Part part, const std::string& text);

Phrase found_or_typed(Part part, const std::string& text) {
  return found_as(part, text).value_or(Phrase(text));
}

/// For a list, if every part of it is known.
std::optional<Phrase> found_list(Part part, const std::string& text, std::string_view between,
                                 std::size_t kept, Phrase (*join)(const Phrase&, const Phrase&)) {
  Phrase all{};
  std::size_t begin = 0;
  for (;;) {
    const std::size_t end = text.find(between, begin);
    const std::optional<Phrase> one = found_as(part, text.substr(begin, end - begin));
    if (!one) return {};
    all = join(all, *one);
    if (end == std::string::npos) return all;
    begin = end + between.size() - kept;
  }
}

std::optional<Phrase> found_one(Part part, const std::string& text) {
  for (const EarlierWording& wording : kEarlierWordings) {
    if (wording.part != part) continue;
    const auto places = places_in(text, wording.sentence);
    if (!places) continue;
    std::vector<Phrase> arguments{};
    for (const std::string& place : *places) {
      arguments.push_back(found_or_typed(wording.places, place));
    }
    return coded_phrases().find(wording.code)->second.filled(std::move(arguments));
  }
  return {};
}

std::optional<Phrase> found_as(Part part, const std::string& text) {
  switch (part) {
    case Part::typed:
      return {};
    case Part::measures:
      return found_list(Part::measure, text, ", ", 0, with_comma);
    case Part::axes:
      return found_list(Part::axis, text, "; along ", 6, with_semicolon);
    case Part::reason:
      if (text.find("; ") != std::string::npos) {
        if (auto list = found_list(Part::reason, text, "; ", 0, with_semicolon)) return list;
      }
      return found_one(part, text);
    case Part::measure:
    case Part::quantity:
    case Part::remark:
    case Part::axis:
      break;
  }
  return found_one(part, text);
}

}  // namespace

Phrase phrase_of_earlier(const std::string& sentence) {
  return found_or_typed(Part::reason, sentence);
}

Phrase remark_of_earlier(const std::string& sentence) {
  return found_or_typed(Part::remark, sentence);
}

}  // namespace asperity

#include "app/conductor/reason.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace asperity {

namespace {

using ReasonWords = std::pair<Reason, Phrase>;

const std::vector<ReasonWords>& all_reasons() {
  static const std::vector<ReasonWords> kReasons{
      {Reason::as_asked, phrase("Reasons", "as asked")},
      {Reason::as_asked_after_trial, phrase("Reasons", "as asked, after the trial")},
      {Reason::as_asked_after_block, phrase("Reasons", "as asked, after the block")},
      {Reason::stopped_as_asked, phrase("Reasons", "stopped as asked")},
      {Reason::terminal_closed, phrase("Reasons", "the terminal was closed")},
      {Reason::window_closed, phrase("Reasons", "the window was closed")},
      {Reason::session_window_closed, phrase("Reasons", "the session window was closed")},
      {Reason::stopped_in_trial, phrase("Reasons", "the emergency stop was pressed in trial %1")},
      {Reason::stopped_between_trials,
       phrase("Reasons", "the emergency stop was pressed between trials")},
      {Reason::failed_in_trial, phrase("Reasons", "the device failed in trial %1: %2")},
      {Reason::failed_between_trials, phrase("Reasons", "the device failed between trials: %1")},
      {Reason::every_trial_stored,
       phrase("Reasons", "every finished trial is stored, go on with --resume")},
      {Reason::failed_repeatedly, phrase("Reasons", "trial %1 failed %2 times in a row (%3)")},
      {Reason::criterion_not_met,
       phrase("Reasons", "the criterion of the block \"%1\" was not met")},
      {Reason::stood_still,
       phrase(
           "Reasons",
           "the servo loop stood still for more than 50 ms, %1 times: the computer was suspended, "
           "the program was stopped, or other programs kept it from running")},
      {Reason::aborted, phrase("Reasons", "aborted")},
      {Reason::emergency_stop, phrase("Reasons", "the emergency stop was pressed")},
      {Reason::noise_stopped, phrase("Reasons", "the masking noise stopped")},
      {Reason::no_noise, phrase("Reasons", "the masking noise could not begin")},
      {Reason::missed_in_contact,
       phrase("Reasons", "deadlines missed in contact: %1, at most %2 allowed")},
      {Reason::missed_deadlines, phrase("Reasons", "%1 missed deadlines, at most %2 allowed")},
      {Reason::lost_records, phrase("Reasons", "%1 lost records, at most %2 allowed")},
      {Reason::force_limited, phrase("Reasons", "force limited in %1 ticks")},
      {Reason::not_explored_as_asked, phrase("Reasons", "not explored as asked: %1")},
      {Reason::not_touched, phrase("Reasons", "surface %1 was not touched")},
      {Reason::set_aside, phrase("Reasons", "set aside: %1")},
      {Reason::not_ready, phrase("Reasons", "the device is not ready: %1")},
      {Reason::does_not_tick, phrase("Reasons", "it does not tick")},
      {Reason::does_not_answer, phrase("Reasons", "it does not answer")},
      {Reason::sends_force, phrase("Reasons", "it is sent a force although there is no surface")},
  };
  return kReasons;
}

Phrase measure_of_surface() { return phrase("Reasons", "%1 of surface %2"); }

/// Named as ComplianceRow does.
Phrase read_quantity(const std::string& name) {
  if (name == "normal_force_N") return phrase("Reasons", "normal force");
  if (name == "speed_m_per_s") return phrase("Reasons", "speed");
  if (name == "contact_s") return phrase("Reasons", "time in contact");
  if (name == "strokes") return phrase("Reasons", "strokes");
  if (name == "stroke_length_m") return phrase("Reasons", "stroke length");
  return name;
}

std::optional<Fault> fault_named(const std::string& name) {
  for (const Fault fault : kFaults) {
    if (name == name_of(fault)) return fault;
  }
  return {};
}

/// What `read` makes of the parts of a list, as one.
Phrase read_list(const std::string& text, std::string_view between,
                 const std::function<Phrase(const std::string&)>& read) {
  const std::size_t end = text.find(between);
  if (end == std::string::npos) return read(text);
  return Phrase("%1" + std::string(between) + "%2")
      .with(read(text.substr(0, end)), read_list(text.substr(end + between.size()), between, read));
}

Phrase read_measure(const std::string& text) {
  const auto places = measure_of_surface().places_in(text);
  if (!places) return text;
  return measure_of_surface().with(read_quantity(places->at(0)), places->at(1));
}

Phrase read_one(const std::string& text) {
  if (const std::optional<Fault> fault = fault_named(text)) return phrase_of(*fault);
  for (const auto& [reason, words] : all_reasons()) {
    const auto places = words.places_in(text);
    if (!places) continue;
    std::vector<Phrase> arguments{};
    for (const std::string& place : *places) {
      // What was set aside was set aside by somebody, in their own words.
      arguments.push_back(reason == Reason::set_aside ? Phrase(place)
                          : reason == Reason::not_explored_as_asked
                              ? read_list(place, ", ", read_measure)
                              : read_one(place));
    }
    return words.filled(std::move(arguments));
  }
  return text;
}

}  // namespace

Phrase phrase_of(Reason reason) {
  const std::vector<ReasonWords>& all = all_reasons();
  const auto found = std::find_if(
      all.begin(), all.end(), [reason](const ReasonWords& words) { return words.first == reason; });
  assert(found != all.end());
  return found->second;
}

Phrase phrase_of(Fault fault) {
  switch (fault) {
    case Fault::none:
      return phrase("Reasons", "none");
    case Fault::emergency_stop:
      return phrase("Reasons", "emergency stop");
    case Fault::device_lost:
      return phrase("Reasons", "the device does not answer");
    case Fault::not_finite:
      return phrase("Reasons", "a force or position that is not a finite number");
    case Fault::workspace_left:
      return phrase("Reasons", "the probe left the workspace");
    case Fault::repeated_misses:
      return phrase("Reasons", "too many missed deadlines");
    case Fault::standstill:
      return phrase("Reasons", "the servo loop stood still for more than 50 ms");
  }
  return {};
}

Phrase failed_measure(const std::string& quantity, int surface) {
  return measure_of_surface().with(quantity, std::to_string(surface));
}

Phrase read_reason(const std::string& stored) { return read_list(stored, "; ", read_one); }

}  // namespace asperity

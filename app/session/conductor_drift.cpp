// The part of Conductor that checks the drift of the device in a break.

#include <vector>

#include <glm/geometric.hpp>

#include "app/session/conductor.h"
#include "app/session/drift_check.h"
#include "app/words/coded_phrases.h"
#include "app/words/reason.h"

namespace asperity {

void Conductor::check_drift(const Protocol::Break::DriftCheck& requested) {
  measure_drift(kHandOff, requested.text, requested.duration_s);
  if (!requested.tip_text.empty())
    measure_drift(kTipHeld, requested.tip_text, requested.duration_s);
}

/// Asks for what has to be done, records the reading without a force, and shows the result.
void Conductor::measure_drift(const char* part, const std::string& prompt, double duration_s) {
  course_.ask_experimenter(prompt, outside_);
  const std::vector<TickRecord> records = records_without_surface(duration_s, outside_);
  if (const Phrase problem = problem_in(records); !problem.empty()) {
    throw Interruption{AttemptOutcome::device_fault, phrase_of(Reason::not_ready).with(problem)};
  }
  const std::vector<EventRow> before = study_.events(session_.row.id);
  DriftCheck check{.reading = rest_reading(records), .limit_m = rest_limit_m(rig_.capability())};
  if (const auto first_m = first_rest_m(before, part)) {
    check.shift_m = glm::length(check.reading.position_m - *first_m);
  }
  course_.event(kDriftChecked, part, drift_data_json(check));
  const Phrase result = drift_text(part, check);
  course_.report_to_experimenter(result.english());
  if (course_.asks_experimenter()) course_.ask_experimenter(result, outside_);
}

}  // namespace asperity

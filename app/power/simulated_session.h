// Simulates one session of a participant from response tables.

#pragma once

#include "analysis/numbers/random.h"
#include "app/power/power_tables.h"
#include "protocols/plan/plan.h"
#include "results_schema/session_answers.h"

namespace asperity {

/// What a simulated session depends on.
struct SimulatedSessionInputs {
  const PowerTables& tables;
  Allocation allocation{};
  Random of_study;        ///< how textures differ, the same for all participants
  Random of_participant;  ///< how the participant differs from others, the same in all sessions
  Random of_session;
};

/// The responses to the trials that analyses count and to catch trials, as they are read from a study. The plan is that of a
/// session on a device, and procedures receive the same responses; practice without a procedure and anchors have no responses,
/// which no analysis counts. No attempt is repeated, and no deadline is missed.
SessionAnswers simulated_session(const SimulatedSessionInputs& inputs);

}  // namespace asperity

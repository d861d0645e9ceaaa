// Compares stored answers with the questions and conditions of the protocol.

#pragma once

#include <span>
#include <string>
#include <vector>

#include "protocols/design/protocol.h"
#include "results_schema/rows.h"

namespace asperity {

/// What contradicts the protocol in one stored answer, of a trial or a questionnaire, as clauses: an answer that its question
/// cannot have, a question that was asked although its condition was not met, or was not asked although it was. `surfaces`:
/// of the trial.
std::vector<std::string> answer_problems(const Question& question,
                                         std::span<const AnsweredItem> stored, bool was_asked,
                                         bool is_condition_met, int surfaces = 0);

/// The same in the answers of a session to its questionnaire, as sentences. A question without a row was not reached.
std::vector<std::string> questionnaire_problems(const SessionRow& session, const Protocol& protocol,
                                                const std::vector<ResponseRow>& rows);

}  // namespace asperity

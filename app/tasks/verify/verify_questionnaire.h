// Compares the stored answers to a questionnaire with the questions and conditions of its protocol.

#pragma once

#include <string>
#include <vector>

#include "protocols/design/protocol.h"
#include "results_schema/rows.h"

namespace asperity {

/// What contradicts the protocol in the answers of a session, as sentences: an answer that its question cannot have, a
/// question that was asked although its condition was not met, or was not asked although it was. A question without a row
/// was not reached.
std::vector<std::string> questionnaire_problems(const SessionRow& session, const Protocol& protocol,
                                                const std::vector<ResponseRow>& rows);

}  // namespace asperity

// The number and the order of trials, with breaks, criteria and feedback, as the report states them.

#pragma once

#include <string>

#include "app/report/text/report_facts.h"
#include "protocols/design/protocol.h"

namespace asperity {

/// Of a text: present in a description of the protocol, past in a paper.
enum class Tense { present, past };

/// "A session was planned with 42 experimental trials, and with 54 in total including anchors and
/// practice."; empty where no session has a plan. Where the responses determine the number, those of the completed
/// sessions: "The number of trials depended on the responses: a completed session had 66 to 87 experimental trials …".
std::string planned_trials_text(const ReportFacts& facts);
/// "20 of 66", and while the responses determine the number of trials, "20 of about 66".
std::string done_trials_text(const ReportedSession& session);
/// " In completed sessions, the block had 3 to 6 trials."; empty without such a session, and of a block whose number of
/// trials does not depend on the responses.
std::string presented_trials_text(const Protocol::Block& block, const ReportFacts& facts);
/// "in random order within each repetition, 3 repetitions, once for each level of speed". The order of trials whose level a
/// procedure chooses is that of the responses and is not stated; empty where nothing else is to be said.
std::string order_of_run(const Protocol& protocol, const Protocol::Block& block,
                         const Protocol::Run& run, Tense tense);
/// " The criterion was not met in either session."; empty where it was met in all.
std::string unmet_text(const std::string& block, const ReportFacts& facts);
/// ", with feedback on whether each response was correct"; empty without feedback.
std::string feedback_text(const Protocol::Block& block);

}  // namespace asperity

// The number and the order of trials, with breaks, criteria and feedback, as the report states them.

#pragma once

#include <string>

#include "app/report/text/report_facts.h"
#include "protocols/design/protocol.h"

namespace asperity {

/// Of a text: present in a description of the protocol, past in a paper.
enum class Tense { present, past };

/// "A session was planned with 42 experimental trials, and with 54 in total including anchors and
/// practice."; empty where no session has a plan.
std::string planned_trials_text(const ReportFacts& facts);
/// "in random order within each repetition, 3 repetitions, once for each level of speed". The order of trials whose level a
/// procedure chooses is that of the responses and is not stated; empty where nothing else is to be said.
std::string order_of_run(const Protocol::Block& block, const Protocol::Run& run, Tense tense);
/// " The criterion was not met in either session."; empty where it was met in all.
std::string unmet_text(const std::string& block, const ReportFacts& facts);
/// ", with feedback on whether each response was correct"; empty without feedback.
std::string feedback_text(const Protocol::Block& block);

}  // namespace asperity

// The languages of a protocol's sessions, as the report states them.

#pragma once

#include <string>

#include "app/report/text/report_facts.h"

namespace asperity {

/// " Participants by language: 12 (de), 10 (en). The scales have labels in words; whether they are equivalent in these
/// languages was not tested."; empty for sessions in one language. The second sentence: for a protocol with such scales.
std::string languages_text(const ReportFacts& facts);

}  // namespace asperity

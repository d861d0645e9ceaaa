// Writes how surfaces were presented at amplitudes of equal roughness.

#pragma once

#include <string>

#include "app/report/text/report_facts.h"

namespace asperity {

/// That the texture forces of the models were matched, and that this was before their roughness was; empty where they were not.
std::string equal_force_text(const ReportFacts& facts);

/// How the amplitudes were determined, and the number of matches with those that did not succeed, in sentences of a
/// report; empty where no surface was matched.
std::string equal_roughness_text(const ReportFacts& facts);

}  // namespace asperity

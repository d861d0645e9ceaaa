// Takes assumptions from the responses of a study: a pilot, or a study that was simulated on the full physics.

#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/findings/gathering/gathered_answers.h"
#include "app/power/assumption.h"
#include "protocols/design/protocol.h"
#include "results_schema/study.h"

namespace asperity {

/// The assumptions with what the responses show of them in their place, and `source`: differences between participants, noise,
/// lapses and order effects (StudyAnalysis::shown_parameters). Effects are not taken: the researcher states the smallest
/// effect of interest. A standard deviation of an effect that the responses show to be 0 is not taken either, because 0 has to be
/// chosen. Everything else is unchanged.
std::vector<Assumption> calibrated(std::vector<Assumption> assumptions, const Protocol& protocol,
                                   std::span<const GatheredAnswers> of_study,
                                   const std::string& source);

/// The same with the responses of a study to a protocol of this name: those of pilot sessions if there are any, or otherwise of
/// persons, or of virtual participants; to this version of it if there are any, or otherwise to the last one. The source names the
/// study, another version and the number of participants. Errors: std::runtime_error where the study has no such responses;
/// ResultsError, also for a damaged study.
std::vector<Assumption> calibrated_by_study(std::vector<Assumption> assumptions,
                                            const Protocol& protocol, const Study& study);

}  // namespace asperity

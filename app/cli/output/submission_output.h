// What the command line states about a submission.

#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "app/cluster/submission.h"
#include "app/cluster/submission_state.h"
#include "app/cluster/submit_jobs.h"

namespace asperity {

/// Lines: the number of complete shards; what is in the queue, by state and reason; the missing shards with the end of their
/// logs; the gather job, and whether it was cancelled or would wait for ever. Errors: ResultsError of a folder that cannot be read.
std::string state_text(const Submission& submission, const SubmissionState& state);

/// Lines: what was cancelled and what was submitted.
std::string submitted_text(const NextJobs& next, const SubmittedJobs& submitted);

/// The document of --json: the state before, and what was submitted then.
nlohmann::ordered_json state_json(const Submission& submission, const SubmissionState& state,
                                  const NextJobs& next, const SubmittedJobs& submitted);

}  // namespace asperity

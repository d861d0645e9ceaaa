// Makes a session's `_events.tsv` in a BIDS dataset: presentations and events, by onset.

#pragma once

#include <vector>

#include "app/exports/columns/export_column.h"
#include "app/exports/columns/study_vocabulary.h"
#include "app/records/session_timeline.h"

namespace asperity {

/// `onset`, `duration`, `trial_type` and `response_time` under their BIDS names, then the subject
/// of the row. A row is an event of the study, an attempt, or a surface that was presented in one.
std::vector<ExportColumn> bids_event_columns(const StudyVocabulary& vocabulary,
                                             ExportAudience audience,
                                             std::vector<std::string>& left_out);

/// The rows of these columns for one session, by onset.
std::vector<std::vector<Cell>> bids_event_rows(const std::vector<ExportColumn>& columns,
                                               ExportAudience audience, const ExportPlace& session,
                                               const std::vector<PlannedTrialRow>& plan,
                                               const std::vector<AttemptRow>& attempts,
                                               const std::vector<TimedEvent>& timeline);

}  // namespace asperity

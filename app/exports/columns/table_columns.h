// The columns of each table of an export. Each table has a source file with the name of its function.

#pragma once

#include "app/exports/columns/column_making.h"
#include "app/exports/columns/study_vocabulary.h"

namespace asperity::export_columns {

// Of columns that two tables have.
inline constexpr const char* kMissedInContact =
    "ticks that missed their deadline while a surface was touched; of the missed deadlines, only "
    "these affect whether an attempt counts";

inline constexpr const char* kGapsInContact =
    "times between two ticks of more than two periods while a surface was touched";

inline constexpr const char* kHeldReadings =
    "ticks with an implausible reading of the device, replaced by the last plausible one";

Columns participant_columns(const StudyVocabulary& vocabulary);
Columns session_columns(const StudyVocabulary& vocabulary);
Columns trial_columns(const StudyVocabulary& vocabulary);
/// Of the table of trials only: in tables of attempts it would say nothing.
ExportColumn attempts_of_trial_column();
Columns attempt_columns(const StudyVocabulary& vocabulary);
Columns presentation_columns(const StudyVocabulary& vocabulary);
/// The detectors of perceived instability, added to the columns of a presentation.
void add_instability(Columns& columns);
Columns response_columns(const StudyVocabulary& vocabulary);
Columns servo_columns();
Columns visit_columns();
Columns compliance_columns();
Columns event_columns();

}  // namespace asperity::export_columns

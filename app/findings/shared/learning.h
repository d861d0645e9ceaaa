// Describes changes of responses over the trials of a protocol, for every kind.

#pragma once

#include "analysis/words/phrase.h"
#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/result_table.h"

namespace asperity {

/// The findings of response times over trials, and of proportions correct.
inline constexpr const char* kLearningOfTimes = "learning_times";
inline constexpr const char* kLearningCorrect = "learning_correct";

/// The tables of changes between the halves of the trials, and of ranges of trials.
inline constexpr const char* kLearning = "learning";
inline constexpr const char* kTrialCourse = "trial_course";

/// A difference or a ratio of two parts of a session; also of the responses to anchors.
inline const ResultColumn kChange{.id = "change", .heading = phrase("AnalysisWords", "change")};

/// Adds the tables `learning` and `trial_course`: response times, and proportions correct where
/// every response is correct or incorrect, over the counted trials of each participant, numbered
/// through all sessions. A description without a test. No table where no participant has two
/// trials.
void add_learning(const GatheredAnswers& gathered, AnalysisOutcome& outcome);

}  // namespace asperity

// Describes how responses to the anchors of a session change, for every kind.

#pragma once

#include "analysis/words/phrase.h"
#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/result_table.h"

namespace asperity {

/// The table of the responses to anchors: participant, session, block_ordinal, block, place, question, response, correct.
inline constexpr const char* kAnchors = "anchors";
/// The table of their means by place and their change over a run of the block.
inline constexpr const char* kAnchorTrend = "anchor_trend";

inline const ResultColumn kAnchorPlace{
    .id = "place", .heading = phrase("AnalysisWords", "place"), .words = words_of_anchor_place};
inline const ResultColumn kAnchorResponse{.id = "response",
                                          .heading = phrase("AnalysisWords", "response")};
/// The means at a place.
inline const ResultColumn kAnchorStart{.id = "start", .heading = phrase("AnalysisWords", "start")};
inline const ResultColumn kAnchorMiddle{.id = "middle",
                                        .heading = phrase("AnalysisWords", "middle")};
inline const ResultColumn kAnchorEnd{.id = "end", .heading = phrase("AnalysisWords", "end")};

/// Adds these tables if a block has an anchor in the middle or at the end: those only at the start are references of a scale.
/// No finding contains anchors, and nothing is tested.
///
/// The change in a run is that from the first to the last place at which the block has responses, y_last − y_first, with
/// y = log10 of an estimate; a run without a response at both is left out. It is the slope of the least-squares line over
/// three equidistant places, and assumes nothing of the place of the middle one. The change of a participant is the mean
/// over the runs. The interval of the mean over participants is that of Student's t. Proportions correct have none: each
/// is one trial. Participants of all groups are analysed together, as the note of the table states where there are groups.
void add_anchors(const GatheredAnswers& gathered, AnalysisOutcome& outcome);

}  // namespace asperity

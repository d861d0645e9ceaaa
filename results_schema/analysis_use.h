// Which attempts count in analyses: the one definition, used by everything that counts answers.

#pragma once

#include <string_view>

namespace asperity {

struct AttemptRow;
struct PlannedTrialRow;

/// What analyses do with an attempt: they count it, or leave it out for the first of these reasons.
enum class AnalysisUse {
  practice,     ///< its trial belongs to familiarisation or practice
  anchor,       ///< its trial presents the anchor of its block: repetition 0
  catch_trial,  ///< its trial is a catch trial of a procedure: repetition 0 as well
  invalid,      ///< as stored, or since the experimenter had it repeated
  unanswered,   ///< no answer came in time
  excluded,     ///< by a later decision, alone or with its session
  counted,
};

/// Of a planned trial, before any attempt at it: practice, anchor, catch trial or counted.
AnalysisUse use_in_analyses(std::string_view phase, int repetition, bool is_catch) noexcept;
AnalysisUse use_in_analyses(const PlannedTrialRow& trial) noexcept;

/// Of an attempt at that trial, as read from a study.
AnalysisUse use_in_analyses(const PlannedTrialRow& trial, const AttemptRow& attempt) noexcept;

/// What becomes of the use of a trial with an attempt at it.
struct AttemptState {
  bool valid = false;
  bool answered = false;
  bool excluded = false;
};
AnalysisUse use_in_analyses(AnalysisUse of_trial, const AttemptState& attempt) noexcept;

}  // namespace asperity

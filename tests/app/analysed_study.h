// Made-up studies of one protocol, analysed, and what a test reads of their outcomes.

#pragma once

#include <cstdint>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "app/findings/study/analyze_study.h"
#include "tests/app/made_up_study.h"
#include "tests/app/stored_tables.h"

namespace asperity {

/// The trials of the participants, in turn from 0.
using TrialsOfParticipant = std::function<std::vector<MadeUpTrial>(int)>;

/// Participants with a session each. Their labels are p and a number.
struct MadeUpParticipants {
  int number = 1;
  int first = 10;        ///< of the numbers; of two digits, so that the labels are in their order
  std::string sex{};     ///< of all; empty: not stated
  bool of_both = false;  ///< the first half are women, the others men
};

void add_participants(MadeUpStudy& made, std::int64_t protocol, const MadeUpParticipants& people,
                      const TrialsOfParticipant& trials_of);

/// The outcome of this kind of a study with one protocol.
AnalysisOutcome analysed(const std::string& kind, const std::string& source,
                         const MadeUpParticipants& people, const TrialsOfParticipant& trials_of);

/// The same with the trials of each participant; `people.number` is not read.
AnalysisOutcome analysed(const std::string& kind, const std::string& source,
                         MadeUpParticipants people,
                         const std::vector<std::vector<MadeUpTrial>>& by_person);

/// The outcome that `make` returned for this key for the first time in this process. Two outcomes that a test compares are
/// not made this way.
const AnalysisOutcome& outcome_once(const std::string& key,
                                    const std::function<AnalysisOutcome()>& make);

/// A key of all arguments of an outcome.
template <class... Parts>
std::string outcome_key(const Parts&... parts) {
  std::ostringstream key{};
  key.precision(17);
  ((key << parts << '|'), ...);
  return key.str();
}

/// A table as programs read it, which exists until the process ends; null where there is none.
const StoredTable* find_table(const AnalysisOutcome& outcome, const std::string& name);
const StoredTable& table_of(const AnalysisOutcome& outcome, const std::string& name);

/// The same as a terminal shows it.
Table shown_table(const AnalysisOutcome& outcome, const std::string& name);

const AnsweredQuestion* find_question(const AnalysisOutcome& outcome, const std::string& name);
const AnsweredQuestion& question_of(const AnalysisOutcome& outcome, const std::string& name);

/// In English; empty where the question is not asked.
std::string answer_to(const AnalysisOutcome& outcome, const std::string& name);

const Finding& finding_of(const AnalysisOutcome& outcome, const std::string& analysis,
                          const std::string& quantity, const std::string& key = {});
std::vector<Finding> part_of(const AnalysisOutcome& outcome, const std::string& analysis);

/// The first sentence about a test; empty where there is none.
std::string sentence_about(const AnalysisOutcome& outcome, const std::string& test,
                           const TestSubject& about = {});

/// All remarks in English, one per line.
std::string remarks_of(const AnalysisOutcome& outcome);

}  // namespace asperity

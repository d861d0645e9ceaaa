// Findings of the families put beside each other: found again by name, said in words.

#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/findings/found_numbers.h"
#include "app/findings/study/analysis_outcome.h"
#include "app/findings/study/study_tests.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {

/// Runs a family on a table and gives its findings the name `analysis`. What the family refuses is a
/// finding `status` with the word not_applicable.
std::vector<Finding> analysis_of(const char* analysis, const char* family, TidyInput input);

/// Which findings to keep.
using KeepFinding = std::function<bool(const Finding&)>;
/// Appends them to those of the outcome.
void keep_findings(
    std::span<const Finding> findings, AnalysisOutcome& outcome,
    const KeepFinding& keep = [](const Finding&) { return true; });

/// A word in the place of an answer, and the sentence that states why there is none.
void add_status(const FindingName& name, std::string word, std::string reason,
                AnalysisOutcome& outcome);

/// "75 %"
Phrase percent(double share);
/// "(95 % interval 40 % to 71 %)" of a share, or why there is none.
Phrase interval_text(const Finding& share);

/// Whether the 95 % CI of an estimate holds this value, so that the estimate establishes no difference from it; not
/// without a CI.
bool holds_in_interval(const Finding& estimate, double value) noexcept;

/// What the n of a finding counts.
enum class CountedUnit { participants, answers, goes };
/// The answer of a question: `finding` is what the sentence rests on.
void add_question(AnalysisOutcome& outcome, const char* name, Phrase question, Phrase answer,
                  Phrase method, const char* table, const Finding* finding,
                  CountedUnit unit = CountedUnit::participants);

/// In what the results of women and men are told.
enum class SexesScale { shares_of_answers, shares_of_items, items };
/// Means of the participants of each sex with their intervals, and the first less the second.
struct SexesComparison {
  std::optional<Finding> women{};
  std::optional<Finding> men{};
  std::optional<Finding> difference{};
  SexesScale scale = SexesScale::shares_of_answers;
};
/// Whether women and men differ; nothing where there are not both.
void ask_sexes(const SexesComparison& sexes, const StudyTests& tests, AnalysisOutcome& outcome);

/// The table `name` from subj.mean, subj.sd, subj.minimum, subj.median and subj.maximum of these
/// keys, with the same as findings `mean_of_persons_QUANTITY`.
struct PersonsRow {
  std::string name{};  ///< in the table
  std::string key{};   ///< of the findings
};
void add_persons(const FoundNumbers& found, std::span<const PersonsRow> rows,
                 const std::string& key_column, const std::string& quantity,
                 AnalysisOutcome& outcome, const char* name = "persons");

/// A row per measure: value and interval, where they are numbers.
struct Measure {
  enum class Form { number, count };
  const char* name = nullptr;  ///< fixed, for programs; words: cell_words.h
  const char* quantity = nullptr;
  Form form = Form::number;
  bool has_interval = true;  ///< false: one over trials, which says nothing about participants
};
/// "%1, averaged over the participants, with a t-based CI on the logit scale." of what `mean` has.
Phrase averaged(const Phrase& proportion, const Finding* mean);

void add_measures(const FoundNumbers& found, std::span<const Measure> measures,
                  AnalysisOutcome& outcome);

}  // namespace asperity

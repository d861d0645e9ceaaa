// Combines the findings of several families, and expresses them as text.

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

#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/outcome/study_tests.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {

/// Runs a family on a table and gives its findings the name `analysis`. An error of the family
/// becomes a finding `status` with the word not_applicable.
std::vector<Finding> analysis_of(const char* analysis, const char* family, TidyInput input);
/// As above, of a family that reads no table.
std::vector<Finding> analysis_of(const char* analysis,
                                 const std::function<std::vector<Finding>()>& family);

/// Selects the findings to keep.
using KeepFinding = std::function<bool(const Finding&)>;
/// Appends them to the findings of the outcome.
void keep_findings(
    std::span<const Finding> findings, AnalysisOutcome& outcome,
    const KeepFinding& keep = [](const Finding&) { return true; });

/// A word in place of a number, and the sentence that states why there is no number.
void add_status(const FindingName& name, std::string word, std::string reason,
                AnalysisOutcome& outcome);

/// "75 %"
Phrase percent(double share);
/// "(95 % CI [40 %, 71 %])" of a proportion, or why there is none.
Phrase interval_text(const Finding& share);
/// "12.3 µm (95 % CI [10 µm, 14.6 µm])" of a number with a unit; the number alone where it has no CI.
Phrase quantity_with_interval(const Finding& estimate);

/// Whether the 95 % CI of an estimate contains this value, so that the estimate establishes no
/// difference from it; false without a CI.
bool holds_in_interval(const Finding& estimate, double value) noexcept;

/// The unit of the n of a finding.
enum class CountedUnit { participants, answers, goes };
/// Adds the answer to a question: `finding` is the number on which the sentence is based.
void add_question(AnalysisOutcome& outcome, const char* name, Phrase question, Phrase answer,
                  Phrase method, const char* table, const Finding* finding,
                  CountedUnit unit = CountedUnit::participants);

/// The usual table of the means of the participants' proportions.
inline constexpr const char* kPersonMeans = "persons";
/// Appends the table `name` from subj.mean, subj.sd, subj.minimum, subj.median and subj.maximum of
/// these keys, and the same numbers as findings `mean_of_persons_QUANTITY`. Null: there are no means, and no table.
struct PersonsRow {
  ResultCell name{};  ///< in the table
  FindingKey key{};   ///< of the findings
};
ResultTable* add_persons(const FoundNumbers& found, std::span<const PersonsRow> rows,
                         const ResultColumn& key_column, const std::string& quantity,
                         AnalysisOutcome& outcome, const char* name = kPersonMeans);

/// A row per measure: value and interval, where they are numbers.
struct Measure {
  enum class Form { number, count };
  const char* name = nullptr;  ///< fixed, for programs; display text: cell_words.h
  QuantityName quantity{};
  Form form = Form::number;
  /// False: its interval is over trials, and does not apply to participants.
  bool has_interval = true;
};
/// "%1, averaged over the participants, with a t-based CI on the logit scale.", without the parts that do not apply to `mean`.
Phrase averaged(const Phrase& proportion, const Finding* mean);

void add_measures(const FoundNumbers& found, std::span<const Measure> measures,
                  AnalysisOutcome& outcome);

}  // namespace asperity

// Calls families, converting a refusal into a finding with its reason, and adds their findings, tables and questions.

#include "app/findings/outcome/study_findings.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <stdexcept>

#include "analysis/numbers/number_text.h"
#include "analysis/tests/multiplicity.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/display_number.h"
#include "results_schema/error_text.h"

namespace asperity {

namespace {

/// "20 participants"
Phrase counted_units(std::size_t n, CountedUnit unit) {
  const std::string number = std::to_string(n);
  switch (unit) {
    case CountedUnit::participants:
      return n == 1 ? phrase("Analysis", "one participant")
                    : phrase("Analysis", "%1 participants").with(number);
    case CountedUnit::answers:
      return n == 1 ? phrase("Analysis", "one response")
                    : phrase("Analysis", "%1 responses").with(number);
    case CountedUnit::goes:
      return n == 1 ? phrase("Analysis", "one trial")
                    : phrase("Analysis", "%1 trials").with(number);
  }
  return {};
}

}  // namespace

std::vector<Finding> analysis_of(const char* analysis, const char* family, TidyInput input) {
  std::vector<Finding> findings =
      analysis_of(analysis, [&] { return tidy_family(family).findings(input); });
  for (Finding& finding : findings) {
    const auto several = input.keys.find(finding.key[0]);
    if (several != input.keys.end()) finding.key = {several->second, finding.key.without_first()};
  }
  return findings;
}

std::vector<Finding> analysis_of(const char* analysis,
                                 const std::function<std::vector<Finding>()>& family) {
  std::vector<Finding> findings{};
  try {
    findings = family();
  } catch (const std::exception& error) {
    Finding refused{};
    refused.quantity = "status";
    refused.word = "not_applicable";
    refused.status = message_of(error);
    findings.push_back(std::move(refused));
  }
  for (Finding& finding : findings) finding.analysis = analysis;
  return findings;
}

void keep_findings(std::span<const Finding> findings, AnalysisOutcome& outcome,
                   const KeepFinding& keep) {
  std::copy_if(findings.begin(), findings.end(), std::back_inserter(outcome.findings), keep);
}

void add_status(const FindingName& name, std::string word, std::string reason,
                AnalysisOutcome& outcome) {
  Finding& added = outcome.findings.emplace_back();
  added.analysis = name.analysis;
  added.quantity = name.quantity;
  added.key = name.key;
  added.word = std::move(word);
  added.status = std::move(reason);
}

Phrase percent(double share) { return display_percent(share); }

Phrase interval_text(const Finding& share) {
  if (share.low && share.high) {
    return phrase("Analysis", "95 % CI [%1, %2]").with(percent(*share.low), percent(*share.high));
  }
  if (share.n > 1) return phrase("Analysis", "no CI, because all participants have the same value");
  return phrase("Analysis", "no CI, because there is only one participant");
}

Phrase quantity_with_interval(const Finding& estimate) {
  const std::string value = display_quantity(*estimate.value, estimate.unit);
  if (!estimate.low || !estimate.high) return value;
  return phrase("Analysis", "%1 (95 % CI [%2, %3])")
      .with(value, display_quantity(*estimate.low, estimate.unit),
            display_quantity(*estimate.high, estimate.unit));
}

bool holds_in_interval(const Finding& estimate, double value) noexcept {
  return estimate.low && estimate.high && *estimate.low <= value && value <= *estimate.high;
}

void add_question(AnalysisOutcome& outcome, const char* name, Phrase question, Phrase answer,
                  Phrase method, const char* table, const Finding* finding, CountedUnit unit) {
  AnsweredQuestion& added = outcome.questions.emplace_back();
  added.name = name;
  added.question = std::move(question);
  added.answer = std::move(answer);
  added.method = std::move(method);
  added.table = table;
  if (finding == nullptr) {
    added.finding.status = added.answer.english();
    return;
  }
  added.finding = *finding;
  added.counted = counted_units(finding->n, unit);
}

ResultTable* add_persons(const FoundNumbers& found, std::span<const PersonsRow> rows,
                         const ResultColumn& key_column, const std::string& quantity,
                         AnalysisOutcome& outcome, const char* name) {
  using namespace columns;
  ResultTable made{
      name,
      phrase("Analysis", "Participant-level proportions, summarised over the participants"),
      {key_column, kPersons, kMean, interval_of(kMean), kSd, kMinimum, kMedian, kMaximum},
      phrase("Analysis",
             "95 % CI of the mean: Student's t over the participants on the logit scale. In "
             "simulations with 2 to 20 participants, its coverage was at least 91 %.")};
  bool has_interval = false;
  for (const PersonsRow& row : rows) {
    const Finding* mean = found.find("subj.mean", row.key);
    if (mean == nullptr || !mean->value) continue;
    made.add({row.name, count_cell(mean->n), *mean->value, found.interval("subj.mean", row.key),
              found.cell("subj.sd", row.key), found.cell("subj.minimum", row.key),
              found.cell("subj.median", row.key), found.cell("subj.maximum", row.key)});
    has_interval = has_interval || mean->low;
    Finding finding = *mean;
    finding.quantity = "mean_of_persons_" + quantity;
    const auto* const word = std::get_if<std::string>(&row.name);
    finding.key = key_column.id + '=' + (word == nullptr ? row.key.text() : *word);
    finding.analysis.clear();
    outcome.findings.push_back(std::move(finding));
  }
  if (made.rows.empty()) return nullptr;
  if (!has_interval) made.note = phrase("Analysis", "With one participant there is no CI.");
  return &outcome.tables.emplace_back(std::move(made));
}

Phrase averaged(const Phrase& proportion, const Finding* mean) {
  const bool has_interval = mean != nullptr && mean->low;
  const bool has_several = mean != nullptr && mean->n > 1;
  return (has_interval
              ? phrase("Analysis",
                       "%1, averaged over the participants, with a t-based CI on the logit "
                       "scale.")
          : has_several ? phrase("Analysis", "%1, averaged over the participants.")
                        : phrase("Analysis", "%1."))
      .with(proportion);
}

void add_measures(const FoundNumbers& found, std::span<const Measure> measures,
                  AnalysisOutcome& outcome) {
  using namespace columns;
  ResultTable made{"measures",
                   phrase("Analysis", "Measures of all responses together"),
                   {kMeasure, kValue, interval_of(kValue), kUnit},
                   {}};
  for (const Measure& measure : measures) {
    const Finding* finding = found.find(measure.quantity);
    if (finding == nullptr) continue;
    const ResultCell value = !finding->value                        ? ResultCell{finding->word}
                             : measure.form == Measure::Form::count ? found.count(measure.quantity)
                                                                    : *finding->value;
    made.add({measure.name, value,
              measure.has_interval ? found.interval(measure.quantity) : ResultCell{},
              finding->unit});
  }
  outcome.tables.push_back(std::move(made));
}

}  // namespace asperity

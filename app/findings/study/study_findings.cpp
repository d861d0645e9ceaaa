#include "app/findings/study/study_findings.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <stdexcept>

#include "analysis/multiplicity.h"
#include "analysis/number_text.h"
#include "analysis/two_samples.h"
#include "app/findings/reading_number.h"
#include "app/findings/study/cell_words.h"
#include "app/findings/study/test_sentences.h"

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

/// "95 % CI [2.10, 2.90]" for an estimate other than a proportion.
Phrase plain_interval(const Finding& finding, int digits) {
  if (finding.low && finding.high) {
    return phrase("Analysis", "95 % CI [%1, %2]")
        .with(reading_signed(*finding.low, digits), reading_signed(*finding.high, digits));
  }
  return phrase("Analysis", "without a CI");
}

/// The same for a difference, whose p comes from a different method than its interval.
Phrase interval_of_difference(const Finding& finding, int digits) {
  if (finding.low && finding.high) {
    return phrase("Analysis", "Welch 95 % CI [%1, %2]")
        .with(reading_signed(*finding.low, digits), reading_signed(*finding.high, digits));
  }
  return phrase("Analysis", "without a CI");
}

}  // namespace

std::vector<Finding> analysis_of(const char* analysis, const char* family, TidyInput input) {
  std::vector<Finding> findings{};
  try {
    findings = tidy_family(family).findings(input);
  } catch (const std::exception& error) {
    Finding refused{};
    refused.quantity = "status";
    refused.word = "not_applicable";
    refused.status = error.what();
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

Phrase percent(double share) { return reading_percent(share); }

Phrase interval_text(const Finding& share) {
  if (share.low && share.high) {
    return phrase("Analysis", "95 % CI [%1, %2]").with(percent(*share.low), percent(*share.high));
  }
  return phrase("Analysis", "no CI, because there is only one participant");
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

Phrase method_of_sexes(const SexesComparison& sexes) {
  const Phrase means = phrase("Analysis", "Means of the participants' own results.");
  const Phrase intervals =
      sexes.difference->low
          ? phrase(
                "Analysis",
                "%1 The CIs of the means are t-based, for proportions on the logit scale; that "
                "of the difference is Welch's CI. p is computed by a different method: in "
                "borderline cases p may be below .05 although the CI contains 0, or the reverse.")
                .with(means)
          : means;
  return sexes.women->n + sexes.men->n <= kMostPermuted
             ? phrase("Analysis",
                      "%1 The permutation test uses all permutations of the group labels.")
                   .with(intervals)
             : phrase("Analysis",
                      "%1 The permutation test uses %2 permutations of the group labels drawn at "
                      "random, because there are too many to enumerate.")
                   .with(intervals, std::to_string(kRandomSplits));
}

void ask_sexes(const SexesComparison& sexes, const StudyTests& tests, AnalysisOutcome& outcome) {
  const StudyTests::Test* test = tests.find("sexes", "F|M");
  const auto has_value = [](const std::optional<Finding>& one) { return one && one->value; };
  if (!has_value(sexes.women) || !has_value(sexes.men) || !has_value(sexes.difference) ||
      test == nullptr) {
    return;
  }
  const bool are_shares = sexes.scale != SexesScale::items;
  const auto mean = [are_shares](const Finding& of) {
    return phrase("Analysis", "%1 (%2, n = %3)")
        .with(are_shares ? percent(*of.value) : Phrase(reading_signed(*of.value, 2)),
              are_shares ? interval_text(of) : plain_interval(of, 2), std::to_string(of.n));
  };
  const Phrase means =
      (sexes.scale == SexesScale::shares_of_answers
           ? phrase("Analysis", "the mean proportion correct is %1 for women and %2 for men")
       : sexes.scale == SexesScale::shares_of_items
           ? phrase("Analysis",
                    "the mean proportion of correctly matched items is %1 for women and %2 for men")
           : phrase("Analysis",
                    "the mean number of correctly matched items per trial is %1 for women and %2 "
                    "for men"))
          .with(mean(*sexes.women), mean(*sexes.men));
  Finding shown = *sexes.difference;
  for (std::optional<double>* number : {&shown.value, &shown.low, &shown.high}) {
    if (*number && are_shares) **number *= 100.0;
  }
  const int digits = are_shares ? 1 : 2;
  const Phrase difference =
      (are_shares ? phrase("Analysis", "%1 percentage points (%2)")
                  : phrase("Analysis", "%1 items (%2)"))
          .with(reading_signed(*shown.value, digits), interval_of_difference(shown, digits));
  const auto with_numbers = [&](const Phrase& words) {
    return words.with(means, difference, p_text(*test));
  };
  if (test->is_significant() && holds_in_interval(*sexes.difference, 0.0)) {
    qualify_test_sentence(outcome, test->name, "; the 95 % CI of the difference contains 0");
  }
  const Sayings sayings{
      holds_in_interval(*sexes.difference, 0.0)
          ? with_numbers(phrase("Analysis",
                                "Not established: %1; difference (women − men) %2. Permutation "
                                "test of group labels: %3. The test is significant, but the CI of "
                                "the difference contains 0; more participants are needed."))
          : with_numbers(phrase("Analysis",
                                "Yes: %1; difference (women − men) %2. Permutation test of group "
                                "labels: %3.")),
      with_numbers(phrase("Analysis",
                          "Not significantly: %1; difference (women − men) %2. Permutation test of "
                          "group labels: %3. This does not show that they are equal.")),
      with_numbers(phrase("Analysis",
                          "For these participants, %1; difference (women − men) %2. Permutation "
                          "test of group labels: %3."))};
  add_question(outcome, "sexes", phrase("Analysis", "Do women and men differ?"),
               said_of(*test, sayings), method_of_sexes(sexes), "tests", &*sexes.difference);
}

void add_persons(const FoundNumbers& found, std::span<const PersonsRow> rows,
                 const std::string& key_column, const std::string& quantity,
                 AnalysisOutcome& outcome, const char* name) {
  NamedTable made{
      name,
      phrase("Analysis", "Participant-level proportions, summarised over the participants"),
      {{key_column, "persons", "mean", "mean_low", "mean_high", "sd", "minimum", "median",
        "maximum"},
       {}},
      phrase("Analysis",
             "95 % CI of the mean: Student's t over the participants on the logit scale. In "
             "simulations with 2 to 20 participants it contained the true mean in 91 % or more of "
             "the studies.")};
  bool has_interval = false;
  for (const PersonsRow& row : rows) {
    const Finding* mean = found.find("subj.mean", row.key);
    if (mean == nullptr || !mean->value) continue;
    const auto [low, high] = found.interval("subj.mean", row.key);
    made.table.rows.push_back(
        {row.name, static_cast<std::int64_t>(mean->n), *mean->value, low, high,
         found.cell("subj.sd", row.key), found.cell("subj.minimum", row.key),
         found.cell("subj.median", row.key), found.cell("subj.maximum", row.key)});
    has_interval = has_interval || mean->low;
    Finding finding = *mean;
    finding.quantity = "mean_of_persons_" + quantity;
    finding.key = key_column + '=' + row.name;
    finding.analysis.clear();
    outcome.findings.push_back(std::move(finding));
  }
  if (!has_interval) made.note = phrase("Analysis", "With one participant there is no CI.");
  outcome.tables.push_back(std::move(made));
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
  NamedTable made{"measures",
                  phrase("Analysis", "Measures of all responses together"),
                  {{"measure", "value", "value_low", "value_high", "unit"}, {}},
                  {}};
  for (const Measure& measure : measures) {
    const Finding* finding = found.find(measure.quantity);
    if (finding == nullptr) continue;
    auto [low, high] = found.interval(measure.quantity);
    if (!measure.has_interval) low = high = Cell{};
    Cell value = finding->value ? Cell{*finding->value} : Cell{finding->word};
    if (finding->value && measure.form == Measure::Form::count) {
      value = static_cast<std::int64_t>(std::llround(*finding->value));
    }
    made.table.rows.push_back({measure.name, value, low, high, finding->unit});
  }
  outcome.tables.push_back(std::move(made));
}

}  // namespace asperity

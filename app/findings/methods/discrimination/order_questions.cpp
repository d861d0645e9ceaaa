// Two alternatives: difference of two proportions; three: proportions by place; none for designs with noise trials.

#include "app/findings/methods/discrimination/order_questions.h"

#include <cstddef>
#include <string>

#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/outcome/test_sentences.h"

namespace asperity {

namespace {

Phrase question_of_order(const DiscriminationResults& results) {
  return results.study.task.is_sequential
             ? phrase("Analysis", "Does the order of presentation matter?")
             : phrase("Analysis", "Does the position of the surfaces matter?");
}

/// What is asked, how it is tested, and the table with the estimates.
struct OrderQuestion {
  std::string name{};
  Phrase question{};
  Phrase method{};
  const char* table = nullptr;
};

void add_answer(AnalysisOutcome& outcome, const OrderQuestion& asked, const Phrase& estimate,
                const StudyTest* test, const Finding* finding) {
  if (test == nullptr || !test->p) {
    add_question(outcome, asked.name.c_str(), asked.question,
                 phrase("Analysis", "Not tested: %1.").with(estimate), asked.method, asked.table,
                 finding);
    return;
  }
  const TestStatements statements =
      statements_of(*test, {.numbers = phrase("Analysis", "%1 (%2).").with(estimate, p_text(*test)),
                            .exploratory = phrase("Analysis", "On average, %1")});
  add_question(outcome, asked.name.c_str(), asked.question, said_of(*test, statements),
               asked.method, asked.table, finding);
}

void ask_order(const DiscriminationResults& results, const StudyTests& tests,
               AnalysisOutcome& outcome) {
  const bool is_sequential = results.study.task.is_sequential;
  const Phrase question = question_of_order(results);
  const Phrase method =
      is_sequential
          ? phrase("Analysis",
                   "Wilcoxon signed-rank test of each participant's proportions of choices of the "
                   "comparison presented first and second.")
          : phrase("Analysis",
                   "Wilcoxon signed-rank test of each participant's proportions of choices of the "
                   "comparison as surface A and as surface B.");
  const std::string name = results.name_of_question(kOrderEffect);
  const FoundNumbers found(results.order);
  const Finding* const mean = found.find("order.difference", results.name);
  const StudyTest* const test = tests.find("order", results.name);
  if (mean == nullptr || !mean->value) {
    add_question(outcome, name.c_str(), question,
                 phrase("Analysis",
                        "This cannot be estimated: no participant felt the comparison in both "
                        "positions."),
                 method, kOrderEffect, nullptr);
    return;
  }
  Phrase difference = phrase("Analysis", "%1 percentage points").with(display_points(*mean->value));
  if (mean->low && mean->high) {
    difference = phrase("Analysis", "%1 (95 % CI [%2, %3])")
                     .with(difference, display_points(*mean->low), display_points(*mean->high));
  }
  const Phrase estimate =
      (is_sequential
           ? phrase(
                 "Analysis",
                 "the difference between the proportions of choices of the comparison, presented "
                 "first minus presented second, was %1")
           : phrase(
                 "Analysis",
                 "the difference between the proportions of choices of the comparison, as surface "
                 "A minus as surface B, was %1"))
          .with(difference);
  add_answer(outcome, {name, question, method, kOrderEffect}, estimate, test, mean);
}

/// "A 36 % (95 % CI [30 %, 42 %]), B …"
Phrase proportions_by_place(const DiscriminationResults& results, const FoundNumbers& found) {
  Phrase all{};
  for (std::size_t place = 0; place < kPlacesOfChoice; ++place) {
    const Finding* const mean = found.find("place.proportion", key_of_place(results.name, place));
    if (mean == nullptr || !mean->value) return {};
    Phrase one =
        phrase("Analysis", "%1 %2").with(kCodesOfPlaces[place], display_percent(*mean->value));
    if (mean->low && mean->high) {
      one = phrase("Analysis", "%1 (95 % CI [%2, %3])")
                .with(one, display_percent(*mean->low), display_percent(*mean->high));
    }
    all = all.empty() ? one : phrase("Analysis", "%1; %2").with(all, one);
  }
  return all;
}

void ask_places(const DiscriminationResults& results, const StudyTests& tests,
                AnalysisOutcome& outcome) {
  const Phrase question = question_of_order(results);
  const Phrase method = phrase("Analysis",
                               "Friedman test of each participant's proportions of choices of the "
                               "surfaces A, B and C, averaged over the positions of the correct "
                               "one.");
  const std::string name = results.name_of_question(kOrderEffect);
  const FoundNumbers found(results.order);
  const Phrase proportions = proportions_by_place(results, found);
  if (proportions.empty()) {
    add_question(outcome, name.c_str(), question,
                 phrase("Analysis",
                        "This cannot be estimated: no participant felt the surface that is to be "
                        "chosen in every position."),
                 method, kChoicesByPlace, nullptr);
    return;
  }
  const Phrase estimate = phrase("Analysis", "mean proportions of choices: %1").with(proportions);
  const Finding* const first = found.find("place.proportion", key_of_place(results.name, 0));
  const StudyTest* const test = tests.find("order", results.name);
  add_answer(outcome, {name, question, method, kChoicesByPlace}, estimate, test, first);
}

}  // namespace

void ask_order_effect(const DiscriminationResults& results, const StudyTests& tests,
                      AnalysisOutcome& outcome) {
  const DiscriminationDesign& design = *results.study.task.design;
  if (design.is_choice_of_three()) {
    ask_places(results, tests, outcome);
  } else if (!design.has_noise()) {
    ask_order(results, tests, outcome);
  }
}

}  // namespace asperity

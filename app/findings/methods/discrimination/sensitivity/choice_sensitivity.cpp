// Passes the counts by condition, level and participant to the family `dprime`, as mafc or oddity.

#include "app/findings/methods/discrimination/sensitivity/choice_sensitivity.h"

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "app/findings/gathering/answer_columns.h"
#include "app/findings/methods/discrimination/sensitivity/discrimination_sensitivity.h"
#include "app/findings/methods/discrimination/thresholds/threshold_columns.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/outcome/study_findings.h"

namespace asperity {

namespace {

/// By condition, value of the parameter and participant.
using CorrectByLevel = std::map<std::tuple<std::size_t, double, std::uint32_t>, HitCount>;

CorrectByLevel correct_by_level(const DiscriminationStudy& study) {
  CorrectByLevel correct{};
  for (const DiscriminationTrial& trial : study.trials) {
    HitCount& count = correct[{trial.condition, trial.value, trial.person}];
    ++count.trials;
    count.hits += trial.chose_comparison ? 1 : 0;
  }
  return correct;
}

std::vector<Finding> sensitivities_of_choices(const GatheredAnswers& gathered,
                                              const DiscriminationResults& results,
                                              const CorrectByLevel& correct) {
  const DiscriminationDesign& design = *results.study.task.design;
  TidyInput input{};
  LabelRows ids{};
  LabelRows subjects{};
  LabelRows designs{};
  NumberColumn hits{};
  NumberColumn trials{};
  for (const auto& [place, count] : correct) {
    const auto& [condition, value, person] = place;
    ids.add(input.label_of(id_of_level(results, {condition, value})));
    subjects.add(gathered.people[person].label);
    designs.add(design.asks_for_odd_one ? "oddity" : "mafc");
    hits.emplace_back(static_cast<double>(count.hits));
    trials.emplace_back(static_cast<double>(count.trials));
  }
  const NumberColumn alternatives(correct.size(), static_cast<double>(design.surfaces()));
  input.tables.emplace_back(std::vector<TidyTable::Column>{{"id", std::move(ids).take()},
                                                           {"subject", std::move(subjects).take()},
                                                           {"design", std::move(designs).take()},
                                                           {"signal_yes", std::move(hits)},
                                                           {"signal_n", std::move(trials)},
                                                           {"m", alternatives}},
                            "the responses");
  return analysis_of(kSensitivity, "dprime", std::move(input));
}

void add_rows(const GatheredAnswers& gathered, const DiscriminationResults& results,
              const CorrectByLevel& correct, const FoundNumbers& found, ResultTable& table) {
  const DiscriminationTask& task = results.study.task;
  for (const auto& [place, count] : correct) {
    const auto& [condition, value, person] = place;
    const std::string& participant = gathered.people[person].label;
    const FindingKey key{id_of_level(results, {condition, value}), participant};
    const std::string& unit = task.varied.unit;
    table.add({participant, results.conditions[condition], task.varied.parameter,
               quantity_cell(value, unit), quantity_cell(value - task.standard(), unit),
               count_cell(count.trials), count_cell(count.hits), proportion(count),
               found.cell("dprime", key), found.interval("dprime", key),
               found.cell("dprime.with.guess", key), found.cell("dprime.io", key),
               word_cell(unit)});
  }
}

struct ShownDesigns {
  bool has_three_alternatives = false;
  bool has_oddity = false;
};

Phrase note_on_choices(const ShownDesigns& shown) {
  Phrase note{};
  const auto add = [&note](const Phrase& sentence) {
    note = note.empty() ? sentence : phrase("Analysis", "%1 %2").with(note, sentence);
  };
  if (shown.has_three_alternatives) {
    add(phrase("Analysis",
               "Three alternatives: d′ of an unbiased choice of the greatest of three impressions "
               "[Hacker 1979]."));
  }
  if (shown.has_oddity) {
    add(phrase("Analysis",
               "Oddity: d′ by the differencing rule [Frijters 1979], and d′ by the rule of "
               "independent observations [Versfeld 1996]; 0 for proportions up to 1/3."));
  }
  add(phrase("Analysis",
             "95 % CI of d′: Wilson limits of the proportion correct. d′ is missing where every "
             "response or no response is correct. Corrected d′: that of (correct responses + "
             "1/3)/(trials + 1), which is finite for every number of correct responses; the means "
             "over the participants are means of the corrected d′."));
  return note;
}

Phrase method_of_mean(const DiscriminationDesign& design) {
  return design.asks_for_odd_one
             ? phrase("Analysis",
                      "Mean over the participants of d′ by the differencing rule, of "
                      "(correct responses + 1/3)/(trials + 1), which is finite; CIs by expanded "
                      "percentiles of a bootstrap over participants, with six participants or "
                      "more.")
             : phrase("Analysis",
                      "Mean over the participants of d′ of (correct responses + 1/3)/(trials + 1), "
                      "which is finite; CIs by expanded percentiles of a bootstrap over "
                      "participants, with six participants or more.");
}

const ResultColumn kDPrimeCorrected{.id = "d_prime_corrected",
                                    .heading = phrase("AnalysisWords", "d′, corrected")};

}  // namespace

void add_choice_sensitivity(const GatheredAnswers& gathered,
                            const std::vector<DiscriminationResults>& all,
                            AnalysisOutcome& outcome) {
  using namespace columns;
  ResultTable choices{
      kSensitivityOfChoices,
      phrase("Analysis", "Sensitivity by level, from the proportion correct"),
      {kParticipant, kCondition, kParameterColumn, kLevelColumn, kDifference, kResponses, kHits,
       kShare, kDPrime, interval_of(kDPrime), kDPrimeCorrected, kDPrimeIndependent, kUnitOfLevels}};
  ShownDesigns shown{};
  for (const DiscriminationResults& results : all) {
    const DiscriminationDesign& design = *results.study.task.design;
    if (!design.is_choice_of_three() || results.study.has_levels_of_procedure) continue;
    const CorrectByLevel correct = correct_by_level(results.study);
    UnboundedAtLevels levels{};
    for (const auto& [place, count] : correct) {
      UnboundedParticipants& of = levels[{std::get<std::size_t>(place), std::get<double>(place)}];
      ++of.participants;
      of.at_ceiling += count.hits == count.trials ? 1 : 0;
      // By the rule of the odd one d′ is never negative.
      of.at_floor += !design.asks_for_odd_one && count.hits == 0 ? 1 : 0;
    }
    std::vector<Finding> findings = sensitivities_of_choices(gathered, results, correct);
    if (design.asks_for_odd_one) {
      const FoundNumbers own(findings);
      for (const auto& [place, count] : correct) {
        const auto& [condition, value, person] = place;
        const FindingKey key{id_of_level(results, {condition, value}),
                             gathered.people[person].label};
        if (own.value("dprime.with.guess", key) == 0.0) ++levels[{condition, value}].at_zero;
      }
    }
    mark_bounds(results, levels, findings);
    keep_findings(findings, outcome);
    const FoundNumbers found(findings);
    add_rows(gathered, results, correct, found, choices);
    if (!levels.empty()) {
      ask_mean_sensitivity(results, levels, found,
                           {.table = kSensitivityOfChoices, .method = method_of_mean(design)},
                           outcome);
    }
    shown.has_oddity = shown.has_oddity || design.asks_for_odd_one;
    shown.has_three_alternatives = shown.has_three_alternatives || !design.asks_for_odd_one;
  }
  if (choices.rows.empty()) return;
  choices.note = note_on_choices(shown);
  choices.drop_empty_columns(2);
  outcome.tables.push_back(std::move(choices));
}

}  // namespace asperity

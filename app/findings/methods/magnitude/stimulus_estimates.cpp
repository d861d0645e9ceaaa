// Calls the families `magnitude`, for means and exponents, and `rmanova`, for effects of stimulus and condition.

#include "app/findings/methods/magnitude/stimulus_estimates.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "app/findings/gathering/answer_columns.h"
#include "app/findings/methods/magnitude/stimulus_estimates_figure.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/outcome/study_tests.h"
#include "app/findings/outcome/test_sentences.h"
#include "app/findings/shared/estimates.h"
#include "app/findings/shared/group_comparisons.h"
#include "app/findings/shared/magnitude_effects.h"
#include "app/findings/shared/similarity_properties.h"
#include "protocols/kinds/estimation.h"

namespace asperity {

namespace {

constexpr const char* kExponents = "exponents";
constexpr const char* kOnlyCondition = "all";

const ResultColumn kPredictor{.id = "predictor", .heading = phrase("AnalysisWords", "predictor")};
const ResultColumn kStimulusUnit = for_files({.id = "stimulus_unit"});
const ResultColumn kPredictorUnit = for_files({.id = "predictor_unit"});
const ResultColumn kExponent{.id = "exponent", .heading = phrase("AnalysisWords", "exponent")};

bool is_stated_predictor(const EstimationDeclaration& estimation) {
  return estimation.predictor == kLevelPredictor || estimation.predictor == kValuePredictor;
}

std::map<std::string, double> stated_predictor(const GatheredAnswers& gathered,
                                               const std::vector<std::string>& stimuli) {
  const EstimationDeclaration& estimation = gathered.estimation;
  std::map<std::string, double> values{};
  for (const std::string& stimulus : stimuli) {
    const auto declared = estimation.predictor_values.find(stimulus);
    const bool is_declared = declared != estimation.predictor_values.end();
    // The levels of a varied parameter are stated by its blocks.
    const std::optional<double> value = is_declared ? std::optional(declared->second)
                                        : estimation.predictor == kLevelPredictor
                                            ? number_in(stimulus)
                                            : std::nullopt;
    if (value) values.emplace(stimulus, *value);
  }
  return values;
}

/// "amplitude" for the levels of a varied parameter `amplitude_m`, "hardness"
std::string name_of_stated_predictor(const EstimationDeclaration& estimation) {
  return estimation.predictor == kLevelPredictor ? words_of_parameter(estimation.items)
                                                 : estimation.items;
}

/// "amplitude", "RMS of the texture force, N"
Phrase predictor_name(const EstimationDeclaration& estimation) {
  if (!is_stated_predictor(estimation)) return words_of_property(estimation.predictor);
  return name_of_stated_predictor(estimation);
}

/// Whether any recording is stored from which the predictor can be computed; a remark where recordings are missing.
bool has_recordings(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  if (gathered.recorded_participants == 0) {
    outcome.remarks.push_back(
        phrase("Analysis",
               "There is no exponent, because the predictor (%1) is computed from recordings, and "
               "none can be read for these responses. Record every tick (key \"recording\" of the "
               "protocol), and simulate participants with \"--recordings all\".")
            .with(predictor_name(gathered.estimation)));
    return false;
  }
  if (gathered.recorded_participants < gathered.count.participants) {
    outcome.remarks.push_back(
        phrase("Analysis",
               "The predictor (%1) is computed from recordings, and these are stored for only %2 "
               "of %3 participants. \"--recordings all\" of \"asperity simulate\" stores those of "
               "all virtual participants.")
            .with(predictor_name(gathered.estimation),
                  std::to_string(gathered.recorded_participants),
                  std::to_string(gathered.count.participants)));
  }
  return true;
}

/// The predictor of every stimulus; empty, with a remark, where it is not above 0 for all of them.
std::map<std::string, double> predictor_of(const GatheredAnswers& gathered,
                                           const std::vector<std::string>& stimuli,
                                           AnalysisOutcome& outcome) {
  const std::string& name = gathered.estimation.predictor;
  if (name.empty()) return {};
  if (is_of_recordings(name) && !has_recordings(gathered, outcome)) return {};
  std::map<std::string, double> values = is_stated_predictor(gathered.estimation)
                                             ? stated_predictor(gathered, stimuli)
                                             : property_of_items(gathered, stimuli, name);
  std::string missing{};
  for (const std::string& stimulus : stimuli) {
    const auto value = values.find(stimulus);
    if (value != values.end() && value->second > 0.0) continue;
    missing += (missing.empty() ? "" : ", ") + stimulus;
  }
  if (missing.empty()) return values;
  outcome.remarks.push_back(phrase("Analysis",
                                   "There is no exponent, because the predictor is unknown or not "
                                   "above 0 for these stimuli: %1.")
                                .with(missing));
  return {};
}

/// Of levels and values: the declared unit, or that in which the name of the factor ends. Empty otherwise.
std::string unit_of_predictor(const EstimationDeclaration& estimation) {
  if (!is_stated_predictor(estimation)) return {};
  if (!estimation.predictor_unit.empty()) return estimation.predictor_unit;
  return estimation.predictor == kLevelPredictor ? unit_of_parameter(estimation.items)
                                                 : std::string();
}

/// "amplitude (m)"
Phrase predictor_with_unit(const EstimationDeclaration& estimation) {
  const std::string unit = unit_of_predictor(estimation);
  if (unit.empty()) return predictor_name(estimation);
  return name_of_stated_predictor(estimation) + " (" + unit + ')';
}

/// The name of a stimulus; of a level with a unit the quantity, "2.5 mm".
ResultCell stimulus_cell(const std::string& stimulus, const std::string& unit) {
  const std::optional<double> level = number_in(stimulus);
  if (unit.empty() || !level) return stimulus;
  return JoinedCell{{stimulus}, display_quantity(*level, unit)};
}

Phrase note_on_stimulus_means(const ComparedEstimates& compared) {
  const Phrase note =
      phrase("Analysis",
             "Geometric means of the estimates. %1 raw: not normalised. left out: number of "
             "participants without an estimate in some cell; only raw includes them.")
          .with(normalisation_note(compared.gathered.estimation, compared.estimates));
  const bool is_within =
      compared.gathered.estimation.normalisation() == EstimateNormalisation::geometric_mean;
  if (compared.gathered.people.size() < 2 || !is_within) return note;
  return phrase(
             "Analysis",
             "%1 The CI of the normalised mean is a within-participant CI (Cousineau and Morey): "
             "it "
             "serves to compare cells and does not include the differences between participants.")
      .with(note);
}

std::vector<Figure> figures_of_stimuli(const ResultTable&, const AnalysisOutcome& outcome) {
  const auto& questions = outcome.questions;
  const bool asks_for_difference =
      std::any_of(questions.begin(), questions.end(),
                  [](const AnsweredQuestion& one) { return one.name == "stimuli"; });
  const FoundNumbers found(outcome.findings, kStimulusEstimates);
  return {answering(
      asks_for_difference ? "stimuli" : "exponent",
      stimulus_estimates_figure(found, outcome.name_of_predictor, outcome.unit_of_predictor))};
}

void add_stimulus_means(const ComparedEstimates& compared, const FoundNumbers& found,
                        AnalysisOutcome& outcome) {
  using namespace columns;
  const EstimateCells cells = cells_of(compared.estimates);
  ResultTable means{kStimulusEstimates,
                    phrase("Analysis", "Estimates by stimulus and condition"),
                    {kCondition, kStimulus, kPredictor, kPersons, kLeftOut, kNormalisedEstimate,
                     interval_of(kNormalisedEstimate), kRawEstimate, kStimulusUnit, kPredictorUnit},
                    note_on_stimulus_means(compared)};
  means.figures = figures_of_stimuli;
  ResultTable persons{
      kEstimatesOfPersons,
      phrase("Analysis", "Estimates of each participant"),
      {kPerson, kCondition, kStimulus, kAnswers, kRawEstimate, kNormalisedEstimate, kStimulusUnit},
      phrase("Analysis",
             "Geometric means over repetitions. The estimates of participants with an empty cell "
             "are not normalised and are left out of curves and tests.")};
  const EstimationDeclaration& estimation = compared.gathered.estimation;
  const std::string unit_of_stimulus = unit_of_parameter(estimation.items);
  const std::string unit_of_values = is_stated_predictor(estimation)
                                         ? unit_of_predictor(estimation)
                                         : unit_of_parameter(estimation.predictor);
  const std::vector<AnsweringPerson>& people = compared.gathered.people;
  for (const std::string& condition : compared.conditions) {
    for (const std::string& stimulus : compared.stimuli) {
      std::vector<double> raw{};
      const FindingKey key{condition, stimulus};
      for (std::uint32_t person = 0; person < people.size(); ++person) {
        const auto cell = cells.find({person, condition, stimulus});
        if (cell == cells.end()) continue;
        raw.push_back(mean_logarithm(cell->second));
        persons.add({people[person].label, condition, stimulus_cell(stimulus, unit_of_stimulus),
                     count_cell(cell->second.size()), std::pow(10.0, raw.back()),
                     found.cell("norm.estimate", {people[person].label, key}),
                     word_cell(unit_of_stimulus)});
      }
      if (raw.empty()) continue;
      const Finding* mean = found.find("geomean", key);
      const std::size_t counted = mean == nullptr || !mean->value ? 0 : mean->n;
      const auto value = compared.predictor.find(stimulus);
      means.add({condition, stimulus_cell(stimulus, unit_of_stimulus),
                 value == compared.predictor.end() ? ResultCell{}
                                                   : quantity_cell(value->second, unit_of_values),
                 count_cell(raw.size()), count_cell(raw.size() - std::min(counted, raw.size())),
                 found.cell("geomean", key), found.interval("geomean", key),
                 std::pow(10.0, mean_logarithm(raw)), word_cell(unit_of_stimulus),
                 word_cell(unit_of_values)});
    }
  }
  means.drop_empty_columns(8);
  persons.drop_empty_columns(6);
  outcome.tables.push_back(std::move(means));
  outcome.tables.push_back(std::move(persons));
}

void add_exponents(const ComparedEstimates& compared, const FoundNumbers& found,
                   AnalysisOutcome& outcome) {
  using namespace columns;
  ResultTable exponents{
      kExponents,
      phrase("Analysis", "Exponents of the power functions"),
      {kCondition, kExponent, interval_of(kExponent), kP, kRSquared},
      phrase("Analysis",
             "Slopes of log estimate on the logarithm of the predictor (%1), by least squares per "
             "participant: mean over the participants with its t-based 95 % CI, and p of the t "
             "test against 0, uncorrected. R²: fit of the line to the means of the stimuli.")
          .with(predictor_with_unit(compared.gathered.estimation))};
  for (const std::string& condition : compared.conditions) {
    if (found.find("exponent.mean", condition) == nullptr) continue;
    if (const Finding* p = found.find("exponent.p", condition)) {
      outcome.tests_in_tables.insert(name_of(*p));
    }
    exponents.add({condition, found.cell("exponent.mean", condition),
                   found.interval("exponent.mean", condition), found.cell("exponent.p", condition),
                   found.cell("pooled.linear.r2", condition)});
  }
  if (!exponents.rows.empty()) outcome.tables.push_back(std::move(exponents));
}

/// One test per condition; named by the predictor where there is only one.
std::string about_condition(const ComparedEstimates& compared, const std::string& condition) {
  if (condition != kOnlyCondition) return condition;
  const EstimationDeclaration& estimation = compared.gathered.estimation;
  return is_stated_predictor(estimation) ? estimation.items : estimation.predictor;
}

void add_exponent_tests(const ComparedEstimates& compared, const FoundNumbers& found,
                        StudyTests& tests) {
  if (compared.predictor.empty()) return;
  for (const std::string& condition : compared.conditions) {
    const std::string about = about_condition(compared, condition);
    if (found.find("exponent.p", condition) != nullptr) {
      tests.add("exponent", about, found, "exponent.p", condition);
      tests.state_effect(found.find("exponent.mean", condition), "exponent");
    } else if (found.find("exponent.t", condition) != nullptr) {
      tests.add("exponent", about, found, "exponent.t", condition);
    } else {
      tests.add("exponent", about, found, "status");
    }
  }
}

/// The exponents of each condition that the groups share.
void add_exponents_to_groups(const ComparedEstimates& compared, const FoundNumbers& found,
                             GroupComparisons& groups) {
  if (compared.predictor.empty()) return;
  const GatheredAnswers& gathered = compared.gathered;
  const bool are_groups = gathered.estimation.condition == gathered.group_factor;
  std::map<std::string, GroupMeasure> measures{};
  for (const Estimated& one : compared.estimates) {
    const bool is_only = are_groups || one.condition == kOnlyCondition;
    measures[is_only ? "" : one.condition].values[one.person] =
        found.value("exponent.subject", {one.condition, gathered.people[one.person].label});
  }
  for (auto& [condition, measure] : measures) {
    measure.name = condition;
    measure.words =
        condition.empty()
            ? phrase("Analysis", "the mean exponent")
            : phrase("Analysis", "the mean exponent (%1)").with(words_of_condition(condition));
    groups.add(measure);
  }
}

/// Why a declared comparison of the exponents cannot be made, where there is no predictor.
void note_no_exponents(const ComparedEstimates& compared, StudyTests& tests) {
  if (compared.predictor.empty() && tests.is_in_family(kGroupsTest)) {
    tests.add_untested(kGroupsTest, "", "no_predictor");
  }
}

/// Both comparisons of the groups.
GroupComparisons groups_of(const ComparedEstimates& compared, const FoundNumbers& found) {
  GroupComparisons groups(compared.gathered);
  add_exponents_to_groups(compared, found, groups);
  groups.add(profile_of_estimates(compared));
  return groups;
}

void ask_exponents(const ComparedEstimates& compared, const FoundNumbers& found,
                   const StudyTests& tests, AnalysisOutcome& outcome) {
  constexpr int kDecimals = 2;
  Phrase answer{};
  const Finding* first = nullptr;
  for (const std::string& condition : compared.conditions) {
    const Finding* mean = found.find("exponent.mean", condition);
    if (mean == nullptr || !mean->value) continue;
    if (first == nullptr) first = mean;
    Phrase one = phrase("Analysis", "exponent %1").with(display_signed(*mean->value, kDecimals));
    if (mean->low && mean->high) {
      one = phrase("Analysis", "%1 (95 % CI [%2, %3])")
                .with(one, display_signed(*mean->low, kDecimals),
                      display_signed(*mean->high, kDecimals));
    }
    const StudyTests::Test* test = tests.find("exponent", about_condition(compared, condition));
    if (test != nullptr && test->p && test->statistic) {
      one = phrase("Analysis", "%1, %2, %3")
                .with(one, statistic_text("t", test->degrees, *test->statistic), p_text(*test));
    }
    if (condition != kOnlyCondition) one = phrase("Analysis", "%1: %2").with(condition, one);
    answer = answer.empty() ? one : phrase("Analysis", "%1; %2").with(answer, one);
  }
  if (answer.empty()) return;
  add_question(outcome, "exponent",
               phrase("Analysis", "How do the estimates grow with the predictor (%1)?")
                   .with(predictor_with_unit(compared.gathered.estimation)),
               phrase("Analysis", "Power function: %1.").with(answer),
               phrase("Analysis",
                      "The exponent is the slope of log estimate on the logarithm of the "
                      "predictor, by least squares per participant; mean and t-based CI over the "
                      "participants."),
               kExponents, first);
}

ComparedEstimates with_predictor(ComparedEstimates compared, AnalysisOutcome& outcome) {
  if (!compared.estimates.empty()) {
    compared.predictor = predictor_of(compared.gathered, compared.stimuli, outcome);
  }
  return compared;
}

std::vector<Finding> anova_of_stimuli(const ComparedEstimates& compared) {
  if (compared.stimuli.size() < 2) return {};
  return analysis_of(kAnova, "rmanova", anova_table(compared, "stimulus"));
}

std::vector<Finding> means_of_stimuli(const ComparedEstimates& compared) {
  return analysis_of(kStimulusEstimates, "magnitude",
                     items_table(compared.gathered, compared.estimates, compared.predictor));
}

}  // namespace

std::vector<StudyTest> test_stimulus_estimates(const GatheredAnswers& gathered) {
  StudyTests tests(gathered);
  AnalysisOutcome unused{};
  const ComparedEstimates compared = with_predictor(compared_estimates(gathered, unused), unused);
  if (compared.estimates.empty()) return std::move(tests).take_family();
  const std::vector<Finding> anova = anova_of_stimuli(compared);
  if (!anova.empty()) {
    add_effect_tests(FoundNumbers(anova), compared.conditions.size(), kEffectsOfStimuli, tests);
  }
  const bool compares_groups =
      tests.is_in_family(kGroupsTest) || tests.is_in_family(kGroupProfilesTest);
  if (tests.is_in_family("exponent") || compares_groups) {
    const std::vector<Finding> curves = means_of_stimuli(compared);
    const FoundNumbers found(curves);
    add_exponent_tests(compared, found, tests);
    if (compares_groups) groups_of(compared, found).add_tests(tests, unused);
    note_no_exponents(compared, tests);
  }
  return std::move(tests).take_family();
}

void analyze_stimulus_estimates(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  const ComparedEstimates compared = with_predictor(compared_estimates(gathered, outcome), outcome);
  if (compared.estimates.empty()) return;
  const std::vector<Finding> means = means_of_stimuli(compared);
  const FoundNumbers found(means);
  add_stimulus_means(compared, found, outcome);
  add_exponents(compared, found, outcome);
  if (!compared.predictor.empty()) {
    outcome.name_of_predictor = predictor_name(gathered.estimation);
    outcome.unit_of_predictor = unit_of_predictor(gathered.estimation);
  }
  StudyTests tests(gathered);
  const std::vector<Finding> anova = anova_of_stimuli(compared);
  const FoundNumbers found_anova(anova);
  if (!anova.empty()) {
    add_anova(found_anova, outcome, kEffectsOfStimuli);
    add_effect_tests(found_anova, compared.conditions.size(), kEffectsOfStimuli, tests);
  }
  add_exponent_tests(compared, found, tests);
  const GroupComparisons groups = groups_of(compared, found);
  groups.add_tests(tests, outcome);
  note_no_exponents(compared, tests);
  tests.finish(outcome);
  ask_exponents(compared, found, tests, outcome);
  ask_effect({"stimuli",
              phrase("Analysis", "Do the estimates depend on the stimulus?"),
              kStimulusEstimates,
              {},
              kEffectsOfStimuli},
             found_anova, tests, outcome);
  ask_effect({"condition",
              phrase("Analysis", "Do the estimates depend on the condition?"),
              kAnova,
              {},
              kEffectsOfStimuli},
             found_anova, tests, outcome);
  ask_effect({"stimuli_by_condition",
              phrase("Analysis", "Does the effect of the stimulus depend on the condition?"),
              kAnova,
              {},
              kEffectsOfStimuli},
             found_anova, tests, outcome);
  groups.report(tests, outcome);
  ask_reliability_of_estimates(compared, outcome);
  keep_findings(means, outcome);
  keep_findings(anova, outcome);
}

}  // namespace asperity

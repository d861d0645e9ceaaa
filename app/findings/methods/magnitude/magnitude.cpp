// Analyses magnitude estimation: perceived roughness by spacing and by the condition that is constant within a block.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/findings/gathering/answer_columns.h"
#include "app/findings/methods/magnitude/magnitude_analysis.h"
#include "app/findings/methods/magnitude/roughness_figure.h"
#include "app/findings/methods/magnitude/roughness_peaks.h"
#include "app/findings/methods/magnitude/stimulus_estimates.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/shared/estimates.h"
#include "app/findings/shared/group_comparisons.h"
#include "app/findings/shared/magnitude_effects.h"

namespace asperity {

namespace {

void add_estimates(const ComparedEstimates& compared, const FoundNumbers& found,
                   AnalysisOutcome& outcome) {
  const GatheredAnswers& gathered = compared.gathered;
  const EstimateCells cells = cells_of(compared.estimates);
  using namespace columns;
  ResultTable curves{
      kRoughness,
      phrase("Analysis", "Roughness by spacing and condition"),
      {kCondition, kSpacing, kPersons, kLeftOut, kNormalisedEstimate,
       interval_of(kNormalisedEstimate), kRawEstimate},
      phrase("Analysis",
             "Geometric means of the estimates. normalised: each participant's scale removed (the "
             "mean of the logarithms of all cells). raw: not normalised. left out: number of "
             "participants without an estimate in some cell; only raw includes them.")};
  curves.figures = [](const ResultTable&, const AnalysisOutcome& drawn) {
    const FoundNumbers numbers(drawn.findings, kRoughness);
    return std::vector{answering("spacing", roughness_figure(numbers, "m", CurveNames::alone))};
  };
  const bool is_within =
      gathered.estimation.normalisation() == EstimateNormalisation::geometric_mean;
  if (!is_within) {
    curves.note =
        phrase("Analysis",
               "Geometric means of the estimates. %1 raw: not normalised. left out: number of "
               "participants without an estimate in some cell; only raw includes them.")
            .with(normalisation_note(gathered.estimation, compared.estimates));
  }
  if (gathered.people.size() > 1 && is_within) {
    curves.note =
        phrase(
            "Analysis",
            "%1 The CI of the normalised mean is a within-participant CI (Cousineau and Morey): it "
            "serves to compare cells and does not include the differences between participants.")
            .with(curves.note);
  }
  ResultTable persons{
      kEstimatesOfPersons,
      phrase("Analysis", "Estimates of each participant"),
      {kPerson, kCondition, kSpacing, kAnswers, kRawEstimate, kNormalisedEstimate},
      phrase("Analysis",
             "Geometric means over repetitions. The estimates of participants with an empty cell "
             "are not normalised and are left out of curves and tests.")};
  for (const std::string& condition : compared.conditions) {
    for (const std::string& spacing : compared.stimuli) {
      std::vector<double> raw{};
      for (std::uint32_t person = 0; person < gathered.people.size(); ++person) {
        const auto cell = cells.find({person, condition, spacing});
        if (cell == cells.end()) continue;
        raw.push_back(mean_logarithm(cell->second));
        const std::string& label = gathered.people[person].label;
        persons.add({label, condition, *number_in(spacing), count_cell(cell->second.size()),
                     std::pow(10.0, raw.back()),
                     found.cell("norm.estimate", {label, condition, spacing})});
      }
      if (raw.empty()) continue;
      const FindingKey cell{condition, spacing};
      const Finding* mean = found.find("geomean", cell);
      const std::size_t counted = mean == nullptr || !mean->value ? 0 : mean->n;
      curves.add({condition, *number_in(spacing), count_cell(raw.size()),
                  count_cell(raw.size() - std::min(counted, raw.size())),
                  found.cell("geomean", cell), found.interval("geomean", cell),
                  std::pow(10.0, mean_logarithm(raw))});
    }
  }
  outcome.tables.push_back(std::move(curves));
  outcome.tables.push_back(std::move(persons));
}

std::vector<Finding> anova_of(const ComparedEstimates& compared) {
  return analysis_of(kAnova, "rmanova", anova_table(compared));
}

std::vector<Finding> curves_of(const ComparedEstimates& compared) {
  return analysis_of(kRoughness, "magnitude", curves_table(compared.gathered, compared.estimates));
}

/// One for every pair of conditions with curves, tested or not: the number of tests that are corrected together must not depend on
/// which of the curves have a maximum. `found`: of the family `magnitude`.
void add_peak_tests(const std::vector<std::string>& conditions, const FoundNumbers& found,
                    StudyTests& tests) {
  std::vector<std::string> with_curve{};
  std::copy_if(conditions.begin(), conditions.end(), std::back_inserter(with_curve),
               [&found](const std::string& condition) {
                 return found.find("invU.significant", condition) != nullptr;
               });
  for (std::size_t i = 0; i < with_curve.size(); ++i) {
    for (std::size_t j = i + 1; j < with_curve.size(); ++j) {
      const TestSubject pair{with_curve[i], with_curve[j]};
      if (has_interior_maximum(found, with_curve[i]) &&
          has_interior_maximum(found, with_curve[j])) {
        tests.add("peaks", pair, found, "peakratio.p", {pair.first, pair.second});
      } else {
        tests.add_untested("peaks", pair, kNotBothPeaks);
      }
    }
  }
}

}  // namespace

std::vector<StudyTest> test_magnitude(const GatheredAnswers& gathered) {
  if (!gathered.estimation.items.empty()) return test_stimulus_estimates(gathered);
  StudyTests tests(gathered);
  AnalysisOutcome unused{};
  const ComparedEstimates compared = compared_estimates(gathered, unused);
  if (compared.estimates.empty()) return std::move(tests).take_family();
  const std::vector<Finding> anova = anova_of(compared);
  add_effect_tests(FoundNumbers(anova), compared.conditions.size(), kEffects, tests);
  if (tests.is_in_family("peaks")) {
    const std::vector<Finding> curves = curves_of(compared);
    add_peak_tests(compared.conditions, FoundNumbers(curves), tests);
  }
  if (tests.is_in_family(kGroupProfilesTest)) {
    GroupComparisons groups(gathered);
    groups.add(profile_of_estimates(compared));
    groups.add_tests(tests, unused);
  }
  if (tests.is_in_family(kGroupsTest)) tests.add_untested(kGroupsTest, "", "no_predictor");
  return std::move(tests).take_family();
}

void analyze_magnitude(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  if (!gathered.estimation.items.empty()) {
    analyze_stimulus_estimates(gathered, outcome);
    return;
  }
  const ComparedEstimates compared = compared_estimates(gathered, outcome);
  if (compared.estimates.empty()) return;
  const std::vector<std::string>& conditions = compared.conditions;
  const std::vector<std::string>& spacings = compared.stimuli;
  const std::vector<Finding> roughness = curves_of(compared);
  const std::vector<Finding> anova = anova_of(compared);
  const FoundNumbers found(roughness);
  const FoundNumbers found_anova(anova);
  add_estimates(compared, found, outcome);
  add_peaks(conditions, spacings, found, outcome);
  add_anova(found_anova, outcome);
  if (const Finding* incomplete = found.find("subjects.incomplete");
      incomplete != nullptr && incomplete->word != "none") {
    std::string names{};
    for (const char sign : incomplete->word) names += sign == ';' ? ", " : std::string(1, sign);
    outcome.remarks.push_back(
        phrase("Analysis",
               "Participants with an empty cell, who are left out of curves and tests: %1.")
            .with(names));
  }
  if (const Finding* replicates = found_anova.find("replicates");
      replicates != nullptr && replicates->word == "unequal") {
    std::size_t least = 0;
    std::size_t greatest = 0;
    for (const Finding* cells : found_anova.all("cells.with.k")) {
      const auto k = static_cast<std::size_t>(number_in(cells->key.last()).value_or(0.0));
      least = least == 0 ? k : std::min(least, k);
      greatest = std::max(greatest, k);
    }
    outcome.remarks.push_back(phrase("Analysis",
                                     "The participants' cells contain %1 to %2 estimates; each "
                                     "cell is averaged first, so that all cells have equal weight.")
                                  .with(std::to_string(least), std::to_string(greatest)));
  }
  StudyTests tests(gathered);
  add_effect_tests(found_anova, conditions.size(), kEffects, tests);
  add_peak_tests(conditions, found, tests);
  GroupComparisons groups(gathered);
  groups.add(profile_of_estimates(compared));
  groups.add_tests(tests, outcome);
  if (tests.is_in_family(kGroupsTest)) tests.add_untested(kGroupsTest, "", "no_predictor");
  tests.finish(outcome);
  ask_effect({"spacing", phrase("Analysis", "Does roughness depend on the spacing?"), kRoughness,
              spacings},
             found_anova, tests, outcome);
  ask_effect({"condition", phrase("Analysis", "Does roughness depend on the condition?"), kAnova,
              conditions},
             found_anova, tests, outcome);
  ask_effect({"interaction",
              phrase("Analysis", "Does the curve over spacings depend on the condition?"),
              kAnova,
              {}},
             found_anova, tests, outcome);
  ask_peaks(conditions, spacings, found, outcome);
  ask_peak_ratios(found, tests, outcome);
  ask_types(conditions, found, outcome);
  groups.report(tests, outcome);
  ask_reliability_of_estimates(compared, outcome);
  keep_findings(roughness, outcome);
  keep_findings(anova, outcome);
}

}  // namespace asperity

// Simulates a study, analyses it as a stored one, and reduces its tests to their outcomes.

#include "app/power/simulated_run.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "app/findings/outcome/study_analysis.h"
#include "app/power/calibration.h"
#include "app/power/power_model.h"
#include "app/power/power_tables.h"
#include "app/power/simulated_study.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

/// The effect in its unit where the analysis states one, or otherwise the proportion or the effect size.
void add_effect(const StudyTest& test, SimulatedOutcome& outcome) {
  const bool is_proportion = !test.in_units && test.estimate && test.estimate->low;
  const std::optional<StudyTest::Effect>& effect = test.in_units   ? test.in_units
                                                   : is_proportion ? test.estimate
                                                                   : test.effect;
  if (!effect) return;
  outcome.estimate = effect->value;
  outcome.lower = effect->low;
  outcome.upper = effect->high;
  if (test.in_units) {
    outcome.measure = test.name_in_units;
  } else if (test.made_by != nullptr) {
    outcome.measure = is_proportion ? test.made_by->estimate_name : test.made_by->effect_symbol;
  }
}

std::vector<GatheredAnswers> answers_of_run(const PowerModel& model, int participants,
                                            std::uint64_t seed, std::int64_t run) {
  if (participants < 1) {
    throw std::invalid_argument("participants must be at least 1, not " +
                                std::to_string(participants));
  }
  if (run < 0) throw std::invalid_argument("run must be at least 0, not " + std::to_string(run));
  return simulated_study(model.tables(), participants, random_of_study(seed, run));
}

SimulatedOutcome outcome_of_test(const std::string& family, const StudyTest& test) {
  SimulatedOutcome outcome{
      .family = family,
      .test = test.about.empty() ? test.name : test.name + ' ' + test.about.text(),
      .method = std::string(test.made_by ? test.made_by->code : ""),
      .p = test.p,
      .corrected_p = test.adjusted};
  if (!test.p) outcome.status = test.status;
  add_effect(test, outcome);
  return outcome;
}

/// The names of its tests, each once. Sorted: an analysis adds a test that cannot be made at the end, and a family has the same name in
/// all studies.
std::string name_of_family(const std::vector<StudyTest>& tests) {
  std::set<std::string> names{};
  for (const StudyTest& test : tests) names.insert(test.name);
  return comma_separated(names);
}

void add_outcomes(const std::vector<StudyTest>& tests, std::vector<SimulatedOutcome>& outcomes) {
  if (tests.empty()) return;
  SimulatedOutcome of_family{.family = name_of_family(tests)};
  for (const StudyTest& test : tests) {
    const SimulatedOutcome& own = outcomes.emplace_back(outcome_of_test(of_family.family, test));
    if (!own.corrected_p) continue;
    of_family.corrected_p =
        std::min(of_family.corrected_p.value_or(*own.corrected_p), *own.corrected_p);
  }
  if (!of_family.corrected_p) of_family.status = tests.front().status;
  outcomes.push_back(std::move(of_family));
}

}  // namespace

std::vector<SimulatedOutcome> outcomes_of(std::span<const GatheredAnswers> of_study) {
  std::vector<SimulatedOutcome> outcomes{};
  for (const GatheredAnswers& gathered : of_study) {
    const StudyAnalysis* const analysis = find_analysis(gathered.kind);
    if (gathered.answers.empty() || analysis == nullptr || analysis->test_family == nullptr)
      continue;
    add_outcomes(analysis->test_family(gathered), outcomes);
  }
  return outcomes;
}

Random random_of_study(std::uint64_t seed, std::int64_t run) {
  return Random(seed).split("simulated study").split(static_cast<std::uint64_t>(run));
}

std::vector<SimulatedOutcome> simulate_and_analyse(const PowerModel& model, int participants,
                                                   std::uint64_t seed, std::int64_t run) {
  return outcomes_of(answers_of_run(model, participants, seed, run));
}

SimulatedStudyResults simulate_and_recover(const PowerModel& model, int participants,
                                           std::uint64_t seed, std::int64_t run) {
  const std::vector<GatheredAnswers> of_study = answers_of_run(model, participants, seed, run);
  SimulatedStudyResults results{.outcomes = outcomes_of(of_study)};
  std::vector<Assumption> without_sources = model.assumptions();
  for (Assumption& one : without_sources) one.source.clear();
  for (const Assumption& shown :
       calibrated(std::move(without_sources), model.protocol(), of_study, "simulated study")) {
    const bool is_recovered = !shown.source.empty() && shown.part == Assumption::Part::other &&
                              !shown.name.ends_with("_sd");
    if (is_recovered) results.recovered.push_back({.name = shown.name, .value = *shown.value});
  }
  return results;
}

}  // namespace asperity

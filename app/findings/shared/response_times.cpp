// Calls the family `response_times` with the factors that have at least two levels.

#include "app/findings/shared/response_times.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "app/findings/gathering/answer_columns.h"
#include "app/findings/gathering/trial_factors.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/shared/figures/response_time_figures.h"

namespace asperity {

namespace {

/// An empty text: no level.
using LevelOf = std::function<std::string(const GatheredAnswer&)>;

TrialFactor factor_of_answers(const std::string& name, const GatheredAnswers& gathered,
                              const std::vector<std::string>& declared, const LevelOf& level_of) {
  std::vector<std::string> by_answer{};
  by_answer.reserve(gathered.answers.size());
  for (const GatheredAnswer& answer : gathered.answers) by_answer.push_back(level_of(answer));
  return trial_factor(name, by_answer, declared);
}

/// The texture of the surfaces of a trial, where they all have the same one.
std::string common_texture(const GatheredAnswers& gathered, const GatheredAnswer& answer) {
  const auto surfaces = gathered.surfaces_of(answer);
  const bool is_common =
      !surfaces.empty() &&
      std::all_of(surfaces.begin(), surfaces.end(), [&surfaces](const FeltSurface& surface) {
        return surface.texture == surfaces.front().texture;
      });
  return is_common ? gathered.word(surfaces.front().texture) : std::string();
}

/// The factors with at least two levels.
std::vector<TrialFactor> factors_of(const GatheredAnswers& gathered) {
  const auto level_of = [&gathered](std::string_view factor) {
    return [&gathered, factor](const GatheredAnswer& answer) {
      return gathered.word(gathered.level(answer, factor));
    };
  };
  std::vector<TrialFactor> factors{};
  if (gathered.has_estimates()) {
    factors.push_back(factor_of_answers("condition", gathered, gathered.estimation.conditions,
                                        level_of(gathered.estimation.condition)));
    factors.push_back(
        factor_of_answers("spacing_m", gathered, {}, [&gathered](const GatheredAnswer& answer) {
          const std::optional<double> spacing_m = gathered.spacing_m(answer);
          return spacing_m ? number_text(*spacing_m) : std::string();
        }));
  } else {
    factors.push_back(
        factor_of_answers(std::string(kColumnFactor), gathered, {}, level_of(kColumnFactor)));
    factors.push_back(factor_of_answers(
        "texture", gathered, gathered.pictures,
        [&gathered](const GatheredAnswer& answer) { return common_texture(gathered, answer); }));
  }
  std::erase_if(factors, [](const TrialFactor& one) { return one.levels.names.size() < 2; });
  return factors;
}

/// The table for the family `response_times`.
TidyInput response_times_table(const GatheredAnswers& gathered, std::vector<TrialFactor> factors) {
  std::vector<TidyTable::Column> columns{{"subject", column_of_people(gathered)},
                                         {"time_s", column_of_times(gathered)}};
  std::vector<std::pair<std::string, std::vector<std::string>>> levels{};
  for (TrialFactor& factor : factors) {
    levels.emplace_back(factor.name, factor.levels.names);
    columns.push_back({factor.name, std::move(factor.levels)});
  }
  TidyInput input{};
  input.options.set("factors", levels);
  input.tables.emplace_back(std::move(columns), "the response times");
  return input;
}

Phrase note_on_times(const ResultTable& times, std::size_t untimed, std::size_t trials) {
  Phrase note = phrase(
      "Analysis",
      "Response times are measured from the cue (the first question after the last surface) to the "
      "response and include repeated presentations. Geometric means over "
      "participants of each participant's geometric mean.");
  if (times.has_values(interval_of(columns::kTime))) {
    note = phrase("Analysis",
                  "%1 95 % CI: t-based over participants, on the logarithmic scale; in simulations "
                  "with 2 to 20 participants, its coverage was at least 92 %.")
               .with(note);
  }
  if (untimed == 0) return note;
  return phrase("Analysis", "%1 Trials without a response time, which are left out: %2 of %3.")
      .with(note, std::to_string(untimed), std::to_string(trials));
}

}  // namespace

void add_response_times(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  std::vector<TrialFactor> factors = factors_of(gathered);
  std::vector<std::pair<std::string, std::string>> rows{{"all", ""}};
  for (const TrialFactor& factor : factors) {
    for (const std::string& level : factor.levels.names) rows.emplace_back(factor.name, level);
  }
  const std::vector<Finding> findings = analysis_of(
      kResponseTimes, kResponseTimes, response_times_table(gathered, std::move(factors)));
  const FoundNumbers found(findings);
  if (found.find("geomean") == nullptr) {
    outcome.remarks.push_back(
        phrase("Analysis", "No trial has a stored response time; collect responses first."));
    return;
  }
  keep_findings(findings, outcome);
  using namespace columns;
  ResultTable made{kResponseTimes,
                   phrase("Analysis", "Response times by condition"),
                   {kFactor, kFactorLevel, kPersons, kTrials, kTime, interval_of(kTime)},
                   {}};
  for (const auto& [factor, level] : rows) {
    const FindingKey key = level.empty() ? std::string() : factor + '=' + level;
    const Finding* trials = found.find("responses", key);
    if (trials == nullptr) continue;
    made.add({factor, word_cell(level), count_cell(trials->n),
              count_cell(static_cast<std::size_t>(*trials->value)), found.cell("geomean", key),
              found.interval("geomean", key)});
  }
  made.figures = [](const ResultTable&, const AnalysisOutcome& drawn) {
    return std::vector{response_times_figure(FoundNumbers(drawn.findings, kResponseTimes))};
  };
  made.note = note_on_times(made, static_cast<std::size_t>(found.value("n.untimed").value_or(0.0)),
                            gathered.answers.size());
  outcome.tables.push_back(std::move(made));
}

}  // namespace asperity

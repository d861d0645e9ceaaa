// Takes the means of the participants, and their effects, from the findings on exploration and response times.

#include "app/report/text/report_exploration.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/drawn_table.h"
#include "app/findings/shared/exploration_model.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

/// "F(1, 64.02) = 4.20, p = .044"; empty in the row of a level.
std::string test_of(const RowReader& effect) {
  const auto* const statistic = std::get_if<JoinedCell>(&effect.cell(kExplorationStatistic));
  const auto p = effect.number(columns::kP);
  if (statistic == nullptr || statistic->shown.empty() || !p) return {};
  return statistic->shown.english() + ", " + display_p(*p);
}

const ResultTable* fitted_models(const AnalysisOutcome& outcome) {
  const ResultTable* const found = table_named(outcome, kExplorationModel);
  return found == nullptr || !found->has_values(kExplorationStatistic) ? nullptr : found;
}

/// "per 10 trials of a block" of a place in the session; empty for a condition.
std::string per_place(const std::string& factor) {
  if (factor == "trial_place") return "per 10 trials of a block";
  if (factor == "block_place") return "from block to block";
  return factor == "session_place" ? "from session to session" : "";
}

/// "contact time" of "contact time, s".
std::string without_unit(const std::string& measure) {
  const std::string words = words_of_measure(measure).english();
  return words.substr(0, words.find(','));
}

}  // namespace

std::string exploration_method(const AnalysisOutcome& outcome, Sources& sources) {
  if (fitted_models(outcome) == nullptr) return {};
  return "Contact times and response times (natural logarithms) were analysed by linear mixed "
         "models" +
         cited("Laird 1982", sources) +
         " with random intercepts of participants, fitted by restricted maximum likelihood; "
         "degrees "
         "of freedom are Satterthwaite’s" +
         cited("Satterthwaite 1946", sources) +
         ", and the tests are exploratory. They assume the same effects for all participants and "
         "are "
         "liberal otherwise (Type I error rates of up to 25 and 54 % at α = .05 in simulations of "
         "ratings "
         "whose effects varied with SDs of half and one residual SD).";
}

std::string exploration_results(const AnalysisOutcome& outcome) {
  const ResultTable* const models = fitted_models(outcome);
  if (models == nullptr) return {};
  std::vector<std::string> sentences{};
  for (const ResultRow& row : models->rows) {
    const RowReader effect(*models, row);
    const std::string test = test_of(effect);
    if (test.empty()) continue;
    const std::string time = capitalised(without_unit(effect.text(columns::kMeasure)));
    const std::string factor = effect.text(columns::kFactor);
    const std::string per = per_place(factor);
    if (per.empty()) {
      sentences.push_back(time + " by " + words_of_factor(factor).english() + ": " + test + '.');
      continue;
    }
    const auto digits = [](const std::optional<double>& number) {
      return display_signed(number.value_or(1.0), 2);
    };
    const Interval interval = effect.interval(columns::kRatio);
    sentences.push_back(time + " changed by a factor of " + digits(effect.number(columns::kRatio)) +
                        ' ' + per + ", 95 % CI [" + digits(interval.low) + ", " +
                        digits(interval.high) + "], " + test + '.');
  }
  return with_sentences(sentences);
}

}  // namespace asperity

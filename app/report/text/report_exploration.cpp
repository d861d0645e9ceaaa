#include "app/report/text/report_exploration.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/reading_number.h"
#include "app/findings/outcome/reading_table.h"
#include "app/findings/outcome/test_sentences.h"
#include "app/findings/shared/exploration_model.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

/// A row of the table of models, by column.
class ModelledEffect final {
 public:
  ModelledEffect(const Table& table, const std::vector<Cell>& row) : table_(table), row_(row) {}

  std::string text(const char* column) const {
    const auto at = column_of(table_, column);
    const auto* const text = at ? std::get_if<std::string>(&row_[*at]) : nullptr;
    return text == nullptr ? std::string() : *text;
  }
  std::optional<double> number(const char* column) const {
    const auto at = column_of(table_, column);
    return at ? number_of(row_[*at]) : std::nullopt;
  }
  /// "F(1, 64.02) = 4.20, p = .044"; empty in the row of a level.
  std::string test() const {
    const auto F = number("F");
    const auto df1 = number("df1");
    const auto df2 = number("df2");
    const auto p = number("p");
    if (!F || !df1 || !df2 || !p) return {};
    return statistic_text("F", std::array{*df1, *df2}, *F) + ", " + reading_p(*p);
  }

 private:
  const Table& table_;
  const std::vector<Cell>& row_;
};

const NamedTable* fitted_models(const AnalysisOutcome& outcome) {
  const auto found =
      std::find_if(outcome.tables.begin(), outcome.tables.end(),
                   [](const NamedTable& table) { return table.name == kExplorationModel; });
  return found == outcome.tables.end() || !has_cells(found->table, "F") ? nullptr : &*found;
}

/// "per 10 trials of a block" of a place in the session; empty for a condition.
std::string per_place(const std::string& factor) {
  if (factor == "trial_place") return "per 10 trials of a block";
  if (factor == "block_place") return "from block to block";
  return factor == "session_place" ? "from session to session" : "";
}

/// "contact time" of "contact time, s".
std::string without_unit(const std::string& measure) {
  const std::string words = words_of_cell("measure", measure).english();
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
  const NamedTable* const models = fitted_models(outcome);
  if (models == nullptr) return {};
  std::vector<std::string> sentences{};
  for (const std::vector<Cell>& row : models->table.rows) {
    const ModelledEffect effect(models->table, row);
    const std::string test = effect.test();
    if (test.empty()) continue;
    const std::string time = capitalised(without_unit(effect.text("measure")));
    const std::string per = per_place(effect.text("factor"));
    if (per.empty()) {
      sentences.push_back(time + " by " + words_of_cell("factor", effect.text("factor")).english() +
                          ": " + test + '.');
      continue;
    }
    const auto digits = [&effect](const char* column) {
      return reading_signed(effect.number(column).value_or(1.0), 2);
    };
    sentences.push_back(time + " changed by a factor of " + digits("ratio") + ' ' + per +
                        ", 95 % CI [" + digits("ratio_low") + ", " + digits("ratio_high") + "], " +
                        test + '.');
  }
  return with_sentences(sentences);
}

}  // namespace asperity

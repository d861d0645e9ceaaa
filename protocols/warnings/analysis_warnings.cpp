// Checks tests, guesses, confidence, exclusion and items of each block against its trials.

#include "protocols/warnings/analysis_warnings.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <variant>

#include "analysis/dissimilarity/multidimensional_scaling.h"
#include "analysis/numbers/number_text.h"
#include "protocols/design/block_factors.h"
#include "protocols/design/json_pointer.h"
#include "protocols/design/question_place.h"
#include "protocols/design/wording.h"
#include "protocols/file/json_document.h"
#include "protocols/kinds/estimation.h"
#include "protocols/kinds/experiment_kind.h"
#include "protocols/kinds/kind_list.h"
#include "protocols/kinds/similarity.h"
#include "protocols/plan/level_tracks.h"
#include "protocols/plan/plan.h"
#include "protocols/plan/roughness_matching.h"
#include "protocols/procedures/procedure.h"

namespace asperity {

namespace {

using Block = Protocol::Block;

/// Of a binomial number of errors.
double probability_of_at_most(double errors, std::size_t trials, double of_error) {
  const auto n = static_cast<double>(trials);
  double sum = 0.0;
  for (double i = 0.0; i <= std::min(errors, n); ++i) {
    sum += std::exp(std::lgamma(n + 1.0) - std::lgamma(i + 1.0) - std::lgamma(n - i + 1.0) +
                    i * std::log(of_error) + (n - i) * std::log1p(-of_error));
  }
  return std::min(sum, 1.0);
}

class AnalysisWarnings final {
 public:
  AnalysisWarnings(const Protocol& protocol, const std::string& file_name)
      : protocol_(protocol), document_(protocol.source, file_name) {
    for (const auto& [name, block] : protocol.blocks) {
      if (block.phase != Phase::main || matches_roughness(protocol, block)) continue;
      if (block.kind == discrimination_kind().id) discriminations_.push_back(&block);
      if (block.kind == similarity_kind().id) similarities_.insert(name);
      if (block.kind == rating_kind().id) ratings_.insert(name);
    }
  }

  std::vector<Diagnostic> all() {
    if (!discriminations_.empty() || !similarities_.empty() || !ratings_.empty()) {
      trials_ = possible_trials(protocol_);
      std::erase_if(trials_, [](const Trial& trial) { return trial.anchor.has_value(); });
    }
    warn_of_tests();
    for (const Block* const block : discriminations_) {
      warn_of_guesses(*block);
      warn_of_confidence(*block);
      warn_of_unused_option(*block);
    }
    warn_of_exclusion();
    warn_of_items();
    warn_of_one_rated_surface();
    warn_of_predictor_without_recordings();
    return std::move(found_);
  }

 private:
  void warn(const std::string& pointer, Phrase message) {
    found_.push_back(document_.at(pointer, std::move(message)));
  }

  /// Tests that the analysis of discriminations leaves out with a status.
  void warn_of_tests() {
    const std::vector<std::string>& family = protocol_.analysis.family;
    for (std::size_t i = 0; i < family.size(); ++i) {
      if (find_test(discrimination_kind(), family[i]) == nullptr || discriminations_.empty())
        continue;
      const std::optional<Phrase> reason = reason_against(family[i]);
      if (!reason) continue;
      warn(pointer_to("/analysis/family", i),
           phrase("Protocols", "the test %1 is not possible: %2; remove it")
               .with(in_quotes(family[i]), *reason));
    }
  }

  std::optional<Phrase> reason_against(const std::string& test) const {
    const auto all_are = [this](auto&& trait) {
      return std::all_of(discriminations_.begin(), discriminations_.end(), trait);
    };
    if (test == "order" &&
        all_are([](const Block* block) { return block->design()->has_noise(); })) {
      return phrase("Protocols", "the responses are words, and no surface is chosen");
    }
    if (test == "point_of_subjective_equality" && all_are(has_correct_responses)) {
      return phrase("Protocols", "it requires the judgement %1").with(word_name("comparison"));
    }
    if (test == "conditions" && discriminations_.size() == 1 &&
        conditions_of(*discriminations_.front()) == 1) {
      return phrase("Protocols",
                    "the thresholds of all trials are those of one condition, because no other "
                    "factor than the varied parameter has several levels");
    }
    return {};
  }

  static bool has_correct_responses(const Block* block) {
    const Protocol::TrialQuestionTemplate* const judged = judged_question(*block);
    return judged != nullptr && judged->judgement() == DiscriminationJudgement::performance;
  }

  /// The combinations of the levels of factors other than the varied one and those that are drawn for every trial.
  std::size_t conditions_of(const Block& block) const {
    std::set<std::map<std::string, std::string>> conditions{};
    for (const Trial& trial : trials_) {
      if (trial.block != block.name) continue;
      std::map<std::string, std::string> levels{};
      for (const auto& [factor, level] : trial.factors) {
        const bool is_drawn =
            std::find(block.drawn.begin(), block.drawn.end(), factor) != block.drawn.end();
        if (is_drawn || (block.vary && factor == block.vary->factor)) continue;
        levels[factor] = text_of(level);
      }
      conditions.insert(std::move(levels));
    }
    return conditions.size();
  }

  /// A participant who guesses attains the proportion at which such a staircase settles, so that its levels fall without limit.
  void warn_of_guesses(const Block& block) {
    if (!block.procedure || block.procedure->tracks.empty() || !has_correct_responses(&block) ||
        block.design()->has_noise()) {
      return;
    }
    const ProcedureSettings& first = block.procedure->tracks.front();
    if (!problems_of(first).empty()) return;
    const std::optional<double> target = procedure_of(first).target(first);
    const double chance = block.design()->guess_rate();
    if (!target || *target > chance + 0.01) return;
    const auto percent = [](double share) { return digits(std::round(1000.0 * share) / 10.0); };
    warn(pointer_to("/blocks", block.name) + "/procedure/method",
         phrase("Protocols",
                "the levels converge on %1 % correct responses, but guesses are correct in %2 %, "
                "so that no level is reached; require more correct responses for a lower level "
                "(%3: 2 or 3), or state a higher %4")
             .with(percent(*target), percent(chance), key_name("down"), key_name("target")));
  }

  /// A scale after a choice is usually meant to rate the confidence in it.
  void warn_of_confidence(const Block& block) {
    const Protocol::TrialQuestionTemplate* const judged = judged_question(block);
    const auto& questions = block.questions;
    const bool has_confidence =
        std::any_of(questions.begin(), questions.end(),
                    [](const auto& each) { return !each.confidence_of().empty(); });
    const bool can_have_roc = judged != nullptr && has_correct_responses(&block) &&
                              !judged->allow_cannot_tell && !block.design()->is_choice_of_three() &&
                              !chooses_levels_from_answers(block);
    if (has_confidence || !can_have_roc) return;
    for (std::size_t i = 0; i < questions.size(); ++i) {
      const auto* const scale = std::get_if<ScaleForm>(&questions[i].form);
      if (scale == nullptr || scale->points == 0) continue;
      warn(place_of_question(block, i),
           phrase("Protocols",
                  "this scale does not state whether it rates the confidence in a response: there "
                  "is no ROC, and virtual participants rate the first surface. If it does, add "
                  "%1: %2")
               .with(key_name("confidence_of"), in_quotes(judged->name)));
    }
  }

  void warn_of_unused_option(const Block& block) {
    const Protocol::TrialQuestionTemplate* const judged = judged_question(block);
    const ObserverDeclaration& observer = protocol_.observer;
    if (judged == nullptr || !judged->allow_cannot_tell || observer.discrimination.unsure_within ||
        observer.deaf) {
      return;
    }
    const auto index = static_cast<std::size_t>(judged - block.questions.data());
    warn(place_of_question(block, index) + "/allow_cannot_tell",
         phrase("Protocols",
                "virtual participants never give the response \"cannot tell\"; state %1 under %2, "
                "the relative difference below which they do")
             .with(key_name("unsure_within"), key_name("observer")));
  }

  /// The catch trials of a session, at most, and the probability that a guess is correct in them.
  struct CatchTrialsOfSession {
    std::size_t trials = 0;
    double guess_rate = 0.0;  ///< the highest of all blocks
  };
  CatchTrialsOfSession catch_trials() const {
    CatchTrialsOfSession all{};
    for (const Block* const block : discriminations_) {
      if (!block->procedure || !block->procedure->catch_trials) continue;
      Block without = *block;
      without.procedure->catch_trials.reset();
      const std::size_t of_run =
          most_trials_of(protocol_, *block) - most_trials_of(protocol_, without);
      for (const Protocol::Run* const run : runs_of(protocol_, *block)) {
        all.trials +=
            of_run *
            (run->for_each.empty() ? 1 : protocol_.factors.at(run->for_each).levels.size());
      }
      // Of two standards, "cannot tell" is the correct one of all options.
      const bool is_easy = block->procedure->catch_trials->type == CatchType::easy;
      all.guess_rate = std::max(
          all.guess_rate, is_easy ? block->design()->guess_rate()
                                  : 1.0 / static_cast<double>(block->design()->alternatives() + 1));
    }
    return all;
  }

  void warn_of_exclusion() {
    const auto& rule = protocol_.analysis.exclude;
    const CatchTrialsOfSession caught = catch_trials();
    if (!rule || caught.trials == 0) return;
    constexpr double kErrorsOfAttentive = 0.05;
    constexpr double kSmall = 0.05;
    const auto trials = static_cast<double>(caught.trials);
    const double most_errors =
        rule->more_errors_than
            ? static_cast<double>(*rule->more_errors_than)
            : std::floor(rule->error_rate_above.value_or(0.0) * trials * (1.0 + 1e-9));
    const double guesser_stays =
        probability_of_at_most(most_errors, caught.trials, 1.0 - caught.guess_rate);
    const double attentive_leaves =
        1.0 - probability_of_at_most(most_errors, caught.trials, kErrorsOfAttentive);
    if (guesser_stays <= kSmall && attentive_leaves <= kSmall) return;
    const auto percent = [](double probability) {
      const double in_percent = 100.0 * probability;
      return in_percent < 0.1 ? phrase("Protocols", "less than %1 %").with(digits(0.1))
                              : phrase("Protocols", "%1 %").with(fixed(in_percent, 1));
    };
    warn("/analysis/exclude",
         (caught.trials == 1
              ? phrase("Protocols",
                       "a session has at most %1 catch trial: a participant who guesses in all of "
                       "them stays in the analysis with a probability of %2, and an attentive "
                       "participant with errors in 5 % of them is excluded with a probability of "
                       "%3; state another limit, or more catch trials (a smaller %4)")
              : phrase("Protocols",
                       "a session has at most %1 catch trials: a participant who guesses in all of "
                       "them stays in the analysis with a probability of %2, and an attentive "
                       "participant with errors in 5 % of them is excluded with a probability of "
                       "%3; state another limit, or more catch trials (a smaller %4)"))
             .with(std::to_string(caught.trials), percent(guesser_stays), percent(attentive_leaves),
                   key_name("every")));
  }

  void warn_of_items() {
    constexpr int kDimensionsOfMap = 2;
    std::set<std::string> items{};
    std::string block{};
    for (const Trial& trial : trials_) {
      if (!similarities_.contains(trial.block)) continue;
      block = trial.block;
      for (const PlannedPresentation& surface : trial.presentations) {
        items.insert(surface.item);
      }
    }
    const auto least = static_cast<std::size_t>(items_for(kDimensionsOfMap));
    if (items.empty() || items.size() >= least) return;
    warn(pointer_to("/blocks", block),
         phrase("Protocols",
                "a configuration in %1 dimensions requires at least %2 surfaces, and this protocol "
                "compares %3; add surfaces, or interpret only the dissimilarities and the "
                "dendrogram")
             .with(std::to_string(kDimensionsOfMap), std::to_string(least),
                   std::to_string(items.size())));
  }

  void warn_of_one_rated_surface() {
    std::set<std::pair<std::string, std::string>> surfaces{};
    std::string block{};
    for (const Trial& trial : trials_) {
      if (!ratings_.contains(trial.block)) continue;
      block = trial.block;
      const PlannedPresentation& rated = trial.presentations.front();
      surfaces.emplace(rated.item, rated.stimulus.name);
    }
    if (surfaces.size() != 1) return;
    warn(pointer_to("/blocks", block),
         phrase("Protocols",
                "every trial presents the same surface, so that no ratings can be compared; cross "
                "or list a factor with the textures, models or parameters to be rated"));
  }

  void warn_of_predictor_without_recordings() {
    const auto& estimation = protocol_.estimation;
    if (!estimation || !is_of_recordings(estimation->predictor) || protocol_.record) return;
    warn("/recording/every_tick",
         phrase("Protocols",
                "the predictor %1 is computed from the recordings, so that there would be no "
                "exponent; set this to true")
             .with(in_quotes(estimation->predictor)));
  }

  const Protocol& protocol_;
  JsonDocument document_;
  std::vector<const Block*> discriminations_{};  ///< main blocks whose responses are analysed
  std::set<std::string, std::less<>> similarities_{};
  std::set<std::string, std::less<>> ratings_{};
  std::vector<Trial> trials_{};  ///< that are analysed: without anchors
  std::vector<Diagnostic> found_{};
};

}  // namespace

std::vector<Diagnostic> warnings_about_analysis(const Protocol& protocol,
                                                const std::string& file_name) {
  return AnalysisWarnings(protocol, file_name).all();
}

}  // namespace asperity

#include "protocols/file/analysis_warnings.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "analysis/multidimensional_scaling.h"
#include "analysis/number_text.h"
#include "protocols/design/json_pointer.h"
#include "protocols/design/wording.h"
#include "protocols/file/json_document.h"
#include "protocols/kinds/discrimination.h"
#include "protocols/kinds/estimation.h"
#include "protocols/kinds/rating.h"
#include "protocols/kinds/similarity.h"
#include "protocols/plan/plan.h"
#include "protocols/plan/roughness_matching.h"
#include "protocols/procedures/procedure.h"

namespace asperity {

namespace {

using Block = Protocol::Block;

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
    }
    warn_of_tests();
    for (const Block* const block : discriminations_) warn_of_guesses(*block);
    warn_of_items();
    warn_of_one_rated_surface();
    warn_of_predictor_without_recordings();
    return std::move(found_);
  }

 private:
  void warn(const std::string& pointer, std::string message) {
    found_.push_back(document_.at(pointer, std::move(message)));
  }

  /// Tests that the analysis of discriminations leaves out with a status.
  void warn_of_tests() {
    const std::vector<std::string>& family = protocol_.analysis.family;
    for (std::size_t i = 0; i < family.size(); ++i) {
      if (find_test(discrimination_kind(), family[i]) == nullptr || discriminations_.empty())
        continue;
      const std::optional<std::string> reason = reason_against(family[i]);
      if (!reason) continue;
      warn(pointer_to("/analysis/family", i),
           "the test " + in_quotes(family[i]) + " is not possible: " + *reason + "; remove it");
    }
  }

  std::optional<std::string> reason_against(const std::string& test) const {
    const auto all_are = [this](auto&& trait) {
      return std::all_of(discriminations_.begin(), discriminations_.end(), trait);
    };
    if (test == "order" && all_are([](const Block* block) { return block->design->has_noise(); })) {
      return "the responses are words, and no surface is chosen";
    }
    if (test == "point_of_subjective_equality" && all_are(has_correct_responses)) {
      return "it requires the judgement \"comparison\"";
    }
    if (test == "conditions" && discriminations_.size() == 1 &&
        conditions_of(*discriminations_.front()) == 1) {
      return "the thresholds of all trials are those of one condition, because no other factor "
             "than the varied parameter has several levels";
    }
    return {};
  }

  static bool has_correct_responses(const Block* block) {
    const Protocol::TrialQuestionTemplate* const judged = judged_question(*block);
    return judged != nullptr && judged->judgement == DiscriminationJudgement::performance;
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
        block.design->has_noise()) {
      return;
    }
    const ProcedureSettings& first = block.procedure->tracks.front();
    if (!problems_of(first).empty()) return;
    const std::optional<double> target = procedure_of(first).target(first);
    const double chance = block.design->guess_rate();
    if (!target || *target > chance + 0.01) return;
    const auto percent = [](double share) {
      return digits(std::round(1000.0 * share) / 10.0) + " %";
    };
    warn(pointer_to("/blocks", block.name) + "/procedure/method",
         "the levels converge on " + percent(*target) +
             " correct responses, but guesses are correct in " + percent(chance) +
             ", so that no level is reached; require more correct responses for a lower level "
             "(\"down\": 2 or 3), or state a higher \"target\"");
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
         "a configuration in " + std::to_string(kDimensionsOfMap) +
             " dimensions requires at least " + std::to_string(least) +
             " surfaces, and this protocol compares " + std::to_string(items.size()) +
             "; add surfaces, or interpret only the dissimilarities and the dendrogram");
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
         "every trial presents the same surface, so that no ratings can be compared; cross or list "
         "a factor with the textures, models or parameters to be rated");
  }

  void warn_of_predictor_without_recordings() {
    const auto& estimation = protocol_.estimation;
    if (!estimation || !is_of_recordings(estimation->predictor) || protocol_.record) return;
    warn("/recording/every_tick",
         "the predictor " + in_quotes(estimation->predictor) +
             " is computed from the recordings, so that there would be no exponent; set this to "
             "true");
  }

  const Protocol& protocol_;
  JsonDocument document_;
  std::vector<const Block*> discriminations_{};  ///< main blocks whose responses are analysed
  std::set<std::string, std::less<>> similarities_{};
  std::set<std::string, std::less<>> ratings_{};
  std::vector<Trial> trials_{};
  std::vector<Diagnostic> found_{};
};

}  // namespace

std::vector<Diagnostic> warnings_about_analysis(const Protocol& protocol,
                                                const std::string& file_name) {
  return AnalysisWarnings(protocol, file_name).all();
}

}  // namespace asperity

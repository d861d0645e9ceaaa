// Finds means among the findings by analysis and quantity, and lists them with their intervals and N.

#include "app/findings/outcome/estimate_sentences.h"

#include <algorithm>

#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/study_analysis.h"
#include "app/findings/outcome/test_sentences.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

/// "83 % (95 % CI [49 %, 96 %]) for height_map"
std::string one_estimate(const Finding& estimate, const std::string& about,
                         const EstimateText& shown) {
  std::string text = shown(*estimate.value);
  if (estimate.low && estimate.high) {
    text += " (95 % CI [" + shown(*estimate.low) + ", " + shown(*estimate.high) + "])";
  }
  return about.empty() ? text : text + " for " + about;
}

}  // namespace

std::vector<const Finding*> numbers_among(const AnalysisOutcome& outcome, std::string_view analysis,
                                          QuantityName quantity) {
  std::vector<const Finding*> found{};
  for (const Finding& finding : outcome.findings) {
    if (finding.analysis == analysis && finding.quantity == quantity && finding.value) {
      found.push_back(&finding);
    }
  }
  return found;
}

std::vector<const Finding*> estimates_among(const AnalysisOutcome& outcome,
                                            std::string_view analysis, QuantityName quantity) {
  std::vector<const Finding*> found = numbers_among(outcome, analysis, quantity);
  // The key of a pair consists of both names.
  std::erase_if(found, [](const Finding* one) { return one->key.size() > 1; });
  return found;
}

std::string all_estimates(const std::vector<const Finding*>& estimates, const std::string& only_key,
                          const EstimateText& shown) {
  std::string text{};
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    if (i > 0) text += i + 1 == estimates.size() ? " and " : ", ";
    const std::string key = estimates[i]->key.text();
    text += one_estimate(*estimates[i], key == only_key ? "" : key, shown);
  }
  return text + ", N = " + display_count(estimates.front()->n);
}

EstimateSentence choices_sentence(const AnalysisOutcome& outcome) {
  const std::vector<const Finding*> means = estimates_among(outcome, "choice", "subj.mean");
  if (means.size() < 2) return {};
  const double chance = 1.0 / static_cast<double>(means.size());
  return {.text = "Mean proportions of choices were " + all_estimates(means, "", display_percent) +
                  "; the chance level was " + display_percent(chance) + '.',
          .has_mean_interval = std::any_of(means.begin(), means.end(), [](const Finding* mean) {
            return mean->low.has_value();
          })};
}

EstimateSentence pairs_sentence(const AnalysisOutcome& outcome) {
  constexpr int kDecimals = 2;
  std::vector<std::string> sentences{};
  const auto state = [&](const char* start, std::string_view analysis, QuantityName quantity,
                         const EstimateText& shown) {
    const std::vector<const Finding*> found = estimates_among(outcome, analysis, quantity);
    if (!found.empty()) sentences.push_back(start + all_estimates(found, "", shown) + '.');
  };
  state("Log-worths of the Bradley–Terry model (mean 0) were ", "scale",
        "bt.ability.sumzero.cluster",
        [](double value) { return display_signed(value, kDecimals); });
  state("Mean proportions of comparisons in which an item was chosen were ", "scores", "mean.score",
        display_percent);
  const std::vector<const Finding*> zetas = numbers_among(outcome, "consistency", "mean.zeta");
  if (!zetas.empty()) {
    sentences.push_back(
        "The mean coefficient of consistence was ζ = " +
        one_estimate(*zetas.front(), "", [](double value) { return display_bounded(value); }) +
        ", N = " + display_count(zetas.front()->n) + '.');
  }
  std::string text{};
  for (const std::string& sentence : sentences) text += (text.empty() ? "" : " ") + sentence;
  return {.text = text};
}

void state_means_of_items(AnalysisOutcome& outcome, const MeansOfItems& means) {
  const auto text_of = [&](const std::vector<std::string>& items, bool is_pair) {
    std::vector<std::string> parts{};
    for (const std::string& item : items) {
      FindingKey key{means.scale, item};
      if (is_pair && means.within_pairs) {
        key = {key, item == items.front() ? items.back() : items.front()};
      }
      const auto found = std::find_if(
          outcome.findings.begin(), outcome.findings.end(), [&](const Finding& finding) {
            return finding.analysis == means.analysis && finding.quantity == means.quantity &&
                   finding.key == key && finding.value;
          });
      if (found == outcome.findings.end()) return std::string();
      parts.push_back(one_estimate(*found, words_of_condition(item), means.shown));
    }
    return "means: " + listed(parts);
  };
  const auto state = [&](const std::string& test, const TestSubject& about,
                         const std::vector<std::string>& items, bool is_pair) {
    const std::string text = text_of(items, is_pair);
    if (!text.empty()) state_means(outcome, test, text, about);
  };
  for (const std::string& test : means.tests) state(test, means.scale, means.items, false);
  for (const std::string& test : means.tests_of_pairs) {
    for (std::size_t a = 0; a < means.items.size(); ++a) {
      for (std::size_t b = 0; b < means.items.size(); ++b) {
        if (a == b) continue;
        const std::vector<std::string> pair{means.items[a], means.items[b]};
        state(test, {pair[0], pair[1]}, pair, true);
        if (!means.scale.empty()) state(test, {pair[0], pair[1], means.scale}, pair, true);
      }
    }
  }
}

EstimateSentence estimate_sentence(const AnalysisOutcome& outcome) {
  const StudyAnalysis* const analysis = find_analysis(outcome.kind);
  if (analysis == nullptr || analysis->estimates == nullptr) return {};
  return analysis->estimates(outcome);
}

}  // namespace asperity

// Composes one clause per condition from the mean thresholds, then sentences on what is missing or bounded.

#include "app/findings/methods/discrimination/threshold_sentences.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "app/findings/methods/discrimination/catch/catch_exclusions.h"
#include "app/findings/methods/discrimination/catch/catch_sentences.h"
#include "app/findings/methods/discrimination/discrimination_methods.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_results.h"
#include "app/findings/methods/discrimination/thresholds/left_out_thresholds.h"
#include "app/findings/methods/discrimination/thresholds/unfinished_tracks.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/outcome/study_findings.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

/// "JND 12.3 µm (95 % CI …)" of a mean, "JND at most 12.3 µm" of an upper bound.
std::string mean_of_paper(const char* measure, const Finding& mean,
                          const std::vector<Finding>& findings) {
  return std::string(measure) + ' ' +
         mean_with_bound(mean, left_out_of_mean(findings, mean)).english();
}

/// " JNDs and CIs of comparisons take the lapse rates of 2 % as known.", where there is the mean of such a JND.
std::string lapses_sentence(const FoundNumbers& means) {
  const std::vector<const Finding*> equalities = means.all("mean.pse");
  const bool has_jnd =
      std::any_of(equalities.begin(), equalities.end(), [&means](const Finding* equality) {
        return means.find("geomean.jnd", equality->key) != nullptr;
      });
  return has_jnd
             ? " The JNDs assume lapse rates of 2 %, and their CIs do not include the error of "
               "this assumption (without lapses the JNDs are too small by 11 to 13 %, and the CIs "
               "contained the true JND in 22 to 95 % of simulated studies)."
             : "";
}

/// " The ratio of the JNDs (metal / wood) was 1.20 (95 % CI …), N = 5 participants with both."
std::string ratio_sentences(const std::vector<Finding>& findings, const std::string& measure) {
  std::string text{};
  for (const Finding& ratio : findings) {
    if (ratio.analysis != kComparedThresholds || !ratio.value ||
        !ratio.quantity.starts_with("ratio.")) {
      continue;
    }
    text += " The ratio of the " + measure + "s (" + words_of_condition(ratio.key[0]) + " / " +
            words_of_condition(ratio.key[1]) + ") was " + quantity_with_interval(ratio).english() +
            ", N = " + display_count(ratio.n) + " participants with both.";
  }
  return text;
}

/// The conditions in which the standard is 0 and responses are correct or incorrect (`DiscriminationTask::is_detection`):
/// then there is a difference at d′ = 1, or the reason why there is none.
std::set<std::string> conditions_of_detections(const std::vector<Finding>& findings) {
  std::set<FindingKey> of_performance{};
  std::set<FindingKey> of_zero{};
  for (const Finding& finding : findings) {
    if (finding.analysis != kThresholds) continue;
    if (is(finding, "jnd.dprime1")) of_performance.insert(finding.key);
    if (is(finding, "standard") && finding.value == 0.0) of_zero.insert(finding.key);
  }
  std::set<std::string> conditions{};
  for (const FindingKey& key : of_zero) {
    if (of_performance.contains(key)) conditions.insert(key.last());
  }
  return conditions;
}

/// The means of the designs in which the threshold is the difference at d′ = 1: there is none at 75 % correct.
std::set<std::string> conditions_at_unit_sensitivity(const FoundNumbers& means) {
  std::set<std::string> conditions{};
  for (const Finding* const mean : means.all("geomean.jnd.dprime1")) {
    if (means.find("geomean.jnd", mean->key) == nullptr) conditions.insert(mean->key.last());
  }
  return conditions;
}

/// The thresholds of these designs.
std::vector<Finding> thresholds_at_unit_sensitivity(const std::vector<Finding>& findings) {
  std::set<FindingKey> with_proportion{};
  for (const Finding& finding : findings) {
    if (finding.analysis == kThresholds && is(finding, "jnd")) {
      with_proportion.insert(finding.key);
    }
  }
  std::vector<Finding> thresholds{};
  for (const Finding& finding : findings) {
    if (finding.analysis == kThresholds && is(finding, "jnd.dprime1") &&
        !with_proportion.contains(finding.key)) {
      thresholds.push_back(finding);
    }
  }
  return thresholds;
}

/// " No JND was estimated for one of 6 participants (responses do not depend on the level as expected)."
std::string missing_sentences(const std::vector<Finding>& findings, QuantityName quantity,
                              const std::string& measure) {
  struct Missing {
    std::size_t participants = 0;
    std::size_t of = 0;
    std::map<std::string, std::size_t> reasons{};
  };
  std::map<std::string, Missing> conditions{};
  for (const Finding& finding : findings) {
    if (finding.analysis != kThresholds || !is(finding, quantity)) continue;
    Missing& missing = conditions[finding.key.size() > 1 ? finding.key.last() : "all"];
    ++missing.of;
    if (finding.value) continue;
    ++missing.participants;
    ++missing.reasons[words_of_status(finding.word).english()];
  }
  std::string text{};
  for (const auto& [condition, missing] : conditions) {
    if (missing.participants == 0) continue;
    std::string reasons{};
    for (const auto& [reason, count] : missing.reasons) {
      reasons += (reasons.empty() ? "" : "; ") +
                 (missing.reasons.size() == 1 ? reason : count_in_words(count) + ": " + reason);
    }
    text += " No " + measure + " was estimated for " +
            (missing.of == 1 ? "the only participant"
                             : count_in_words(missing.participants) + " of " +
                                   display_count(missing.of) + " participants") +
            (condition == "all" ? "" : " in the condition " + words_of_condition(condition)) +
            " (" + reasons + ").";
  }
  return text;
}

}  // namespace

EstimateSentence thresholds_sentence(const AnalysisOutcome& outcome) {
  std::vector<Finding> all_means{};  // also those that are not reported
  std::vector<Finding> means{};
  for (const Finding& finding : outcome.findings) {
    if (finding.analysis != kMeanThresholds) continue;
    all_means.push_back(finding);
    if (finding.value) means.push_back(finding);
  }
  const std::set<std::string> detections = conditions_of_detections(outcome.findings);
  std::string text{};
  const FoundNumbers found(means);
  std::vector<std::string> conditions{};
  const std::set<std::string> at_unit = conditions_at_unit_sensitivity(FoundNumbers(all_means));
  for (const QuantityName quantity : std::initializer_list<QuantityName>{
           "mean.pse", "geomean.jnd", "geomean.jnd.dprime1", "geomean.jnd.posterior"}) {
    for (const Finding* const mean : found.all(quantity)) {
      if (std::find(conditions.begin(), conditions.end(), mean->key.last()) == conditions.end()) {
        conditions.push_back(mean->key.last());
      }
    }
  }
  for (const std::string& condition : conditions) {
    std::vector<const Finding*> shown{};
    std::vector<std::string> parts{};
    const auto add = [&](QuantityName quantity, const char* measure) {
      const Finding* const mean = found.find(quantity, condition);
      if (mean == nullptr) return;
      shown.push_back(mean);
      parts.push_back(mean_of_paper(measure, *mean, outcome.findings));
    };
    add("mean.pse", "PSE");
    const char* const measure = detections.contains(condition) ? "detection threshold" : "JND";
    if (at_unit.contains(condition)) {
      add("geomean.jnd.dprime1",
          detections.contains(condition) ? "detection threshold at d′ = 1" : "JND at d′ = 1");
    } else {
      add("geomean.jnd", measure);
    }
    add("geomean.jnd.posterior",
        detections.contains(condition) ? "posterior detection threshold" : "posterior JND");
    add("geomean.weber", "Weber fraction");
    const bool is_same_n = std::all_of(shown.begin(), shown.end(), [&shown](const Finding* mean) {
      return mean->n == shown.front()->n;
    });
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (!is_same_n) parts[i] += " for " + display_count(shown[i]->n) + " participants";
    }
    text += text.empty() ? "Mean thresholds were: " : "; ";
    if (condition != "all") text += words_of_condition(condition) + ", ";
    text += comma_separated(parts);
    if (is_same_n) text += ", N = " + display_count(shown.front()->n);
  }
  if (!text.empty()) text += '.';
  const std::string of_difference = detections.empty() ? "JND" : "threshold";
  const std::vector<Finding> at_unit_sensitivity = thresholds_at_unit_sensitivity(outcome.findings);
  text += missing_sentences(outcome.findings, "pse", "PSE") +
          missing_sentences(outcome.findings, "jnd", of_difference) +
          missing_sentences(at_unit_sensitivity, "jnd.dprime1", of_difference) +
          bound_sentences(outcome.findings, "pse", "PSE") +
          bound_sentences(outcome.findings, "jnd", of_difference) +
          bound_sentences(at_unit_sensitivity, "jnd.dprime1", of_difference) +
          ratio_sentences(outcome.findings, of_difference) + lapses_sentence(found) +
          unfinished_sentence(outcome.findings) + sensitivity_sentences(outcome) +
          catch_trials_sentence(outcome) + exclusions_sentence(outcome);
  if (text.starts_with(' ')) text.erase(0, 1);
  return {.text = text};
}

}  // namespace asperity

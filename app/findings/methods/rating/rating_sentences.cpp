// States only methods whose findings exist: intraclass correlations, Cronbach's alpha and principal components.

#include "app/findings/methods/rating/rating_sentences.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "app/findings/outcome/display_number.h"

namespace asperity {

namespace {

constexpr std::string_view kAgreementAnalysis = "agreement";
constexpr std::string_view kReliabilityAnalysis = "reliability";
constexpr std::string_view kConstructAnalysis = "constructs";
constexpr std::string_view kComponentAnalysis = "components";

/// Those of a form of the coefficient, the last name of the key.
std::vector<const Finding*> numbers_of_form(const AnalysisOutcome& outcome,
                                            std::string_view analysis, QuantityName quantity,
                                            std::string_view form) {
  std::vector<const Finding*> found = numbers_among(outcome, analysis, quantity);
  std::erase_if(found, [form](const Finding* one) { return one->key.last() != form; });
  return found;
}

/// "= .71, 95 % CI [.38, .91]", without the interval where there is none.
std::string estimate_with_interval(const Finding& one) {
  std::string text = "= " + display_bounded(*one.value);
  if (one.low && one.high) {
    text += ", 95 % CI [" + display_bounded(*one.low) + ", " + display_bounded(*one.high) + ']';
  }
  return text;
}

const std::string& scale_of_key(const Finding& one) { return one.key[0]; }

/// " Agreement of the participants: on the scale “rough”, ICC(2,1) = .71, 95 % CI [.38, .91], and ICC(3,k) = …; …"
std::string agreement_text(const AnalysisOutcome& outcome) {
  std::string text{};
  const std::vector<const Finding*> means =
      numbers_of_form(outcome, kAgreementAnalysis, "icc", "ICC3k");
  for (const Finding* const one : numbers_of_form(outcome, kAgreementAnalysis, "icc", "ICC2")) {
    text += std::string(text.empty() ? " Agreement of the participants: on the scale “" : "; “") +
            scale_of_key(*one) + "”, ICC(2,1) " + estimate_with_interval(*one);
    const auto mean = std::find_if(means.begin(), means.end(), [one](const Finding* other) {
      return scale_of_key(*other) == scale_of_key(*one);
    });
    if (mean != means.end()) text += ", and ICC(3,k) " + estimate_with_interval(**mean);
  }
  return text.empty() ? text : text + '.';
}

std::string reliability_text(const AnalysisOutcome& outcome) {
  std::string text{};
  for (const Finding* const one : numbers_among(outcome, kReliabilityAnalysis, "icc.mean")) {
    text += std::string(text.empty() ? " Reliability over repetitions: on the scale “" : "; “") +
            scale_of_key(*one) + "”, mean ICC(3,1) " + estimate_with_interval(*one) +
            ", N = " + std::to_string(one->n);
  }
  return text.empty() ? text : text + '.';
}

std::string construct_text(const AnalysisOutcome& outcome) {
  std::string text{};
  for (const Finding* const one : numbers_among(outcome, kConstructAnalysis, "cronbach.alpha")) {
    text += " For the construct “" + one->key.text() + "”, Cronbach’s α " +
            estimate_with_interval(*one) + '.';
    if (one->value.value_or(0.0) < 0.0) {
      text += " α is negative because the answers on its scales covary negatively on average.";
    }
  }
  return text;
}

std::string components_text(const AnalysisOutcome& outcome) {
  const std::vector<const Finding*> first =
      numbers_of_form(outcome, kComponentAnalysis, "proportion", "C1");
  const std::vector<const Finding*> retained =
      numbers_among(outcome, kComponentAnalysis, "retained");
  if (first.empty() || retained.empty()) return {};
  const Finding& share = *first.front();
  std::string text =
      " The first principal component had " + display_percent(*share.value) + " of the variance";
  const std::vector<const Finding*> corrected =
      numbers_of_form(outcome, kComponentAnalysis, "proportion.corrected", "C1");
  if (!corrected.empty()) {
    const Finding& jackknifed = *corrected.front();
    text += " of the items’ means (without the participants’ deviations: " +
            display_percent(*jackknifed.value) + ", 95 % CI [" + display_percent(*jackknifed.low) +
            ", " + display_percent(*jackknifed.high) + "])";
  }
  const auto count = static_cast<std::uint64_t>(*retained.front()->value);
  return text + "; parallel analysis retained " + count_in_words(count) +
         (count == 1 ? " component." : " components.");
}

}  // namespace

std::string rating_methods_text(const AnalysisOutcome& outcome) {
  std::string text{};
  const auto add = [&text](const char* sentence) {
    text += (text.empty() ? "" : " ") + std::string(sentence);
  };
  if (!numbers_among(outcome, kAgreementAnalysis, "icc").empty()) {
    add("The agreement of the participants was estimated by intraclass correlations of their mean "
        "ratings, with the items as "
        "targets: ICC(2,1), absolute agreement of one participant, and ICC(3,k), consistency of "
        "the mean of all participants "
        "[Shrout 1979].");
  }
  if (!numbers_among(outcome, kReliabilityAnalysis, "icc.mean").empty()) {
    add("Reliability over repetitions is the mean over participants of the ICC(3,1) of a "
        "participant’s ratings.");
  }
  if (!numbers_among(outcome, kConstructAnalysis, "cronbach.alpha").empty()) {
    add("Cronbach’s α of the scales of a construct was computed over the combinations of a "
        "participant and an item; its CI is "
        "from a bootstrap over the participants.");
  }
  if (!numbers_among(outcome, kComponentAnalysis, "eigenvalue").empty()) {
    add("Principal components are those of the correlations of the scales over the items’ mean "
        "ratings; components were "
        "retained by parallel analysis [Horn 1965]. Corrected proportions are without the variance "
        "that the participants’ deviations add to observed means; their CIs are by the jackknife "
        "over the participants [Efron 1982].");
  }
  return text;
}

EstimateSentence rating_estimates_sentence(const AnalysisOutcome& outcome) {
  std::string text = agreement_text(outcome) + reliability_text(outcome) + construct_text(outcome) +
                     components_text(outcome);
  if (!text.empty()) text.erase(0, 1);
  return {.text = text};
}

}  // namespace asperity

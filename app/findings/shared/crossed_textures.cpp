// Calls the family `glmm`; where one deviation is 0, fits the other factor alone, by quadrature.

#include "app/findings/shared/crossed_textures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "app/findings/gathering/answer_columns.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/study_findings.h"

namespace asperity {

namespace {

constexpr const char* kCrossed = "glmm";
constexpr const char* kParticipantFactor = "subject";
constexpr const char* kTextureFactor = "item";
// With fewer, a standard deviation is not reliably estimated.
constexpr std::size_t kFewestParticipants = 5;
constexpr std::size_t kFewestTextures = 3;
// Of the responses of the rarer kind: events per parameter of a logistic regression [Peduzzi 1996].
constexpr std::size_t kFewestOfEach = 10;

/// A row per participant and texture. Numbers replace names, which no finding contains.
std::vector<TidyTable::Column> rows_of(std::span<const TextureResponse> responses) {
  struct Count {
    std::size_t hits = 0;
    std::size_t trials = 0;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, Count> counts{};
  for (const TextureResponse& one : responses) {
    Count& count = counts[{one.person, one.texture}];
    ++count.trials;
    count.hits += one.is_hit ? 1 : 0;
  }
  LabelRows subjects{};
  LabelRows items{};
  NumberColumn correct{};
  NumberColumn trials{};
  for (const auto& [of, count] : counts) {
    subjects.add(std::to_string(of.first));
    items.add(std::to_string(of.second));
    correct.push_back(static_cast<double>(count.hits));
    trials.push_back(static_cast<double>(count.trials));
  }
  return {{"subject", std::move(subjects).take()},
          {"item", std::move(items).take()},
          {"correct", std::move(correct)},
          {"trials", std::move(trials)}};
}

std::vector<Finding> fitted(const CrossedResponses& crossed, const char* random) {
  TidyInput input{};
  input.tables.emplace_back(rows_of(crossed.responses), "the responses");
  input.options.set("chance", crossed.chance);
  if (random != nullptr) {
    input.options.set("random", std::vector<std::string>{random});
    input.options.set("likelihood", std::string("quadrature"));
    // A deviation that is estimated as 0 does not make the sample of its factor larger.
    input.options.set("sampled", std::vector<std::string>{kParticipantFactor, kTextureFactor});
  }
  return analysis_of(kCrossed, "glmm", std::move(input));
}

/// The factor that varies, where the standard deviation of the other is estimated as 0.
const char* lone_random(const FoundNumbers& found) {
  const Finding* status = found.find("glmm.status");
  if (status == nullptr) return nullptr;
  if (status->word == "no_item_variance") return kParticipantFactor;
  return status->word == "no_participant_variance" ? kTextureFactor : nullptr;
}

Finding no_deviation(const char* factor, std::size_t participants) {
  Finding none{};
  none.analysis = kCrossed;
  none.quantity = "glmm.sigma";
  none.key = factor;
  none.value = 0.0;
  none.unit = "1";
  none.method =
      "estimated as 0: the model without these intercepts has the same maximum likelihood";
  none.n = participants;
  return none;
}

Phrase crossed_answer(const FoundNumbers& found, const CrossedResponses& crossed,
                      std::size_t textures) {
  const Finding& proportion = *found.find("glmm.proportion");
  return phrase("Analysis",
                "For a participant and a texture with random intercepts of 0, %1 is estimated as "
                "%2 (%3), "
                "compared with a chance level of %4: t(%5) = %6, %7, uncorrected. SD of the "
                "intercepts (logit): participants %8, textures %9. This test is exploratory.")
      .with(crossed.proportion, percent(*proportion.value), interval_text(proportion),
            percent(crossed.chance), fixed(*found.value("glmm.t.df", "intercept"), 0),
            display_signed(*found.value("glmm.t", "intercept"), 2),
            display_p(*found.value("glmm.t.p", "intercept")),
            fixed(*found.value("glmm.sigma", kParticipantFactor), 2),
            phrase("Analysis", "%1 (N = %2)")
                .with(fixed(*found.value("glmm.sigma", kTextureFactor), 2),
                      std::to_string(textures)));
}

}  // namespace

void add_no_crossed_model(const char* code, const std::string& reason, AnalysisOutcome& outcome) {
  add_status({.analysis = kCrossed, .quantity = "glmm.status"}, code, reason, outcome);
}

void ask_other_textures(const CrossedResponses& crossed, AnalysisOutcome& outcome) {
  std::set<std::uint32_t> participants{};
  std::set<std::uint32_t> textures{};
  for (const TextureResponse& one : crossed.responses) {
    participants.insert(one.person);
    textures.insert(one.texture);
  }
  if (participants.size() < kFewestParticipants || textures.size() < kFewestTextures) {
    const std::string reason = "it needs at least " + std::to_string(kFewestParticipants) +
                               " participants and " + std::to_string(kFewestTextures) +
                               " textures; participants: " + std::to_string(participants.size()) +
                               ", textures: " + std::to_string(textures.size()) +
                               "; add participants or textures";
    add_no_crossed_model(
        participants.size() < kFewestParticipants ? "too_few_participants" : "too_few_textures",
        reason, outcome);
    return;
  }
  const auto hits = static_cast<std::size_t>(
      std::count_if(crossed.responses.begin(), crossed.responses.end(),
                    [](const TextureResponse& one) { return one.is_hit; }));
  const std::size_t rarer = std::min(hits, crossed.responses.size() - hits);
  if (rarer > 0 && rarer < kFewestOfEach) {
    add_no_crossed_model(
        hits == rarer ? "near_floor" : "near_ceiling",
        "it needs at least " + std::to_string(kFewestOfEach) +
            " responses of either kind (correct or of the target, and the others), "
            "which determine how much participants and textures differ; there "
            "are " +
            std::to_string(hits) + " and " + std::to_string(crossed.responses.size() - hits) +
            "; add participants or trials",
        outcome);
    return;
  }
  std::vector<Finding> findings = fitted(crossed, nullptr);
  if (const char* varies = lone_random(FoundNumbers(findings))) {
    findings = fitted(crossed, varies);
    if (FoundNumbers(findings).value("glmm.proportion")) {
      findings.push_back(no_deviation(
          std::string(varies) == kParticipantFactor ? kTextureFactor : kParticipantFactor,
          participants.size()));
    }
  }
  keep_findings(findings, outcome);
  const FoundNumbers found(findings);
  if (!found.value("glmm.proportion")) return;
  const Phrase method = phrase(
      "Analysis",
      "Generalised linear mixed model (logit) with crossed random intercepts of "
      "participants and textures, by maximum likelihood with the Laplace approximation, "
      "or by numerical integration where one SD is estimated as 0; t test and CI of the "
      "fixed intercept, with the degrees of freedom of the smaller sample (participants or "
      "textures), also where its SD is estimated as 0. In simulations with 5 to 20 "
      "participants and SDs of 0.5 and 1, the coverage of the 95 % CI was 97 to 100 % with "
      "four textures and 94 to 100 % with ten for proportions of 25 to 80 %; for 95 %, where few "
      "studies have enough incorrect responses for an estimate, it was 89 to 99 % and "
      "70 to 97 %.");
  add_question(outcome, kCrossed,
               phrase("Analysis",
                      "Does the result hold for other participants and other textures of the same "
                      "kind?"),
               crossed_answer(found, crossed, textures.size()),
               crossed.assumption.empty()
                   ? method
                   : phrase("Analysis", "%1 %2").with(method, crossed.assumption),
               "", found.find("glmm.proportion"));
}

}  // namespace asperity

// Calls the family `icc`: once with participants as targets, or per participant with surfaces as targets.

#include "app/findings/shared/repetition_reliability.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/findings/gathering/answer_columns.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/shared/intraclass_targets.h"
#include "app/findings/tidy/finding_list.h"

namespace asperity {

namespace {

constexpr const char* kReliability = "reliability";

struct MeanScore {
  double sum = 0.0;
  std::size_t n = 0;

  void add(double score) {
    sum += score;
    ++n;
  }
};
/// By target and repetition.
using Ratings = std::map<std::pair<std::uint32_t, std::uint32_t>, MeanScore>;

/// The findings of the family `icc`, with at least three of these targets. Numbers replace names, which no finding contains.
std::vector<Finding> correlations_of(const Ratings& ratings, const IntraclassTargets& rated) {
  LabelRows targets{};
  LabelRows raters{};
  NumberColumn scores{};
  for (const auto& [of, mean] : ratings) {
    targets.add(std::to_string(of.first));
    raters.add(std::to_string(of.second));
    scores.push_back(mean.sum / static_cast<double>(mean.n));
  }
  TidyInput input{};
  input.tables.emplace_back(std::vector<TidyTable::Column>{{"target", std::move(targets).take()},
                                                           {"rater", std::move(raters).take()},
                                                           {"score", std::move(scores)}},
                            "the repetitions");
  std::vector<Finding> findings = analysis_of(kReliability, "icc", std::move(input));
  withhold_few_targets(findings, rated);
  return findings;
}

bool has_too_few_targets(const FoundNumbers& found) {
  const std::vector<const Finding*> all = found.all("icc");
  return !all.empty() && all.front()->word.starts_with("too_few_");
}

/// "ICC(3,1) = .71, 95 % CI [.38, .91]", without the interval where there is none.
Phrase correlation_text(const Phrase& name, const Finding& icc) {
  if (!icc.value) return phrase("Analysis", "%1 is not defined").with(name);
  if (!icc.low || !icc.high)
    return phrase("Analysis", "%1 = %2").with(name, display_bounded(*icc.value));
  return phrase("Analysis", "%1 = %2, 95 % CI [%3, %4]")
      .with(name, display_bounded(*icc.value), display_bounded(*icc.low),
            display_bounded(*icc.high));
}

std::size_t repetitions_in(const Ratings& ratings) {
  std::set<std::uint32_t> repetitions{};
  for (const auto& [of, mean] : ratings) repetitions.insert(of.second);
  return repetitions.size();
}

Phrase reliability_question() {
  return phrase("Analysis", "How reliable are the participants' results over repetitions?");
}

struct OwnReliability {
  Finding mean{};   ///< without a value, the status that states why there is none
  Phrase answer{};  ///< empty without a value
};

/// The repetitions that all repeated surfaces have: where their numbers differ, the first ones of each.
class SharedRepetitions final {
 public:
  explicit SharedRepetitions(std::span<const RepeatedEstimate> estimates) {
    for (const RepeatedEstimate& estimate : estimates) {
      planned_[estimate.surface].insert(estimate.repetition);
    }
    all_ = planned_.size();
    std::erase_if(planned_, [](const auto& surface) { return surface.second.size() < 2; });
    for (const auto& [surface, repetitions] : planned_) {
      fewest_ = fewest_ == 0 ? repetitions.size() : std::min(fewest_, repetitions.size());
      most_ = std::max(most_, repetitions.size());
    }
  }
  /// The surface and the repetition as numbers; nothing for those that are not used.
  std::optional<std::pair<std::uint32_t, std::uint32_t>> place_of(
      const RepeatedEstimate& estimate) const {
    const auto surface = planned_.find(estimate.surface);
    if (surface == planned_.end()) return std::nullopt;
    const auto repetition = static_cast<std::size_t>(
        std::distance(surface->second.begin(), surface->second.find(estimate.repetition)));
    if (repetition >= fewest_) return std::nullopt;
    return std::pair(static_cast<std::uint32_t>(std::distance(planned_.begin(), surface)),
                     static_cast<std::uint32_t>(repetition));
  }
  std::size_t repetitions() const noexcept { return fewest_; }
  bool are_all() const noexcept { return planned_.size() == all_ && fewest_ == most_; }
  /// Which of them are used, where not all are.
  Phrase with_those_used(const Phrase& answer) const {
    if (are_all()) return answer;
    return phrase("Analysis",
                  "%1 The numbers of repetitions differ: the first %2 of each of the %3 repeated "
                  "items are used.")
        .with(answer, std::to_string(fewest_), std::to_string(planned_.size()));
  }

 private:
  std::map<std::string, std::set<int>>
      planned_{};  ///< of the repeated surfaces, over all participants
  std::size_t all_ = 0;
  std::size_t fewest_ = 0;
  std::size_t most_ = 0;
};

/// The mean over participants of their own ICC3, or the status that no participant has three targets with all repetitions;
/// nothing where no target is repeated, and where all participants who have three respond alike to them.
std::optional<OwnReliability> own_reliability(const GatheredAnswers& gathered,
                                              std::span<const RepeatedEstimate> estimates,
                                              const FindingKey& key, const std::string& what,
                                              const IntraclassTargets& rated) {
  const SharedRepetitions shared(estimates);
  if (shared.repetitions() == 0) return {};
  std::vector<Ratings> own(gathered.people.size());
  for (const RepeatedEstimate& estimate : estimates) {
    if (const auto place = shared.place_of(estimate)) {
      own[estimate.person][*place].add(estimate.value);
    }
  }
  std::vector<double> correlations{};
  std::optional<Finding> too_few{};
  bool has_enough = false;
  for (const Ratings& ratings : own) {
    if (ratings.empty()) continue;
    const std::vector<Finding> findings = correlations_of(ratings, rated);
    const FoundNumbers found(findings);
    const std::optional<double> icc = found.value("icc", "ICC3");
    if (icc) correlations.push_back(*icc);
    if (!has_too_few_targets(found)) {
      has_enough = true;
    } else if (!too_few) {
      too_few = *found.find("icc", rated.key);
    }
  }
  if (correlations.empty()) {
    if (has_enough || !too_few) return {};
    too_few->quantity = "icc.mean";
    return OwnReliability{.mean = *too_few};
  }
  FindingList list{};
  // With k repetitions no correlation is below −1/(k − 1).
  const double least = -1.0 / (static_cast<double>(shared.repetitions()) - 1.0);
  add_mean_of_group("icc.mean", key, correlations,
                    {.possible = ConfidenceInterval{.low = least, .high = 1.0}, .of = what}, list);
  std::vector<Finding> findings = list.take();
  for (Finding& finding : findings) finding.analysis = kReliability;
  const Finding& mean = findings.front();
  return OwnReliability{.mean = mean,
                        .answer = shared.with_those_used(
                            phrase("Analysis",
                                   "Within-participant reliability of one of the %1 repetitions: "
                                   "%2; N = %3 participants.")
                                .with(std::to_string(shared.repetitions()),
                                      correlation_text(phrase("Analysis", "mean ICC(3,1)"), mean),
                                      std::to_string(mean.n)))};
}

}  // namespace

void ask_reliability(const GatheredAnswers& gathered, const RepeatedScores& repeated,
                     AnalysisOutcome& outcome) {
  Ratings ratings{};
  std::size_t with_column = 0;
  for (const RepeatedScore& score : repeated.scores) {
    const bool has_column = !gathered.word(score.column).empty();
    if (has_column) ++with_column;
    ratings[{score.person,
             has_column ? score.column : static_cast<std::uint32_t>(score.repetition)}]
        .add(score.score);
  }
  // Where only some trials belong to a column, the others are not repetitions of them.
  if (with_column > 0 && with_column < repeated.scores.size()) return;
  const std::size_t repetitions = repetitions_in(ratings);
  if (repetitions < 2) return;
  if (repetitions_are_textures(gathered)) {
    add_no_reliability("repetitions_are_textures",
                       "each repetition presents other textures than the others, so that "
                       "repetitions and textures cannot be distinguished",
                       outcome);
    return;
  }
  const std::vector<Finding> findings =
      correlations_of(ratings, {.counted = "participants with all repetitions"});
  const FoundNumbers found(findings);
  const Finding* one = found.find("icc", "ICC3");
  const Finding* agreement = found.find("icc", "ICC2");
  const Finding* all = found.find("icc", "ICC3k");
  const Finding* none = found.find("icc");
  if (has_too_few_targets(found)) {
    keep_findings(std::span(none, 1), outcome);
    return;
  }
  keep_findings(findings, outcome);
  const Phrase answer =
      one == nullptr || agreement == nullptr || all == nullptr
          ? phrase("Analysis",
                   "Not defined: all participants have the same result in every repetition.")
          : phrase("Analysis",
                   "Reliability of a single repetition: %1 (consistency) and %2 (agreement); of "
                   "the mean of the %3 repetitions: %4; N = %5 participants.")
                .with(correlation_text("ICC(3,1)", *one), correlation_text("ICC(2,1)", *agreement),
                      std::to_string(repetitions), correlation_text("ICC(3,k)", *all),
                      std::to_string(one->n));
  const Phrase method = phrase("Analysis",
                               "Intraclass correlations of %1 in each repetition. They are also "
                               "low where participants differ little from each other.")
                            .with(repeated.name);
  const bool has_interval = one != nullptr && one->low && one->high;
  add_question(
      outcome, kReliability, reliability_question(), answer,
      has_interval
          ? phrase("Analysis",
                   "%1 The CIs assume normally distributed results. In simulations of proportions "
                   "of 2 to 20 participants, their coverage was at least 86 % with a mean of 25 to "
                   "71 %, and at least 58 % with a mean of 87 or 95 %.")
                .with(method)
          : method,
      "", one != nullptr ? one : none);
}

bool repetitions_are_textures(const GatheredAnswers& gathered) {
  std::map<std::pair<std::uint32_t, int>, std::set<std::uint32_t>> textures{};
  for (const GatheredAnswer& answer : gathered.answers) {
    const std::uint32_t column = gathered.column_of(answer);
    const bool has_column = !gathered.word(column).empty();
    std::set<std::uint32_t>& own =
        textures[{has_column ? column : 0, has_column ? 0 : answer.repetition}];
    for (const FeltSurface& surface : gathered.surfaces_of(answer)) {
      if (!gathered.word(surface.texture).empty()) own.insert(surface.texture);
    }
  }
  std::set<std::uint32_t> all{};
  std::size_t sum = 0;
  for (const auto& [repetition, own] : textures) {
    if (own.empty()) return false;
    all.insert(own.begin(), own.end());
    sum += own.size();
  }
  return textures.size() > 1 && all.size() == sum;
}

bool has_repetitions(const GatheredAnswers& gathered) {
  return std::any_of(gathered.answers.begin(), gathered.answers.end(),
                     [&gathered, &first = gathered.answers.front()](const GatheredAnswer& one) {
                       return gathered.column_of(one) != gathered.column_of(first) ||
                              one.repetition != first.repetition;
                     });
}

void add_no_reliability(const char* code, const char* reason, AnalysisOutcome& outcome) {
  add_status({.analysis = kReliability, .quantity = "icc"}, code, reason, outcome);
}

void ask_reliability_of_estimates(const GatheredAnswers& gathered,
                                  std::span<const RepeatedEstimate> estimates,
                                  AnalysisOutcome& outcome) {
  const std::optional<OwnReliability> own = own_reliability(
      gathered, estimates, "ICC3",
      "mean of the participants' own intraclass correlations ICC3 of the logarithms, surfaces by "
      "repetitions",
      {.counted = "surfaces with all repetitions"});
  if (!own) return;
  keep_findings(std::span(&own->mean, 1), outcome);
  if (!own->mean.value) return;
  add_question(
      outcome, kReliability, reliability_question(), own->answer,
      phrase("Analysis",
             "Each participant's own intraclass correlation (consistency) of the logarithms of the "
             "estimates, with the surfaces in each condition as targets and the repetitions as "
             "raters; mean over the participants with a t-based CI. In simulations with 2 to 20 "
             "participants and seven surfaces, the coverage of the CI was at least 90 %."),
      "", &own->mean);
}

void ask_reliability_of_ratings(const GatheredAnswers& gathered, const std::string& scale,
                                std::span<const RepeatedEstimate> ratings,
                                AnalysisOutcome& outcome) {
  const std::optional<OwnReliability> own = own_reliability(
      gathered, ratings, {scale, "ICC3"},
      "mean of the participants' own intraclass correlations ICC3, items by repetitions",
      {.counted = "items with all repetitions", .key = scale});
  if (!own) return;
  keep_findings(std::span(&own->mean, 1), outcome);
  if (!own->mean.value) return;
  add_question(
      outcome, (kReliability + ('_' + scale)).c_str(),
      phrase("Analysis", "How reliable are the ratings on the scale “%1” over repetitions?")
          .with(scale),
      own->answer,
      phrase("Analysis",
             "Each participant's own intraclass correlation (consistency) of the ratings, with the "
             "items as targets and the repetitions as raters; mean over the participants with a "
             "t-based CI. It is also low where a participant rates the items alike."),
      "", &own->mean);
}

}  // namespace asperity

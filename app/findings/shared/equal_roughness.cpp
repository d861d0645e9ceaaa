// Geometric means over sessions, then participants; no interval where a match of the stimulus did not succeed.

#include "app/findings/shared/equal_roughness.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "analysis/tests/geometric_mean.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/tidy/finding_list.h"

namespace asperity {

namespace {

const ResultColumn kMatchedAmplitude{.id = "relative_amplitude",
                                     .heading = phrase("AnalysisWords", "relative amplitude")};
const ResultColumn kRoughnessMatch{.id = "roughness_match",
                                   .heading = phrase("AnalysisWords", "roughness match")};

/// Whether matches of which `of` is the same differ in `part`.
template <typename Of>
bool differ_in(std::string PresentedMatch::*part, const std::vector<ParticipantMatch>& matches,
               const Of& of) {
  std::map<decltype(of(matches.front().match)), std::string> known{};
  return std::any_of(matches.begin(), matches.end(), [&](const ParticipantMatch& each) {
    const std::string& own = each.match.*part;
    return known.try_emplace(of(each.match), own).first->second != own;
  });
}

/// The shortest labels that distinguish all matches: "recorded"; with several textures "recorded, stone"; with several
/// stimuli of a model and texture their names, "rendered_stone_recorded"; and the blocks, if several match a stimulus:
/// "recorded (matching)".
class MatchLabels {
 public:
  explicit MatchLabels(const std::vector<ParticipantMatch>& matches)
      : has_textures_(
            differ_in(&PresentedMatch::texture, matches, [](const PresentedMatch&) { return 0; })),
        has_names_(differ_in(
            &PresentedMatch::stimulus, matches,
            [](const PresentedMatch& match) { return std::pair(match.model, match.texture); })),
        has_blocks_(differ_in(&PresentedMatch::matched_in, matches,
                              [](const PresentedMatch& match) { return match.stimulus; })) {}

  std::string of(const PresentedMatch& match) const {
    std::string label = has_names_ ? match.stimulus : match.model;
    if (has_textures_ && !has_names_ && !match.texture.empty()) label += ", " + match.texture;
    if (has_blocks_) label += " (" + match.matched_in + ')';
    return label;
  }

 private:
  bool has_textures_ = false;
  bool has_names_ = false;
  bool has_blocks_ = false;
};

/// The geometric mean of the matched sessions of each participant.
using OfParticipants = std::map<std::string, std::vector<double>>;

std::vector<double> participant_means(const OfParticipants& of) {
  std::vector<double> means{};
  for (const auto& [participant, amplitudes] : of) means.push_back(geometric_mean(amplitudes).mean);
  return means;
}

}  // namespace

void add_equal_roughness(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  using namespace columns;
  if (gathered.matches.empty()) return;
  constexpr double kConfidenceOfAmplitudes = 0.95;
  const MatchLabels labels(gathered.matches);
  ResultTable participants{kEqualRoughness,
                           phrase("Analysis", "Relative amplitudes of equal roughness"),
                           {kParticipant, kSession, kStimulus, kMatchedAmplitude, kRoughnessMatch},
                           {}};
  std::vector<std::string> stimuli{};
  std::map<std::string, OfParticipants> matched{};
  std::map<std::string, std::size_t> missing{};  // matches that did not succeed, by stimulus
  std::size_t not_matched = 0;
  for (const ParticipantMatch& each : gathered.matches) {
    const std::string stimulus = labels.of(each.match);
    participants.add({each.participant, std::int64_t{each.session}, stimulus,
                      each.match.relative_amplitude, std::string(text_of(each.match.status))});
    if (std::find(stimuli.begin(), stimuli.end(), stimulus) == stimuli.end()) {
      stimuli.push_back(stimulus);
    }
    if (each.match.status == MatchStatus::matched) {
      matched[stimulus][each.participant].push_back(each.match.relative_amplitude);
    } else {
      ++not_matched;
      missing[stimulus] += each.match.status == MatchStatus::reference ? 0 : 1;
    }
  }
  participants.note =
      phrase("Analysis",
             "Factor by which the amplitude was multiplied, so that the participant judged the "
             "stimulus as rough as the reference. below_range and above_range: rougher, or less "
             "rough, at every amplitude, and presented at the end of the range. unmatched: too few "
             "reversals, and presented unchanged.");
  ResultTable means{kMeanAmplitudes,
                    phrase("Analysis", "Relative amplitudes of equal roughness: means"),
                    {kStimulus, kPersons, kMatchedAmplitude, interval_of(kMatchedAmplitude)},
                    phrase("Analysis",
                           "Geometric means over the participants whose stimulus was matched, with "
                           "t-based 95 % CIs on the logarithmic scale, and without a CI where a "
                           "match did not succeed: the matched ones are then a selection (for "
                           "thresholds within the levels such CIs contained the true mean in 48 to "
                           "75 % of simulated studies). The reference has the relative amplitude "
                           "1.")};
  FindingList list{};
  for (const std::string& stimulus : stimuli) {
    const std::vector<double> of = participant_means(matched[stimulus]);
    if (of.empty()) {
      means.add({stimulus, count_cell(0)});
      continue;
    }
    GeometricMean mean = geometric_mean(of, kConfidenceOfAmplitudes);
    // Those who could be matched within the range are a selection.
    if (missing[stimulus] > 0) mean.interval.reset();
    Basis basis{
        .n = mean.n,
        .method = "geometric mean over the matched participants; t interval on the log scale",
        .interval = mean.interval};
    if (mean.interval) basis.confidence = kConfidenceOfAmplitudes;
    list.number("relative_amplitude", stimulus, mean.mean, basis);
    means.add(
        {stimulus, count_cell(mean.n), mean.mean,
         mean.interval ? interval_cell(mean.interval->low, mean.interval->high) : ResultCell{}});
  }
  for (Finding& finding : list.take()) {
    finding.analysis = kEqualRoughness;
    outcome.findings.push_back(std::move(finding));
  }
  outcome.tables.push_back(std::move(means));
  outcome.tables.push_back(std::move(participants));
  if (not_matched == 0) {
    outcome.remarks.push_back(
        phrase("Analysis",
               "The surfaces were presented at amplitudes of equal roughness; all %1 matches "
               "succeeded.")
            .with(std::to_string(gathered.matches.size())));
    return;
  }
  outcome.remarks.push_back(
      phrase(
          "Analysis",
          "The surfaces were presented at amplitudes of equal roughness; %1 of %2 matches did not "
          "succeed, so that these stimuli were presented at the end of the range or unchanged "
          "(the table lists them).")
          .with(std::to_string(not_matched), std::to_string(gathered.matches.size())));
}

}  // namespace asperity

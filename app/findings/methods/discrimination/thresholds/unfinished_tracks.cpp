// Counts participants and estimates from the findings `unfinished.tracks` of the thresholds.

#include "app/findings/methods/discrimination/thresholds/unfinished_tracks.h"

#include <cstddef>
#include <set>

#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/found_numbers.h"

namespace asperity {

namespace {

/// Participants with an unfinished track, and the estimates of one quantity from unfinished tracks: one for each of these
/// participants and conditions.
struct UnfinishedTracks {
  std::set<std::string> participants{};
  std::set<std::string> of{};  ///< all participants
  bool is_measured = false;    ///< the task has this quantity
  std::size_t estimates = 0;
  std::size_t included = 0;  ///< estimates that exist, and are therefore included in the mean
};

UnfinishedTracks unfinished_tracks(const std::vector<Finding>& thresholds, QuantityName quantity) {
  UnfinishedTracks found{};
  const FoundNumbers numbers(thresholds);
  for (const Finding& finding : thresholds) {
    if (finding.analysis != kThresholds) continue;
    const std::string& participant = finding.key[0];
    found.of.insert(participant);
    found.is_measured = found.is_measured || is(finding, quantity);
    if (!is(finding, "unfinished.tracks")) continue;
    found.participants.insert(participant);
    ++found.estimates;
    if (numbers.value(quantity, finding.key)) ++found.included;
  }
  return found;
}

/// "the JND was estimated from the presented trials and is included in the means"
std::string included_text(const UnfinishedTracks& unfinished, const std::string& measure) {
  if (unfinished.included == 0) {
    return "no " + measure + " could be estimated from the presented trials";
  }
  if (unfinished.included < unfinished.estimates) {
    return "the means include " + count_in_words(unfinished.included) + " of " +
           display_count(unfinished.estimates) + ' ' + measure +
           "s of these tracks, for which the presented trials were sufficient";
  }
  return "the " + measure + (unfinished.estimates == 1 ? " was" : "s were") +
         " estimated from the presented trials and " + (unfinished.estimates == 1 ? "is" : "are") +
         " included in the means";
}

}  // namespace

Phrase with_unfinished_tracks(const Phrase& answer, const DiscriminationResults& results,
                              QuantityName quantity, const Phrase& means) {
  const UnfinishedTracks unfinished = unfinished_tracks(results.fit.thresholds, quantity);
  if (unfinished.participants.empty()) return answer;
  const Phrase stated = phrase("Analysis", "%1 Participants with an unfinished track: %2 of %3.")
                            .with(answer, std::to_string(unfinished.participants.size()),
                                  std::to_string(unfinished.of.size()));
  if (means.empty()) return stated;
  return phrase("Analysis",
                "%1 Estimates from unfinished tracks that are included in the mean, because the "
                "presented trials were sufficient: %2 of %3.")
      .with(stated, std::to_string(unfinished.included), std::to_string(unfinished.estimates));
}

std::string unfinished_sentence(const std::vector<Finding>& findings) {
  const UnfinishedTracks of_jnd = unfinished_tracks(findings, "jnd");
  if (of_jnd.participants.empty()) return {};
  const UnfinishedTracks of_pse = unfinished_tracks(findings, "pse");
  const std::string how = of_pse.is_measured
                              ? included_text(of_pse, "PSE") + "; " + included_text(of_jnd, "JND")
                              : included_text(of_jnd, "threshold");
  const std::string participants = of_jnd.of.size() == 1
                                       ? "the only participant"
                                       : count_in_words(of_jnd.participants.size()) + " of " +
                                             display_count(of_jnd.of.size()) + " participants";
  return " Tracks of " + participants + " were unfinished; " + how + '.';
}

}  // namespace asperity

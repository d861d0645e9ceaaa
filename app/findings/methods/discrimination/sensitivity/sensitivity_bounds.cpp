// Removes the intervals of means with participants at ceiling or floor, and states which bound such a mean is.

#include "app/findings/methods/discrimination/sensitivity/sensitivity_bounds.h"

#include <algorithm>
#include <optional>

#include "analysis/numbers/number_text.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/tidy/finding_list.h"

namespace asperity {

FindingKey id_of_level(const DiscriminationResults& results,
                       const std::pair<std::size_t, double>& place) {
  return {results.conditions[place.first], number_text(place.second)};
}

void mark_bounds(const DiscriminationResults& results, const UnboundedAtLevels& levels,
                 std::vector<Finding>& findings) {
  std::map<FindingKey, UnboundedParticipants> by_id{};
  for (const auto& [place, of] : levels) {
    if (of.is_any()) by_id[id_of_level(results, place)] = of;
  }
  drop_intervals(findings, [&by_id](const Finding& finding) -> std::optional<std::string> {
    const auto found = by_id.find(finding.key);
    if (!is(finding, "dprime.mean") || found == by_id.end()) return std::nullopt;
    const UnboundedParticipants& of = found->second;
    const std::string bound = of.at_floor == 0     ? "a lower bound without an interval"
                              : of.at_ceiling == 0 ? "an upper bound without an interval"
                                                   : "without an interval, and not a bound";
    return bound + ": d′ of " + std::to_string(of.at_ceiling + of.at_floor) + " of " +
           std::to_string(of.participants) +
           " participants depends on their numbers of trials, because a proportion is 0 or 1";
  });
}

Phrase with_bound(const Phrase& mean, const UnboundedParticipants& of) {
  const std::string ceiling = std::to_string(of.at_ceiling);
  const std::string floor = std::to_string(of.at_floor);
  const std::string all = std::to_string(of.participants);
  if (of.at_floor == 0) {
    return phrase("Analysis", "%1 (at least; ceiling: %2 of %3 participants)")
        .with(mean, ceiling, all);
  }
  if (of.at_ceiling == 0) {
    return phrase("Analysis", "%1 (at most; floor: %2 of %3 participants)").with(mean, floor, all);
  }
  return phrase("Analysis", "%1 (ceiling: %2, floor: %3 of %4 participants)")
      .with(mean, ceiling, floor, all);
}

Phrase explained_bounds(const Phrase& answer, const UnboundedAtLevels& levels,
                        const DiscriminationResults& results) {
  Phrase explained = answer;
  const auto add = [&](auto is_so, const Phrase& sentence) {
    if (std::any_of(levels.begin(), levels.end(),
                    [&is_so](const auto& each) { return is_so(each.second); })) {
      explained = phrase("Analysis", "%1 %2").with(explained, sentence);
    }
  };
  using Of = UnboundedParticipants;
  add([](const Of& of) { return of.at_ceiling > 0 && of.at_floor == 0; },
      phrase("Analysis",
             "Ceiling: a proportion is 0 or 1, so that d′ of these participants depends on their "
             "numbers of trials; the mean is a lower bound and has no CI."));
  add([](const Of& of) { return of.at_ceiling == 0 && of.at_floor > 0; },
      phrase("Analysis",
             "Floor: a proportion is 0 or 1 and d′ is negative, so that d′ of these participants "
             "depends on their numbers of trials; the mean is an upper bound and has no CI."));
  add([](const Of& of) { return of.at_ceiling > 0 && of.at_floor > 0; },
      phrase("Analysis",
             "Ceiling and floor: without a correction, d′ of some participants is positive and "
             "infinite and that of others negative and infinite; the mean depends on their numbers "
             "of trials, is neither a lower nor an upper bound, and has no CI."));
  Phrase zeros{};
  for (const auto& [place, of] : levels) {
    if (of.at_zero == 0) continue;
    Phrase one = phrase("Analysis", "%1: %2 of %3")
                     .with(stated_quantity(place.second, results.study.task.varied.unit),
                           std::to_string(of.at_zero), std::to_string(of.participants));
    if (results.conditions.size() > 1) {
      one = phrase("Analysis", "%1, %2")
                .with(words_of_condition(results.conditions[place.first]), one);
    }
    zeros = zeros.empty() ? one : phrase("Analysis", "%1; %2").with(zeros, one);
  }
  if (zeros.empty()) return explained;
  return phrase("Analysis",
                "%1 By this decision rule d′ is not negative, and chance alone makes it greater "
                "than 0 for some participants: means of small d′ are too high. Participants with "
                "d′ = 0: %2.")
      .with(explained, zeros);
}

}  // namespace asperity

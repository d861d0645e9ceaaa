// States how the amplitudes of surfaces were made equal in force or in roughness.

#include "app/report/text/report_roughness.h"

#include <vector>

#include "analysis/numbers/number_text.h"
#include "app/words/text_parts.h"

namespace asperity {

std::string equal_force_text(const ReportFacts& facts) {
  if (!facts.has_equal_force) return {};
  const std::string matched =
      "he force models were matched in the RMS of their texture force along a prescribed path.";
  // The amplitudes of equal roughness then change the forces.
  return (facts.roughness_matches.empty() ? "T" : "Before their roughness was matched, t") +
         matched;
}

std::string equal_roughness_text(const ReportFacts& facts) {
  std::size_t all = 0;
  std::size_t failed = 0;
  std::vector<std::string> failures{};
  for (const auto& [status, count] : facts.roughness_matches) {
    all += count;
    if (status == MatchStatus::matched) continue;
    failed += count;
    failures.push_back(std::to_string(count) + ' ' + std::string(text_of(status)) + " (" +
                       std::string(meaning_of(status)) + ')');
  }
  if (all == 0) return {};
  std::string text =
      "The surfaces were presented at the amplitudes at which the participant had judged them as "
      "rough as the reference: 1-up/1-down staircases varied the amplitude of each stimulus, and "
      "the geometric mean of the amplitudes at their reversals was used.";
  if (failed == 0) {
    return text + ' ' + (all == 1 ? "The match" : "All " + std::to_string(all) + " matches") +
           " succeeded.";
  }
  return text + " Of " + counted(all, "match", "matches") + ", " + std::to_string(failed) +
         " did not succeed: " + listed(failures) + '.';
}

}  // namespace asperity

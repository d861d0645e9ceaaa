// Implements the names of the ways in which a relative amplitude was determined.

#include "protocols/design/roughness_match.h"

namespace asperity {

std::string_view text_of(MatchStatus status) noexcept {
  switch (status) {
    case MatchStatus::reference:
      return "reference";
    case MatchStatus::matched:
      return "matched";
    case MatchStatus::below_range:
      return "below_range";
    case MatchStatus::above_range:
      return "above_range";
    case MatchStatus::unmatched:
      return "unmatched";
  }
  return {};
}

std::string_view meaning_of(MatchStatus status) noexcept {
  switch (status) {
    case MatchStatus::reference:
      return "the reference of the matching, with a relative amplitude of 1";
    case MatchStatus::matched:
      return "the geometric mean of the reversals";
    case MatchStatus::below_range:
      return "rougher than the reference at every amplitude: the lowest of the range";
    case MatchStatus::above_range:
      return "less rough than the reference at every amplitude: the highest of the range";
    case MatchStatus::unmatched:
      return "too few reversals, or tracks that contradict each other: unchanged, with a relative "
             "amplitude of 1";
  }
  return {};
}

std::optional<MatchStatus> match_status_named(std::string_view text) noexcept {
  for (const MatchStatus status : match_statuses()) {
    if (text == text_of(status)) return status;
  }
  return std::nullopt;
}

const std::vector<MatchStatus>& match_statuses() {
  static const std::vector<MatchStatus> kAll{MatchStatus::reference, MatchStatus::matched,
                                             MatchStatus::below_range, MatchStatus::above_range,
                                             MatchStatus::unmatched};
  return kAll;
}

}  // namespace asperity

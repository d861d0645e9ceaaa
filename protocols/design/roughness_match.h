// Declares the amplitude at which a participant judged a stimulus to be as rough as a reference.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// How the relative amplitude of a stimulus was determined.
enum class MatchStatus {
  reference,    ///< the stimulus is the reference of the matching: 1
  matched,      ///< every track has enough reversals: the geometric mean
  below_range,  ///< the stimulus was rougher at every amplitude: the lowest of the range
  above_range,  ///< the reference was rougher at every amplitude: the highest of the range
  unmatched,    ///< too few answers, or tracks that contradict each other: 1
};

/// The text in a plan and in exports.
std::string_view text_of(MatchStatus status) noexcept;
/// What a reader of a report learns of it, as an entry of a list.
std::string_view meaning_of(MatchStatus status) noexcept;
/// Nothing for a text of another version.
std::optional<MatchStatus> match_status_named(std::string_view text) noexcept;
const std::vector<MatchStatus>& match_statuses();

/// The match of one stimulus: of one model with one texture.
struct RoughnessMatch {
  std::string stimulus{};  ///< the template
  std::string model{};
  std::string texture{};
  /// Multiplies the amplitude that the stimulus has otherwise, so that it is as rough as the reference.
  double relative_amplitude = 1.0;
  MatchStatus status = MatchStatus::unmatched;
  int answers = 0;    ///< of all tracks
  int reversals = 0;  ///< of all tracks

  bool operator==(const RoughnessMatch&) const = default;
};

}  // namespace asperity

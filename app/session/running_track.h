// The tracks of a block whose levels a procedure chooses, as far as they have been answered in a running session.

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/session/session_monitor.h"
#include "protocols/procedures/level_answer.h"

namespace asperity {

/// One trial that counts for its track.
struct RunningTrial {
  int step = 0;        ///< from 1, within the track
  double level = 0.0;  ///< as the levels are stated (Dimension)
  LevelOutcome outcome = LevelOutcome::incorrect;
};

/// Where a track is: the mean of its reversals, or the median of its posterior with the 95 % credible interval.
struct RunningEstimate {
  double level = 0.0;
  std::optional<double> low{};  ///< of a posterior
  std::optional<double> high{};
};

struct RunningTrack {
  int track = 0;            ///< from 1, within the run of its block
  std::string condition{};  ///< the levels of the other factors; names, hidden while blind
  std::vector<RunningTrial> trials{};
  std::size_t reversals = 0;  ///< of an up-down method
  /// Nothing before the first reversal or answer, and where no function of the prior can give the responses.
  std::optional<RunningEstimate> estimate{};
};

/// The tracks of one run of a block.
struct RunningTracks {
  std::string quantity{};              ///< the varied parameter
  std::string unit{};                  ///< of the levels: "m", "dB", "%"; empty for pure numbers
  std::vector<RunningTrack> tracks{};  ///< those with an answer, by number
};

/// Computed from the answers of the stored attempts (AttemptSummary), of which the last valid one of each trial counts.
/// Catch trials belong to no track.
///
/// The mean of the reversals is that of their levels, of their logarithms where the grid is not linear [Levitt 1971]. The
/// posterior is that of the procedure's prior, marginal over slope and lapse rate, and an unsure response is a guess, as in
/// the procedure (`posterior_rule`); its threshold is a difference from the standard, shown at the side of the levels that
/// were presented.
///
/// Nothing where no procedure chooses the levels of the block from the responses: constant stimuli have no tracks.
std::optional<RunningTracks> running_tracks(const Protocol& protocol, const Plan& plan,
                                            std::span<const AttemptSummary> attempts,
                                            int block_ordinal);

/// Whether a block of the protocol has a procedure whose tracks can be shown.
bool has_running_tracks(const Protocol& protocol) noexcept;

}  // namespace asperity

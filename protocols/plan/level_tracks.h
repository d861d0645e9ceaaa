// Declares the tracks of one run of a block whose levels a procedure chooses.

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analysis/random.h"
#include "protocols/design/protocol.h"
#include "protocols/plan/roughness_matching.h"
#include "protocols/plan/trial_maker.h"

namespace asperity {

/// The tracks of a block with a procedure: one for every combination of the other factors and every track of the
/// procedure, in this order.
///
/// A track also ends when it has presented `kMostPresented` times its maximum number of trials, answered or not.
///
/// Tracks are interleaved in rounds: in each round every track that is not finished has one trial, in random order
/// (`Block::Order::shuffle`). With the order `fixed` a track begins when the one before is finished.
///
/// With catch trials, one of every `CatchTrials::every` trials of the block is one, at a place that is drawn beforehand.
/// Their places do not depend on answers, and they do not change the levels of the tracks; answers determine only after
/// how many trials the block ends.
class LevelTracks final {
 public:
  /// The protocol and the block must outlive the tracks.
  LevelTracks(const Protocol& protocol, BlockRun run);

  const BlockRun& run() const noexcept { return run_; }
  /// Trials so far.
  std::size_t trials() const noexcept { return trials_; }

  /// The next trial, without its ordinal; nothing when all tracks are finished. It has to be answered before the next
  /// one is determined.
  std::optional<Trial> next(const TrialMaker& maker);
  /// The answer to the last trial; nothing where it does not count for its track, which then has the same level in
  /// another trial. The answer to a catch trial changes nothing.
  void answer(const std::optional<LevelAnswer>& answer);

  /// The answers so far, track by track.
  std::vector<AnsweredTrack> answered() const;

  static constexpr std::size_t kMostPresented = 2;

 private:
  struct Track {
    std::size_t row = 0;
    std::size_t most_trials = 0;
    LevelRule rule{};
    Random random{0};
    AnsweredTrack answered{};
    std::size_t trials = 0;
  };

  /// The level of the next trial of a track; nothing when it is finished.
  static std::optional<double> next_level(const Track& track);
  void begin_round();
  bool is_place_of_catch_trial() const;
  Trial next_of_track(const TrialMaker& maker);
  Trial next_catch_trial(const TrialMaker& maker);
  /// Completes a trial with a level, the `count`-th with this stream of draws.
  Trial made(Trial trial, std::size_t row, double level, std::size_t count, const Random& draws,
             const TrialMaker& maker);

  const Protocol* protocol_;
  BlockRun run_{};
  std::vector<BlockRow> rows_{};
  std::vector<Track> tracks_{};
  std::vector<std::size_t>
      round_{};  // the tracks that still follow in this round, the next one last
  std::size_t rounds_ = 0;
  std::size_t trials_ = 0;
  std::size_t catch_trials_ = 0;
  std::optional<std::size_t> awaited_{};  // the track; nothing of a catch trial
};

/// The maximum number of trials of one run of a block with a procedure.
std::size_t most_trials_of(const Protocol& protocol, const Protocol::Block& block);

}  // namespace asperity

// Declares the tracks of one run of a block whose levels a procedure chooses.

#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "analysis/numbers/random.h"
#include "protocols/design/protocol.h"
#include "protocols/plan/roughness_matching.h"
#include "protocols/plan/trial_maker.h"

namespace asperity {

/// An answer that counts for a track, as a program receives it.
struct TrackAnswer {
  TrackStep of{};
  LevelAnswer answer{};
};

/// A step of a track that a program has to state before the session can continue.
struct LevelRequest {
  int block_ordinal = 0;
  std::string block{};
  TrackStep of{};
  std::size_t tracks = 0;  ///< of the run of the block
  FactorLevels factors{};  ///< the levels of the other factors
  External settings{};     ///< of the track
  std::vector<TrackAnswer>
      answers{};  ///< of all tracks of this run of the block, in the order of the trials
};

/// The rules of the tracks of each block with a procedure, by the name of the block; none of `External`. Sessions of one protocol can
/// share them, on several threads at a time, so that a table of likelihoods is made once.
using RulesByBlock = std::map<std::string, std::vector<LevelRule>, std::less<>>;
RulesByBlock rules_of(const Protocol& protocol);

/// The tracks of a block with a procedure: one for every combination of the other factors and every track of the
/// procedure, in this order.
///
/// A track also ends when it has presented `kMostPresented` times its maximum number of trials, answered or not.
///
/// Tracks are interleaved in rounds: in each round every track that is not finished has one trial, in random order
/// (`Block::Order::shuffle`). With the order `fixed` a track begins when the one before is finished.
///
/// Of a design with several types of trials, each track has all of them equally often, as far as possible.
///
/// With catch trials, one of every `CatchTrials::every` trials of the block is one, at a place that is drawn beforehand.
/// Their places do not depend on answers, and they do not change the levels of the tracks; answers determine only after
/// how many trials the block ends. A catch trial presents the easy level, or the standard twice (CatchType); its surfaces are
/// then the items "standard" and "standard_2".
///
/// The levels of the procedure `external` are supplied one by one: `request` returns what has to be supplied before
/// `next`. A track is asked for a level when its turn comes, not before, so that the level can depend on every answer.
class LevelTracks final {
 public:
  /// The protocol and the block must outlive the tracks. `rules`: those of the protocol; null makes those of the block.
  LevelTracks(const Protocol& protocol, BlockRun run, const RulesByBlock* rules = nullptr);

  const BlockRun& run() const noexcept { return run_; }
  /// Trials so far.
  std::size_t trials() const noexcept { return trials_; }

  /// The step that has to be supplied before `next`; nothing where none is missing.
  std::optional<LevelRequest> request();
  /// The step that `request` asks for: one of the levels of its settings, or the end of the track.
  ///
  /// Errors: std::logic_error where nothing is requested; std::invalid_argument for another level.
  void supply(const NextStep& step);
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
    std::variant<LevelRule, External> levels{};
    /// Until its trial is answered: as a program stated it, or as the rule determined it from the answers, once.
    std::optional<NextStep> next{};
    Random random{0};
    AnsweredTrack answered{};
    std::size_t trials = 0;
  };

  /// The level of the next trial of a track; nothing when it is finished.
  static std::optional<double> next_level(Track& track);
  /// Whether the track can have another trial.
  static bool is_open(Track& track);
  void settle_round();
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
  std::vector<TrackAnswer> answers_{};
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

// Declares the making of one trial: its surfaces and questions, once its factors are known.

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/numbers/random.h"
#include "protocols/design/protocol.h"
#include "protocols/design/roughness_match.h"
#include "protocols/design/trial.h"
#include "protocols/plan/block_rows.h"

namespace asperity {

/// What distinguishes one run of a block from the others of a session.
struct BlockRun {
  const Protocol::Run* run = nullptr;
  const Protocol::Block* block = nullptr;
  int ordinal = 0;       ///< 1-based within the session
  FactorLevels outer{};  ///< of the group, and of `Run::for_each`
  std::size_t part = 0;  ///< of the pairs, where participants share them
  Random random{0};      ///< the stream of this run
  /// Of the block that `equal_roughness` names; empty where the block was not run.
  std::vector<RoughnessMatch> matches{};
};

/// The surfaces of a trial in the listed order: where the block has pairs, with the levels of the pair of the row; where
/// its design has several types of trials, those of the type of the row. A second surface of a role counts as "ROLE_2".
std::vector<Protocol::Presented> surfaces_of(const Protocol::Block& block, const BlockRow& row);

/// Makes the trials of one session.
class TrialMaker final {
 public:
  /// The protocol must outlive the maker. `of_session` is the stream of the plan.
  TrialMaker(const Protocol& protocol, const Random& of_session)
      : protocol_(&protocol), of_session_(of_session) {}

  /// Completes a trial whose ordinal, repetition and factors are set. `surfaces`: in the order of presentation;
  /// `of_trial`: the stream of its options and phases.
  Trial make(Trial trial, const BlockRun& run, const std::vector<Protocol::Presented>& surfaces,
             const Random& of_trial) const;

 private:
  std::vector<std::string> pictures_of(const Protocol::TrialQuestionTemplate& question,
                                       Random of_trial) const;

  const Protocol* protocol_;
  Random of_session_;
};

/// `count` draws from `levels` in random order, each level equally often as far as possible. A longer series begins with
/// the shorter one.
std::vector<Level> balanced_draws(const std::vector<Level>& levels, std::size_t count,
                                  Random random);

}  // namespace asperity

// Declares which factors the trials of a block have, and the runs that set them.

#pragma once

#include <set>
#include <string>
#include <vector>

#include "protocols/design/protocol.h"

namespace asperity {

/// The runs of a block in the flow of its protocol, in order. The pointers are valid as long as the protocol.
std::vector<const Protocol::Run*> runs_of(const Protocol& protocol, const Protocol::Block& block);

/// The factors that a block crosses, lists or draws, and the one that `run` iterates (null: no run).
std::set<std::string> factors_set_by(const Protocol::Block& block, const Protocol::Run* run);

/// Whether the levels of a factor are values of a parameter that a block varies (`Block::vary`), which states them.
bool is_varied(const Protocol& protocol, const std::string& factor);

/// Whether a procedure chooses the levels of a block from the answers; not constant stimuli. That of a stored protocol
/// whose tracks could not be read does.
bool chooses_levels_from_answers(const Protocol::Block& block);

/// Whether the number of trials of the block's tracks does not depend on the responses; true without a procedure.
bool has_tracks_of_fixed_length(const Protocol::Block& block);

/// The question whose answers a procedure and a psychometric function are made of: the first one with a judgement. Null
/// if there is none.
const Protocol::TrialQuestionTemplate* judged_question(const Protocol::Block& block) noexcept;

/// Null where the block has no question of this name.
const Protocol::TrialQuestionTemplate* question_named(const Protocol::Block& block,
                                                      const std::string& name) noexcept;

/// The number of surfaces in a trial of the block; a design can present fewer than the block lists.
std::size_t surfaces_in_trial(const Protocol::Block& block) noexcept;

}  // namespace asperity

// Declares the groups of participants of a protocol.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocols/design/protocol.h"
#include "protocols/plan/block_rows.h"
#include "protocols/plan/permuted_blocks.h"
#include "protocols/plan/plan.h"

namespace asperity {

/// The groups of a protocol, as the text of their levels, in the declared order; empty without groups.
std::vector<std::string> groups_of(const Protocol& protocol);

/// Whether a text for these groups is for the participants of the group: one for no group in particular is for all. Without
/// groups in the protocol the group is empty.
bool is_for_group(const std::vector<std::string>& groups, std::string_view group);

/// The factor level that every trial of a participant of this group has. An empty text stands for the first group.
///
/// Errors: std::runtime_error for a text that is not a group of the protocol.
FactorLevels group_factor(const Protocol& protocol, const std::string& group);

/// The blocks in which the program assigns the groups; nullopt if it assigns them otherwise.
std::optional<PermutedBlocks> permuted_blocks_of(const Protocol& protocol);

/// The group of the participant who is assigned after `assigned` others, of a protocol with permuted blocks
/// (permuted_place).
std::string permuted_group(const Protocol& protocol, const std::string& mode, std::size_t assigned);

/// The allocation of the n-th simulated participant, from 0: groups in turn, and the rows of counterbalancing in turn
/// within each group. With an even number of groups every round begins one group later, so that participants whose
/// attributes alternate do not always belong to the same groups. With permuted blocks the group is that of the sequence of
/// the mode simulate.
Allocation allocation_in_turn(const Protocol& protocol, int n);

/// The allocations of the first `count` places of a study that is divided among stations, in order, for sessions of this mode:
/// by the same rule, with permuted blocks by the sequence of the mode. The seeds are left out.
std::vector<Allocation> allocations_in_turn(const Protocol& protocol, const std::string& mode,
                                            int count);

}  // namespace asperity

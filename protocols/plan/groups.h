// Declares the groups of participants of a protocol.

#pragma once

#include <string>
#include <vector>

#include "protocols/design/protocol.h"
#include "protocols/plan/block_rows.h"
#include "protocols/plan/plan.h"

namespace asperity {

/// The groups of a protocol, as the text of their levels, in the declared order; empty without groups.
std::vector<std::string> groups_of(const Protocol& protocol);

/// The factor level that every trial of a participant of this group has. An empty text stands for the first group.
///
/// Errors: std::runtime_error for a text that is not a group of the protocol.
FactorLevels group_factor(const Protocol& protocol, const std::string& group);

/// The allocation of the n-th simulated participant, from 0: groups in turn, and the rows of counterbalancing in turn
/// within each group. With an even number of groups every round begins one group later, so that participants whose
/// attributes alternate do not always belong to the same groups.
Allocation allocation_in_turn(const Protocol& protocol, int n);

}  // namespace asperity

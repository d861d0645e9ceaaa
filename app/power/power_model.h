// A protocol with all assumptions from which its studies are simulated without rendering.

#pragma once

#include <memory>
#include <vector>

#include "app/power/assumption.h"
#include "protocols/design/protocol.h"

namespace asperity {

struct PowerTables;

/// All assumptions of a protocol: of the questions of its main blocks, and of blocks with a procedure. Effects that a test of the
/// declared family concerns, and their standard deviations, have no value.
///
/// Errors: std::runtime_error for a question whose responses cannot be simulated without rendering, and for a procedure whose levels an
/// external program states; the message names the block, the kind and the remedy.
std::vector<Assumption> assumptions_of(const Protocol& protocol);

/// The number of participants with which every row of counterbalancing occurs equally often in every group.
int participants_per_round(const Protocol& protocol);

/// A protocol with all its assumptions, checked. It is shared by all simulated runs and threads, and never changed.
class PowerModel final {
 public:
  /// Errors: as `assumptions_of`; std::runtime_error listing assumptions without a value, with a value out of range, without a source,
  /// missing ones, and those that the protocol does not have.
  PowerModel(const Protocol& protocol, std::vector<Assumption> assumptions);

  const Protocol& protocol() const noexcept;
  const std::vector<Assumption>& assumptions() const noexcept { return assumptions_; }
  /// The same model with every effect at its null value; the standard deviations of the effects are kept.
  PowerModel at_null() const;
  /// Of the simulation.
  const PowerTables& tables() const noexcept { return *tables_; }

 private:
  std::vector<Assumption> assumptions_{};
  /// Shared by copies, because it does not change and refers to itself.
  std::shared_ptr<const PowerTables> tables_{};
};

}  // namespace asperity

// The response tables of a protocol with their values, by block and question. Seen by this folder only.

#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/findings/gathering/gathered_answers.h"
#include "app/power/assumption.h"
#include "protocols/design/protocol.h"
#include "protocols/kinds/experiment_kind.h"
#include "protocols/kinds/response_table.h"
#include "protocols/plan/level_tracks.h"

namespace asperity {

/// Whether the trials of a block have simulated responses: they are analysed, or they determine later trials.
bool has_simulated_responses(const Protocol::Block& block) noexcept;

/// The tabulated questions of the blocks with simulated responses that the flow runs, by block and in the order of the
/// questions. They refer to the protocol. Errors: as `assumptions_of`.
struct TabulatedBlock {
  struct OfQuestion {
    TabulatedQuestion asked;
    const ResponseTable* table = nullptr;
    bool is_of_block =
        true;  ///< its kind is that of the block; otherwise it accompanies the question of that kind
  };
  std::vector<OfQuestion> questions{};
};
std::map<std::string, TabulatedBlock, std::less<>> tabulated_blocks(const Protocol& protocol);

/// The name of an assumption.
std::string assumption_name(const TabulatedQuestion& asked, const std::string& parameter);

/// A protocol with its tables and their values. Never moved: its parts refer to each other.
struct PowerTables {
  PowerTables(const Protocol& of, std::span<const Assumption> assumptions);
  PowerTables(const PowerTables&) = delete;
  PowerTables& operator=(const PowerTables&) = delete;

  struct OfQuestion {
    const TabulatedBlock::OfQuestion* tabulated = nullptr;
    ResponseValues values{};
  };
  /// Null for a block without simulated responses.
  const std::vector<OfQuestion>* questions_of(std::string_view block) const;

  const Protocol protocol;
  const std::map<std::string, TabulatedBlock, std::less<>> blocks;
  std::map<std::string, std::vector<OfQuestion>, std::less<>> with_values{};
  const SessionGathering::OfProtocol gathered;
  const RulesByBlock rules;  ///< of all simulated sessions
};

}  // namespace asperity

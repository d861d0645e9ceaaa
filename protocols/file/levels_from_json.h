// Declares the completion of the keys "vary" and "procedure" of a block.

#pragma once

#include <set>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "protocols/design/protocol.h"

namespace asperity {

/// Completes the dimension of a block by what the presented stimuli state: the value of the standard, and the unit.
void complete_dimension(Protocol::Block& block, const Protocol& protocol,
                        const std::vector<ModelDeclaration>& models);

/// Declares the factor of a completed dimension in the protocol. A factor of the file (`of_file`) with this name remains, which the check of meaning reports. The levels of the factor
/// are those of the dimension, and that of the catch trials of the block's procedure.
void declare_dimension(Protocol::Block& block, Protocol& protocol,
                       const std::set<std::string>& of_file);

/// States in the settings of tracks that choices between so many alternatives are unforced: "cannot tell" is an option.
void declare_unforced(std::size_t alternatives, std::vector<ProcedureSettings>& tracks);

/// The key "procedure", with the levels of the block's completed dimension and the guess rate of its design.
Protocol::Block::LevelProcedure procedure_in(const nlohmann::json& object,
                                             const Dimension& dimension,
                                             const DiscriminationDesign& design);

}  // namespace asperity

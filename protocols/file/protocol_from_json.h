// Declares the conversion of a document that follows the schema to a Protocol.

#pragma once

#include <optional>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "protocols/design/protocol.h"

namespace asperity {

/// Converts a document that follows the schema, without checking its meaning. `models` declare the units of varied
/// parameters.
Protocol protocol_from_json(const nlohmann::json& root,
                            const std::vector<ModelDeclaration>& models);

/// The key `analysis` of any JSON; parts in another form count as absent.
AnalysisDeclaration analysis_declared_in(const nlohmann::json& root);
/// The key `estimation` of any JSON; parts in another form count as absent.
std::optional<EstimationDeclaration> estimation_declared_in(const nlohmann::json& root);

}  // namespace asperity

// A document that follows the schema, as a Protocol.

#pragma once

#include <nlohmann/json_fwd.hpp>

#include "protocols/design/protocol.h"

namespace asperity {

/// Reads what the schema allows; whether it makes sense is not looked at.
Protocol protocol_from_json(const nlohmann::json& root);

/// The key `analysis` of any JSON: what is not in this form is not there.
AnalysisDeclaration analysis_declared_in(const nlohmann::json& root);
/// Likewise the key `estimation`.
std::optional<EstimationDeclaration> estimation_declared_in(const nlohmann::json& root);

}  // namespace asperity

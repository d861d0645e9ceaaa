// Declares access to the nodes of the protocols' schema.

#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace asperity {

/// The schema of protocols, parsed once.
const nlohmann::json& schema_root();

/// The target of a "$ref"; any other node itself. `root` is the complete schema.
const nlohmann::json& resolved_node(const nlohmann::json& root, const nlohmann::json& schema);

/// The schema of a member; null if the schema does not describe it.
const nlohmann::json* member_schema(const nlohmann::json& root, const nlohmann::json& schema,
                                    const std::string& key);

}  // namespace asperity

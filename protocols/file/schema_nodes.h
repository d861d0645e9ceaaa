// Where in the schema of protocols a value is described.

#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace asperity {

/// The schema of protocols, read once.
const nlohmann::json& schema_root();

/// What a "$ref" stands for; any other node itself. `root` is the whole schema.
const nlohmann::json& resolved_node(const nlohmann::json& root, const nlohmann::json& schema);

/// Keys that are remarks of an author: "x-…" and "$comment".
bool is_comment(const std::string& key);

/// The schema of a member; null where the schema states nothing about it.
const nlohmann::json* member_schema(const nlohmann::json& root, const nlohmann::json& schema,
                                    const std::string& key);

}  // namespace asperity

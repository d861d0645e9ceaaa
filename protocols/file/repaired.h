// What of a document has the form of a protocol, so that its meaning can be looked at while its form is wrong elsewhere.

#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "protocols/file/json_document.h"

namespace asperity {

/// A document in which every value that the schema refuses was replaced by one that it allows, or left out.
///
/// What a replaced value should be cannot be known: where it is one of a few, each of these stands in one of the `roots`,
/// and where it is a number, the default, a small and a large one. What holds in all of them does not depend on it. Keys
/// that are nearly one of the schema's are taken for it.
struct Repair {
  std::vector<nlohmann::json> roots{};  ///< each follows the schema; none where too much is missing
  std::vector<std::string> places{};    ///< pointers of what was replaced or left out
};
Repair repaired(const JsonDocument& document);

/// Whether a finding at `pointer` can be a consequence of the repair: it is about the same object as such a place, lies
/// around it, or quotes its name; or it is about a block, whose trials are made of the levels of factors, one of which was
/// repaired. A level that names nothing is wrong whatever else its factor has.
bool may_follow_from(const Repair& repair, const std::string& pointer, const std::string& message);

}  // namespace asperity

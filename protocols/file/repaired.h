// Declares the part of a document that has the form of a protocol, for checks of its meaning despite errors of form elsewhere.

#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "protocols/file/json_document.h"

namespace asperity {

/// A document in which every value that does not have the form of its key is replaced by a permitted one or left out.
///
/// The correct value of a replacement is unknown. If it is one of a few, each of these occurs in one of the `roots`;
/// for a number they contain the default, a small and a large one, for a name the declared ones. Findings that hold in
/// all roots do not depend on the replacement. Unknown keys are treated as the declared key that is most similar.
struct Repair {
  std::vector<nlohmann::json> roots{};  ///< each has the form; empty if too much is missing
  std::vector<std::string> places{};    ///< pointers of the replaced and left-out values
};
Repair repaired(const JsonDocument& document);

/// Whether a finding at `pointer` can be a consequence of the repair: it concerns the same object as a replaced value,
/// contains or lies in such a value, or quotes its name; or it concerns a block while a factor was repaired, since a
/// block's trials consist of levels. A level with an unknown name is invalid regardless of the factor's other levels.
bool may_follow_from(const Repair& repair, const std::string& pointer, const Phrase& message);

}  // namespace asperity

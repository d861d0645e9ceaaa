// Declares the removal of problems that are consequences of others.

#pragma once

#include <vector>

#include "protocols/file/diagnostic.h"
#include "protocols/file/json_document.h"
#include "stimuli/properties/parameter.h"

namespace asperity {

/// The names that a document declares: the keys of its objects of objects, such as textures, factors and blocks.
std::vector<std::string> declared_names(const nlohmann::json& root);

/// Removes the problems of meaning that vanish when the value at another problem is corrected: one misspelt name of a
/// factor is one problem, not one for every block that depends on it. A correction is tried where the value has a probable
/// one: a similar name, a number for a number in quotation marks, or a name that another problem is about. The document
/// has the form of a protocol; a protocol without the removed problems is still invalid.
std::vector<Diagnostic> without_follow_ups(std::vector<Diagnostic> problems,
                                           const JsonDocument& document,
                                           const std::vector<ModelDeclaration>& models);

}  // namespace asperity

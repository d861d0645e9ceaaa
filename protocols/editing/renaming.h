// Declares the renaming of what has a name in a protocol.

#pragma once

#include <string>
#include <string_view>

#include "protocols/editing/text_change.h"
#include "protocols/file/json_document.h"

namespace asperity {

/// Renames a texture, a factor, a level or anything else that has a name in the protocol, in one walk over it: where it is
/// declared and in all references, as keys, values and in formulas. A name that is one thing in two registries, such as
/// a level that is a texture, changes in both. `registry` and names: see names_in.h.
///
/// Errors: ProtocolError with a place if the protocol does not declare the name (such as that of a force model), if
/// `after` is taken, or if it cannot be a name.
TextChanges rename(const JsonDocument& protocol, const std::string& registry, std::string_view name,
                   std::string_view after);

/// The same, except that a level that is a texture, or another thing with a name, becomes another one of them, and nothing else
/// is renamed.
TextChanges rename_or_replace(const JsonDocument& protocol, const std::string& registry,
                              std::string_view name, std::string_view after);

}  // namespace asperity

// Declares the value of a new entry of a list whose entries are names, words or levels.

#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "protocols/file/json_document.h"
#include "protocols/keys/names_in.h"
#include "protocols/shapes/shape.h"

namespace asperity {

/// A value that is not in the list yet, for an entry before the one at `index`, or at the end:
/// - the first name or word that the list does not have,
/// - of a factor whose levels are names, such as textures, the first one that is not a level,
/// - otherwise behind a level that is a number the next one (the step before it is continued, else it is 1), within the limits,
/// - behind a name this name with a number.
/// nullopt for other lists, and where the first level is not known. `names`: those of the protocol (offered_names.h).
///
/// Errors: ProtocolError with the place of the list if all names or words are in it and none can occur twice.
std::optional<nlohmann::ordered_json> new_entry(const JsonDocument& protocol,
                                                const ProtocolNames& names, const std::string& list,
                                                const ListShape& shape, std::size_t index);

}  // namespace asperity

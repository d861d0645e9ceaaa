// Declares the names that the fields of a form offer.

#pragma once

#include <string>
#include <vector>

#include "protocols/file/json_document.h"
#include "protocols/keys/names_in.h"
#include "protocols/shapes/shape.h"

namespace asperity {

/// `names_in` the protocol, with the names that its analysis can have: tests with what they answer, items, scales.
ProtocolNames names_of_form(const JsonDocument& protocol);

/// The names that a reference of this shape can have, where they follow from the blocks and no value declares them; null where values
/// declare them.
const std::vector<ProtocolNames::Offered>* offered_in(const ProtocolNames& names,
                                                      const NameShape& shape);

/// All names that a reference of this shape can have.
std::vector<std::string> offered_names(const ProtocolNames& names, const NameShape& shape);

}  // namespace asperity

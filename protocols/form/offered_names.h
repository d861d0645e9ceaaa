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

/// Those that follow from the blocks, which a reference of this shape can name; null: other names.
const std::vector<ProtocolNames::Offered>* offered_in(const ProtocolNames& names,
                                                      const NameShape& shape);

/// What a reference of this shape can name, in the order of the text.
std::vector<std::string> offered_names(const ProtocolNames& names, const NameShape& shape);

}  // namespace asperity

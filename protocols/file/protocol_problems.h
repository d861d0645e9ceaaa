// Everything that is wrong with the text of a protocol, of all layers at once.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocols/design/protocol.h"
#include "protocols/file/diagnostic.h"
#include "protocols/file/repaired.h"
#include "stimuli/properties/parameter.h"

namespace asperity {

/// A text and how far it is a protocol.
struct ProtocolReading {
  std::vector<Diagnostic> problems{};  ///< in the order of lines
  /// The protocol, where there are no problems; else as much of it as has the required form, for further checks.
  /// None where keys occur twice, since its text is read again then.
  std::optional<Protocol> protocol{};
  bool has_form = false;  ///< the schema holds: nothing of the protocol is a replacement
  Repair repair{};        ///< what was replaced where it does not
};

/// Reads as far as it goes. A text that is not JSON has the problem of its syntax alone. Where the schema does not hold, the
/// meaning is looked at in what remains, and a problem of it is reported where it does not depend on what is wrong with
/// the form. Arguments as of `read_protocol`. Never throws because of the text.
ProtocolReading read_protocol_with_problems(std::string_view text, const std::string& file_name,
                                            const std::vector<ModelDeclaration>& models);

void sort_by_line(std::vector<Diagnostic>& diagnostics);

}  // namespace asperity

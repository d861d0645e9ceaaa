// Declares the search for all problems in the text of a protocol, in all layers at once.

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

/// The result of reading a text that may not be a valid protocol.
struct ProtocolReading {
  std::vector<Diagnostic> problems{};  ///< in the order of lines
  /// The protocol if there are no problems; otherwise the part of it that has the required form, for further checks.
  /// nullopt if keys occur twice, since the text is read again in this case.
  std::optional<Protocol> protocol{};
  bool has_form = false;  ///< the schema is met: no part of the protocol is a replacement
  Repair repair{};        ///< the replacements if the schema is not met
};

/// Reads as much as possible. For a text that is not JSON, only the syntax error is reported. If the schema is not met,
/// the meaning of the rest is checked, and a problem is reported if it does not depend on the errors of form. Arguments
/// as in `read_protocol`. The text never causes an exception.
ProtocolReading read_protocol_with_problems(std::string_view text, const std::string& file_name,
                                            const std::vector<ModelDeclaration>& models);

void sort_by_line(std::vector<Diagnostic>& diagnostics);

}  // namespace asperity

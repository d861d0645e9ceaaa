// JSON → Protocol, or every reason why not.

#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "protocols/design/protocol.h"
#include "protocols/file/diagnostic.h"
#include "stimuli/properties/parameter.h"

namespace asperity {

/// Reads and checks a protocol.
///
/// Three layers, each of which reports all it finds: JSON (syntax, duplicate keys), schema
/// (protocols/schema/protocol-1.schema.json, draft-07), meaning (references, models and their
/// parameters against `models`, order constraints that cannot be met, bands against the force
/// limit, criteria, blocks never run, …). All are reported at once (protocol_problems.h).
///
/// `models` are the declarations of the force models that there are. Files of textures are not
/// looked for here (see `files_of`): the reader knows no study.
///
/// Errors: ProtocolError.
Protocol read_protocol(std::string_view text, const std::string& file_name,
                       const std::vector<ModelDeclaration>& models);

/// One file that a protocol names, and where it names it.
struct NamedFile {
  std::string path{};  ///< study-relative
  Diagnostic place{};  ///< filled but for its message
  enum class Kind { height_field, picture, textured_mesh, speech };
  Kind kind = Kind::picture;
};
/// Where the body of that name stands; filled but for its message.
Diagnostic place_of_body(const Protocol& protocol, const std::string& file_name,
                         const std::string& body);
/// Likewise of the template of stimuli of that name.
Diagnostic place_of_stimulus(const Protocol& protocol, const std::string& file_name,
                             const std::string& stimulus_template);
std::vector<NamedFile> files_of(const Protocol& protocol, const std::string& file_name);

}  // namespace asperity

// Declares the reader of protocol files, which returns a Protocol or all problems.

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
/// The check has three layers: JSON (syntax, duplicate keys), schema (protocol_schema() of library_protocols.h,
/// draft-07), meaning (references, models and their parameters against `models`, order constraints that cannot be met,
/// bands against the force limit, criteria, blocks never run, …). All problems of all layers are reported at once
/// (protocol_problems.h).
///
/// `models` are the declarations of the available force models. The existence of texture files is not checked here (see
/// `files_of`): the reader does not access the study.
///
/// Errors: ProtocolError.
Protocol read_protocol(std::string_view text, const std::string& file_name,
                       const std::vector<ModelDeclaration>& models);

/// A file that a protocol names, and the location of its name.
struct NamedFile {
  std::string path{};  ///< study-relative
  Diagnostic place{};  ///< complete except for its message
  /// For code that reads the file. `asset`: of a role that force models declare.
  enum class Kind { height_field, picture, asset, textured_mesh, speech };
  Kind kind = Kind::picture;
};
/// All files of a study of which the named one consists: a height field has a sidecar.
std::vector<std::string> paths_of(const NamedFile& named);
/// All files that a protocol names: the one list of them, for everything that hashes, checks or lists files.
std::vector<NamedFile> files_of(const Protocol& protocol, const std::string& file_name);
/// The same with the JSON pointers of their places alone, without reading the source of the protocol.
std::vector<NamedFile> files_of(const Protocol& protocol);

}  // namespace asperity

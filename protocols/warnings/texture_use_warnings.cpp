// Compares the textures with the names in the protocol.

#include "protocols/warnings/texture_use_warnings.h"

#include "protocols/design/json_pointer.h"
#include "protocols/design/wording.h"
#include "protocols/file/json_document.h"
#include "protocols/keys/names_in.h"

namespace asperity {

std::vector<Diagnostic> warnings_about_texture_use(const Protocol& protocol,
                                                   const std::string& file_name) {
  const JsonDocument document(protocol.source, file_name);
  const ProtocolNames names = names_in(document.root());
  std::vector<Diagnostic> found{};
  for (const auto& [name, texture] : protocol.textures) {
    const std::string pointer = pointer_to("/textures", name);
    const NameUse* const declared = declaration_at(names, pointer, true);
    if (declared == nullptr || uses_of(names, declared->registry, name).size() > 1) continue;
    found.push_back(
        document.at(pointer, phrase("Protocols",
                                    "no stimulus, level, question or body uses the texture %1; "
                                    "use it, or remove it")
                                 .with(in_quotes(name))));
  }
  return found;
}

}  // namespace asperity

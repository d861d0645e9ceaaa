// Implements the reading of a protocol and the list of its files.

#include "protocols/file/protocol_reader.h"

#include <string>
#include <utility>

#include "protocols/design/json_pointer.h"
#include "protocols/file/json_document.h"
#include "protocols/file/protocol_problems.h"

namespace asperity {

Protocol read_protocol(std::string_view text, const std::string& file_name,
                       const std::vector<ModelDeclaration>& models) {
  ProtocolReading reading = read_protocol_with_problems(text, file_name, models);
  if (!reading.problems.empty()) throw ProtocolError(std::move(reading.problems));
  return std::move(*reading.protocol);
}

std::vector<std::string> paths_of(const NamedFile& named) {
  if (named.kind != NamedFile::Kind::height_field) return {named.path};
  return {named.path, named.path + ".json"};
}

std::vector<NamedFile> files_of(const Protocol& protocol) {
  std::vector<NamedFile> files{};
  const auto add = [&files](const std::optional<std::string>& path, std::string pointer,
                            NamedFile::Kind kind) {
    if (path) files.push_back({*path, {.pointer = std::move(pointer)}, kind});
  };
  for (const auto& [name, texture] : protocol.textures) {
    const std::string place = pointer_to("/textures", name);
    add(texture.height_field, place + "/height_field", NamedFile::Kind::height_field);
    add(texture.picture, place + "/picture", NamedFile::Kind::picture);
    add(texture.true_height_field, place + "/true_height_field", NamedFile::Kind::height_field);
    for (const auto& [role, path] : texture.assets) {
      add(path, pointer_to(place + "/assets", role), NamedFile::Kind::asset);
    }
  }
  for (const auto& [name, body] : protocol.bodies) {
    add(body.mesh, pointer_to("/bodies", name) + "/mesh", NamedFile::Kind::textured_mesh);
  }
  for (const auto& [cue, path] : protocol.speech) {
    add(path, pointer_to("/environment/speech", cue), NamedFile::Kind::speech);
  }
  return files;
}

std::vector<NamedFile> files_of(const Protocol& protocol, const std::string& file_name) {
  const JsonDocument document(protocol.source, file_name);
  std::vector<NamedFile> files = files_of(protocol);
  for (NamedFile& file : files) file.place = document.at(file.place.pointer, Phrase());
  return files;
}

}  // namespace asperity

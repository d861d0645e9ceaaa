// Finds the first free name, and changes the name in the protocol accordingly.

#include "app/tasks/protocol_templates.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "app/study_files/study_protocols.h"
#include "results_schema/files/atomic_file.h"

namespace asperity {

namespace {

const LibraryProtocol& library_protocol(std::string_view name) {
  std::string names{};
  for (const LibraryProtocol& protocol : library_protocols()) {
    if (protocol.name == name) return protocol;
    names += (names.empty() ? "" : ", ") + std::string(protocol.name);
  }
  throw std::invalid_argument("the library has no protocol \"" + std::string(name) +
                              "\"; choose one of: " + names);
}

}  // namespace

std::filesystem::path protocol_from_template(const std::filesystem::path& study,
                                             std::string_view name) {
  const LibraryProtocol& protocol = library_protocol(name);
  const std::string first(name);
  std::string free_name = first;
  const auto is_taken = [&] {
    const std::filesystem::path file = study / "protocols" / free_name;
    const auto exists = [&file](std::string_view ending) {
      return std::filesystem::exists(file.string() + std::string(ending) + ".json");
    };
    return exists("") || std::any_of(protocol.translations.begin(), protocol.translations.end(),
                                     [&exists](const LibraryTranslation& each) {
                                       return exists('.' + std::string(each.language));
                                     });
  };
  for (int number = 2; is_taken(); ++number) {
    free_name = first + '_' + std::to_string(number);
  }
  return write_library_protocol(study, protocol, free_name);
}

std::filesystem::path write_library_protocol(const std::filesystem::path& study,
                                             const LibraryProtocol& protocol,
                                             const std::string& name) {
  const std::filesystem::path folder = study / "protocols";
  const std::filesystem::path file = folder / (name + ".json");
  const std::string text(protocol.text);
  write_file(file, name == protocol.name ? text : with_protocol_name(text, name),
             Overwrite::refuse);
  for (const LibraryTranslation& each : protocol.translations) {
    write_file(folder / (name + '.' + std::string(each.language) + ".json"), each.text,
               Overwrite::refuse);
  }
  return file;
}

}  // namespace asperity

#include "app/tasks/protocol_templates.h"

#include <stdexcept>
#include <string>

#include "app/study_files/study_protocols.h"
#include "protocols/file/library_protocols.h"
#include "results_schema/files/atomic_file.h"

namespace asperity {

namespace {

const LibraryProtocol& library_protocol(std::string_view name, std::string_view language) {
  std::string names{};
  for (const LibraryProtocol& protocol : library_protocols(language)) {
    if (protocol.name == name) return protocol;
    names += (names.empty() ? "" : ", ") + std::string(protocol.name);
  }
  throw std::invalid_argument(
      "the library has no protocol \"" + std::string(name) + "\" in the language \"" +
      std::string(language) + "\"; " +
      (names.empty() ? "use the language en or de" : "choose one of: " + names));
}

}  // namespace

std::filesystem::path protocol_from_template(const std::filesystem::path& study,
                                             std::string_view name, std::string_view language) {
  const LibraryProtocol& protocol = library_protocol(name, language);
  const std::string first(name);
  std::string free_name = first;
  const auto file_of = [&study](const std::string& stem) {
    return study / "protocols" / (stem + ".json");
  };
  for (int number = 2; std::filesystem::exists(file_of(free_name)); ++number) {
    free_name = first + '_' + std::to_string(number);
  }
  const std::string text(protocol.text);
  write_file(file_of(free_name), free_name == first ? text : with_protocol_name(text, free_name),
             Overwrite::refuse);
  return file_of(free_name);
}

}  // namespace asperity

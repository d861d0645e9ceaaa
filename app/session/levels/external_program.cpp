// Finds the blocks with an external procedure, and stores path, arguments and checksum of the program.

#include "app/session/levels/external_program.h"

#include <algorithm>
#include <system_error>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "results_schema/hashes/sha256.h"
#include "results_schema/study.h"

namespace asperity {

namespace {

std::string stored_checksum(const std::filesystem::path& file) {
  try {
    return sha256_of_file(file);
  } catch (const ResultsError& error) {
    throw PhrasedError(
        phrase("ExternalProgram",
               "the file %1 cannot be read, and its checksum is stored with the session: %2; check "
               "the permissions of the file, or correct the external program and its arguments")
            .with(file.string(), std::string(error.what())));
  }
}

}  // namespace

std::vector<std::string> blocks_of_external_program(const Protocol& protocol) {
  std::vector<std::string> names{};
  for (const auto& [name, block] : protocol.blocks) {
    if (!block.procedure) continue;
    const std::vector<ProcedureSettings>& tracks = block.procedure->tracks;
    const bool is_external =
        std::any_of(tracks.begin(), tracks.end(), [](const ProcedureSettings& settings) {
          return std::holds_alternative<External>(settings);
        });
    if (is_external) names.push_back(name);
  }
  return names;
}

std::optional<Phrase> complaint_about_program(const Protocol& protocol,
                                              const std::optional<ExternalProgram>& program) {
  const std::vector<std::string> blocks = blocks_of_external_program(protocol);
  if (!program) {
    if (blocks.empty()) return std::nullopt;
    return phrase(
               "ExternalProgram",
               "the levels of the block \"%1\" come from an external program, and none is given; "
               "give it with --external PROGRAM, or choose it in the window")
        .with(blocks.front());
  }
  if (blocks.empty()) {
    return phrase("ExternalProgram",
                  "the protocol \"%1\" takes no levels from an external program; leave out the "
                  "program %2, or set the procedure of a block to \"external\"")
        .with(protocol.name, program->file.string());
  }
  std::error_code error{};
  if (!std::filesystem::is_regular_file(program->file, error)) {
    return phrase("ExternalProgram",
                  "the external program %1 does not exist or is not a file; give the path of the "
                  "program itself")
        .with(program->file.string());
  }
  if (::access(program->file.c_str(), X_OK) != 0) {
    return phrase("ExternalProgram",
                  "the external program %1 cannot be executed; make it executable (chmod +x), and "
                  "begin a script with the line #! and its interpreter")
        .with(program->file.string());
  }
  return std::nullopt;
}

void require_program(const Protocol& protocol, const std::optional<ExternalProgram>& program) {
  if (const auto complaint = complaint_about_program(protocol, program)) {
    throw PhrasedError(*complaint);
  }
  if (program) provenance_json(*program);  // each file can be read
}

std::string provenance_json(const ExternalProgram& program) {
  nlohmann::ordered_json json{{"program", program.name()},
                              {"sha256", stored_checksum(program.file)},
                              {"arguments", program.arguments}};
  for (const std::string& argument : program.arguments) {
    std::error_code error{};
    if (!std::filesystem::is_regular_file(argument, error)) continue;
    json["argument_sha256"][argument] = stored_checksum(argument);
  }
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace asperity

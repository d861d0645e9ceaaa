// Lists participants, seed, recordings, device, protocols and force models as JSON.

#include "app/tasks/simulation/simulation_declaration.h"

#include <filesystem>

#include <nlohmann/json.hpp>

#include "app/session/session_setup.h"
#include "app/tasks/protocol_files.h"
#include "results_schema/hashes/sha256.h"

namespace asperity {

const char* text_of(Recordings recordings) {
  switch (recordings) {
    case Recordings::all:
      return "all";
    case Recordings::first:
      return "first";
    case Recordings::none:
      return "none";
  }
  return "";
}

std::string declaration_of(const SimulationInputs& inputs, const ModelRegistry& models) {
  nlohmann::ordered_json json{{"participants", inputs.participants},
                              {"seed", std::to_string(inputs.seed)},
                              {"recordings", text_of(inputs.recordings)},
                              {"device", inputs.device},
                              {"protocols", nlohmann::ordered_json::array()}};
  for (const std::filesystem::path& file : inputs.protocols) {
    const Protocol protocol = load_protocol(file, models, inputs.study);
    auto files = nlohmann::ordered_json::object();
    for (const StimulusFileRow& row : hash_files(protocol, inputs.study)) {
      files[row.path] = row.sha256;
    }
    json["protocols"].push_back({{"name", protocol.name},
                                 {"version", protocol.version},
                                 {"sha256", sha256_of(protocol.source)},
                                 {"files_sha256", files}});
  }
  if (inputs.on_gpu) json["compute"] = *inputs.on_gpu ? "gpu" : "cpu";
  if (inputs.level_program) {
    json["external"] = nlohmann::ordered_json::parse(provenance_json(*inputs.level_program));
  }
  for (const ForceModel& model : models.models()) {
    if (model.plugin) json["plugins_sha256"][model.declaration.id] = model.plugin->sha256;
  }
  return json.dump();
}

}  // namespace asperity

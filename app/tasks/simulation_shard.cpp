#include "app/tasks/simulation_shard.h"

#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <system_error>

#include <nlohmann/json.hpp>

#include "app/session/session_setup.h"
#include "app/shards/study_shard.h"
#include "app/study_files/program.h"
#include "app/tasks/protocol_files.h"
#include "results_schema/hashes/sha256.h"
#include "results_schema/study.h"
#include "results_schema/study_sharing.h"

namespace asperity {

namespace {

/// A new folder that no other process has, removed with what is in it.
class WorkFolder final {
 public:
  /// `remedy` completes the error.
  WorkFolder(const std::filesystem::path& place, const std::string& beginning,
             const std::string& remedy) {
    std::string name = (place / (beginning + "XXXXXX")).string();
    if (::mkdtemp(name.data()) == nullptr) {
      const std::string reason = std::generic_category().message(errno);
      throw std::runtime_error("no folder can be made in " + place.string() + " (" + reason +
                               "); " + remedy);
    }
    path_ = name;
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  ~WorkFolder() {
    std::error_code left{};
    std::filesystem::remove_all(path_, left);
  }
  const std::filesystem::path& path() const noexcept { return path_; }

 private:
  std::filesystem::path path_{};
};

/// TMPDIR, or /tmp.
std::filesystem::path folder_for_temporary_files() {
  std::error_code error{};
  std::filesystem::path folder = std::filesystem::temp_directory_path(error);
  if (!error) return folder;
  const char* const stated = std::getenv("TMPDIR");
  throw std::runtime_error("the folder for temporary files, " +
                           std::string(stated == nullptr ? "/tmp" : stated) + ", cannot be used (" +
                           error.message() + "); set TMPDIR to a folder that you may write to");
}

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

/// Everything that determines the rows, except the program.
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

/// The study from which all shards are made. One that has participants would give them to each of the shards.
void require_no_participants(const Study& study) {
  if (study.participants().empty() && study.withdrawals().empty()) return;
  throw std::runtime_error(
      "the study " + study.folder().string() +
      " has participants already, and a simulation is divided only for a study "
      "without any; name a new study with the same stimuli, and merge the studies "
      "afterwards");
}

/// What every shard begins with.
void make_study(const std::filesystem::path& folder, const std::filesystem::path& whole) {
  if (Study::exists(whole)) {
    const Study study = Study::open(whole, Access::read_only);
    require_no_participants(study);
    study.copy_to(folder);
  } else {
    const std::filesystem::path path = std::filesystem::absolute(whole).lexically_normal();
    Study::create(folder, (path.has_filename() ? path : path.parent_path()).filename().string());
  }
}

/// Copies the study, complete or not at all. Where another process was first with the same shard, its study is kept.
///
/// The copy is made in a folder that no other process has, and renamed: what a killed process left on a network file system, where
/// it cannot be determined whether a process still writes it, does not keep the shard from being stored.
void publish(const std::filesystem::path& from, const std::filesystem::path& to,
             const ShardIdentity& identity) {
  const std::filesystem::path parent = std::filesystem::absolute(to).parent_path();
  make_folders(parent);
  const WorkFolder next_to(parent, to.filename().string() + ".part-", "change its permissions");
  const std::filesystem::path copy = next_to.path() / "content";
  Study::open(from, Access::read_only).copy_to(copy);
  std::error_code error{};
  std::filesystem::rename(copy, to, error);  // not onto a folder that has files
  if (!error || is_stored_study(to, identity)) return;
  throw ResultsError("the study " + to.string() + " cannot be made (" + error.message() +
                         "); change the permissions of " + parent.string() +
                         ", then simulate this shard again",
                     to, error.value());
}

}  // namespace

SimulatedShard simulate_shard(const SimulationInputs& inputs, const ModelRegistry& models,
                              const std::stop_token& stop,
                              const std::function<void(double)>& progress,
                              const std::function<void(const AttemptDone&)>& done) {
  const Shard& shard = inputs.shard.value();
  require_items(shard, static_cast<std::size_t>(inputs.participants), "participants");
  SimulatedShard simulated{.study = shard_path(inputs.study, shard)};
  const ShardIdentity identity{.whole = {.command = "simulate",
                                         .declaration = declaration_of(inputs, models),
                                         .results = static_cast<std::size_t>(inputs.participants),
                                         .program = numerical_identity()},
                               .shard = shard};
  if (is_stored_study(simulated.study, identity)) return simulated;
  const WorkFolder work(folder_for_temporary_files(), "asperity-shard-",
                        "set TMPDIR to a folder that you may write to");
  SimulationInputs own = inputs;
  own.resume = false;
  own.study = work.path() / "study";
  make_study(own.study, inputs.study);
  simulated.result = simulate(own, models, stop, progress, done);
  write_study_shard(own.study, identity);
  publish(own.study, simulated.study, identity);
  return simulated;
}

}  // namespace asperity

// Reads the store and the folders, and collects the problems, progress and users of each file.

#include "app/tasks/study_overview.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <exception>
#include <fstream>
#include <map>
#include <set>
#include <span>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include <glm/common.hpp>
#include <nlohmann/json.hpp>

#include "analysis/numbers/random.h"
#include "app/plugins/stored_plugins.h"
#include "app/session/session_setup.h"
#include "app/session/stimulus_builder.h"
#include "app/study_files/height_field_files.h"
#include "app/study_files/protocol_languages.h"
#include "app/study_files/textured_mesh_files.h"
#include "app/tasks/protocol_files.h"
#include "app/tasks/unfinished_session.h"
#include "app/tasks/warnings/session_warnings.h"
#include "app/words/phrase_of_error.h"
#include "device/simulated_device.h"
#include "protocols/file/protocol_problems.h"
#include "protocols/file/protocol_reader.h"
#include "protocols/file/stored_protocol.h"
#include "protocols/plan/course.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/files/folder_entries.h"
#include "results_schema/hashes/sha256.h"
#include "stimuli/photographs/preview.h"

namespace asperity {

namespace {

/// Regular files of a folder, by name; none where there is no such folder.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files{};
  std::error_code ignored{};
  for (const auto& entry : entries_in(folder)) {
    if (entry.is_regular_file(ignored)) files.push_back(entry.path());
  }
  return files;
}

bool is_ended_by_rule(const Study& study, const SessionRow& row, const ProtocolRow& protocol) {
  if (row.state != SessionState::stopped) return false;
  const ProtocolCheck check = check_protocol_text(protocol.source, protocol.name,
                                                  with_stored_plugins(built_in_models(), study),
                                                  std::nullopt, std::nullopt);
  return check.protocol && has_ended_by_rule(study, *check.protocol, row);
}

SessionOverview overview_of(const Study& study, const SessionRow& row, const ProtocolRow& protocol,
                            const SessionCounts& counts) {
  SessionOverview overview{};
  overview.row = row;
  overview.protocol_name = protocol.name;
  overview.protocol_version = protocol.version;
  overview.planned_trials = counts.planned_trials;
  overview.planned_is_estimated = counts.planned_is_estimated;
  overview.notes = counts.notes;
  overview.done_trials = counts.done_trials;
  overview.attempts = counts.attempts;
  overview.duration_s = counts.running_s;
  overview.is_running = is_running(study, row);
  overview.ended_by_rule = is_ended_by_rule(study, row, protocol);
  return overview;
}

/// A simulated date is not comparable.
bool began_before(const SessionRow& a, const SessionRow& b) {
  const bool made_up = has_made_up_dates(a);
  if (made_up != has_made_up_dates(b)) return made_up;
  return a.started_utc < b.started_utc;
}

/// How many sessions of a protocol each participant has completed.
using Completed = std::map<std::string, int>;

void count_progress(ProtocolOverview& overview, const std::vector<SessionRow>& sessions,
                    const std::map<std::int64_t, std::string>& names,
                    const std::set<std::string>& virtual_people) {
  Completed people{};
  Completed virtual_ones{};
  for (const SessionRow& session : sessions) {
    if (names.at(session.protocol_id) != overview.name()) continue;
    if (!overview.last_session || !began_before(session, *overview.last_session)) {
      overview.last_session = session;
    }
    if (session.state != SessionState::completed || session.withdrawn) continue;
    if (virtual_people.contains(session.participant)) {
      ++virtual_ones[session.participant];
    } else if (session.mode == SessionMode::run) {
      ++people[session.participant];
    }
  }
  const int wanted = overview.read().sessions;
  const auto done = [wanted](const Completed& completed) {
    return static_cast<int>(
        std::count_if(completed.begin(), completed.end(),
                      [wanted](const auto& entry) { return entry.second >= wanted; }));
  };
  overview.people_done = done(people);
  overview.virtual_done = done(virtual_ones);
}

/// Also one that does not exist; empty where none is stated.
std::string stated_kind(const std::string& source) {
  const auto protocol = nlohmann::json::parse(source, nullptr, false);
  const bool has_kind =
      protocol.is_object() && protocol.contains("kind") && protocol.at("kind").is_string();
  return has_kind ? protocol.at("kind").get<std::string>() : std::string();
}

/// Which protocols of the study name each file.
struct ProtocolFile {
  std::filesystem::path file{};
  Protocol protocol{};
};

/// Those without a problem: the problems of the others are reported where protocols are listed.
std::vector<ProtocolFile> sound_protocols(const std::filesystem::path& study,
                                          const ModelRegistry& models) {
  std::vector<ProtocolFile> protocols{};
  for (const std::filesystem::path& file : protocol_files(study)) {
    try {
      protocols.push_back({file, load_protocol(file, models, study)});
    } catch (const std::exception&) {
      continue;
    }
  }
  return protocols;
}

std::map<std::string, std::vector<std::string>> users_of_files(
    const std::vector<ProtocolFile>& protocols) {
  std::map<std::string, std::vector<std::string>> users{};
  for (const auto& [file, protocol] : protocols) {
    std::set<std::string> named{};
    for (const NamedFile& each : files_of(protocol)) named.insert(each.path);
    for (const std::string& path : named) users[path].push_back(protocol.name);
  }
  return users;
}

/// Files of roles that force models declare.
std::set<std::string> declared_assets_of(const std::vector<ProtocolFile>& protocols) {
  std::set<std::string> assets{};
  for (const auto& [file, protocol] : protocols) {
    for (const NamedFile& each : files_of(protocol)) {
      if (each.kind == NamedFile::Kind::asset) assets.insert(each.path);
    }
  }
  return assets;
}

/// Those that note the rendering with their surfaces.
std::vector<std::string> protocols_with_rendering(const std::vector<ProtocolFile>& protocols,
                                                  const std::string& name) {
  std::vector<std::string> names{};
  for (const auto& [file, protocol] : protocols) {
    for (const std::string& rendering : renderings_in(protocol.source)) {
      if (rendering != name) continue;
      names.push_back(protocol.name);
      break;
    }
  }
  return names;
}

/// Protocols and the names of their bodies that are shapes.
std::vector<std::pair<const Protocol*, std::string>> shapes_of(
    const std::vector<ProtocolFile>& protocols) {
  std::vector<std::pair<const Protocol*, std::string>> shapes{};
  for (const ProtocolFile& each : protocols) {
    for (const auto& [name, body] : each.protocol.bodies) {
      if (body.shape) shapes.emplace_back(&each.protocol, name);
    }
  }
  return shapes;
}

std::string lower_ending(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

/// By its name, or by the beginning of its content.
bool is_textured_mesh(const std::filesystem::path& file) {
  if (lower_ending(file) == ".mesh") return true;
  if (!std::filesystem::is_regular_file(file)) return false;  // reading a pipe would block
  std::array<char, 64> begin{};
  std::ifstream(file, std::ios::binary).read(begin.data(), begin.size());
  return std::string_view(begin.data(), begin.size()).find("asperity.textured_mesh/") !=
         std::string_view::npos;
}

bool is_picture_name(const std::filesystem::path& file) {
  const std::string ending = lower_ending(file);
  constexpr std::array<std::string_view, 7> kEndings = {".png",  ".jpg", ".jpeg", ".tif",
                                                        ".tiff", ".bmp", ".webp"};
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

void look_at(StimulusOverview& stimulus, const TexturedMesh& body) {
  stimulus.triangles = body.triangles.size();
  stimulus.rows = body.atlas.rows;
  stimulus.columns = body.atlas.columns;
  glm::dvec3 low_m = body.vertices_m.front();
  glm::dvec3 high_m = low_m;
  for (const glm::dvec3& vertex : body.vertices_m) {
    low_m = glm::min(low_m, vertex);
    high_m = glm::max(high_m, vertex);
  }
  stimulus.size_m = high_m - low_m;
}

void look_into(StimulusOverview& stimulus, const std::filesystem::path& file,
               std::size_t relief_rows) {
  if (stimulus.kind == StimulusOverview::Kind::picture) {
    const std::string bytes = read_file(file, kPictureFile);
    const PictureFacts facts = inspect_picture(std::as_bytes(std::span(bytes)), stimulus.path);
    stimulus.rows = facts.rows;
    stimulus.columns = facts.columns;
    return;
  }
  const std::string png = read_file(file, kPictureFile);
  const StoredHeightField stored = decode_height_field(
      std::as_bytes(std::span(png)), read_file(sidecar_of(file), kSidecarFile), stimulus.path);
  if (sha256_of(png) != stored.sha256) {
    throw std::runtime_error(stimulus.path +
                             " is not the picture that its sidecar describes: the SHA-256 differs; "
                             "make both again");
  }
  const HeightField& field = stored.field;
  stimulus.made_from = stored.provenance.kind;
  stimulus.rows = field.grid().rows;
  stimulus.columns = field.grid().columns;
  stimulus.width_m = field.width_m();
  stimulus.length_m = field.length_m();
  stimulus.pitch_m = field.grid().pitch_m;
  stimulus.rms_m = field.rms_m();
  stimulus.range_m = field.maximum_m() - field.minimum_m();
  const GreyImage relief = shaded_relief(field);
  stimulus.relief = side_by_side(std::span(&relief, 1), relief_rows);
}

}  // namespace

bool has_sidecar(const std::filesystem::path& picture) {
  std::error_code ignored{};
  return is_picture_name(picture) && std::filesystem::exists(sidecar_of(picture), ignored);
}

bool is_stimulus_file(const std::filesystem::path& file) {
  return is_picture_name(file) || is_textured_mesh(file) || is_rendering(file);
}

bool is_running(const Study& study, const SessionRow& row) {
  return row.state == SessionState::open &&
         StudyLock::holder(study.folder(), Study::session_lock_name(row.participant)).has_value();
}

bool is_blind(const Study& study, const SessionRow& row) {
  return row.mode == SessionMode::run && is_running(study, row);
}

std::map<std::string, std::filesystem::path> protocol_files_by_text(
    const std::filesystem::path& study) {
  std::map<std::string, std::filesystem::path> files{};
  for (const std::filesystem::path& protocol : protocol_files(study)) {
    for (const ProtocolInLanguage& each : languages_of_protocol(protocol)) {
      try {
        files.emplace(protocol_source(each.file).text, each.file);
      } catch (const std::exception&) {
        // Its problem is reported where protocols are listed.
      }
    }
  }
  return files;
}

std::vector<SessionOverview> session_overviews(const Study& study, const std::stop_token& stop) {
  std::map<std::int64_t, ProtocolRow> protocols{};
  for (ProtocolRow& protocol : study.protocols()) {
    const std::int64_t id = protocol.id;
    protocols.emplace(id, std::move(protocol));
  }
  const auto files = protocol_files_by_text(study.folder());
  const std::map<std::int64_t, SessionCounts> counts = study.session_counts();
  std::vector<SessionOverview> overviews{};
  for (const SessionRow& row : study.sessions()) {
    if (stop.stop_requested()) break;
    const auto counted = counts.find(row.id);
    // it began after the counts were read: the next call includes it
    if (counted == counts.end()) continue;
    const ProtocolRow& protocol = protocols.at(row.protocol_id);
    overviews.push_back(overview_of(study, row, protocol, counted->second));
    if (const auto file = files.find(protocol.source); file != files.end()) {
      overviews.back().protocol_file = file->second;
    }
  }
  return overviews;
}

bool has_made_up_dates(const SessionRow& session) { return session.pacing == "stepped"; }

std::string ProtocolOverview::name() const {
  return read().name.empty() ? std::filesystem::path(check.file).stem().string() : read().name;
}

std::vector<ProtocolOverview> protocol_overviews(const Study& study, const ModelRegistry& models,
                                                 const std::stop_token& stop) {
  std::map<std::int64_t, std::string> names{};
  for (const ProtocolRow& protocol : study.protocols()) names[protocol.id] = protocol.name;
  std::set<std::string> virtual_people{};
  for (const ParticipantRow& person : study.participants()) {
    if (person.is_virtual) virtual_people.insert(person.label);
  }
  const std::vector<SessionRow> sessions = study.sessions();

  std::vector<ProtocolOverview> overviews{};
  for (const std::filesystem::path& file : protocol_files(study.folder())) {
    if (stop.stop_requested()) break;
    ProtocolOverview overview{};
    overview.check = check_protocol(file, models, study.folder(), std::nullopt);
    if (overview.check.protocol) {
      ProtocolCheck& check = overview.check;
      append(check.warnings, warnings_about_sessions({*check.protocol, check.file}, study, models));
      sort_by_line(check.warnings);
      const Plan plan = example_plan(*overview.check.protocol, {1, 0});
      if (!plan.trials.empty()) overview.blocks = plan.trials.back().block_ordinal;
    } else {
      overview.part = stored_protocol(overview.check.text).protocol;
      overview.part.kind = stated_kind(overview.check.text);
    }
    count_progress(overview, sessions, names, virtual_people);
    overviews.push_back(std::move(overview));
  }
  return overviews;
}

std::vector<ParticipantOverview> participant_overviews(const Study& study) {
  std::vector<ParticipantOverview> overviews{};
  std::map<std::string, std::size_t> places{};
  for (ParticipantRow& person : study.participants()) {
    places[person.label] = overviews.size();
    overviews.emplace_back().row = std::move(person);
  }
  for (const SessionRow& session : study.sessions()) {
    ParticipantOverview& overview = overviews[places.at(session.participant)];
    if (session.withdrawn) {
      ++overview.withdrawn;
    } else if (session.state != SessionState::completed) {
      ++overview.unfinished;
    } else if (session.mode != SessionMode::pilot) {
      ++overview.completed;
    }
    if (!overview.last_session || began_before(*overview.last_session, session)) {
      overview.last_session = session;
    }
  }
  return overviews;
}

std::optional<bool> TrialOverview::correct() const {
  std::optional<bool> all{};
  if (!attempt) return all;
  for (const ResponseRow& response : attempt->responses) {
    if (response.correct) all = all.value_or(true) && *response.correct;
  }
  return all;
}

SessionDetail session_detail(const Study& study, std::int64_t session_id) {
  SessionDetail detail{};
  const SessionRow row = study.session(session_id);
  const std::vector<AttemptRow> attempts = study.attempts(session_id);
  detail.overview =
      overview_of(study, row, study.protocol(row.protocol_id), study.session_counts(session_id));
  detail.events = events_in_order(study.events(session_id), attempts);
  for (const PlannedTrialRow& planned : study.plan(session_id)) {
    bool begun = false;
    for (const AttemptRow& attempt : attempts) {
      if (attempt.trial != planned.trial) continue;
      begun = true;
      detail.trials.push_back({planned, attempt});
    }
    if (!begun) detail.trials.push_back({planned, {}});
  }
  return detail;
}

int count_stimuli(const std::filesystem::path& study, const ModelRegistry& models) {
  const std::vector<std::filesystem::path> files = files_in(study / "stimuli");
  const auto listed = std::count_if(files.begin(), files.end(), [](const auto& file) {
    return is_textured_mesh(file) || has_sidecar(file);
  });
  return static_cast<int>(listed) +
         static_cast<int>(shapes_of(sound_protocols(study, models)).size());
}

std::vector<StimulusOverview> stimulus_overviews(const std::filesystem::path& study,
                                                 const ModelRegistry& models,
                                                 std::size_t relief_rows,
                                                 const std::stop_token& stop, const BodySeen& see) {
  const std::vector<ProtocolFile> protocols = sound_protocols(study, models);
  const auto users = users_of_files(protocols);
  const std::set<std::string> assets = declared_assets_of(protocols);
  std::vector<StimulusOverview> overviews{};
  // `look` returns the body, where it is one.
  const auto add = [&](StimulusOverview stimulus, auto look) {
    try {
      const std::shared_ptr<const TexturedMesh> body = look(stimulus);
      if (body) look_at(stimulus, *body);
      if (body && see) see(overviews.size(), body);
    } catch (const std::exception& error) {
      stimulus.problem = phrase_of(error);
    }
    overviews.push_back(std::move(stimulus));
  };
  using StimulusKind = StimulusOverview::Kind;
  for (const std::filesystem::path& file : files_in(study / "stimuli")) {
    if (stop.stop_requested()) break;
    StimulusOverview stimulus{};
    stimulus.path = "stimuli/" + file.filename().string();
    if (is_picture_name(file)) {
      stimulus.kind = has_sidecar(file) ? StimulusKind::height_field : StimulusKind::picture;
    } else if (is_textured_mesh(file)) {
      stimulus.kind = StimulusKind::textured_mesh;
    } else if (assets.contains(stimulus.path)) {
      stimulus.kind = StimulusKind::asset;
    } else if (is_rendering(file)) {
      stimulus.kind = StimulusKind::rendering;
      stimulus.used_by = protocols_with_rendering(protocols, rendering_name(file));
    } else {
      continue;
    }
    if (const auto found = users.find(stimulus.path); found != users.end()) {
      stimulus.used_by = found->second;
    }
    add(std::move(stimulus), [&](StimulusOverview& own) -> std::shared_ptr<const TexturedMesh> {
      if (own.kind == StimulusKind::asset) return {};  // only its models can read it
      if (own.kind == StimulusKind::rendering) {
        const Rendering rendering = load_rendering(file);
        own.model = rendering.model;
        own.remarks = remarks_about(rendering, models, study);
        return {};
      }
      if (own.kind != StimulusKind::textured_mesh) {
        look_into(own, file, relief_rows);
        return {};
      }
      const LoadedTexturedMesh loaded = load_textured_mesh(file);
      own.source_name = loaded.stored->provenance.source_name;
      return {loaded.stored, &loaded.stored->mesh};
    });
  }
  for (const auto& [protocol, name] : shapes_of(protocols)) {
    if (stop.stop_requested()) break;
    BodyDescription body = protocol->bodies.at(name);
    if (body.texture) body.height_field = protocol->textures.at(*body.texture).height_field;
    StimulusOverview stimulus{};
    stimulus.path = protocol->name + '/' + name;
    stimulus.kind = StimulusKind::shape;
    stimulus.shape = body.shape;
    stimulus.used_by = {protocol->name};
    add(std::move(stimulus), [&](StimulusOverview&) {
      return StimulusBuilder(models, study).body(body, BodyRole::tool).mesh;
    });
  }
  return overviews;
}

std::vector<DeviceCapability> device_overviews() {
  VirtualHand hand(HandHabits{}, Random(0));
  return {SimulatedDevice(hand, SimulatedDeviceSettings{}).capability()};
}

}  // namespace asperity

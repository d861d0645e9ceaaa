// What is in a study, as the pages of a window list it.

#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "app/tasks/protocol_files.h"
#include "device/device_capability.h"
#include "renderers/force/force_model.h"
#include "results_schema/study.h"
#include "stimuli/meshes/textured_mesh.h"
#include "stimuli/meshes/textured_shape.h"
#include "stimuli/pictures/grey_image.h"

namespace asperity {

// All of these read and write nothing. What takes long ends early, with what it has, when it is
// asked to stop. Errors: ResultsError as Study's; what is wrong with a single file is a value.

/// It ran on a simulated clock: its dates are no dates of the calendar.
bool has_made_up_dates(const SessionRow& session);

/// Open, and some process holds it.
bool is_running(const Study& study, const SessionRow& row);
/// Whoever runs it may not know yet what was felt and whether it was right: a run that is running.
bool is_blind(const Study& study, const SessionRow& row);

/// The files of the study's `protocols/` by their texts; of equal ones the first by name.
std::map<std::string, std::filesystem::path> protocol_files_by_text(
    const std::filesystem::path& study);

/// A session in one line.
struct SessionOverview {
  SessionRow row{};
  std::string protocol_name{};
  std::string protocol_version{};
  int planned_trials = 0;
  int done_trials = 0;  ///< as SessionCounts'
  int attempts = 0;
  int notes = 0;
  /// From the first to the last trial of each stretch of uninterrupted running.
  double duration_s = 0.0;
  bool is_running = false;     ///< see the function
  bool ended_by_rule = false;  ///< see `has_ended_by_rule`
  /// The file of the study's `protocols/` with the very text that the session began with; looked
  /// for by `session_overviews` only.
  std::optional<std::filesystem::path> protocol_file{};

  /// See the function.
  bool is_blind() const noexcept { return is_running && row.mode == SessionMode::run; }
  /// It could go on: neither completed, nor ended by a rule, nor running.
  bool is_unfinished() const noexcept {
    return !row.withdrawn && row.state != SessionState::completed && !ended_by_rule && !is_running;
  }
};
/// By participant, then session.
std::vector<SessionOverview> session_overviews(const Study& study, const std::stop_token& stop);

/// A protocol file of the study's `protocols/`, and how far it has come.
struct ProtocolOverview {
  ProtocolCheck check{};
  int blocks = 0;  ///< of an example plan
  /// Who has completed as many sessions as the protocol asks for; people in mode `run`.
  int people_done = 0;
  int virtual_done = 0;
  /// The one that was started last, of any mode; one with a made-up date only if all have one.
  std::optional<SessionRow> last_session{};

  bool is_valid() const noexcept { return check.protocol && check.diagnostics.empty(); }
  /// The protocol's name, or the file's where the protocol cannot be read.
  std::string name() const;
};
/// By file name.
std::vector<ProtocolOverview> protocol_overviews(const Study& study, const ModelRegistry& models,
                                                 const std::stop_token& stop);

struct ParticipantOverview {
  ParticipantRow row{};
  int completed = 0;   ///< sessions that count as data: not pilots; of virtual ones all
  int unfinished = 0;  ///< of any mode
  int withdrawn = 0;   ///< kept and never used: in neither of the others
  std::optional<SessionRow> last_session{};  ///< as ProtocolOverview's
};
/// By label.
std::vector<ParticipantOverview> participant_overviews(const Study& study);

/// One go at a trial, or a trial that is still to come.
struct TrialOverview {
  PlannedTrialRow planned{};
  std::optional<AttemptRow> attempt{};

  /// What was answered, in order: "metal", or "1 brick, 2 wood".
  std::string answer() const;
  /// Whether all answers were right, where any can be.
  std::optional<bool> correct() const;
};

/// A session with everything that happened in it.
struct SessionDetail {
  SessionOverview overview{};
  std::vector<TrialOverview> trials{};  ///< by trial, attempt
  std::vector<EventRow> events{};       ///< those of attempts too, by time
};
SessionDetail session_detail(const Study& study, std::int64_t session_id);

/// A file of the study's `stimuli/`, or a body that a protocol makes of a shape.
struct StimulusOverview {
  enum class Kind {
    picture,
    height_field,
    textured_mesh,
    shape,
  };
  /// Study-relative; of a shape the protocol's name and the body's, "tools_matching/fine".
  std::string path{};
  Kind kind = Kind::picture;
  std::size_t rows = 0;  ///< of a picture, a height field or the texture of a mesh
  std::size_t columns = 0;
  // Of a height field:
  std::string made_from{};  ///< "photograph", or the kind of a synthetic surface
  double width_m = 0.0;
  double length_m = 0.0;
  double pitch_m = 0.0;
  double rms_m = 0.0;
  double range_m = 0.0;
  GreyImage relief{};  ///< small, lit from the upper left
  // Of a textured mesh and a shape:
  std::size_t triangles = 0;
  glm::dvec3 size_m{0.0};     ///< of the box around it
  std::string source_name{};  ///< of a mesh: the file that it was baked from
  std::optional<Shape> shape{};

  std::vector<std::string> used_by{};  ///< names of protocols
  std::string problem{};               ///< why it cannot be used; empty when it can
};
/// Told of every body while it is in memory, and its place in the list: textures of many bodies are too
/// much to be kept.
using BodySeen = std::function<void(std::size_t, const std::shared_ptr<const TexturedMesh>&)>;
/// How many surfaces there are, without the pictures of them; looks into no picture and makes no body.
int count_stimuli(const std::filesystem::path& study, const ModelRegistry& models);
/// Files by path, then shapes by protocol and name, of protocols without a fault. Files that are
/// neither pictures nor height fields nor textured meshes are left out.
std::vector<StimulusOverview> stimulus_overviews(const std::filesystem::path& study,
                                                 const ModelRegistry& models,
                                                 std::size_t relief_rows,
                                                 const std::stop_token& stop,
                                                 const BodySeen& see = {});

/// The devices that this program can run a session on.
std::vector<DeviceCapability> device_overviews();

}  // namespace asperity

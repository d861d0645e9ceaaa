// Lists the contents of a study for the pages of a window.

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

#include "app/tasks/check_protocol.h"
#include "app/tasks/rendering_use.h"
#include "device/device_capability.h"
#include "renderers/force/force_model.h"
#include "results_schema/study.h"
#include "stimuli/meshes/textured_mesh.h"
#include "stimuli/meshes/textured_shape.h"
#include "stimuli/pictures/grey_image.h"

namespace asperity {

// All of these only read. Long operations end early, with a partial result, when a stop is
// requested. Errors: ResultsError as for Study; the problem of a single file is a value.

/// Whether it ran on a simulated clock: its dates are not calendar dates.
bool has_made_up_dates(const SessionRow& session);

/// Whether it is open and held by a process.
bool is_running(const Study& study, const SessionRow& row);
/// Whether the stimuli and the correctness of responses are still concealed from the experimenter:
/// a running session of mode `run`.
bool is_blind(const Study& study, const SessionRow& row);

/// The files of the study's `protocols/` by the texts of the protocols that they stand for, translations included; of
/// equal ones the first by name.
std::map<std::string, std::filesystem::path> protocol_files_by_text(
    const std::filesystem::path& study);

/// A summary of a session.
struct SessionOverview {
  SessionRow row{};
  std::string protocol_name{};
  std::string protocol_version{};
  int planned_trials = 0;
  bool planned_is_estimated = false;  ///< the number depends on responses that are still to come
  int done_trials = 0;                ///< as in SessionCounts
  int attempts = 0;
  int notes = 0;
  /// From the first to the last trial of each stretch of uninterrupted running.
  double duration_s = 0.0;
  bool is_running = false;     ///< see the function
  bool ended_by_rule = false;  ///< see `has_ended_by_rule`
  /// The file of the study's `protocols/` with exactly the text with which the session began; set
  /// only by `session_overviews`.
  std::optional<std::filesystem::path> protocol_file{};

  /// See the function.
  bool is_blind() const noexcept { return is_running && row.mode == SessionMode::run; }
  /// Planned trials that a complete session did without: the criterion of their block was reached or could no longer be.
  int trials_not_needed() const noexcept {
    return row.state == SessionState::completed ? planned_trials - done_trials : 0;
  }
  /// It can be resumed: neither completed, nor ended by a rule, nor running.
  bool is_unfinished() const noexcept {
    return !row.withdrawn && row.state != SessionState::completed && !ended_by_rule && !is_running;
  }
};
/// By participant, then session.
std::vector<SessionOverview> session_overviews(const Study& study, const std::stop_token& stop);

/// A protocol file of the study's `protocols/`, and the progress of its sessions.
struct ProtocolOverview {
  ProtocolCheck check{};
  Protocol part{};  ///< of a protocol that the check could not read: what can be read of it
  int blocks = 0;   ///< of an example plan
  /// The number of participants who have completed as many sessions as the protocol specifies;
  /// people in mode `run`.
  int people_done = 0;
  int virtual_done = 0;
  /// The session that was started last, of any mode; one with a simulated date only if all have
  /// one.
  std::optional<SessionRow> last_session{};

  bool is_valid() const noexcept { return check.is_valid(); }
  const Protocol& read() const noexcept { return check.protocol ? *check.protocol : part; }
  /// The protocol's name, or the file's where it has none.
  std::string name() const;
};
/// By file name.
std::vector<ProtocolOverview> protocol_overviews(const Study& study, const ModelRegistry& models,
                                                 const std::stop_token& stop);

struct ParticipantOverview {
  ParticipantRow row{};
  int completed = 0;   ///< sessions that count as data: no pilots; of virtual participants all
  int unfinished = 0;  ///< of any mode
  int withdrawn = 0;   ///< kept and never used: not counted in the others
  std::optional<SessionRow> last_session{};  ///< as ProtocolOverview::last_session
};
/// By label.
std::vector<ParticipantOverview> participant_overviews(const Study& study);

/// One attempt at a trial, or a trial without an attempt yet.
struct TrialOverview {
  PlannedTrialRow planned{};
  std::optional<AttemptRow> attempt{};

  /// Whether all responses were correct, where there are correct ones.
  std::optional<bool> correct() const;
};

/// A session with all its trials and events.
struct SessionDetail {
  SessionOverview overview{};
  std::vector<TrialOverview> trials{};  ///< by trial, attempt
  std::vector<EventRow> events{};       ///< including those of attempts, by time
};
SessionDetail session_detail(const Study& study, std::int64_t session_id);

/// Whether it is the picture of a height field, which has a sidecar: FILE.png.json, with an ending in any case.
bool has_sidecar(const std::filesystem::path& picture);

/// Whether a file of `stimuli/` is a picture, a textured mesh or a rendering. Data files of force models are known by the
/// protocols that name them alone.
bool is_stimulus_file(const std::filesystem::path& file);

/// A file of the study's `stimuli/`, or a body that a protocol makes from a shape.
struct StimulusOverview {
  enum class Kind {
    picture,
    height_field,
    textured_mesh,
    shape,
    asset,  ///< of a role that force models declare
    rendering,
  };
  /// Study-relative; for a shape the protocol's name and the body's, "tools_matching/fine".
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
  // For a textured mesh and a shape:
  std::size_t triangles = 0;
  glm::dvec3 size_m{0.0};     ///< of the box around it
  std::string source_name{};  ///< for a mesh: the file from which it was baked
  std::optional<Shape> shape{};
  // Of a rendering:
  std::string model{};
  RenderingRemarks remarks{};

  /// Names of protocols; of a rendering those with its values, which do not depend on it.
  std::vector<std::string> used_by{};
  Phrase problem{};  ///< why it cannot be used; empty when it can
};
/// Receives every body while it is in memory, with its index in the list: the textures of many
/// bodies would need too much memory.
using BodySeen = std::function<void(std::size_t, const std::shared_ptr<const TexturedMesh>&)>;
/// The number of surfaces, without their pictures; reads no picture and makes no body.
int count_stimuli(const std::filesystem::path& study, const ModelRegistry& models);
/// Files by path, then shapes by protocol and name, of protocols without a problem. Files that are
/// neither pictures nor height fields nor textured meshes nor renderings are omitted.
std::vector<StimulusOverview> stimulus_overviews(const std::filesystem::path& study,
                                                 const ModelRegistry& models,
                                                 std::size_t relief_rows,
                                                 const std::stop_token& stop,
                                                 const BodySeen& see = {});

/// The devices on which this program can run a session.
std::vector<DeviceCapability> device_overviews();

}  // namespace asperity

#include "app/records/recorded_attempt.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "app/session/layout.h"
#include "app/session/rig/recording_columns.h"
#include "app/study_files/parameter_json.h"
#include "protocols/file/protocol_reader.h"

namespace asperity {

std::string natural_key(const SessionRow& session, const AttemptRow& attempt) {
  return session.participant + '/' + std::to_string(session.session) + '/' +
         std::to_string(attempt.trial) + '/' + std::to_string(attempt.attempt);
}

namespace {

std::string session_name(const SessionRow& session) {
  return "session " + std::to_string(session.session) + " of participant " + session.participant;
}

std::uint64_t seed_of(const SessionRow& session) {
  std::uint64_t seed = 0;
  const char* const end = session.seed.data() + session.seed.size();
  if (const auto read = std::from_chars(session.seed.data(), end, seed);
      read.ec != std::errc{} || read.ptr != end) {
    throw std::runtime_error(session_name(session) + ": its seed \"" + session.seed +
                             "\" is not a number from 0 to 2^64 - 1");
  }
  return seed;
}

bool is_as_stored(const Trial& trial, const PlannedTrialRow& stored) {
  return stored.trial == trial.ordinal && stored.block == trial.block &&
         stored.block_ordinal == trial.block_ordinal && stored.phase == text_of(trial.phase) &&
         stored.repetition == trial.repetition && stored.factors_json == factors_json_of(trial) &&
         stored.plan_json == json_of(trial);
}

}  // namespace

PlansOfSessions::PlansOfSessions(const Study& study, const ModelRegistry& models)
    : study_(study), declarations_(declarations_of(models)) {}

Plan PlansOfSessions::of(const SessionRow& session) {
  auto known = protocols_.find(session.protocol_id);
  if (known == protocols_.end()) {
    const ProtocolRow row = study_.protocol(session.protocol_id);
    known = protocols_.emplace(row.id, read_protocol(row.source, row.name, declarations_)).first;
  }
  Plan plan = make_plan(known->second, {seed_of(session), session.counterbalance_row});
  const std::vector<PlannedTrialRow> stored = study_.plan(session.id);
  if (!std::equal(plan.trials.begin(), plan.trials.end(), stored.begin(), stored.end(),
                  is_as_stored)) {
    throw std::runtime_error(
        session_name(session) +
        ": its stored plan differs from the one that its protocol, seed and row determine");
  }
  return plan;
}

Plan plan_of(const Study& study, const SessionRow& session, const ModelRegistry& models) {
  return PlansOfSessions(study, models).of(session);
}

RecordedAttempt recorded_attempt(const Study& study, const SessionRow& session, const Trial& trial,
                                 const AttemptRow& attempt, StimulusBuilder& builder) {
  if (!attempt.recording) {
    throw std::runtime_error("attempt " + natural_key(session, attempt) + " was not recorded");
  }
  RecordedAttempt recorded{};
  recorded.row = attempt;
  recorded.session = session;
  const Recording recording = read_recording(study.folder() / attempt.recording->path);
  recorded.rate_Hz = recording.header.rate_Hz;
  recorded.records = records_of(recording);
  for (const PresentationRow& row : attempt.presentations) {
    RecordedSurface surface{};
    surface.row = row;
    PreparedStimulus& stimulus = surface.stimulus;
    stimulus.model = builder.models().find(row.model);
    if (stimulus.model == nullptr) {
      throw std::runtime_error("this program has no force model \"" + row.model +
                               "\", which attempt " + natural_key(session, attempt) +
                               " was rendered with");
    }
    const StimulusDescription& described =
        trial.presentations.at(static_cast<std::size_t>(row.position - 1)).stimulus;
    stimulus.inputs.parameters = parameter_values_in(row.parameters_json);
    stimulus.inputs.seed = std::stoull(row.seed);
    stimulus.inputs.material = described.material;
    stimulus.inputs.patch = Layout{session.mirrored}.of(described.patch);
    if (row.height_field_sha256 && described.height_field) {
      const LoadedHeightField loaded = builder.height_field(*described.height_field);
      if (loaded.sha256 != *row.height_field_sha256) {
        throw std::runtime_error("attempt " + natural_key(session, attempt) + ": the file " +
                                 *described.height_field +
                                 " differs from the one that was presented (its SHA-256 differs); "
                                 "restore it from a copy of the study");
      }
      stimulus.inputs.height_field = loaded.field;
      stimulus.height_field_sha256 = loaded.sha256;
    }
    const auto rebuild = [&](const std::optional<std::string>& sha256,
                             const std::optional<BodyDescription>& body, BodyRole role,
                             std::shared_ptr<const TexturedMesh>& mesh) {
      if (!sha256) return;
      if (!body) throw std::logic_error("a body was presented that is not in the plan");
      const LoadedBody loaded = builder.body(*body, role);
      if (loaded.sha256 != *sha256) {
        throw std::runtime_error(
            "attempt " + natural_key(session, attempt) + ": the body \"" + body->name +
            "\" is not the " + text_of(role) +
            " that was presented (its SHA-256 differs); restore its file from a copy of the study");
      }
      mesh = loaded.mesh;
    };
    rebuild(row.surface_sha256, described.surface, BodyRole::surface, stimulus.inputs.surface);
    rebuild(row.tool_sha256, described.tool, BodyRole::tool, stimulus.inputs.tool);
    stimulus.surface_sha256 = row.surface_sha256;
    stimulus.tool_sha256 = row.tool_sha256;
    recorded.surfaces.push_back(std::move(surface));
  }
  return recorded;
}

AttemptRow find_attempt(const Study& study, const std::string& what) {
  std::size_t number = 0;
  const bool is_key = what.find('/') != std::string::npos;
  for (const SessionRow& session : study.sessions()) {
    for (const AttemptRow& attempt : study.attempts(session.id)) {
      ++number;
      if (is_key ? natural_key(session, attempt) == what : std::to_string(number) == what) {
        return attempt;
      }
    }
  }
  throw std::runtime_error("there is no attempt " + what + " in " + study.folder().string() +
                           ": give a row number of the exported attempts.tsv, 1 to " +
                           std::to_string(number) + ", or PARTICIPANT/SESSION/TRIAL/ATTEMPT");
}

}  // namespace asperity

// Plans the session again, compares plan and files with what was stored, and replays surfaces.

#include "app/records/recorded_attempt.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "app/plugins/stored_plugins.h"
#include "app/session/layout.h"
#include "app/session/levels/external_program.h"
#include "app/session/rig/recording_columns.h"
#include "app/session/trial_outcome.h"
#include "app/session/trial_surfaces.h"
#include "app/study_files/parameter_json.h"
#include "protocols/file/protocol_reader.h"
#include "renderers/offline/replay.h"

namespace asperity {

std::string natural_key(const SessionRow& session, const AttemptRow& attempt) {
  return session.participant + '/' + std::to_string(session.session) + '/' +
         std::to_string(attempt.trial) + '/' + std::to_string(attempt.attempt);
}

std::string session_name(const SessionRow& session) {
  return "session " + std::to_string(session.session) + " of participant " + session.participant;
}

namespace {

std::uint64_t seed_of(const SessionRow& session) {
  std::uint64_t seed = 0;
  const char* const end = session.seed.data() + session.seed.size();
  if (const auto read = std::from_chars(session.seed.data(), end, seed);
      read.ec != std::errc{} || read.ptr != end) {
    throw std::runtime_error(
        session_name(session) + ": its seed \"" + session.seed +
        "\" is not a number from 0 to 2^64 - 1; restore the study from a copy");
  }
  return seed;
}

bool is_as_stored(const Trial& trial, const PlannedTrialRow& stored) {
  return stored.trial == trial.ordinal && stored.block == trial.block &&
         stored.track == (trial.track ? std::optional(trial.track->track) : std::nullopt) &&
         stored.step == (trial.track ? std::optional(trial.track->step) : std::nullopt) &&
         stored.is_catch == trial.catch_trial.has_value() &&
         stored.block_ordinal == trial.block_ordinal && stored.phase == text_of(trial.phase) &&
         stored.repetition == trial.repetition && stored.factors_json == factors_json_of(trial) &&
         stored.plan_json == json_of(trial);
}

/// That the study still gives what was presented. `attempt` is for the sentence.
void require_presented(const std::vector<AssetRow>& presented, const PreparedStimulus& loaded,
                       const StimulusDescription& described, const std::string& attempt) {
  const std::vector<StimulusAsset> files = assets_of(described);
  for (const AssetRow& asset : presented) {
    if (asset_sha256(loaded.assets, asset.role) == asset.sha256) continue;
    const auto file = std::find_if(files.begin(), files.end(), [&asset](const StimulusAsset& each) {
      return each.role == asset.role;
    });
    if (asset.role == kPluginRole) {
      throw std::runtime_error(
          attempt +
          ": the loaded plug-in of its force model differs from the one that "
          "rendered it (its SHA-256 differs); load that one with --plugin FILE");
    }
    const std::string role = asset.role == kHeightFieldRole ? "height field" : asset.role;
    if (file == files.end()) {
      throw std::runtime_error(
          attempt + ": the " + role +
          " of its stimulus differs from the one that was presented (its "
          "SHA-256 differs); use the version of Asperity that recorded the attempt");
    }
    throw std::runtime_error(attempt + ": the " + role + ", file " + file->path +
                             ", differs from the one that was presented (its SHA-256 differs); "
                             "restore it from a copy of the study");
  }
}

}  // namespace

PlansOfSessions::PlansOfSessions(const Study& study, const ModelRegistry& models)
    : study_(study), declarations_(declarations_of(with_stored_plugins(models, study))) {}

bool PlansOfSessions::has_stated_levels(const SessionRow& session) const {
  return !blocks_of_external_program(protocols_.at(session.protocol_id)).empty();
}

const Protocol& PlansOfSessions::protocol_of(const SessionRow& session) {
  auto known = protocols_.find(session.protocol_id);
  if (known == protocols_.end()) {
    const ProtocolRow row = study_.protocol(session.protocol_id);
    known = protocols_.emplace(row.id, read_protocol(row.source, row.name, declarations_)).first;
  }
  return known->second;
}

Plan PlansOfSessions::of(const SessionRow& session) {
  const Protocol& protocol = protocol_of(session);
  Course course(protocol, {.seed = seed_of(session),
                           .counterbalance_row = session.counterbalance_row,
                           .group = session.group_level.value_or("")});
  std::vector<PlannedTrialRow> stored{};
  if (course.is_complete()) {
    stored = study_.plan(session.id);
  } else {
    // A running session may store a response and the trials that it determines between two reads.
    std::vector<AttemptRow> attempts{};
    std::vector<DecisionRow> decisions{};
    std::vector<EventRow> events{};
    study_.read_at_one_moment([&] {
      attempts = study_.attempts(session.id);
      decisions = study_.decisions(session.id);
      events = study_.events(session.id);
      stored = study_.plan(session.id);
    });
    advance_through(course, protocol, attempts, set_aside_in(decisions), SuppliedSteps(events));
  }
  if (session.state == SessionState::completed && !course.is_complete()) {
    throw std::runtime_error(session_name(session) +
                             ": the session is completed, but some of the trials that its "
                             "responses determine are not stored; restore the study from a copy");
  }
  Plan plan = course.plan();
  // The session was interrupted before the trials that the last response determined were stored.
  if (session.state != SessionState::completed &&
      stored.size() == course.trials_before_last_outcome()) {
    plan.trials.resize(stored.size());
    std::erase_if(plan.steps, [&plan](const PlanStep& step) {
      const auto* const of_trial = std::get_if<TrialStep>(&step);
      return of_trial != nullptr && of_trial->trial >= plan.trials.size();
    });
  }
  const auto [trial, row] = std::mismatch(plan.trials.begin(), plan.trials.end(), stored.begin(),
                                          stored.end(), is_as_stored);
  if (trial != plan.trials.end() || row != stored.end()) {
    const std::size_t number = static_cast<std::size_t>(row - stored.begin()) + 1;
    throw std::runtime_error(
        session_name(session) + ", trial " + std::to_string(number) +
        ": its stored plan differs from the one that its protocol, seed, row, group and earlier "
        "responses determine; use the version of Asperity that ran the session, or restore the "
        "study from a copy");
  }
  return plan;
}

Plan plan_of(const Study& study, const SessionRow& session, const ModelRegistry& models) {
  return PlansOfSessions(study, models).of(session);
}

RecordedAttempt recorded_attempt(const std::filesystem::path& study_folder,
                                 const SessionRow& session, const Trial& trial,
                                 const AttemptRow& attempt, StimulusBuilder& builder) {
  if (!attempt.recording) {
    throw std::runtime_error("attempt " + natural_key(session, attempt) +
                             " was not recorded; choose an attempt with a recording");
  }
  RecordedAttempt recorded{};
  recorded.row = attempt;
  recorded.session = session;
  recorded.trial = trial;
  const std::filesystem::path file = study_folder / attempt.recording->path;
  const Recording recording = read_recording(file);
  recorded.rate_Hz = recording.header.rate_Hz;
  recorded.records = records_of(recording, file);
  for (const PresentationRow& row : attempt.presentations) {
    if (builder.models().find(row.model) == nullptr) {
      const bool is_plugin = asset_sha256(row.assets, kPluginRole).has_value();
      throw std::runtime_error("this program does not have the force model \"" + row.model +
                               "\" of attempt " + natural_key(session, attempt) + "; " +
                               (is_plugin
                                    ? "load its plug-in with --plugin FILE"
                                    : "use the version of Asperity that recorded the attempt"));
    }
    StimulusDescription described =
        trial.presentations.at(static_cast<std::size_t>(row.position - 1)).stimulus;
    described.model = row.model;
    RecordedSurface surface{.row = row, .stimulus = builder.without_parameters(described)};
    require_presented(row.assets, surface.stimulus, described,
                      "attempt " + natural_key(session, attempt));
    RendererInputs& inputs = surface.stimulus.inputs;
    inputs.parameters = parameter_values_in(row.parameters_json);
    inputs.seed = std::stoull(row.seed);
    inputs.patch = Layout{session.mirrored}.of(
        trial.presentations.at(static_cast<std::size_t>(row.position - 1)));
    recorded.surfaces.push_back(std::move(surface));
  }
  return recorded;
}

RecordedAttempt recorded_attempt(const Study& study, const AttemptRow& attempt,
                                 StimulusBuilder& builder) {
  const SessionRow session = study.session(study.session_of(attempt.id));
  const Plan plan = plan_of(study, session, builder.models());
  return recorded_attempt(study.folder(), session,
                          plan.trials.at(static_cast<std::size_t>(attempt.trial - 1)), attempt,
                          builder);
}

ReplayedSurface replay_surface(const RecordedAttempt& attempt, int position,
                               const ForceModel& model, const RendererInputs& inputs) {
  const auto felt_at = static_cast<std::uint64_t>(position);
  ReplayedSurface replayed{};
  if (attempt.trial.arrangement.surfaces != Arrangement::Surfaces::side_by_side) {
    for (const TickRecord& record : attempt.records) {
      if (record.presentation == felt_at) replayed.records.push_back(record);
    }
    const auto renderer = make_renderer(model, inputs);
    replayed.ticks = replay(*renderer, replayed.records, attempt.rate_Hz);
    return replayed;
  }
  std::vector<AdjacentPatch> patches{};
  for (const RecordedSurface& surface : attempt.surfaces) {
    const bool is_replaced = surface.row.position == position;
    patches.push_back({is_replaced ? &model : surface.stimulus.model,
                       is_replaced ? inputs : surface.stimulus.inputs});
  }
  std::vector<TickRecord> presented{};
  for (const TickRecord& record : attempt.records) {
    if (record.presentation != 0) presented.push_back(record);
  }
  const auto renderer = side_by_side(attempt.trial, Layout{attempt.session.mirrored}, patches);
  const std::vector<RenderedTick> ticks = replay(*renderer, presented, attempt.rate_Hz);
  for (std::size_t i = 0; i < presented.size(); ++i) {
    if (presented[i].presentation != felt_at) continue;
    replayed.records.push_back(presented[i]);
    replayed.ticks.push_back(ticks[i]);
  }
  return replayed;
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
                           ": give a row number in the exported attempts.tsv, 1 to " +
                           std::to_string(number) + ", or PARTICIPANT/SESSION/TRIAL/ATTEMPT");
}

}  // namespace asperity

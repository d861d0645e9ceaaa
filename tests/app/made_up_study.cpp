// Rows with just enough in them for the store to take them.

#include "tests/app/made_up_study.h"

#include <nlohmann/json.hpp>

namespace asperity {

namespace {

constexpr std::int64_t kClockZero_ns = 5'000'000'000;
constexpr std::int64_t kTrial_ns = 10'000'000'000;
constexpr std::int64_t kFirstTrial_ns = kClockZero_ns + 1'000'000'000;

AttemptRow attempt_of(const MadeUpTrial& made, int trial, int segment) {
  AttemptRow attempt{};
  attempt.trial = trial;
  attempt.attempt = 1;
  attempt.segment = segment;
  attempt.outcome = made.outcome;
  attempt.valid = made.valid;
  if (!made.valid) attempt.invalid_reason = "made up to be invalid";
  attempt.flagged = made.flagged;
  if (made.flagged) attempt.flag_reason = "made up to be flagged";
  attempt.onset_ns = kFirstTrial_ns + (trial - 1) * kTrial_ns;
  attempt.offset_ns = attempt.onset_ns + kTrial_ns / 2;
  attempt.recording = made.recording;
  attempt.events = made.events;
  attempt.presentations = made.surfaces;
  attempt.compliance = made.compliance;
  int position = 0;
  for (PresentationRow& surface : attempt.presentations) surface.position = ++position;
  for (std::size_t i = 0; i < made.answers.size(); ++i) {
    ResponseRow response{};
    response.question = made.questions.empty() ? "which" : made.questions[i];
    response.item = made.questions.empty() ? static_cast<int>(i) + 1 : 1;
    response.answer = made.answers[i];
    const bool is_number = made.answers[i].find_first_of("-0123456789") == 0;
    response.answer_number = made.questions.empty() ? made.number
                             : is_number            ? std::optional(std::stod(made.answers[i]))
                                                    : std::nullopt;
    if (i < made.right.size()) response.correct = made.answers[i] == made.right[i];
    response.options_json = nlohmann::json(made.options).dump();
    response.time_ns = attempt.offset_ns;
    response.from_cue_s = made.from_cue_s;
    response.source = "keyboard";
    attempt.responses.push_back(response);
  }
  return attempt;
}

}  // namespace

PresentationRow surface_of(const std::string& item, const std::string& model,
                           const std::string& texture) {
  PresentationRow surface{};
  surface.role = "alternative";
  surface.item = item;
  surface.stimulus = "surface";
  surface.model = model;
  surface.model_version = "1";
  surface.texture = texture;
  surface.seed = "7";
  surface.onset_ns = kFirstTrial_ns;
  surface.contact_s = 2.0;
  return surface;
}

MadeUpStudy::MadeUpStudy() { study_ = Study::create(folder(), "made up"); }

std::int64_t MadeUpStudy::add_protocol(const std::string& name, const std::string& kind,
                                       const std::string& source, const std::string& version) {
  ProtocolRow protocol{};
  protocol.name = name;
  protocol.version = version;
  protocol.kind = kind;
  protocol.design = "chapter";
  nlohmann::json text = nlohmann::json::parse(source);
  text["name"] = name;  // no two protocols are the same file
  if (version != "1") text["version"] = version;
  protocol.source = text.dump();
  return study_->add_protocol(protocol);
}

void MadeUpStudy::add_person(const std::string& label, const std::string& sex) {
  ParticipantRow person{};
  person.label = label;
  if (!sex.empty()) person.sex = sex;
  person.created_utc = "2001-02-03T04:05:06Z";
  study_->add_participant(person);
}

void MadeUpStudy::add_virtual(const std::string& label, const std::string& sex) {
  ParticipantRow person{};
  person.label = label;
  person.is_virtual = true;
  person.sex = sex;
  person.created_utc = "2001-02-03T04:05:06Z";
  study_->add_participant(person);
}

std::int64_t MadeUpStudy::add_session(const std::string& participant, std::int64_t protocol,
                                      const std::vector<MadeUpTrial>& trials, SessionMode mode) {
  SessionRow session{};
  session.participant = participant;
  session.protocol_id = protocol;
  session.mode = mode;
  session.seed = "42";
  session.generator = "none";
  session.program_version = "1";
  session.program_commit = "none";
  session.program_build = "test";
  session.instruction_set = "sse2";
  session.os = "Linux 6.1.0-made-up x86_64";
  session.device = "simulated";
  session.device_json = device_json_;
  session.pacing = "stepped";
  session.scheduling = "none";
  session.rate_Hz = 1000.0;
  session.started_utc = "2001-02-03T04:05:06Z";
  session.clock_zero_ns = kClockZero_ns;
  session.observer_json = observer_json_;
  session.files = files_;
  session.group_level = group_;
  std::vector<PlannedTrialRow> plan{};
  for (const MadeUpTrial& trial : trials) {
    PlannedTrialRow row{};
    row.trial = static_cast<int>(plan.size()) + 1;
    row.block = trial.block;
    row.block_ordinal = trial.block_ordinal;
    row.phase = trial.phase;
    row.factors_json = trial.factors_json;
    row.repetition = trial.repetition;
    row.track = trial.track;
    row.is_catch = trial.is_catch;
    row.step = trial.step;
    row.plan_json = trial.plan_json;
    plan.push_back(row);
  }
  const std::int64_t id = study_->add_session(session, plan);
  const int segment = study_->begin_segment(id, kClockZero_ns);
  int trial = 0;
  for (const MadeUpTrial& made : trials) {
    ++trial;
    if (made.is_presented) study_->add_attempt(id, attempt_of(made, trial, segment));
  }
  study_->end_segment(id, segment, kFirstTrial_ns + trial * kTrial_ns, "completed");
  study_->end_session(id, state_, "2001-02-03T05:05:06Z");
  return id;
}

}  // namespace asperity

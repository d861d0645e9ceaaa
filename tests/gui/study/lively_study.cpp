// Adds participants with sessions, attempts, decisions and notes directly to the store.

#include "tests/gui/study/lively_study.h"

#include <array>
#include <string>

#include "results_schema/files/atomic_file.h"
#include "results_schema/study.h"

namespace asperity {

namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr std::int64_t kClockZero_ns = 500 * kSecond_ns;
constexpr std::array<const char*, 4> kTextures = {"metal", "stone", "wood", "brick"};

std::string label_of(int number) {
  return std::string("P") + (number < 10 ? "00" : "0") + std::to_string(number);
}

void add_person(Study& study, int number) {
  ParticipantRow person{};
  person.label = label_of(number);
  person.age_years = 19.0 + (number * 7) % 23;
  person.sex = number % 2 == 0 ? "F" : "M";
  person.handedness = number % 5 == 0 ? "left" : "right";
  person.answers_json = R"({"hand_used": "right", "hand_problems": "no"})";
  person.created_utc = "2026-03-02T08:00:00Z";
  study.add_participant(person);
}

AttemptRow attempt_of(int trial, int segment) {
  AttemptRow attempt{};
  attempt.trial = trial;
  attempt.attempt = 1;
  attempt.segment = segment;
  attempt.onset_ns = kClockZero_ns + trial * 40 * kSecond_ns;
  attempt.offset_ns = attempt.onset_ns + 25 * kSecond_ns;
  PresentationRow surface{};
  surface.position = 1;
  surface.role = "target";
  surface.item = kTextures[static_cast<std::size_t>(trial) % 4];
  surface.stimulus = "rendered";
  surface.model = "height_map";
  surface.model_version = "1";
  surface.texture = surface.item;
  surface.seed = "7";
  surface.contact_s = 8.0;
  attempt.presentations = {surface};
  ResponseRow response{};
  response.question = "recognised";
  response.answer = kTextures[static_cast<std::size_t>(trial * trial) % 4];
  response.correct = response.answer == surface.item;
  response.options_json = "[]";
  response.time_ns = attempt.offset_ns;
  response.from_contact_s = 9.0 + 0.37 * trial;
  response.from_cue_s = 1.0 + 0.21 * trial;
  response.source = "keyboard";
  attempt.responses = {response};
  if (trial == 5) {
    attempt.flagged = true;
    attempt.flag_reason = "speed outside its band for 62 % of the contact";
  }
  return attempt;
}

struct MadeUpSession {
  std::string participant{};
  std::int64_t protocol = 0;
  SessionMode mode = SessionMode::run;
  SessionState state = SessionState::completed;
  int done = 12;
  std::string started_utc{};
};

void add_session(Study& study, const MadeUpSession& made) {
  SessionRow session{};
  session.participant = made.participant;
  session.protocol_id = made.protocol;
  session.mode = made.mode;
  session.seed = "42";
  session.generator = "none";
  session.program_version = "0.2.0";
  session.program_commit = "none";
  session.program_build = "test";
  session.instruction_set = "sse2";
  session.os = "none";
  session.device = "simulated";
  session.device_json = "{}";
  session.pacing = made.mode == SessionMode::simulate ? "stepped" : "real_time";
  session.scheduling = "other";
  session.rate_Hz = 1000.0;
  session.started_utc = made.started_utc;
  session.clock_zero_ns = kClockZero_ns;
  std::vector<PlannedTrialRow> plan{};
  for (int trial = 1; trial <= 12; ++trial) {
    PlannedTrialRow row{};
    row.trial = trial;
    row.block = trial <= 4 ? "practice" : "main";
    row.block_ordinal = trial <= 4 ? 1 : 2;
    row.phase = trial <= 4 ? "practice" : "main";
    row.factors_json = R"({"column":1.0,"texture":")" +
                       std::string(kTextures[static_cast<std::size_t>(trial) % 4]) + "\"}";
    plan.push_back(row);
  }
  const std::int64_t id = study.add_session(session, plan);
  const int segment = study.begin_segment(id, kClockZero_ns);
  study.add_event(id, {kClockZero_ns, "session_began", "", "null"});
  for (int trial = 1; trial <= made.done; ++trial) {
    study.add_attempt(id, attempt_of(trial, segment));
    if (trial == 3) {
      study.add_event(id, {kClockZero_ns + 145 * kSecond_ns, "note",
                           "asked whether both hands are allowed", "null"});
    }
  }
  study.end_segment(id, segment, kClockZero_ns + 600 * kSecond_ns, "ended");
  study.end_session(id, made.state, "2026-03-02T10:00:00Z");
}

std::string read_broken(const std::filesystem::path& study) {
  std::string text = read_file(study / "protocols" / "chapter_matching.json");
  const auto replace = [&text](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  replace("stimuli/metal.png", "stimuli/mteal.png");
  replace("stimuli/stone.png", "stimuli/lost.png");
  replace("\"chapter_matching\"", "\"matching_pilot\"");
  return text;
}

}  // namespace

void fill_with_participants(const std::filesystem::path& folder) {
  write_file(folder / "protocols" / "broken.json", read_broken(folder), Overwrite::refuse);
  Study study = Study::open(folder, Access::read_write);
  const auto add_protocol = [&](const std::string& name, const std::string& kind) {
    ProtocolRow row{};
    row.name = name;
    row.version = "1.1.0";
    row.kind = kind;
    row.design = "chapter";
    row.source = read_file(folder / "protocols" / (name + ".json"));
    return study.add_protocol(row);
  };
  const std::int64_t recognition = add_protocol("chapter_recognition", "recognition");
  const std::int64_t selection = add_protocol("chapter_selection", "selection");
  for (int number = 1; number <= 12; ++number) {
    add_person(study, number);
    MadeUpSession session{.participant = label_of(number), .protocol = recognition};
    if (number == 4) {
      session.state = SessionState::stopped;
      session.done = 7;
    }
    if (number == 12) {
      session.state = SessionState::crashed;
      session.done = 3;
    }
    const std::string hour = (number < 10 ? "0" : "") + std::to_string(number);
    session.started_utc = "2026-03-02T" + hour + ":10:00Z";
    add_session(study, session);
  }
  add_session(study, {.participant = "P002",
                      .protocol = selection,
                      .mode = SessionMode::pilot,
                      .started_utc = "2026-03-01T09:00:00Z"});
  for (const char* label : {"virtual0001", "virtual0002"}) {
    ParticipantRow person{};
    person.label = label;
    person.is_virtual = true;
    person.sex = "F";
    person.created_utc = "2026-03-03T08:00:00Z";
    study.add_participant(person);
    add_session(study, {.participant = label,
                        .protocol = selection,
                        .mode = SessionMode::simulate,
                        .started_utc = "2026-03-03T09:00:00Z"});
  }
}

}  // namespace asperity

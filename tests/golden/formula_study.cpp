// Writes the rows of a study that nobody took part in, through the same functions as a session.

#include "tests/golden/formula_study.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/records/participant_answers.h"
#include "app/session/response_rows.h"
#include "app/session/session_setup.h"
#include "app/session/trial_outcome.h"
#include "app/session/trial_tally.h"
#include "app/study_files/parameter_json.h"
#include "app/words/coded_phrases.h"
#include "app/words/reason.h"
#include "protocols/file/library_protocols.h"
#include "protocols/file/protocol_reader.h"
#include "protocols/plan/groups.h"
#include "renderers/built_in_models.h"
#include "results_schema/study.h"
#include "tests/golden/formula_answers.h"

namespace asperity::test {

namespace {

constexpr int kParticipants = 8;
constexpr std::int64_t kClockZero_ns = 1'000'000'000;
constexpr std::int64_t kTrial_ns = 10'000'000'000;
constexpr std::int64_t kSurface_ns = 3'000'000'000;
constexpr const char* kCreated = "2001-02-03T04:05:06Z";
constexpr const char* kStarted = "2001-02-03T05:00:00Z";
constexpr const char* kEnded = "2001-02-03T06:00:00Z";
const ProgramIdentity kProgram{.version = "0.0.0",
                               .commit = "golden",
                               .build = "Release",
                               .sha256 = std::string(64, '0'),
                               .instruction_set = "none",
                               .os = "none"};

std::int64_t ns_of(double seconds) { return std::llround(seconds * 1e9); }
/// A whole number of thousandths from `low` to `high`: few digits in tables.
double between(double low, double high, double chance) {
  return std::round((low + (high - low) * chance) * 1e3) / 1e3;
}

std::string text_of_library(const std::string& name) {
  for (const LibraryProtocol& each : library_protocols()) {
    if (each.name == name) return std::string(each.text);
  }
  throw std::runtime_error("the library has no protocol " + name);
}

/// Measures of the exploration are stored with the first protocol of each kind: their analysis is the same for all kinds, and has more
/// numbers than all others together.
bool is_first_of_its_kind(const Protocol& protocol) {
  for (const LibraryProtocol& each : library_protocols()) {
    if (nlohmann::json::parse(each.text).at("kind") == protocol.kind) {
      return each.name == protocol.name;
    }
  }
  return false;
}

void make_stimuli(const Protocol& protocol, const std::filesystem::path& study) {
  for (const NamedFile& file : files_of(protocol)) {
    for (const std::string& path : paths_of(file)) {
      std::filesystem::create_directories((study / path).parent_path());
      std::ofstream(study / path) << path << '\n';
    }
  }
}

/// One session of one participant.
class FormulaSession final {
 public:
  FormulaSession(Study& study, const Protocol& protocol, const FormulaAnswers& answers,
                 const std::string& label, FormulaPlace place)
      : study_(study),
        protocol_(protocol),
        answers_(answers),
        place_(place),
        is_first_(is_first_of_its_kind(protocol)) {
    SessionConditions conditions{
        .seed = static_cast<std::uint64_t>(100 * place.participant + place.session),
        .pacing = "real_time",
        .scheduling = "none",
        .started_utc = kStarted,
        .clock_zero_ns = kClockZero_ns};
    conditions.device.name = "made-up";
    conditions.device.peak_force_N = 10.0;
    if (!protocol.consent_version.empty()) conditions.consent_utc = kStarted;
    if (protocol.groups &&
        protocol.groups->assigned == Protocol::Groups::Assignment::by_experimenter) {
      conditions.group = allocation_in_turn(protocol, place.participant - 1).group;
    }
    open_ = begin_session(study, protocol, label, conditions, kProgram);
  }

  void run() {
    Course& course = *open_.course;
    TrialTally tally(protocol_, course.plan());
    segment_ = study_.begin_segment(open_.row.id, now_ns_);
    for (std::size_t next = 0; next < course.plan().trials.size(); ++next) {
      if (is_stopped() && 2 * next > course.plan().trials.size()) {
        study_.end_segment(open_.row.id, segment_, now_ns_, "stopped");
        study_.end_session(open_.row.id, SessionState::stopped, kEnded);
        return;
      }
      const Trial& trial = course.plan().trials[next];
      if (tally.is_over(trial)) continue;
      place_.trial = trial.ordinal;
      if (is_repeated()) tally.add(stored_attempt(trial, 1));
      const AttemptRow done = stored_attempt(trial, is_repeated() ? 2 : 1);
      tally.add(done);
      if (course.awaited() == &trial) advance(trial, done);
    }
    if (!course.is_complete()) {
      throw std::runtime_error("the levels of the protocol " + protocol_.name +
                               " are not determined by the responses");
    }
    place_.trial = 0;
    answer_questionnaire();
    if (place_.participant == 7) exclude_an_attempt(tally);
    if (is_excluded()) exclude({}, {}, "the participant had misunderstood the task");
    study_.end_segment(open_.row.id, segment_, now_ns_, "completed");
    study_.end_session(open_.row.id, SessionState::completed, kEnded);
  }

 private:
  double chance(std::string_view what) const { return formula_number(place_, what); }
  bool is_repeated() const { return place_.participant == 3 && place_.trial % 29 == 5; }
  bool is_skipped() const { return place_.participant == 2 && place_.trial % 37 == 11; }
  bool is_flagged() const { return place_.trial % 31 == 7; }
  /// The last participant's last session: stopped half-way in the first protocol of each kind, excluded in the others.
  bool is_last() const {
    return place_.participant == kParticipants && place_.session == protocol_.sessions;
  }
  bool is_stopped() const { return is_last() && is_first_; }
  bool is_excluded() const { return is_last() && !is_first_; }

  void advance(const Trial& trial, const AttemptRow& done) {
    Course& course = *open_.course;
    const std::size_t before = course.plan().trials.size();
    course.advance(outcome_of(protocol_, trial, done));
    std::vector<PlannedTrialRow> added{};
    for (std::size_t i = before; i < course.plan().trials.size(); ++i) {
      added.push_back(planned_row(course.plan().trials[i]));
    }
    study_.add_trials(open_.row.id, added);
  }

  AttemptRow stored_attempt(const Trial& trial, int number) {
    AttemptRow attempt{.trial = trial.ordinal, .attempt = number, .segment = segment_};
    attempt.onset_ns = now_ns_;
    now_ns_ += kTrial_ns;
    attempt.offset_ns = now_ns_;
    add_surfaces(attempt, trial);
    if (is_repeated() && number == 1) {
      attempt.outcome = AttemptOutcome::not_compliant;
      attempt.valid = false;
      attempt.invalid_reason = stored(phrase_of(Reason::not_touched).with("1"));
    } else if (is_skipped()) {
      attempt.outcome = AttemptOutcome::skipped;
      attempt.valid = false;
      attempt.invalid_reason = StoredWords("the surface was not clean");
    } else {
      add_responses(attempt, trial);
      if (is_flagged()) {
        attempt.flagged = true;
        attempt.flag_reason = stored(phrase_of(Reason::force_limited).with("12"));
      }
    }
    attempt.id = study_.add_attempt(open_.row.id, attempt);
    return attempt;
  }

  void add_surfaces(AttemptRow& attempt, const Trial& trial) const {
    std::int64_t onset_ns = attempt.onset_ns;
    for (const PlannedPresentation& planned : trial.presentations) {
      const std::string place = std::to_string(planned.position);
      PresentationRow surface{.position = planned.position,
                              .role = planned.role,
                              .item = planned.item,
                              .stimulus = planned.stimulus.name,
                              .model = planned.stimulus.model,
                              .model_version = "1",
                              .texture = planned.stimulus.texture,
                              .parameters_json = json_text_of(planned.stimulus.parameters),
                              .seed = place};
      surface.stiffness_N_per_m = planned.stimulus.material.stiffness_N_per_m;
      surface.friction = planned.stimulus.material.friction;
      surface.contact_s = is_first_ ? between(1.5, 2.5, chance("contact " + place)) : 2.0;
      surface.onset_ns = onset_ns;
      surface.contact_ns = onset_ns + kSurface_ns / 10;
      surface.offset_ns = *surface.contact_ns + ns_of(surface.contact_s);
      onset_ns += kTrial_ns / 20;
      surface.achieved_texture_force_N = between(0.05, 0.15, chance("texture force " + place));
      if (planned.equal_force) surface.matched_texture_force_N = 0.1;
      if (is_first_) add_exploration(attempt, surface);
      attempt.presentations.push_back(std::move(surface));
    }
  }

  void add_exploration(AttemptRow& attempt, PresentationRow& surface) const {
    const std::string place = std::to_string(surface.position);
    const double speed_m_per_s = between(0.04, 0.1, chance("speed " + place));
    const double force_N = between(0.6, 1.4, chance("force " + place));
    surface.visits.push_back({.contact_ns = *surface.contact_ns,
                              .offset_ns = *surface.offset_ns,
                              .contact_s = surface.contact_s,
                              .path_m = std::round(1e6 * speed_m_per_s * surface.contact_s) / 1e6,
                              .force_mean_N = force_N,
                              .force_sd_N = 0.1,
                              .speed_mean_m_per_s = speed_m_per_s,
                              .speed_sd_m_per_s = 0.01});
    surface.instability = InstabilityRow{.buzz = between(0.0, 0.05, chance("buzz " + place)),
                                         .buzz_force_N = 0.8,
                                         .buzz_ns = surface.contact_ns,
                                         .no_aliveness = "too_short",
                                         .no_crest_share = "no_crests"};
    const auto comply = [&](const char* quantity, double mean) {
      attempt.compliance.push_back({.position = surface.position,
                                    .quantity = quantity,
                                    .mean = mean,
                                    .sd = mean / 8,
                                    .p05 = mean / 2,
                                    .p50 = mean,
                                    .p95 = mean * 2});
    };
    comply("normal_force_N", force_N);
    comply("speed_m_per_s", speed_m_per_s);
    comply("contact_s", surface.contact_s);
    comply("strokes", 2.0 + std::floor(3.0 * chance("strokes " + place)));
    comply("stroke_length_m", between(0.04, 0.08, chance("stroke " + place)));
  }

  void add_responses(AttemptRow& attempt, const Trial& trial) const {
    const std::int64_t cue_ns = attempt.onset_ns + kTrial_ns / 2;
    for (const Question& question : trial.questions) {
      const double from_cue_s = between(0.4, 2.4, chance("time " + question.name));
      for (ResponseRow& row : rows_of(question, answers_.answer(trial, question, place_),
                                      {.time_ns = cue_ns + ns_of(from_cue_s),
                                      .from_cue_s = from_cue_s,
                                      .source = "keyboard"})) {
        attempt.responses.push_back(std::move(row));
      }
    }
  }

  void answer_questionnaire() {
    for (const PlanStep& step : open_.course->plan().steps) {
      const auto* const ask = std::get_if<Protocol::Ask>(&step);
      if (ask == nullptr) continue;
      for (const std::string& name : ask->questions) answer_question(protocol_.questions.at(name));
    }
  }

  void answer_question(const Question& question) {
    now_ns_ += kTrial_ns;
    const StoredAnswers earlier(study_.session_answers(open_.row.id));
    if (earlier.has(question.name)) return;
    const bool is_asked = earlier.meet(question.condition);
    study_.add_session_answer(
        open_.row.id, is_asked
                          ? rows_of(question, answers_.answer(question, place_),
                                    {.time_ns = now_ns_, .from_cue_s = 2.5, .source = "keyboard"})
                          : row_not_asked(question, now_ns_));
  }

  void exclude_an_attempt(const TrialTally& tally) {
    const AttemptRow* const last = tally.last_done();
    if (last != nullptr) exclude(last->trial, last->attempt, "the participant spoke");
  }

  void exclude(std::optional<int> trial, std::optional<int> attempt, const char* reason) {
    DecisionRow decision{.trial = trial, .attempt = attempt, .verdict = Verdict::exclude};
    decision.reason = StoredWords(reason);
    decision.decided_by = "experimenter";
    decision.decided_utc = kEnded;
    study_.add_decision(open_.row.id, decision);
  }

  Study& study_;
  const Protocol& protocol_;
  const FormulaAnswers& answers_;
  FormulaPlace place_;
  bool is_first_;
  OpenSession open_{};
  int segment_ = 0;
  std::int64_t now_ns_ = kClockZero_ns;
};

ParticipantRow person(const Protocol& protocol, const FormulaAnswers& answers, int number) {
  ParticipantAnswers given{};
  for (const Question& question : questions_about_participant(protocol)) {
    const std::optional<Answer> answer =
        answers.answer(question, {.participant = number, .session = 0, .trial = 0});
    given[question.name] = answer ? items_of(question, *answer).front().answer : std::string();
  }
  ParticipantRow row = person_of("P0" + std::to_string(number), protocol, given, kCreated);
  row.sex = number % 2 == 0 ? "M" : "F";  // groups of equal size
  return row;
}

}  // namespace

void make_formula_study(const std::string& name, const std::filesystem::path& folder) {
  const ModelRegistry models = built_in_models();
  const Protocol protocol =
      read_protocol(text_of_library(name), name + ".json", declarations_of(models));
  Study study = Study::create(folder, name);
  make_stimuli(protocol, folder);
  const FormulaAnswers answers(protocol);
  for (int number = 1; number <= kParticipants; ++number) {
    const ParticipantRow row = person(protocol, answers, number);
    study.add_participant(row);
    for (int session = 1; session <= protocol.sessions; ++session) {
      FormulaSession(study, protocol, answers, row.label,
                     {.participant = number, .session = session})
          .run();
    }
  }
}

}  // namespace asperity::test

// What a report says, read as a value.

#include "app/report/text/study_report.h"

#include <algorithm>
#include <memory>
#include <set>
#include <stop_token>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/number_text.h"
#include "app/findings/reading_number.h"
#include "app/findings/study/analyze_study.h"
#include "app/findings/tidy/finding_list.h"
#include "app/records/session_conditions.h"
#include "app/report/text/report_numbers.h"
#include "app/report/text/report_sections.h"
#include "app/report/text/report_tests.h"
#include "app/tasks/simulation.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "tests/app/made_up_study.h"
#include "tests/app/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// Every word of a section, a line per part or row.
std::string words_of(const ReportSection& section) {
  std::string text = section.heading + '\n';
  for (const ReportPart& part : section.parts) {
    if (const auto* words = std::get_if<ReportText>(&part)) text += words->text + '\n';
    if (const auto* list = std::get_if<ReportList>(&part)) {
      for (const std::string& item : list->items) text += item + '\n';
    }
    if (const auto* table = std::get_if<ReportTable>(&part)) {
      text += table->title + '\n';
      for (const std::vector<std::string>& row : table->rows) {
        for (const std::string& cell : row) text += cell + " | ";
        text += '\n';
      }
      text += table->note + '\n';
    }
  }
  return text;
}

std::string words_of(const ReportChapter& chapter) {
  std::string text = chapter.heading + '\n';
  for (const ReportSection& section : chapter.sections) text += words_of(section);
  return text;
}

const ReportSection& section(const ReportChapter& chapter, const std::string& heading) {
  const auto found =
      std::find_if(chapter.sections.begin(), chapter.sections.end(),
                   [&heading](const ReportSection& each) { return each.heading == heading; });
  if (found == chapter.sections.end()) throw std::runtime_error("no section " + heading);
  return *found;
}

/// A choice of one of two models.
MadeUpTrial choice(const std::string& chosen) {
  MadeUpTrial trial{};
  trial.options = {"height_map", "sinusoid"};
  for (const std::string& model : trial.options) {
    trial.surfaces.push_back(surface_of(model, model, "brick"));
  }
  trial.answers = {chosen};
  return trial;
}

/// A choice that was answered between 6 s and 7 s of the clock, with a reason to repeat it.
TEST(ReportNotes, HaveSessionTimeAndTrial) {
  MadeUpStudy made;
  made.add_person("anna", "F");
  const std::int64_t protocol = made.add_protocol("choose", "selection");
  const std::int64_t session =
      made.add_session("anna", protocol, {choice("height_map"), choice("sinusoid")});
  const std::vector<AttemptRow> attempts = made.study().attempts(session);
  const std::int64_t second_ns = attempts.at(1).onset_ns + 1'000'000;  // a moment into it
  made.study().add_event(session, {second_ns, "note", "looked away, 2 s"});
  made.study().add_event(session, {5'250'000'000, "unblinded", "safety"});
  made.study().add_event(session, {66'000'000'000, "trial_repeated",
                                   "The participant was distracted", R"({"trial":2,"attempt":1})"});
  made.study().add_event(session, {70'000'000'000, "resumed_late", "was ill"});
  made.study().add_decision(session, {.trial = 1,
                                      .attempt = 1,
                                      .verdict = Verdict::exclude,
                                      .reason = "wrong hand",
                                      .decided_by = "MK"});
  const Report report = study_report(made.study(), {});
  const ReportSection& notes = section(report.chapters.back(), "Notes and decisions");
  ASSERT_EQ(notes.parts.size(), 1U);
  const std::string time = fixed(static_cast<double>(second_ns - 5'000'000'000) * 1e-9, 1);
  EXPECT_THAT(std::get<ReportTable>(notes.parts.front()).rows,
              ElementsAre(ElementsAre("anna", "1", "0:00.3", "–", "unblinded", "safety"),
                          ElementsAre("anna", "1", "0:" + time, "2", "note", "looked away, 2 s"),
                          ElementsAre("anna", "1", "1:01.0", "2", "trial repeated",
                                      "The participant was distracted"),
                          ElementsAre("anna", "1", "–", "1", "excluded afterwards",
                                      "wrong hand (decided by MK)")));
  // The reason of a late resume is listed once, with the sessions.
  EXPECT_THAT(words_of(section(report.chapters.at(1), "Sessions and exclusions")),
              HasSubstr("was resumed"));
  EXPECT_THAT(words_of(section(report.chapters.at(1), "Sessions and exclusions")),
              HasSubstr("was ill"));
}

std::vector<MadeUpTrial> choices(int hits, int of) {
  std::vector<MadeUpTrial> trials{};
  for (int i = 0; i < of; ++i) trials.push_back(choice(i < hits ? "height_map" : "sinusoid"));
  return trials;
}

void add_person(MadeUpStudy& made, const std::string& label, std::optional<double> age_years,
                const std::string& sex, const std::string& handedness) {
  ParticipantRow person{};
  person.label = label;
  person.age_years = age_years;
  if (!sex.empty()) person.sex = sex;
  if (!handedness.empty()) person.handedness = handedness;
  person.created_utc = "2001-02-03T04:05:06Z";
  made.study().add_participant(person);
}

TEST(StudyReport, SaysOfAnEmptyStudyThatThereIsNothing) {
  MadeUpStudy made;
  const Report report = study_report(made.study(), {});
  ASSERT_EQ(report.chapters.size(), 1U);
  EXPECT_THAT(words_of(report.chapters[0]), HasSubstr("no sessions yet"));
  EXPECT_EQ(report.chapters[0].mark, "");
}

TEST(StudyReport, CountsPeopleByAgeSexAndHandednessAsTheyAreStored) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol("which", "selection");
  add_person(made, "p1", 20.0, "F", "right");
  add_person(made, "p2", 24.0, "F", "left");
  add_person(made, "p3", 28.0, "M", "right");
  add_person(made, "p4", {}, "", "");
  for (const char* label : {"p1", "p2", "p3", "p4"}) {
    made.add_session(label, protocol, choices(1, 2));
  }
  const Report report = study_report(made.study(), {});
  const std::string words = words_of(section(report.chapters.at(1), "Participants"));
  EXPECT_THAT(words, HasSubstr("Four participants took part."));
  EXPECT_THAT(words, HasSubstr("Sex: 2 female, 1 male and 1 not reported."));
  // Mean of 20, 24 and 28; the squares of their distances are 16, 0 and 16, over 2: SD 4.
  EXPECT_THAT(words, HasSubstr("Age: M = 24.0 years, SD = 4.0, range 20 to 28 (3 of 4 reported)."));
  EXPECT_THAT(words, HasSubstr("2 right-handed, 1 left-handed and 1 not reported."));
  EXPECT_THAT(words, HasSubstr("No consent is stored for p1, p2, p3 and p4."));
}

TEST(StudyReport, SaysOfOneParticipantWhatItCan) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol("which", "selection");
  add_person(made, "p1", 31.0, "X", "");
  made.add_session("p1", protocol, choices(1, 1));
  const Report report = study_report(made.study(), {});
  const std::string words = words_of(report.chapters.at(1));
  EXPECT_THAT(words, HasSubstr("One participant took part."));
  EXPECT_THAT(words, HasSubstr("Age: 31 years."));
  EXPECT_THAT(words, HasSubstr("One participant began one session, which was completed."));
  EXPECT_THAT(words, HasSubstr("1 attempt at a trial of the main phase is stored; it counts."));
}

TEST(StudyReport, NamesSessionsThatWereExcludedOrNotFinishedAndWhy) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol("which", "selection");
  for (const char* label : {"p1", "p2", "p3"}) made.add_person(label, "F");
  made.add_session("p1", protocol, choices(1, 3));
  const std::int64_t second = made.add_session("p2", protocol, choices(1, 3));
  made.study().add_decision(
      second,
      {.verdict = Verdict::exclude, .reason = "fell asleep <twice> & left", .decided_by = "ab"});
  const std::int64_t once = made.add_session("p3", protocol, choices(1, 3));
  made.study().add_decision(once, {.verdict = Verdict::exclude, .reason = "by mistake"});
  made.study().add_decision(once, {.verdict = Verdict::include, .reason = "taken back"});
  SessionRow stopped = made.study().session(once);
  stopped.session = 0;
  stopped.ended_utc.reset();
  stopped.state = SessionState::open;
  PlannedTrialRow trial{};
  trial.trial = 1;
  trial.block = "only";
  trial.block_ordinal = 1;
  trial.phase = "main";
  const std::int64_t unfinished = made.study().add_session(stopped, {trial});
  made.study().end_session(unfinished, SessionState::stopped, "2001-02-03T05:05:06Z");

  const Report report = study_report(made.study(), {});
  const std::string words = words_of(section(report.chapters.at(1), "Sessions and exclusions"));
  EXPECT_THAT(words,
              HasSubstr("Three participants began four sessions, three of which were completed."));
  EXPECT_THAT(words, HasSubstr("Session 2 of p3 was stopped after 0 of 1 trial."));
  EXPECT_THAT(words, HasSubstr("One session was excluded:\nSession 1 of p2: fell asleep <twice> & "
                               "left (decided by ab)."));
  EXPECT_THAT(words, Not(HasSubstr("by mistake")));
  EXPECT_THAT(words, HasSubstr("9 attempts at trials of the main phase are stored; 6 "
                               "count. Not counted: three were excluded."));
}

TEST(StudyReport, SaysWhatBecameOfAttemptsThatDoNotCountAndWhichAreFlagged) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol("which", "selection");
  made.add_person("p1", "F");
  std::vector<MadeUpTrial> trials = choices(2, 4);
  trials[1].flagged = true;
  trials[2].valid = false;
  trials[3].phase = "practice";
  made.add_session("p1", protocol, trials);
  const Report report = study_report(made.study(), {});
  const std::string words = words_of(section(report.chapters.at(1), "Sessions and exclusions"));
  EXPECT_THAT(words, HasSubstr("3 attempts at trials of the main phase are stored; 2 count. Not "
                               "counted: one was answered but invalid. One attempt that counts is "
                               "flagged."));
  EXPECT_THAT(words,
              HasSubstr("One attempt belongs to practice and is not included in the results."));
  EXPECT_THAT(words, HasSubstr("1 | answered but invalid | made up to be invalid"));
  EXPECT_THAT(words, HasSubstr("1 | flagged, counts | made up to be flagged"));
}

TEST(StudyReport, CountsAnchorsWithPracticeAndNotWithWhatCounts) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol("rough", "magnitude");
  made.add_person("p1", "F");
  std::vector<MadeUpTrial> trials(3);
  for (MadeUpTrial& trial : trials) {
    trial.surfaces = {surface_of("wave", "pd_gradient", "wave")};
    trial.answers = {"5"};
  }
  trials[0].repetition = 0;
  made.add_session("p1", protocol, trials);
  const Report report = study_report(made.study(), {});
  const std::string words = words_of(section(report.chapters.at(1), "Sessions and exclusions"));
  EXPECT_THAT(words, HasSubstr("2 attempts at trials of the main phase are stored; both count."));
  EXPECT_THAT(words,
              HasSubstr("One attempt belongs to anchors and is not included in the results."));
  EXPECT_THAT(words_of(section(report.chapters.at(1), "Design")),
              HasSubstr("A session was planned with 2 experimental trials, and with 3 in total "
                        "including anchors."));
}

TEST(StudyReport, SaysSoWhereNothingOfTheMainPhaseWasAnswered) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol("which", "selection");
  made.add_person("p1", "F");
  std::vector<MadeUpTrial> trials = choices(1, 1);
  trials[0].phase = "practice";
  made.add_session("p1", protocol, trials);
  const Report report = study_report(made.study(), {});
  EXPECT_THAT(words_of(report.chapters.at(1)),
              HasSubstr("There are no responses yet; run a session first."));
  EXPECT_THAT(words_of(report.chapters.at(1)),
              HasSubstr("No attempt at a trial of the main phase is stored. One attempt belongs to "
                        "practice and is not included in the results."));
  EXPECT_THAT(words_of(report.chapters.at(2)), HasSubstr("The analysis yielded no results."));
}

TEST(StudyReport, GivesPeoplePilotsAndVirtualOnesMarkedChaptersOfTheirOwn) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol("which", "selection");
  made.add_person("p1", "F");
  made.add_person("p2", "M");
  made.add_virtual("virtual0001", "F");
  made.add_session("p1", protocol, choices(1, 1));
  made.add_session("p2", protocol, choices(1, 1), SessionMode::pilot);
  made.add_session("virtual0001", protocol, choices(1, 1), SessionMode::simulate);
  const Report report = study_report(made.study(), {});
  std::vector<std::string> marks{};
  for (const ReportChapter& chapter : report.chapters) marks.push_back(chapter.mark);
  // The appendices follow in the same order.
  EXPECT_THAT(marks, ElementsAre("includes SIMULATED data", "", "PILOT: not study data",
                                 "SIMULATED: no human participant", "", "PILOT: not study data",
                                 "SIMULATED: no human participant"));
  EXPECT_THAT(words_of(report.chapters.at(1)), Not(HasSubstr("virtual")));
  EXPECT_THAT(words_of(report.chapters.at(1)), Not(HasSubstr("p2")));
  EXPECT_THAT(words_of(report.chapters.at(3)), HasSubstr("No human participant took part."));
}

TEST(StudyReport, HoldsResultsBackWhileAPersonIsRunThroughTheProtocol) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol("which", "selection");
  made.add_person("p1", "F");
  made.add_person("p2", "F");
  made.add_session("p1", protocol, choices(2, 3));
  EXPECT_THAT(words_of(study_report(made.study(), {}).chapters.at(1)),
              HasSubstr("eight_map was chosen most often"));
  SessionRow running = made.study().sessions().front();
  running.participant = "p2";
  running.session = 0;
  running.state = SessionState::open;
  running.ended_utc.reset();
  made.study().add_session(running, {});
  const auto lock = std::make_unique<StudyLock>(made.folder(), Study::session_lock_name("p2"));
  const std::string words = words_of(study_report(made.study(), {}).chapters.at(1));
  EXPECT_THAT(words, HasSubstr("its experimenter is blind"));
  EXPECT_THAT(words, Not(HasSubstr("was chosen")));
  EXPECT_THAT(words, Not(HasSubstr("proportion chosen")));
  const std::string appendix = words_of(study_report(made.study(), {}).chapters.at(2));
  EXPECT_THAT(appendix, Not(HasSubstr("height_map")));
  EXPECT_THAT(appendix, HasSubstr("Every session"));
}

TEST(StudyReport, CountsWhatDidNotComeAsItWasMeant) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol("which", "selection");
  made.add_person("p1", "F");
  const std::int64_t id = made.add_session("p1", protocol, {});
  SessionRow row = made.study().session(id);
  row.session = 0;
  row.state = SessionState::open;
  row.ended_utc.reset();
  row.pacing = "real_time";
  std::vector<PlannedTrialRow> plan(2);
  for (int i = 0; i < 2; ++i) {
    plan[static_cast<std::size_t>(i)].trial = i + 1;
    plan[static_cast<std::size_t>(i)].block = "only";
    plan[static_cast<std::size_t>(i)].block_ordinal = 1;
    plan[static_cast<std::size_t>(i)].phase = "main";
  }
  const std::int64_t session = made.study().add_session(row, plan);
  const int segment = made.study().begin_segment(session, row.clock_zero_ns);
  for (int i = 0; i < 2; ++i) {
    AttemptRow attempt{};
    attempt.trial = i + 1;
    attempt.attempt = 1;
    attempt.segment = segment;
    attempt.outcome = AttemptOutcome::skipped;
    attempt.valid = false;
    attempt.invalid_reason = "skipped";
    attempt.onset_ns = row.clock_zero_ns + 10 * (i + 1);
    attempt.offset_ns = attempt.onset_ns + 5;
    PresentationRow surface = surface_of("a", "pd_gradient", "brick");
    surface.position = 1;
    surface.limits = {{"too_deep", i == 0 ? 7 : 0}};
    PresentationRow other = surface_of("b", "pd_gradient", "wave");
    other.position = 2;
    other.limits = {{"too_deep", 0}, {"fine_detail", 5}};
    attempt.presentations = {surface, other};
    ServoQualityRow servo{};
    servo.rate_Hz = 1000.0;
    servo.ticks = 6000;
    servo.lateness_p99_s = i == 0 ? 20e-6 : 40e-6;
    servo.missed_deadlines = i == 0 ? 0 : 3;
    servo.missed_in_contact = i == 0 ? 0 : 1;
    servo.lost_records = i;
    servo.saturated_ticks = i == 0 ? 12 : 0;
    servo.held_readings = i == 0 ? 0 : 4;
    attempt.servo = servo;
    ComplianceRow force{};
    force.position = 1;
    force.quantity = "normal_force_N";
    force.minimum = 0.5;
    force.maximum = 1.5;
    force.mean = i == 0 ? 1.0 : 2.0;
    force.fraction_in_band = i == 0 ? 1.0 : 0.5;
    force.passed = i == 0;
    attempt.compliance = {force};
    made.study().add_attempt(session, attempt);
  }
  const Report report = study_report(made.study(), {});
  const std::string words = words_of(section(report.chapters.at(1), "Presentation"));
  EXPECT_THAT(words, HasSubstr("at most 30 µs late; in the worst attempt, 40 µs"));
  EXPECT_THAT(words, AllOf(HasSubstr("The servo loop was set to 1000 Hz; it ran 12"),
                           HasSubstr(" ticks in 2 attempts. In the median")));
  EXPECT_THAT(words, HasSubstr("3 deadlines were missed in one attempt (one in contact) and 1 tick "
                               "record was lost in one attempt."));
  EXPECT_THAT(words, HasSubstr("The limiter reduced the force in 12 ticks of one attempt."));
  EXPECT_THAT(words, HasSubstr("missed deadlines | 3 | 1 of 2 attempts | 3 |"));
  EXPECT_THAT(words, HasSubstr("readings replaced as implausible | 4 | 1 of 2 attempts | 4 |"));
  EXPECT_THAT(
      words,
      HasSubstr("violated assumption of pd_gradient: too deep, brick | 7 | 1 of 2 surfaces | 7 |"));
  EXPECT_THAT(
      words,
      HasSubstr("violated assumption of pd_gradient: fine detail, wave | 10 | 2 of 2 surfaces"));
  EXPECT_THAT(words, Not(HasSubstr("too deep, wave")));
  const std::string hands = words_of(section(report.chapters.at(1), "Exploration"));
  EXPECT_THAT(hands, HasSubstr("Explored as the protocol requires: normal force (0.5 N to 1.5 N) "
                               "on 1 of 2 surfaces (50 %)."));
  EXPECT_THAT(hands, HasSubstr("normal force | 0.5 N to 1.5 N | 2 | 1.5 N |"));
  EXPECT_THAT(hands, HasSubstr("| 75 % | 1 of 2 |"));
}

// --- conditions, from what the sessions recorded ---------------------------------------------------

constexpr const char* kNoisy = R"({
  "format": "asperity.protocol/1", "kind": "recognition", "design": "improved",
  "name": "noisy", "version": "1.0.0", "title": "Which one", "environment": {
    "vision": "blindfold", "masking_noise": {"kind": "pink", "level_dBA": 65}},
  "consent": {"version": "1.0", "statement": "I take part."},
  "textures": {"grain": {"height_field": "stimuli/grain.png", "picture": "stimuli/grain.png"},
               "other": {"picture": "stimuli/other.png"}},
  "factors": {"texture": {"levels": ["grain"]}},
  "stimuli": {"rendered": {"model": "height_map", "texture": {"factor": "texture"}}},
  "explorations": {"short": {"minimum_contact_s": 0.3, "maximum_contact_s": 2}},
  "blocks": {"main": {"crossed": ["texture"], "presented": [{"stimulus": "rendered"}],
    "question": {"name": "which", "prompt": "Which?", "pictures": ["grain", "other"],
                 "pictures_after_feeling": true, "allow_revisit": false,
                 "correct_factor": "texture"}, "exploration": "short"}},
  "flow": [{"run": "main"}]
})";

constexpr const char* kFalcon =
    R"({"name": "falcon", "model": "Novint Falcon", "serial": "7", "actuated_degrees_of_freedom": 3})";
constexpr const char* kMouse =
    R"({"name": "mouse", "model": "pointer of a window", "actuated_degrees_of_freedom": 0})";
constexpr const char* kVirtualHand =
    R"({"name": "simulated", "model": "mass", "actuated_degrees_of_freedom": 3})";

/// Sessions of people whose conditions a test writes.
class Conditions : public testing::Test {
 protected:
  Conditions() {
    made_.add_person("template", "F");
    const std::int64_t other = made_.add_protocol("template", "recognition");
    template_ = made_.study().session(made_.add_session("template", other, {}));
    template_.session = 0;
    template_.state = SessionState::open;
    template_.ended_utc.reset();
    template_.pacing = "real_time";
    template_.protocol_id = made_.add_protocol("noisy", "recognition", kNoisy);
  }

  /// One of a new participant that began on this device, with these events and a skipped trial in each stretch:
  /// `presented_`, explored as `explored_`.
  void add_session(const std::string& device_json, const std::vector<EventRow>& events,
                   SessionMode mode = SessionMode::run) {
    SessionRow row = template_;
    const nlohmann::json device = nlohmann::json::parse(device_json);
    row.device = device.at("name").get<std::string>() + ' ' + device.at("model").get<std::string>();
    row.device_json = device_json;
    row.participant = "p" + std::to_string(++participants_);
    row.mode = mode;
    made_.add_person(row.participant, "F");
    std::vector<PlannedTrialRow> plan{};
    for (const EventRow& event : events) {
      if (event.kind != "session_began" && event.kind != "session_resumed") continue;
      PlannedTrialRow& trial = plan.emplace_back();
      trial.trial = static_cast<int>(plan.size());
      trial.block = "main";
      trial.block_ordinal = 1;
      trial.phase = "main";
    }
    const std::int64_t session = made_.study().add_session(row, plan);
    std::int64_t time_ns = row.clock_zero_ns;
    for (EventRow event : events) {
      event.time_ns = ++time_ns;
      made_.study().add_event(session, event);
    }
    for (const PlannedTrialRow& trial : plan) {
      AttemptRow attempt{};
      attempt.trial = trial.trial;
      attempt.attempt = 1;
      attempt.segment = made_.study().begin_segment(session, ++time_ns);
      attempt.outcome = is_answered_ ? AttemptOutcome::answered : AttemptOutcome::skipped;
      attempt.valid = is_answered_;
      if (is_answered_) {
        attempt.responses.push_back({.question = "which", .answer = "grain", .source = "keyboard"});
      } else {
        attempt.invalid_reason = "skipped";
      }
      attempt.onset_ns = attempt.offset_ns = ++time_ns;
      attempt.presentations = presented_;
      for (PresentationRow& surface : attempt.presentations) {
        surface.position = static_cast<int>(&surface - attempt.presentations.data()) + 1;
      }
      attempt.compliance = explored_;
      made_.study().add_attempt(session, attempt);
      made_.study().end_segment(session, attempt.segment, ++time_ns, "ended");
    }
    if (ends_as_ != SessionState::open) {
      made_.study().end_session(session, ends_as_, template_.started_utc);
    }
  }
  static EventRow began() { return {.kind = "session_began", .data_json = R"({"segment": 1})"}; }
  static EventRow resumed() {
    return {.kind = "session_resumed", .data_json = R"({"segment": 2})"};
  }
  static EventRow noise(const std::string& data) {
    return {.kind = "masking_noise", .data_json = data};
  }
  static EventRow played(const std::string& measured_dBA) {
    return noise(R"({"kind": "pink", "heard": true, "measured_dBA": )" + measured_dBA +
                 R"(, "verified_by": "AB"})");
  }

  const ReportChapter& chapter() {
    report_ = study_report(made_.study(), {});
    return report_.chapters.at(1);
  }
  std::string conditions() { return words_of(section(chapter(), "Apparatus and conditions")); }

  /// Where the protocol requires no fraction: everything passes.
  static ComplianceRow measured(const std::string& quantity, double mean,
                                std::optional<double> fraction) {
    ComplianceRow row{.position = 1, .quantity = quantity, .minimum = 0.5, .maximum = 2.0};
    row.mean = mean;
    row.fraction_in_band = fraction;
    row.passed = true;
    return row;
  }

  MadeUpStudy made_;
  SessionRow template_{};
  std::vector<PresentationRow> presented_{surface_of("grain", "height_map", "grain")};
  std::vector<ComplianceRow> explored_{measured("normal_force_N", 1.0, 1.0)};
  SessionState ends_as_ = SessionState::open;
  bool is_answered_ = false;
  Report report_{};
  int participants_ = 0;
};

TEST_F(Conditions, StateWhereNoiseWasPlayedMeasuredAttestedAndNotPlayed) {
  add_session(kFalcon, {began(), played("64.5")});
  add_session(kFalcon, {began(), played("null")});
  add_session(kFalcon, {began(), noise(R"({"kind": "pink", "heard": false, "measured_dBA": 66,
                                           "verified_by": "A. Keller"})")});
  add_session(kFalcon, {began(), noise(R"({"kind": "pink", "heard": false, "measured_dBA": null,
                                           "verified_by": ""})")});
  add_session(kFalcon, {began()});  // interrupted before it was stored
  add_session(kFalcon, {began(), noise(R"({"output": "unknown"})")});
  const std::string words = conditions();
  EXPECT_THAT(
      words,
      HasSubstr("The protocol requests pink noise of 65 dB(A) at the ear to mask the sound of the "
                "device. The program played masking noise in 2 of 6 sessions (level at the ear, as "
                "measured in 1 of 6 sessions: 64.5 dB(A)). Masking noise came from another source "
                "in 1 of 6 sessions: A. Keller measured 66 dB(A) at the ear. No masking noise was "
                "played in 1 of 6 sessions. Whether masking noise was played is not recorded in 2 "
                "of 6 sessions."));
}

TEST_F(Conditions, StateThatNoNoiseWasPlayedInTheOnlySession) {
  add_session(kFalcon, {began(), noise(R"({"kind": "none", "heard": false})")});
  EXPECT_THAT(conditions(), HasSubstr("No masking noise was played in the only session."));
  EXPECT_THAT(conditions(), Not(HasSubstr("played masking noise")));
}

TEST_F(Conditions, TellThePartsOfAResumedSessionApart) {
  add_session(kFalcon,
              {began(), played("65"), resumed(), noise(R"({"kind": "none", "heard": false})")});
  add_session(kFalcon, {began(), played("65")});
  EXPECT_THAT(conditions(), HasSubstr("The program played masking noise in 1 of 2 sessions and in "
                                      "part of one more (level at the ear, as measured: 65 dB(A)). "
                                      "No masking noise was played in part of 1 of 2 sessions."));
}

TEST_F(Conditions, StateWhereAnEyeMaskWasConfirmed) {
  add_session(kFalcon, {began(), {.kind = "mask_on"}});
  add_session(kFalcon, {began()});
  EXPECT_THAT(conditions(),
              HasSubstr("The protocol requests an eye mask while surfaces are explored. Its use "
                        "was confirmed in 1 of 2 sessions. Whether one was worn is not recorded "
                        "in 1 of 2 sessions."));
}

TEST_F(Conditions, StateThatNobodyFeltADeviceWithoutMotors) {
  add_session(kMouse, {began()});
  add_session(kFalcon, {began()});
  const std::string words = conditions();
  EXPECT_THAT(words,
              HasSubstr("Device: falcon Novint Falcon (in 1 of 2 sessions); mouse pointer of "
                        "a window (in 1 of 2 sessions). A device without motors was used in 1 of "
                        "2 sessions: forces were computed but not exerted, and no participant "
                        "felt the surfaces there."));
  EXPECT_THAT(words_of(section(chapter(), "Exploration")),
              HasSubstr("The normal force was computed in 1 of 2 sessions, but not exerted by the "
                        "device."));
}

TEST_F(Conditions, StateThatAVirtualHandMadeTheStrokes) {
  add_session(kVirtualHand, {began()}, SessionMode::pilot);
  const std::string words = words_of(chapter());
  EXPECT_THAT(words, HasSubstr("One participant took part in pilot sessions. In the only session "
                               "the program moved the device, not the participant."));
  EXPECT_THAT(words, HasSubstr("A virtual hand moved the device in the only session: no "
                               "participant moved a device or felt a force there."));
  EXPECT_THAT(words, HasSubstr("No participant made the strokes in the only session."));
  add_session(kVirtualHand, {began()}, SessionMode::pilot);
  EXPECT_THAT(words_of(chapter()), HasSubstr("No participant made the strokes in either session."));
}

TEST_F(Conditions, NameTheDeviceThatASessionWasResumedOn) {
  add_session(kFalcon,
              {began(),
               {.kind = kDeviceChanged, .text = "mouse pointer of a window", .data_json = kMouse},
               resumed()});
  EXPECT_THAT(conditions(),
              HasSubstr("Session 1 of p1 began on falcon Novint Falcon, serial number 7, then was "
                        "resumed on mouse pointer of a window."));
}

TEST_F(Conditions, StateThatSessionsWereResumedAndDevicesPooled) {
  add_session(kFalcon, {began()});
  EXPECT_THAT(words_of(chapter()), AllOf(Not(HasSubstr("interrupted and resumed")),
                                         Not(HasSubstr("pool the sessions"))));
  add_session(kMouse, {began(), resumed(), resumed()});
  EXPECT_THAT(words_of(section(chapter(), "Sessions and exclusions")),
              HasSubstr("Session 1 of p2 was interrupted and resumed twice."));
  EXPECT_THAT(conditions(), Not(HasSubstr("pool the sessions"))) << "nothing was answered";
  is_answered_ = true;
  add_session(kFalcon, {began()});
  EXPECT_THAT(conditions(), Not(HasSubstr("pool the sessions")));
  add_session(kMouse, {began()});
  EXPECT_THAT(conditions(), HasSubstr("The analyses pool the sessions on different devices."));
}

TEST_F(Conditions, NameEveryProgramThatRanAPartOfASession) {
  template_.program_version = "0.2.0";
  template_.program_commit = "5979704d1215";
  template_.os = "Linux 6.1";
  add_session(kFalcon, {began(), {.kind = "session_resumed", .data_json = R"({"segment": 2,
      "program_version": "0.3.0", "program_commit": "71cf3affd4dd", "os": "Linux 6.12",
      "device": "falcon Novint Falcon"})"}});
  const std::string words = words_of(section(chapter(), "Provenance"));
  EXPECT_THAT(words, HasSubstr("operating system | Linux 6.1 (in part of the only session); Linux "
                               "6.12 (in part of the only session)"));
  EXPECT_THAT(words,
              HasSubstr("asperity 0.3.0, commit 71cf3affd4dd (in part of the only session)"));
  EXPECT_THAT(words, HasSubstr("device | falcon Novint Falcon |"));
}

TEST_F(Conditions, LeaveOutSurfacesThatWereNeverPresented) {
  PresentationRow never = surface_of("other", "sinusoid", "other");
  never.onset_ns.reset();
  presented_.push_back(never);
  add_session(kFalcon, {began()});
  const std::string design = words_of(section(chapter(), "Design"));
  EXPECT_THAT(design, HasSubstr("Force models of the surfaces presented, with their versions: "
                                "height_map 1."));
}

TEST_F(Conditions, SayThatNoSurfaceWasPresented) {
  presented_[0].onset_ns.reset();
  add_session(kFalcon, {began()});
  EXPECT_THAT(words_of(section(chapter(), "Design")),
              HasSubstr("No surface was presented. According to the "));
}

TEST_F(Conditions, ClaimNothingOfABandThatNothingHasToLieIn) {
  explored_ = {measured("normal_force_N", 1.0, 0.75), measured("speed_m_per_s", 1.0, 1.0)};
  add_session(kFalcon, {began()});
  explored_ = {measured("normal_force_N", 1.0, 0.77), measured("speed_m_per_s", 0.0, {})};
  add_session(kFalcon, {began()});
  const std::string words = words_of(section(chapter(), "Exploration"));
  EXPECT_THAT(words,
              HasSubstr("The protocol requires no minimum proportion of the contact time or of the "
                        "strokes to be within these bands. On average, normal force was in its "
                        "band (0.5 N to 2 N) for 76 % of the contact time and speed was in its "
                        "band (500 mm/s to 2 m/s) for 100 % of the strokes."));
  EXPECT_THAT(words, Not(HasSubstr("of 2 surfaces")));
  EXPECT_THAT(words,
              HasSubstr("speed | 500 mm/s to 2 m/s | 1 | 1 m/s | 1 m/s to 1 m/s | 100 % | – |"))
      << "a surface without a stroke has no speed";
  explored_ = {measured("normal_force_N", 0.0, {})};
  add_session(kFalcon, {began()});
  EXPECT_THAT(words_of(section(chapter(), "Exploration")),
              HasSubstr("normal force | 0.5 N to 2 N | 2 | 1 N | "))
      << "a surface without contact has no force";
  explored_ = {measured("normal_force_N", 0.0, 0.0)};
  add_session(kFalcon, {began()});
  EXPECT_THAT(words_of(section(chapter(), "Exploration")),
              HasSubstr("normal force | 0.5 N to 2 N | 3 | "))
      << "a device without motors renders zero in contact";
}

TEST_F(Conditions, NameTheFactorsThatAreDrawn) {
  std::string source = kNoisy;
  const std::string crossed = R"("crossed": ["texture"])";
  source.replace(source.find(crossed), crossed.size(),
                 R"("drawn": ["texture"], "repetitions": 2, "order": "fixed")");
  template_.protocol_id = made_.add_protocol("drawn", "recognition", source);
  add_session(kFalcon, {began()});
  EXPECT_THAT(words_of(section(chapter(), "Design")),
              HasSubstr("in fixed order, texture drawn at random in each trial"));
}

TEST_F(Conditions, CountTheTrialsThatResponsesDetermined) {
  template_.expected_trials = 20;
  ends_as_ = SessionState::completed;
  add_session(kFalcon, {began()});
  EXPECT_THAT(
      words_of(section(chapter(), "Design")),
      AllOf(HasSubstr("A completed session had 1 experimental trial."), Not(HasSubstr("planned"))));
  add_session(kFalcon, {began(), resumed()});
  EXPECT_THAT(words_of(section(chapter(), "Design")),
              HasSubstr("The number of trials depended on the responses: a completed session had 1 "
                        "to 2 experimental trials."));
  ends_as_ = SessionState::stopped;
  add_session(kFalcon, {began()});
  EXPECT_THAT(words_of(section(chapter(), "Sessions and exclusions")),
              HasSubstr("Session 1 of p3 was stopped after 1 of about 20 trials."));
}

TEST_F(Conditions, CountSessionsThatWereNotCompleted) {
  add_session(kFalcon, {began()});
  EXPECT_THAT(words_of(section(chapter(), "Sessions and exclusions")),
              HasSubstr("One participant began one session, which was not completed."));
  add_session(kFalcon, {began()});
  EXPECT_THAT(words_of(section(chapter(), "Sessions and exclusions")),
              HasSubstr("Two participants began two sessions, neither of which was completed."));
}

/// A study that `simulate` has made: two virtual participants, three trials each.
const TemporaryFolder& simulated() {
  static const std::unique_ptr<TemporaryFolder> kFolder = [] {
    auto folder = std::make_unique<TemporaryFolder>();
    make_small_study(folder->path() / "study");
    write_file(folder->path() / "study" / "protocols" / "small.json", small_protocol(),
               Overwrite::refuse);
    SimulationInputs inputs{};
    inputs.protocols = {folder->path() / "study" / "protocols" / "small.json"};
    inputs.study = folder->path() / "study";
    inputs.participants = 2;
    inputs.seed = 5;
    inputs.recordings = Recordings::none;
    simulate(inputs, built_in_models(), {}, {}, {});
    return folder;
  }();
  return *kFolder;
}

Finding found(const std::string& quantity, const std::string& key, double value,
              const std::string& method = "") {
  Finding finding{};
  finding.quantity = quantity;
  finding.key = key;
  finding.value = value;
  finding.method = method;
  finding.n = 20;
  return finding;
}

TEST(StudyReport, TellsFurtherNumbersOnceInWordsAndWhereTheRestIs) {
  const Study study = Study::open(simulated().path() / "study", Access::read_only);
  const Report report = study_report(study, {});
  ASSERT_EQ(report.chapters.size(), 3U);
  EXPECT_EQ(report.chapters[2].heading, "Appendix to " + report.chapters[1].heading);
  const ReportSection& numbers = section(report.chapters[2], "Further tests and numbers");
  std::set<std::vector<std::string>> rows{};
  for (const ReportPart& part : numbers.parts) {
    const auto* table = std::get_if<ReportTable>(&part);
    if (table == nullptr) continue;
    for (std::vector<std::string> row : table->rows) {
      for (std::size_t i = 0; i < row.size(); ++i) {
        EXPECT_THAT(row[i], Not(testing::ContainsRegex("[0-9]e-"))) << table->columns[i].heading;
        // Things keep the names that the study has given them.
        if (table->columns[i].heading == "factor or level") continue;
        const std::size_t model = row[i].find("height_map");
        if (model != std::string::npos) row[i].erase(model, std::string("height_map").size());
        EXPECT_THAT(row[i], Not(HasSubstr("_"))) << table->columns[i].heading;
        EXPECT_THAT(row[i], Not(HasSubstr("subj.")));
      }
      row.push_back(table->title);
      EXPECT_TRUE(rows.insert(row).second) << testing::PrintToString(row) << " stands twice";
    }
  }
  EXPECT_GT(rows.size(), 3U);
  EXPECT_THAT(words_of(numbers), HasSubstr("asperity analyze STUDY --protocol"));
}

TEST(ReportNumbers, WriteCountsAsCountsAndNumbersWithTheirUnit) {
  Finding count = found("total.items", "", 234.0);
  Finding bits = found("H.response", "", 2.466);
  bits.unit = "bit";
  Finding share = found("precision", "wood", 0.8);
  share.low = 0.55;
  share.high = 0.975;
  const std::vector<Finding> findings{count, bits, share, found("subject.mean", "p1", 3.0)};
  const ReportTable table = further_numbers_table(findings);
  ASSERT_EQ(table.rows.size(), 3U) << "no number of a single participant";
  EXPECT_THAT(table.rows[0], ElementsAre("items", "–", "234", "–", "20"));
  EXPECT_THAT(table.rows[1], ElementsAre("response entropy H(R)", "–", "2.47 bit", "–", "20"));
  EXPECT_THAT(table.rows[2], ElementsAre("precision (positive predictive value)", "wood", "80 %",
                                         "55 % to 97 %", "20"));
}

TEST(StudyReport, TellsDesignAndMakingOfARealStudy) {
  const Study study = Study::open(simulated().path() / "study", Access::read_only);
  const Report report = study_report(study, {});
  EXPECT_EQ(report.subtitle, "Data from sessions on a simulated clock, which has no date");
  const std::string design = words_of(section(report.chapters[1], "Design"));
  EXPECT_THAT(design, HasSubstr("A few short trials"));
  EXPECT_THAT(design, HasSubstr("Task: in each trial, several surfaces are presented, and one is "
                                "to be chosen: “Which felt more like the picture?”"));
  EXPECT_THAT(
      design,
      HasSubstr("A session was planned with 3 experimental trials. Two surfaces were presented "
                "in each answered trial."));
  EXPECT_THAT(design, HasSubstr("“Which felt more like the picture?”"));
  EXPECT_THAT(design, HasSubstr("explored for 500 ms to 2 s"));
  const std::string made = words_of(section(report.chapters[1], "Provenance"));
  EXPECT_THAT(made, HasSubstr(study.protocols().front().source_sha256));
  EXPECT_THAT(made, HasSubstr(study.sessions().front().program_commit));
  EXPECT_THAT(words_of(section(report.chapters[1], "Apparatus and conditions")),
              HasSubstr("Device: simulated mass, spring and damper.\n"
                        "Virtual participants neither see nor hear."));
  const std::string sessions = words_of(section(report.chapters[2], "Every session"));
  for (const SessionRow& session : study.sessions()) EXPECT_THAT(sessions, HasSubstr(session.seed));
}

TEST(StudyReport, IsTheSameOfTheSameStudyAndNumbersItsTables) {
  const Study study = Study::open(simulated().path() / "study", Access::read_only);
  const Report once = study_report(study, {});
  const Report again = study_report(study, {});
  int number = 0;
  for (std::size_t i = 0; i < once.chapters.size(); ++i) {
    EXPECT_EQ(words_of(once.chapters[i]), words_of(again.chapters.at(i)));
    for (const ReportSection& each : once.chapters[i].sections) {
      for (const ReportPart& part : each.parts) {
        if (const auto* table = std::get_if<ReportTable>(&part)) {
          EXPECT_EQ(table->number, ++number);
          for (const auto& row : table->rows) EXPECT_EQ(row.size(), table->columns.size());
        }
      }
    }
  }
  EXPECT_GT(number, 5);
}

TEST(StudyReport, EndsEarlyWhenItIsAskedTo) {
  const Study study = Study::open(simulated().path() / "study", Access::read_only);
  std::stop_source source{};
  source.request_stop();
  EXPECT_TRUE(study_report(study, {}, {}, source.get_token()).chapters.empty());
}

TEST(StudyReport, RefusesAProtocolThatTheStudyHasNoSessionOf) {
  const Study study = Study::open(simulated().path() / "study", Access::read_only);
  EXPECT_THROW(study_report(study, {}, "another"), ResultsError);
}

TEST(ReportTests, PutsStatisticDegreesAndAdjustedPTogether) {
  const std::vector<Finding> findings{
      found("chisq", "exp1", 9.1), found("chisq.df", "exp1", 2.0),
      found("chisq.p", "exp1", 0.0105672, "Pearson's X² against equal proportions"),
      found("chisq.p.holm", "exp1", 0.0317016)};
  const std::vector<ReportedTest> tests = tests_among(findings);
  ASSERT_EQ(tests.size(), 1U);
  EXPECT_EQ(sentence_of(tests[0]),
            "For exp1, Pearson's X² against equal proportions: χ²(2) = 9.10, p = .011, "
            "Holm-corrected p = "
            ".032 (n = 20).");
}

TEST(ReportTests, TakesNothingFromAnotherKeyOrAnalysis) {
  std::vector<Finding> findings{found("chisq", "a", 5.0), found("chisq", "b", 7.0),
                                found("chisq.p", "b", 0.5, "a test")};
  findings[2].analysis = "other";
  const std::vector<ReportedTest> tests = tests_among(findings);
  ASSERT_EQ(tests.size(), 1U);
  EXPECT_EQ(tests[0].statistic, nullptr) << "a stranger's";
  findings[1].analysis = "other";
  EXPECT_EQ(tests_among(findings)[0].statistic, &findings[1]);
}

TEST(ReportTests, GivesAnFBothItsDegreesOfFreedom) {
  const std::vector<Finding> findings{found("df1", "spacing", 4.0), found("df2", "spacing", 44.0),
                                      found("F", "spacing", 20.5267),
                                      found("p", "spacing", 1.3e-9, "analysis of variance")};
  const std::vector<ReportedTest> tests = tests_among(findings);
  ASSERT_EQ(tests.size(), 1U);
  EXPECT_EQ(sentence_of(tests[0]),
            "For spacing, analysis of variance: F(4, 44) = 20.53, p < .001 (n = 20).");
}

TEST(ReportTests, TellsWholesFromTheirParts) {
  const std::vector<Finding> findings{found("p", "column=1 item=a", 0.2, "a test"),
                                      found("p", "column=all item=a", 0.1, "a test"),
                                      found("p", "texture=brick item=a", 0.3, "a test")};
  const std::vector<ReportedTest> tests = tests_among(findings);
  ASSERT_EQ(tests.size(), 3U);
  EXPECT_FALSE(tests[0].is_of_whole);
  EXPECT_TRUE(tests[1].is_of_whole);
  EXPECT_TRUE(tests[2].is_of_whole) << "there is no whole of its kind";
  EXPECT_EQ(words_of_key("column=all item=a"), "a (all repetitions)");
  EXPECT_EQ(words_of_key("column=1 person=Other or not told"),
            "repetition 1, Other or not reported");
  EXPECT_EQ(words_of_key("condition:spacing"), "spacing by condition");
  EXPECT_EQ(words_of_quantity("peak.fieller"), "Fieller’s CI of the peak");
}

// Both p are alike; what is told is known by its name.
TEST(ReportResults, ListsATestThatNoTableHasWhateverItsP) {
  AnalysisOutcome outcome{};
  outcome.findings = {found("signflip.p.two", "a|b", 0.25, "sign flips"),
                      found("signflip.p.two", "a|c", 0.25, "other sign flips")};
  outcome.tables.push_back({.name = "tests", .table = {{"test", "p"}, {{std::string("x"), 0.25}}}});
  outcome.tests_in_tables.insert(name_of(outcome.findings[0]));
  const std::string words = words_of(numbers_section(outcome));
  EXPECT_THAT(words, HasSubstr("other sign flips | a, c"));
  EXPECT_THAT(words, Not(HasSubstr("a, b")));
}

TEST(ReportResults, SaysRefusalsAsSentences) {
  AnalysisOutcome outcome{};
  Finding refused{};
  refused.quantity = "p";
  refused.key = "item=a";
  refused.status =
      "the chance level differs between the trials, so that one test of all trials is not valid";
  outcome.findings = {refused};
  EXPECT_THAT(words_of(results_section(outcome, {})),
              HasSubstr("The test of a: the chance level differs between the trials, so that one "
                        "test of all trials is not valid."));
}

TEST(ReportResults, NamesWhatHasNoAnswerInWordsAndCountsTheStepsOfComputations) {
  const auto without = [](const char* quantity, const char* key, const char* analysis,
                          const char* status) {
    Finding finding{};
    finding.quantity = quantity;
    finding.key = key;
    finding.analysis = analysis;
    finding.status = status;
    return finding;
  };
  const char* undefined = kNotDefined;
  AnalysisOutcome outcome{};
  outcome.findings = {without("pooled.quad.vs.linear.F", "s1", "roughness", undefined),
                      without("peak.se.log10.pooledOLS", "s3", "roughness", undefined),
                      without("bt.order.status", "first", "scale", "nobody felt both orders"),
                      without("cochran.Q", "1", "position", "nobody differs"),
                      without("dprime", "", "recognition", "every response is correct"),
                      without("dprime.lower", "", "recognition", "every response is correct"),
                      without("replicates", "", "anova", "A has 2 rows")};
  const std::string words = words_of(results_section(outcome, {}));
  EXPECT_THAT(words, HasSubstr("The order effect on the preference scale: "
                               "nobody felt both orders.\n"));
  EXPECT_THAT(words, HasSubstr("Cochran’s Q of position 1: nobody differs.\n"));
  EXPECT_THAT(words, HasSubstr("The sensitivity d′ and the CI of the sensitivity d′: every "
                               "response is correct.\n"));
  EXPECT_THAT(words, HasSubstr("2 numbers of the appendix or of tables are not defined for these "
                               "data; asperity analyze STUDY --json lists each by name.\n"));
  EXPECT_THAT(words, Not(HasSubstr("pooledOLS")));
  EXPECT_THAT(words, Not(HasSubstr("A has 2 rows")));
}

TEST(ReportResults, AnswersTheQuestionsOfAnAnalysisFirst) {
  AnalysisOutcome outcome{};
  outcome.questions.push_back({"preference",
                               Phrase("Is one chosen more often?"),
                               Phrase("Yes: 15 of 20 times"),
                               Phrase("by counting"),
                               "",
                               {},
                               Phrase("20 answers")});
  const ReportSection results = results_section(outcome, {});
  const auto& first = std::get<ReportText>(results.parts.at(0));
  EXPECT_EQ(first.text, "Is one chosen more often? Yes: 15 of 20 times.");
  EXPECT_EQ(first.tone, ReportText::Tone::lead);
  EXPECT_EQ(std::get<ReportText>(results.parts.at(1)).text, "By counting. n = 20 answers.");
}

TEST(ReportResults, PutsAFigureBesideItsQuestion) {
  AnalysisOutcome outcome{};
  for (const char* name : {"first", "second"}) {
    outcome.questions.push_back({name, Phrase("Is it?"), Phrase("Yes"), {}, "", {}, {}});
  }
  Figure figure{};
  figure.name = "of_second";
  figure.question = "second";
  const std::vector<Figure> figures{figure};
  const ReportSection results = results_section(outcome, figures);
  ASSERT_EQ(results.parts.size(), 3U);
  EXPECT_EQ(std::get<ReportFigure>(results.parts[2]).figure.name, "of_second");
  EXPECT_TRUE(tables_section(outcome, figures).parts.empty()) << "once";
}

TEST(ReportResults, PutsTheOtherFiguresBesideTheirTablesBehind) {
  AnalysisOutcome outcome{};
  outcome.tables = {{"one", Phrase("One"), {{"a"}, {}}, {}},
                    {"two", Phrase("Two"), {{"a"}, {}}, {}}};
  Figure of_two{};
  of_two.name = "of_two";
  of_two.table = "two";
  Figure free{};
  free.name = "free";
  const std::vector<Figure> figures{of_two, free};
  const ReportSection results = results_section(outcome, figures);
  ASSERT_EQ(results.parts.size(), 1U) << "what was counted";
  EXPECT_EQ(std::get<ReportTable>(results.parts[0]).title, "One");
  const ReportSection behind = tables_section(outcome, figures);
  ASSERT_EQ(behind.parts.size(), 3U);
  EXPECT_EQ(std::get<ReportFigure>(behind.parts[0]).figure.name, "free");
  EXPECT_EQ(std::get<ReportFigure>(behind.parts[1]).figure.name, "of_two");
  EXPECT_EQ(std::get<ReportTable>(behind.parts[2]).title, "Two");
}

TEST(ReadingNumber, HasTheDigitsThatMeanSomething) {
  EXPECT_EQ(reading_number(0.60412345), "0.6041");
  EXPECT_EQ(reading_number(47.0), "47");
  EXPECT_EQ(reading_number(2.51e-23), "2.5e-23");
  EXPECT_EQ(reading_p(0.0112), "p = .011");
  EXPECT_EQ(reading_p(0.0004), "p < .001");
  EXPECT_EQ(reading_p(1.0), "p > .999");
  EXPECT_EQ(reading_p(0.9994), "p = .999");
  EXPECT_EQ(reading_percent(0.7833), "78 %");
  EXPECT_EQ(reading_percent(0.975), "97 %") << "as a table rounds it to two decimals";
  EXPECT_EQ(reading_p_cell(0.0004), "< .001");
  EXPECT_EQ(reading_percent(0.002), "0.2 %") << "not nothing";
  EXPECT_EQ(reading_percent(0.998), "99.8 %") << "not all";
  EXPECT_EQ(reading_percent(0.0004), "< 0.1 %") << "nor 0.0 %";
  EXPECT_EQ(reading_percent(0.9996), "> 99.9 %") << "nor 100.0 %";
  EXPECT_EQ(reading_percent(0.0), "0 %");
  EXPECT_EQ(reading_percent(1.0), "100 %");
  EXPECT_EQ(reading_quantity(31e-6, "s"), "31 µs");
  EXPECT_EQ(reading_quantity(0.05, "m/s"), "50 mm/s");
  EXPECT_EQ(reading_quantity(0.8, "N"), "0.8 N");
  EXPECT_EQ(reading_quantity(6876.0, "Pa"), "6.88 kPa");
  EXPECT_EQ(reading_quantity(2.5e6, "Pa"), "2.5 MPa");
  EXPECT_EQ(reading_quantity(0.0, "s"), "0 s");
  EXPECT_EQ(reading_count(9999), "9999");
  EXPECT_EQ(count_in_words(3), "three");
  EXPECT_EQ(count_in_words(12), "12");
}

TEST(ReadingNumber, HasAMinusSign) {
  EXPECT_EQ(reading_number(-0.60412345), "−0.6041");
  EXPECT_EQ(reading_number(-12.0), "−12");
  EXPECT_EQ(reading_number(-0.0), "0");
  EXPECT_EQ(reading_whole(-3), "−3");
  EXPECT_EQ(reading_quantity(-0.002, "m"), "−2 mm");
}

TEST(UnbrokenNumbers, HaveNoBreakSpacesOnlyWithinNumbers) {
  const auto shown = [](const std::string& text) {  // with "_" for a no-break space
    std::string unbroken = with_numbers_unbroken(text);
    for (std::size_t at = unbroken.find("\u00A0"); at != std::string::npos;
         at = unbroken.find("\u00A0", at)) {
      unbroken.replace(at, 2, "_");
    }
    return unbroken;
  };
  EXPECT_EQ(shown("95 % CI [0.16, 0.49], N = 8"), "95_% CI [0.16,_0.49], N_=_8");
  EXPECT_EQ(shown("F(2, 38) = 5.17, p < .001, g = −0.10 [−0.16, 0.49]"),
            "F(2,_38)_=_5.17, p_<_.001, g_=_−0.10 [−0.16,_0.49]");
  EXPECT_EQ(shown("at 50 mm/s, 4 N and 1000 Hz."), "at 50_mm/s, 4_N and 1000_Hz.");
  EXPECT_EQ(shown("62 % (95 % CI [< 0.1 %, 71 %])"), "62_% (95_% CI [<_0.1_%,_71_%])");
  EXPECT_EQ(shown("One of 4 participants (a, b) chose x = y in block 2 s1."),
            "One of 4 participants (a, b) chose x = y in block 2 s1.");
}

}  // namespace
}  // namespace asperity

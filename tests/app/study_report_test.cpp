// What a report states of a study: its participants, sessions and attempts.

#include "app/report/text/study_report.h"

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/numbers/number_text.h"
#include "app/findings/tidy/finding_list.h"
#include "app/report/text/report_sections.h"
#include "app/tasks/simulation/simulation.h"
#include "tests/app/made_up_study.h"
#include "tests/app/report_words.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

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
  const Report report = study_report(made.study());
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
  const Report report = study_report(made.study());
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
  const Report report = study_report(made.study());
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
  const Report report = study_report(made.study());
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

  const Report report = study_report(made.study());
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
  const Report report = study_report(made.study());
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
  const Report report = study_report(made.study());
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
  const Report report = study_report(made.study());
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
  const Report report = study_report(made.study());
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
  EXPECT_THAT(words_of(study_report(made.study()).chapters.at(1)),
              HasSubstr("eight_map was chosen most often"));
  SessionRow running = made.study().sessions().front();
  running.participant = "p2";
  running.session = 0;
  running.state = SessionState::open;
  running.ended_utc.reset();
  made.study().add_session(running, {});
  const auto lock = std::make_unique<StudyLock>(made.folder(), Study::session_lock_name("p2"));
  const std::string words = words_of(study_report(made.study()).chapters.at(1));
  EXPECT_THAT(words, HasSubstr("its experimenter is blind"));
  EXPECT_THAT(words, Not(HasSubstr("was chosen")));
  EXPECT_THAT(words, Not(HasSubstr("proportion chosen")));
  const std::string appendix = words_of(study_report(made.study()).chapters.at(2));
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
  const Report report = study_report(made.study());
  const std::string words = words_of(section(report.chapters.at(1), "Presentation"));
  EXPECT_THAT(words, HasSubstr("at most 30 µs late; in the worst attempt, 40 µs"));
  EXPECT_THAT(words, AllOf(HasSubstr("The servo loop was set to 1000 Hz; it ran 12"),
                           HasSubstr(" ticks in 2 attempts. In the median")));
  EXPECT_THAT(words,
              HasSubstr("3 deadlines were missed in one attempt (one in contact) and 1 tick was "
                        "not recorded in one attempt."));
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

}  // namespace
}  // namespace asperity

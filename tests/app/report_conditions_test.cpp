// What a report states of the conditions of sessions, from what they recorded.

#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/numbers/number_text.h"
#include "app/records/session_conditions.h"
#include "app/report/text/report_sections.h"
#include "app/report/text/study_report.h"
#include "tests/app/made_up_study.h"
#include "tests/app/report_words.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

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

/// Sessions of human participants whose conditions a test writes.
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
    report_ = study_report(made_.study());
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

}  // namespace
}  // namespace asperity

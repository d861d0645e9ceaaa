// One session, from its plan to its rows: the real loop, the real store, a scripted person.

#include "app/session/conductor.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <sstream>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/session/attempt_measures.h"
#include "app/session/respondents/terminal_respondent.h"
#include "app/session/respondents/typed_answer.h"
#include "app/session/rig/contact_reader.h"
#include "app/session/rig/recording_columns.h"
#include "app/words/coded_phrases.h"
#include "app/words/reason.h"
#include "results_schema/tables/table.h"
#include "tests/app/scripted_session.h"

namespace asperity {
namespace {

using ConductorTest = SessionTest;

TEST_F(ConductorTest, StoresEveryTrialOfThePlanInOrder) {
  begin(small_protocol());
  const SessionEnd end = run();
  EXPECT_EQ(end.state, SessionState::completed);
  const auto rows = attempts();
  ASSERT_EQ(rows.size(), 3U);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].trial, static_cast<int>(i) + 1);
    EXPECT_TRUE(rows[i].valid);
    ASSERT_EQ(rows[i].presentations.size(), 2U);
    ASSERT_EQ(rows[i].responses.size(), 1U);
    // The first option of a selection is the first surface.
    EXPECT_EQ(rows[i].responses[0].answer, rows[i].presentations[0].item);
    EXPECT_NEAR(*rows[i].responses[0].from_cue_s, 0.2, 1e-3);
  }
  EXPECT_EQ(study_->session(session_.row.id).state, SessionState::completed);
  EXPECT_EQ(done_.size(), 3U);
}

TEST_F(ConductorTest, LetsEverySurfaceBeFeltAsLongAsAskedFor) {
  begin(small_protocol());
  run();
  for (const AttemptRow& row : attempts()) {
    for (const PresentationRow& surface : row.presentations) {
      EXPECT_GE(surface.contact_s, 0.5);
      EXPECT_LT(surface.contact_s, 1.0);
      EXPECT_LE(*surface.onset_ns, *surface.contact_ns);
      EXPECT_LT(*surface.contact_ns, *surface.offset_ns);
    }
    // Reaction times count from the first contact with the first surface.
    EXPECT_NEAR(
        *row.responses[0].from_contact_s,
        static_cast<double>(row.responses[0].time_ns - *row.presentations[0].contact_ns) * 1e-9,
        1e-9);
  }
}

TEST_F(ConductorTest, ReportsATrialOnlyWhenItsRowIsStored) {
  begin(small_protocol());
  Conductor conductor(
      *study_, protocol_, *builder_, *rig_, person_,
      {.record = true, .done = [this](const AttemptDone& done) {
         const Study other = Study::open(folder_.path() / "study", Access::read_only);
         const auto rows = other.attempts(session_.row.id);
         ASSERT_FALSE(rows.empty());
         EXPECT_EQ(rows.back().trial, done.trial);
         EXPECT_TRUE(std::filesystem::exists(other.folder() / rows.back().recording->path));
       }});
  conductor.run(session_);
}

TEST_F(ConductorTest, ReportsWhetherAnAttemptCountsAndWhyItsTrialIsRepeated) {
  begin(small_protocol());
  std::vector<std::string> lines{};
  links_.tell = [&lines](const std::string& line) { lines.push_back(line); };
  person_.at_question = [this](int question, const Trial&) -> Reply {
    if (question == 2) conductor_->requests().skip("the sample broke");
    if (question == 2) return feels_again(1);
    if (question == 3) conductor_->requests().repeat_last("the door banged");
    return chooses(0);
  };
  EXPECT_EQ(run().state, SessionState::completed);
  std::vector<std::string> reported{};
  for (const AttemptDone& done : done_) {
    reported.push_back(std::to_string(done.trial) + '/' + std::to_string(done.attempt) +
                       (done.counts ? " counts" : std::string(" ") + text_of(done.outcome)));
  }
  EXPECT_THAT(reported,
              testing::ElementsAre("1/1 counts", "2/1 skipped", "3/1 counts", "3/2 counts"));
  EXPECT_THAT(lines, testing::ElementsAre(
                         "Trial 3 is repeated: repeated by the experimenter: the door banged."));
}

// The loop ticks late sixty times, where fifty are allowed: after a surface was felt, then while one is felt.
TEST_F(ConductorTest, JudgesAnAttemptByTheDeadlinesMissedInContact) {
  begin(small_protocol());
  const auto tick_late = [this](bool in_contact) {
    TickRecord late{};
    late.probe.time_ns = rig_->clock().now_ns();
    late.flags = static_cast<std::uint32_t>(TickFlag::missed_deadline);
    if (in_contact) {
      late.presentation = 1;
      late.penetration_m = 1e-4;
      late.flags |= static_cast<std::uint32_t>(TickFlag::presenting);
    }
    for (int i = 0; i < 60; ++i) rig_->records().push(late);
  };
  rig_->at_pass = [&, was_presented = false, times = std::size_t{0}]() mutable {
    const bool is_presented = rig_->loop().status().presentation != 0;
    const bool is_moment = times == 0 ? was_presented && !is_presented : is_presented;
    was_presented = is_presented;
    if (times > 1 || done_.size() != times || !is_moment) return;
    tick_late(times == 1);
    ++times;
  };
  EXPECT_EQ(run().state, SessionState::completed);
  const std::vector<AttemptRow> rows = attempts();
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_TRUE(rows[0].valid);
  EXPECT_EQ(rows[0].servo->missed_deadlines, 60);
  EXPECT_EQ(rows[0].servo->missed_in_contact, 0);
  EXPECT_FALSE(rows[1].valid);
  EXPECT_EQ(rows[1].servo->missed_in_contact, 60);
  EXPECT_EQ(rows[1].invalid_reason.value().text,
            "deadlines missed in contact: 60, at most 50 allowed");
  EXPECT_EQ(codes_of(*rows[1].invalid_reason), "deadlines_missed_in_contact");
  EXPECT_EQ(phrase_of(rows[1].invalid_reason).english(), rows[1].invalid_reason->text);
  EXPECT_TRUE(rows[2].valid);
}

// Sixty gaps in contact, where fifty are allowed.
TEST_F(ConductorTest, JudgesAnAttemptByTheGapsInContact) {
  begin(small_protocol());
  rig_->at_pass = [&, is_done = false]() mutable {
    if (is_done || rig_->loop().status().presentation == 0) return;
    is_done = true;
    TickRecord gap{};
    gap.probe.time_ns = rig_->clock().now_ns();
    gap.flags = static_cast<std::uint32_t>(TickFlag::gap_in_contact);
    for (int i = 0; i < 60; ++i) rig_->records().push(gap);
  };
  EXPECT_EQ(run().state, SessionState::completed);
  const std::vector<AttemptRow> rows = attempts();
  EXPECT_FALSE(rows[0].valid);
  EXPECT_EQ(rows[0].servo->gaps_in_contact, 60);
  EXPECT_EQ(rows[0].invalid_reason.value().text,
            "gaps between ticks in contact: 60, at most 50 allowed");
  EXPECT_EQ(codes_of(*rows[0].invalid_reason), "gaps_in_contact");
  EXPECT_TRUE(rows[1].valid);
}

TEST_F(ConductorTest, RecordsEveryTickOfAnAttempt) {
  begin(small_protocol());
  run();
  const AttemptRow row = attempts().front();
  const Recording recording = read_recording(folder_.path() / "study" / row.recording->path);
  EXPECT_EQ(static_cast<std::int64_t>(recording.time_ns.size()), row.servo->ticks);
  EXPECT_EQ(row.servo->lost_records, 0);
  EXPECT_NEAR(static_cast<double>(row.servo->ticks) / 1000.0,
              static_cast<double>(row.offset_ns - row.onset_ns) * 1e-9, 0.002);
}

TEST_F(ConductorTest, KeepsAnAbortedAttemptAndAsksAgainAfterAResume) {
  begin(small_protocol());
  person_.at_question = [this](int question, const Trial&) -> Reply {
    if (question < 2) return chooses(0);
    conductor_->requests().abort("the fire alarm rang");
    return feels_again(1);  // feels surface 1 again, and is interrupted in it
  };
  SessionEnd end = run();
  EXPECT_EQ(end.state, SessionState::stopped);
  EXPECT_EQ(end.reason, "the fire alarm rang");
  ASSERT_EQ(attempts().size(), 2U);
  EXPECT_EQ(attempts()[1].outcome, AttemptOutcome::aborted);
  EXPECT_EQ(attempts()[1].invalid_reason.value().text, "the fire alarm rang");

  reopen_session();
  person_.at_question = {};
  end = run();
  EXPECT_EQ(end.state, SessionState::completed);
  const auto rows = attempts();
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[2].trial, 2);
  EXPECT_EQ(rows[2].attempt, 2);
  EXPECT_EQ(rows[2].segment, 2);
  EXPECT_EQ(rows[3].trial, 3);
}

TEST_F(ConductorTest, StopsAfterTheTrialWhenAsked) {
  begin(small_protocol());
  person_.at_question = [this](int, const Trial&) -> Reply {
    conductor_->requests().stop_after(StopAfter::trial);
    return chooses(0);
  };
  const SessionEnd end = run();
  EXPECT_EQ(end.state, SessionState::stopped);
  ASSERT_EQ(attempts().size(), 1U);
  EXPECT_TRUE(attempts().front().valid);
}

TEST_F(ConductorTest, KeepsASkippedTrialAndDoesNotAskItAgain) {
  begin(small_protocol());
  person_.at_question = [this](int question, const Trial&) -> Reply {
    if (question == 1) {
      conductor_->requests().skip("the picture fell down");
      return feels_again(1);  // feels again, and is interrupted in it
    }
    return chooses(0);
  };
  const SessionEnd end = run();
  EXPECT_EQ(end.state, SessionState::completed);
  const auto rows = attempts();
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].outcome, AttemptOutcome::skipped);
  EXPECT_EQ(rows[0].invalid_reason.value().text, "the picture fell down");
  EXPECT_TRUE(rows[0].responses.empty());
  EXPECT_EQ(rows[1].trial, 2);
}

TEST_F(ConductorTest, LetsASurfaceBeFeltAgainBeforeTheAnswer) {
  begin(small_protocol());
  person_.at_question = [](int question, const Trial&) -> Reply {
    if (question == 1) return feels_again(2);
    return chooses(1);
  };
  run();
  const auto rows = attempts();
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(person_.felt_positions, (std::vector<int>{1, 2, 2, 1, 2, 1, 2}));
  EXPECT_GT(rows[0].presentations[1].contact_s, 1.8 * rows[0].presentations[0].contact_s);
}

TEST_F(ConductorTest, AsksATrialAgainAtOnceWhenItWasNotExploredAsAsked) {
  // The hand aims at the middle of the band, but the narrow band is not kept for 99 % of the time.
  begin(small_protocol("", R"(, "normal_force_N": {"minimum": 0.999, "maximum": 1.001},
       "required_fraction_in_band": 0.99, "on_failure": "repeat_now", "maximum_repeats": 1)"));
  const SessionEnd end = run();
  EXPECT_EQ(end.state, SessionState::completed);
  const auto rows = attempts();
  ASSERT_EQ(rows.size(), 6U);
  EXPECT_EQ(rows[0].outcome, AttemptOutcome::not_compliant);
  EXPECT_FALSE(rows[0].valid);
  EXPECT_EQ(rows[1].trial, 1);
  EXPECT_EQ(rows[1].attempt, 2);
  EXPECT_TRUE(rows[1].valid);    // the last repeat counts
  EXPECT_TRUE(rows[1].flagged);  // and says what was wrong
  EXPECT_NE(rows[1].flag_reason->text.find("normal force of surface 1"), std::string::npos);
}

TEST_F(ConductorTest, AsksATrialAgainAtTheEndOfTheBlock) {
  begin(small_protocol("", R"(, "normal_force_N": {"minimum": 0.999, "maximum": 1.001},
       "required_fraction_in_band": 0.99, "on_failure": "requeue_at_end_of_block",
       "maximum_repeats": 1)"));
  run();
  std::vector<int> trials{};
  for (const AttemptDone& done : done_) trials.push_back(done.trial);
  EXPECT_EQ(trials, (std::vector<int>{1, 2, 3, 1, 2, 3}));
}

// The texture is away and the hand strokes on a plain plate: what it means to press is what it presses.
TEST_F(ConductorTest, TakesAHandAtNineTenthsOfTheTargetAndAsksOneAtOneAndAHalfAgain) {
  begin(small_protocol("", R"(, "normal_force_N": {"minimum": 0.75, "target": 0.9, "maximum": 1.25},
       "strokes": {"target": 4}, "required_fraction_in_band": 0.7, "on_failure": "repeat_now",
       "maximum_repeats": 1)"));
  protocol_.stimuli.at("rendered").parameters["height_scale"] = {ParameterValue{0.0}, ""};
  protocol_.blocks.at("main").presented.pop_back();
  session_.course.emplace(protocol_, Allocation{.seed = 7});
  person_.at_question = [this](int question, const Trial&) -> Reply {
    auto& force_N = protocol_.explorations.at("short").normal_force_N;
    force_N.target = question == 1 ? 1.5 : 0.9;
    return chooses(0);
  };
  run();
  const auto rows = attempts();
  ASSERT_EQ(rows.size(), 4U);  // the second trial twice
  const auto force_of = [](const AttemptRow& row) { return row.compliance.at(0); };
  EXPECT_TRUE(rows[0].valid);
  EXPECT_FALSE(rows[0].flagged);
  EXPECT_EQ(force_of(rows[0]).passed, true);
  EXPECT_NEAR(force_of(rows[0]).p50, 0.9, 0.09);
  EXPECT_EQ(rows[1].trial, 2);
  EXPECT_EQ(rows[1].outcome, AttemptOutcome::not_compliant);
  EXPECT_EQ(rows[1].invalid_reason.value().text,
            "not explored as instructed: normal force of surface 1");
  EXPECT_EQ(force_of(rows[1]).passed, false);
  EXPECT_GT(force_of(rows[1]).p50, 1.25);
  EXPECT_LT(*force_of(rows[1]).fraction_in_band, 0.3);  // while the force rises
  EXPECT_EQ(rows[2].trial, 2);
  EXPECT_EQ(rows[2].attempt, 2);
  EXPECT_TRUE(rows[2].valid);
  EXPECT_FALSE(rows[2].flagged);
}

// Ten strokes of 50 mm by a hand that is told 1 N and 100 mm/s; it slows down where it turns, as a
// sinusoid does, on a texture that shakes it. Bands are 20 % to either side.
std::vector<ComplianceRow> stroked_at(double times_target, JudgedForce force = JudgedForce::sent) {
  constexpr double kPi = 3.14159265358979;
  std::vector<TickRecord> records{};
  for (int i = 0; i <= std::lround(5000.0 / times_target); ++i) {
    TickRecord record{};
    record.probe.time_ns = 1'000'000LL * i;
    record.presentation = 1;
    record.flags = static_cast<std::uint32_t>(TickFlag::presenting);
    record.penetration_m = 1e-4;
    record.gain = 1.0;
    const double ripple = std::sin(2.0 * kPi * 50.0 * 1e-3 * i);
    Wrench& given = force == JudgedForce::sent ? record.sent : record.rendered;
    given.force_N = {0.2, 0.0, times_target * (1.0 + 0.3 * ripple)};
    record.probe.position_m.x = -0.025 * std::cos(kPi * 2e-3 * times_target * i) + 2e-5 * ripple;
    records.push_back(record);
  }
  Exploration asked{};
  asked.normal_force_N = {.minimum = 0.8, .target = 1.0, .maximum = 1.2};
  asked.speed_m_per_s = {.minimum = 0.08, .target = 0.1, .maximum = 0.12};
  asked.required_fraction_in_band = 0.7;
  return compliance_of(records, 1, 1000.0, asked, force);
}

TEST(AttemptMeasures, PassAHandAtNineTenthsOfTheTargetAndFailOneAtOneAndAHalf) {
  for (const double times_target : {0.9, 1.5}) {
    const auto rows = stroked_at(times_target);
    const ComplianceRow& force = rows.at(0);
    const ComplianceRow& speed = rows.at(1);
    const bool is_inside = times_target < 1.0;
    EXPECT_NEAR(force.mean, times_target, 0.01);
    EXPECT_LT(force.sd, 0.03 * times_target);  // of 0.21: the ripple
    EXPECT_EQ(force.fraction_in_band, is_inside ? 1.0 : 0.0);
    EXPECT_EQ(force.passed, is_inside);
    EXPECT_NEAR(speed.mean, 0.1 * times_target, 0.003);
    EXPECT_EQ(speed.fraction_in_band, is_inside ? 1.0 : 0.0);
    EXPECT_EQ(speed.passed, is_inside);
  }
}

// A device without motors is sent no force.
TEST(AttemptMeasures, JudgeAHandThatIsPushedByNothingByTheRenderedForce) {
  const ComplianceRow force = stroked_at(0.9, JudgedForce::rendered).at(0);
  EXPECT_NEAR(force.mean, 0.9, 0.01);
  EXPECT_EQ(force.passed, true);
  EXPECT_EQ(judged_force_of({.actuated_degrees_of_freedom = 0}), JudgedForce::rendered);
  EXPECT_EQ(judged_force_of({.actuated_degrees_of_freedom = 3}), JudgedForce::sent);
}

// What the windows show of a hand while it feels, its row in the store, and what anybody computes of the
// recording: one number.
TEST_F(ConductorTest, ShowsOfTheHandWhatItsRecordingGivesAgain) {
  SessionMonitor monitor{};
  links_.monitor = &monitor;
  begin(small_protocol("", R"(, "strokes": {"target": 4}, "normal_force_N": {"minimum": 0.9,
       "maximum": 1.1}, "speed_m_per_s": {"minimum": 0.06, "maximum": 0.09})"));
  std::vector<HandSoFar> shown{};
  person_.at_question = [&](int, const Trial&) -> Reply {
    shown.push_back(monitor.snapshot().hand);
    return chooses(0);
  };
  run();
  std::vector<LiveBin> bins{};
  monitor.bins_from(0, bins);
  const auto rows = attempts();
  ASSERT_EQ(shown.size(), rows.size());
  std::size_t bins_held = 0;
  std::size_t strokes_told = 0;
  std::array<std::set<double>, 2> fractions{};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto records =
        records_of(read_recording(folder_.path() / "study" / rows[i].recording->path));
    const auto computed =
        compliance_of(records, 2, protocol_.rate_Hz, protocol_.explorations.at("short"));
    EXPECT_EQ(shown[i].surface, 2);
    for (std::size_t quantity = 0; quantity < 2; ++quantity) {
      const QuantitySoFar& live = quantity == 0 ? shown[i].force_N : shown[i].speed_m_per_s;
      const ComplianceRow& stored = rows[i].compliance.at(5 + quantity);
      EXPECT_EQ(stored.quantity, computed[quantity].quantity);
      EXPECT_GT(live.samples, 0);
      EXPECT_GT(live.mean, 0.01);
      EXPECT_NEAR(live.mean, computed[quantity].mean, 1e-9);
      EXPECT_NEAR(live.sd, computed[quantity].sd, 1e-9);
      EXPECT_NEAR(*live.fraction_in_band, *computed[quantity].fraction_in_band, 1e-9);
      fractions[quantity].insert(*live.fraction_in_band);
      EXPECT_EQ(stored.mean, computed[quantity].mean);
      EXPECT_EQ(stored.fraction_in_band, computed[quantity].fraction_in_band);
    }
    HandWatch again({.usual_stroke_m = 0.06});
    for (const TickRecord& record : records) {
      again.take(record);
      const auto bin = std::find_if(bins.begin(), bins.end(), [&](const LiveBin& one) {
        return one.time_ns == record.probe.time_ns;
      });
      if (bin == bins.end() || !again.now()) continue;
      ++bins_held;
      EXPECT_NEAR(bin->pressing_N, again.now()->pressing_N, 1e-9);
      EXPECT_EQ(bin->stroking_m_per_s, again.now()->stroking_m_per_s);
      if (bin->stroking_m_per_s) ++strokes_told;
    }
  }
  EXPECT_GT(bins_held, 100U);
  EXPECT_GT(strokes_told, 50U);
  for (const std::set<double>& seen : fractions) {
    EXPECT_LT(*seen.begin(), 1.0);  // there was something to agree on
    EXPECT_GT(*seen.rbegin(), 0.0);
  }
}

// A hand that is never steady, and slows down to rest at every turn, strokes as fast on the whole as is
// asked; another half as fast again. Both through the whole of a session.
TEST_F(ConductorTest, TakesANaturalHandOnTargetAndAsksOneThatIsTooFastAgain) {
  SessionMonitor monitor{};
  links_.monitor = &monitor;
  begin(small_protocol("", R"(, "speed_m_per_s": {"minimum": 0.07, "target": 0.1, "maximum": 0.13},
       "stroke_length_m": {"target": 0.05}, "strokes": {"target": 5},
       "required_fraction_in_band": 0.6, "on_failure": "requeue_at_end_of_block",
       "maximum_repeats": 1)"));
  double times_target = 1.0;
  rig_->at_prepare = [&](HandHabits& hand) {
    hand.gathering = 0.5;
    hand.speed_m_per_s = times_target * 0.1 / (1.0 - hand.gathering);
    hand.speed_variation = 0.05;
  };
  std::vector<double> live{};
  person_.at_question = [&](int question, const Trial&) -> Reply {
    times_target = question == 1 ? 1.5 : 1.0;
    live.push_back(monitor.snapshot().hand.speed_m_per_s.fraction_in_band.value_or(-1.0));
    return chooses(0);
  };
  run();
  std::vector<int> trials{};
  for (const AttemptDone& done : done_) trials.push_back(done.trial);
  EXPECT_EQ(trials, (std::vector<int>{1, 2, 3, 2}));
  const auto rows = attempts();  // by trial
  ASSERT_EQ(rows.size(), 4U);
  const std::array<double, 4> shown{live[0], live[1], live[3], live[2]};
  for (const std::size_t on_target : {0U, 2U, 3U}) {
    EXPECT_TRUE(rows[on_target].valid);
    EXPECT_FALSE(rows[on_target].flagged);
    const ComplianceRow& speed = rows[on_target].compliance.at(6);
    EXPECT_GE(*speed.fraction_in_band, 0.6);
    EXPECT_EQ(shown[on_target], *speed.fraction_in_band);
    EXPECT_NEAR(speed.mean, 0.1, 0.02);
  }
  EXPECT_EQ(rows[1].outcome, AttemptOutcome::not_compliant);
  EXPECT_EQ(rows[1].invalid_reason.value().text,
            "not explored as instructed: speed of surface 1, speed of surface 2");
  EXPECT_LT(shown[1], 0.4);
}

TEST_F(ConductorTest, GuidesTheHandOfAParticipantOnlyWhileASurfaceIsFeltAndWhereTheProtocolSaysSo) {
  SessionMonitor monitor{};
  links_.monitor = &monitor;
  begin(small_protocol("", R"(, "guidance": "bars", "normal_force_N": {"minimum": 0.7})"));
  int guided = 0;
  rig_->at_pass = [&] {
    const auto scene = monitor.snapshot().scene;
    EXPECT_EQ(scene->guide.has_value(),
              scene->kind == ParticipantScene::Kind::feel &&
                  protocol_.explorations.at("short").guidance == Exploration::Guidance::bars);
    if (!scene->guide) return;
    ++guided;
    EXPECT_EQ(scene->guide->normal_force_N.minimum, 0.7);
  };
  int guided_at_first = 0;
  person_.at_question = [&](int, const Trial&) -> Reply {
    protocol_.explorations.at("short").guidance = Exploration::Guidance::experimenter;
    if (guided_at_first == 0) guided_at_first = guided;
    return chooses(0);
  };
  run();
  EXPECT_GT(guided_at_first, 20);
  EXPECT_EQ(guided, guided_at_first);
}

std::vector<std::string> kinds_of(const std::vector<EventRow>& events) {
  std::vector<std::string> kinds{};
  for (const EventRow& event : events) kinds.push_back(event.kind);
  return kinds;
}

TEST_F(ConductorTest, EndsAPracticeWithItsCriterion) {
  begin(practised_protocol("end_session"));
  person_.at_question = [](int question, const Trial& trial) {
    return question == 1 ? incorrect_reply(trial) : correct_reply(trial);
  };
  EXPECT_EQ(run().state, SessionState::completed);
  const auto rows = attempts();
  ASSERT_EQ(rows.size(), 5U);  // wrong, right, right, right, and the main trial
  EXPECT_EQ(rows[4].trial, 6);
  EXPECT_EQ(person_.texts[0], "Incorrect.");
  EXPECT_EQ(person_.texts[1], "Correct.");
}

TEST_F(ConductorTest, EndsTheSessionWhereThePracticeFailsAndTheProtocolSaysSo) {
  begin(practised_protocol("end_session"));
  person_.at_question = [](int, const Trial& trial) { return incorrect_reply(trial); };
  const SessionEnd end = run();
  EXPECT_EQ(end.state, SessionState::stopped);
  EXPECT_TRUE(end.as_the_protocol_says);
  EXPECT_EQ(attempts().size(), 5U);
  EXPECT_THAT(kinds_of(study_->events(session_.row.id)), testing::Contains("criterion_not_met"));
}

TEST_F(ConductorTest, ContinuesMarkedWhereThePracticeFailsAndTheProtocolSaysSo) {
  begin(practised_protocol("continue_flagged"));
  person_.at_question = [](int, const Trial& trial) { return incorrect_reply(trial); };
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_EQ(attempts().size(), 6U);
  EXPECT_THAT(kinds_of(study_->events(session_.row.id)), testing::Contains("criterion_not_met"));
}

TEST_F(ConductorTest, StopsTheForceAtOnceWhenTheEmergencyStopIsPressed) {
  begin(small_protocol());
  person_.at_question = [this](int, const Trial&) -> Reply {
    conductor_->requests().emergency_stop();
    return feels_again(1);
  };
  const SessionEnd end = run();
  EXPECT_EQ(end.state, SessionState::stopped);
  EXPECT_EQ(end.reason, "the emergency stop was pressed in trial 1");
  const auto rows = attempts();
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].outcome, AttemptOutcome::emergency_stop);
  EXPECT_EQ(rows[0].invalid_reason.value().text, "the emergency stop was pressed");
  EXPECT_EQ(rows[0].servo->fault, "emergency_stop");
  const Recording recording = read_recording(folder_.path() / "study" / rows[0].recording->path);
  const std::vector<TickRecord> records = records_of(recording);
  EXPECT_EQ(records.back().sent.force_N, glm::dvec3{0.0});
}

// On a busy machine the conductor may know of the stop before the servo has ticked again.
TEST_F(ConductorTest, RecordsTheTickInWhichAStopActed) {
  begin(small_protocol());
  rig_->at_pass = [this] {
    if (rig_->loop().status().presentation != 0) rig_->loop().emergency_stop();
  };
  EXPECT_EQ(run().state, SessionState::stopped);
  const AttemptRow row = attempts().at(0);
  const auto records = records_of(read_recording(folder_.path() / "study" / row.recording->path));
  EXPECT_TRUE(records.back().has(TickFlag::fault_latched));
  EXPECT_EQ(records.back().sent.force_N, glm::dvec3{0.0});
}

TEST_F(ConductorTest, SaysThatItWasTheEmergencyStopAlsoBetweenTrials) {
  begin(small_protocol());
  rig_->at_pass = [this] { conductor_->requests().emergency_stop(); };
  const SessionEnd end = run();
  EXPECT_THAT(end.reason.english(),
              testing::StartsWith("the emergency stop was pressed between trials"));
  EXPECT_THAT(end.reason.english(), testing::Not(testing::HasSubstr("device")));
}

TEST_F(ConductorTest, ReportsTheTextureForceWithoutTheFrictionOfTheTurningHand) {
  // A plain plate: whatever the hand does, there is no texture in its force.
  begin(small_protocol("", R"(, "strokes": {"target": 4})"));
  protocol_.stimuli.at("rendered").parameters["height_scale"] = {ParameterValue{0.0}, ""};
  protocol_.blocks.at("main").presented.pop_back();
  session_.course.emplace(protocol_, Allocation{.seed = 7});
  run();
  for (const AttemptRow& row : attempts()) {
    ASSERT_TRUE(row.presentations[0].achieved_texture_force_N);
    EXPECT_NEAR(*row.presentations[0].achieved_texture_force_N, 0.0, 1e-6);
  }
}

TEST_F(ConductorTest, TakesALateAnswerForNoneAndContinues) {
  begin(small_protocol());
  person_.at_question = [](int question, const Trial&) -> Reply {
    return question == 2 ? Reply{} : chooses(0);
  };
  EXPECT_EQ(run().state, SessionState::completed);
  const auto rows = attempts();
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[1].outcome, AttemptOutcome::timed_out);
  EXPECT_TRUE(rows[1].valid);
  EXPECT_TRUE(rows[1].responses.empty());
}

TEST_F(ConductorTest, GivesUpATrialWhoseSurfaceCannotBeTouched) {
  std::string text = small_protocol();
  text.insert(text.find("\"textures\""), R"("surface": {"centre_m": [0, 0, -1]}, )");
  begin(text);
  protocol_.patch.centre_m = {0.0, 0.0, 0.0};  // the hand strokes there, a metre above the surface
  const SessionEnd end = run();
  EXPECT_EQ(end.state, SessionState::stopped);
  EXPECT_NE(end.reason.english().find("surface 1 was not touched"), std::string::npos);
  const auto rows = attempts();
  ASSERT_EQ(rows.size(), 3U);
  for (const AttemptRow& row : rows) EXPECT_EQ(row.outcome, AttemptOutcome::not_compliant);
}

TEST_F(ConductorTest, AsksARequeuedTrialAgainAfterAllOthersEveryTime) {
  begin(small_protocol("", R"(, "normal_force_N": {"minimum": 0.999, "maximum": 1.001},
       "required_fraction_in_band": 0.99, "on_failure": "requeue_at_end_of_block",
       "maximum_repeats": 2)"));
  run();
  std::vector<int> trials{};
  for (const AttemptDone& done : done_) trials.push_back(done.trial);
  EXPECT_EQ(trials, (std::vector<int>{1, 2, 3, 1, 2, 3, 1, 2, 3}));
}

TEST_F(ConductorTest, HoldsTheLongestContactOfEachVisitAgainstTheMaximum) {
  begin(small_protocol());
  person_.at_question = [](int question, const Trial&) -> Reply {
    if (question < 5)
      return feels_again(1);  // goes back to the first surface four times, 0.6 s each
    return chooses(0);
  };
  run();
  const AttemptRow row = attempts().front();
  EXPECT_GT(row.presentations[0].contact_s, 2.0);  // more than a single visit may last
  EXPECT_FALSE(row.flagged) << row.flag_reason.value_or("").text;
}

TEST_F(ConductorTest, CountsReactionTimesFromTheFirstTimeTheQuestionWasPut) {
  begin(small_protocol());
  std::int64_t put_ns = 0;
  person_.at_question = [&](int question, const Trial&) -> Reply {
    if (question == 1) put_ns = rig_->clock().now_ns() - 200'000'000;  // it took 0.2 s
    if (question < 3) return feels_again(1);
    return chooses(0);
  };
  run();
  const ResponseRow response = attempts().front().responses.at(0);
  EXPECT_NEAR(*response.from_cue_s, 1e-9 * static_cast<double>(response.time_ns - put_ns), 2e-3);
  EXPECT_GT(*response.from_cue_s, 1.5);  // the surface was felt twice again
}

bool is_doubt(const Trial& trial) {
  return trial.questions.front().prompt.starts_with("Please check");
}

TEST_F(ConductorTest, AsksOnceMoreForANumberTenTimesAnEarlierOneAndKeepsBoth) {
  begin(estimated_protocol());
  std::map<decltype(Trial::factors), int> times{};
  person_.at_question = [&times](int, const Trial& trial) {
    const double number = is_doubt(trial) ? 120.0 : ++times[trial.factors] == 1 ? 10.0 : 100.0;
    return gives(number);
  };
  run();
  const auto rows = attempts();
  ASSERT_EQ(rows.size(), 14U);
  int doubts = 0;
  for (const AttemptRow& row : rows) {
    ASSERT_EQ(row.responses.size(), 1U);
    const ResponseRow& response = row.responses[0];
    EXPECT_EQ(response.question, "roughness");
    EXPECT_EQ(number_in(response.answer), response.answer_number);
    EXPECT_EQ(response.options_json, "[]");
    const auto doubt =
        std::find_if(row.events.begin(), row.events.end(),
                     [](const EventRow& event) { return event.kind == "estimate_doubted"; });
    if (doubt == row.events.end()) {
      EXPECT_NE(response.answer, "120");
      continue;
    }
    ++doubts;
    EXPECT_EQ(doubt->text, "100");
    EXPECT_NE(doubt->data_json.find("\"earlier_estimate\":10.0"), std::string::npos)
        << doubt->data_json;
    EXPECT_EQ(response.answer, "120");
    EXPECT_GT(*response.from_cue_s, 0.39);  // both times of 0.2 s
  }
  // The third number for the anchor's spacing is compared with the second, not with the first.
  EXPECT_EQ(doubts, 6);
}

TEST_F(ConductorTest, ComparesNoAdditionalNumberWithEarlierEstimates) {
  nlohmann::json protocol = nlohmann::json::parse(estimated_protocol());
  nlohmann::json& block = protocol["blocks"]["main"];
  block["questions"] = {block["question"],
                        {{"name", "ridges"}, {"prompt", "How many ridges?"}, {"form", "number"}}};
  block.erase("question");
  begin(protocol.dump());
  person_.at_question = [](int, const Trial& trial) {
    return gives(trial.questions.front().name == "ridges" ? 1.0 : 100.0);
  };
  run();
  for (const AttemptRow& row : attempts()) {
    EXPECT_TRUE(std::ranges::none_of(
        row.events, [](const EventRow& event) { return event.kind == "estimate_doubted"; }));
    EXPECT_EQ(row.responses.at(1).answer, "1");
  }
}

TEST_F(ConductorTest, TakesASecondNumberAsItIsAndOneLessThanTenTimesWithoutAsking) {
  begin(estimated_protocol());
  int doubts = 0;
  std::map<decltype(Trial::factors), int> times{};
  person_.at_question = [&](int, const Trial& trial) {
    if (is_doubt(trial)) {
      ++doubts;
      return gives(1e6);
    }
    const bool is_small = std::get<std::string>(trial.factors.at("tip")) == "small";
    return gives(++times[trial.factors] == 1 ? 1.0 : is_small ? 9.9 : 0.1);
  };
  run();
  // With the large tip: a tenth asks, a million for it stands, and after a million a tenth asks again
  // where there is a third number.
  EXPECT_EQ(doubts, 4);
}

TEST_F(ConductorTest, BeginsEveryRunOfABlockWithItsAnchor) {
  begin(estimated_protocol());
  person_.at_question = [](int, const Trial&) { return gives(5.0); };
  run();
  for (const AttemptRow& row : attempts()) {
    const bool is_first = row.trial == 1 || row.trial == 8;
    EXPECT_EQ(row.presentations[0].role, is_first ? "anchor" : "target") << row.trial;
  }
}

// Others are judged by it: it cannot wait until they are over.
TEST_F(ConductorTest, AsksAnAnchorThatWasNotExploredAsAskedAgainAtOnceAndOthersAtTheEndOfTheBlock) {
  begin(estimated_protocol());
  Exploration& asked = protocol_.explorations.at("short");
  asked.normal_force_N = {.minimum = 0.999, .target = {}, .maximum = 1.001};
  asked.required_fraction_in_band = 0.99;
  asked.on_failure = Exploration::OnFailure::requeue_at_end_of_block;
  asked.maximum_repeats = 1;
  person_.at_question = [](int, const Trial&) { return gives(5.0); };
  run();
  std::vector<int> trials{};
  for (const AttemptDone& done : done_) trials.push_back(done.trial);
  EXPECT_EQ(trials, (std::vector<int>{1, 1, 2, 3,  4,  5,  6,  7,  2, 3,  4,  5,  6,  7,
                                      8, 8, 9, 10, 11, 12, 13, 14, 9, 10, 11, 12, 13, 14}));
}

// The program ends while trials wait to be asked again: first amid the block, then amid the repeats.
TEST_F(ConductorTest, ContinuesAfterACrashWithTheTrialsThatWaitToBeAskedAgain) {
  begin(small_protocol("", R"(, "normal_force_N": {"minimum": 0.999, "maximum": 1.001},
       "required_fraction_in_band": 0.99, "on_failure": "requeue_at_end_of_block",
       "maximum_repeats": 1)"));
  const auto crash_at = [this](int at) {
    person_.questions = 0;
    person_.at_question = [at](int question, const Trial&) -> Reply {
      if (question == at) throw std::runtime_error("power failure");
      return chooses(0);
    };
    EXPECT_THROW(run(), std::runtime_error);
    const SessionRow row = find_unfinished(*study_, protocol_, "p1", {});
    make_rig({});
    rig_->move_clock_to(1'000'000'000'000LL * (at + 1));
    session_ = reopen(*study_, protocol_, row);
  };
  crash_at(3);  // trials 1 and 2 wait
  crash_at(2);  // 3 waits as well, and 1 is asked again
  person_.at_question = {};
  EXPECT_EQ(run().state, SessionState::completed);
  std::vector<std::pair<int, int>> made{};
  for (const AttemptDone& done : done_) made.emplace_back(done.trial, done.attempt);
  EXPECT_EQ(made,
            (std::vector<std::pair<int, int>>{{1, 1}, {2, 1}, {3, 1}, {1, 2}, {2, 2}, {3, 2}}));
  for (const AttemptRow& row : attempts()) {
    EXPECT_EQ(row.valid, row.attempt == 2) << row.trial;  // the last repeat counts, once
    EXPECT_EQ(row.flagged, row.attempt == 2);
  }
}

TEST_F(ConductorTest, KeepsTheNumberThatNobodyConfirmedBeforeTheDeadline) {
  std::string text = estimated_protocol();
  const std::string from = "\"repetitions\": 2,";
  text.replace(text.find(from), from.size(), from + " \"response_deadline_s\": 5,");
  begin(text);
  std::map<decltype(Trial::factors), int> times{};
  person_.at_question = [&times](int, const Trial& trial) {
    if (is_doubt(trial)) return Reply{};
    return gives(++times[trial.factors] == 1 ? 10.0 : 1.0);
  };
  run();
  int kept = 0;
  for (const AttemptRow& row : attempts()) {
    EXPECT_EQ(row.outcome, AttemptOutcome::answered);
    ASSERT_EQ(row.responses.size(), 1U);
    if (row.responses[0].answer == "1") ++kept;
  }
  EXPECT_EQ(kept, 8);
}

TEST(EstimateIn, UnderstandsPointAndCommaAndNothingElse) {
  EXPECT_EQ(estimate_in(" 0,5 "), 0.5);
  EXPECT_EQ(estimate_in("0.5"), 0.5);
  EXPECT_EQ(estimate_in("120"), 120.0);
  for (const char* text :
       {"", "0", "-3", "0,0", "1,000.5", "1.000.000", "ten", "3x", "inf", "nan"}) {
    EXPECT_EQ(estimate_in(text), std::nullopt) << text;
    EXPECT_FALSE(is_unclear_estimate(text)) << text;
  }
}

TEST(EstimateIn, RefusesWhatMayBeThousandsOrDecimals) {
  for (const char* text : {"1,000", " 1.000 ", "12.500", "999,999"}) {
    EXPECT_TRUE(is_unclear_estimate(text)) << text;
    EXPECT_EQ(estimate_in(text), std::nullopt) << text;
  }
  EXPECT_EQ(estimate_in("0,125"), 0.125);  // nobody writes a 0 before thousands
  EXPECT_EQ(estimate_in("1,5"), 1.5);
  EXPECT_EQ(estimate_in("1.25"), 1.25);
  EXPECT_EQ(estimate_in("1000"), 1000.0);
  EXPECT_EQ(estimate_in("1234,567"), 1234.567);  // a fourth digit without its own mark
  EXPECT_EQ(estimate_in("3,1416"), 3.1416);
}

TEST(TerminalRespondent, AsksForANumberUntilItIsOneAboveZero) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  const std::string typed = "rough\n0\n1,000\n7,5\n";
  ASSERT_EQ(::write(ends[1], typed.data(), typed.size()), static_cast<ssize_t>(typed.size()));
  std::ostringstream shown;
  TerminalRespondent person(ends[0], shown, {}, {});
  Trial trial{};
  trial.questions.resize(1);
  trial.questions.front().form = NumberForm{.is_estimate = true};
  trial.questions.front().prompt = "How rough was it?";
  trial.arrangement.maximum_visits = 1;
  const Reply reply = person.ask(trial, trial.questions, {}, {}, [](double) {});
  EXPECT_EQ(reply.number(), 7.5);
  EXPECT_NE(shown.str().find("How rough was it?\nYour number: Please enter a number above 0"),
            std::string::npos)
      << shown.str();
  EXPECT_NE(shown.str().find("1,000 is ambiguous."), std::string::npos) << shown.str();
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST_F(ConductorTest, StopsTheDeadlineWhileASurfaceIsFeltAgain) {
  begin(small_protocol(R"(, "response_deadline_s": 3)"));
  person_.at_question = [&](int question, const Trial&) -> Reply {
    // Wished for 0.15 s after the question was put, heard 0.05 s later.
    if (question == 1) return feels_again(1, rig_->clock().now_ns() - 50'000'000);
    if (question == 2) return feels_again(1);
    return chooses(0);
  };
  run();
  ASSERT_GE(person_.deadlines_s.size(), 4U);
  EXPECT_DOUBLE_EQ(*person_.deadlines_s[0], 3.0);
  EXPECT_NEAR(*person_.deadlines_s[1], 2.85, 2e-3);
  EXPECT_NEAR(*person_.deadlines_s[2], 2.65, 2e-3);
  EXPECT_DOUBLE_EQ(*person_.deadlines_s[3], 3.0) << "the next trial has its own";
}

TEST_F(ConductorTest, EndsAtOnceWhenAskedToStopWhileSomethingIsRead) {
  begin(small_protocol());
  conductor_ = std::make_unique<Conductor>(*study_, protocol_, *builder_, *rig_, person_,
                                           ConductorSettings{});
  conductor_->requests().stop_after(StopAfter::trial);
  EXPECT_EQ(conductor_->run(session_).state, SessionState::stopped);
  EXPECT_TRUE(attempts().empty());
}

TEST_F(ConductorTest, LatchesZeroForceAndStopsWhenTheDeviceIsLost) {
  begin(small_protocol(), {{.kind = ScriptedFault::Kind::lost, .at_s = 1.0}});
  const SessionEnd end = run();
  EXPECT_EQ(end.state, SessionState::stopped);
  const auto rows = attempts();
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].outcome, AttemptOutcome::device_fault);
  EXPECT_EQ(rows[0].servo->fault, "device_lost");
  EXPECT_FALSE(rows[0].valid);

  reopen_session();
  EXPECT_EQ(run().state, SessionState::completed);
  const auto all = attempts();
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all[1].trial, 1);
  EXPECT_EQ(all[1].attempt, 2);
}

TEST_F(ConductorTest, LatchesZeroForceWhenTheDeviceSaysNotANumber) {
  begin(small_protocol(), {{.kind = ScriptedFault::Kind::nan, .at_s = 1.0}});
  EXPECT_EQ(run().state, SessionState::stopped);
  ASSERT_EQ(attempts().size(), 1U);
  EXPECT_EQ(attempts()[0].servo->fault, "not_finite");
}

TEST_F(ConductorTest, AnswersTheQuestionsOfTheSessionOnce) {
  begin(small_protocol());
  run();
  const auto answers = study_->session_answers(session_.row.id);
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(answers[0].question, "comfort");
  EXPECT_EQ(answers[0].answer, "well");
  EXPECT_EQ(answers[0].options_json, R"(["well","tired"])");
  EXPECT_EQ(answers[1].answer, "") << "the optional one was left empty";
  EXPECT_EQ(answers[1].source, "keyboard");
}

TEST_F(ConductorTest, GivesTheRespondentWhatEachSurfaceFeltLike) {
  begin(small_protocol("", R"(, "strokes": {"target": 4})"));
  run();
  ASSERT_EQ(person_.last_felt.size(), 2U);
  EXPECT_NE(person_.last_felt[0].size, person_.last_felt[1].size);
}

TEST_F(ConductorTest, RendersTheSameForcesInASecondRunOfTheSameSeed) {
  begin(small_protocol());
  run();
  const std::string first = attempts()[2].recording->sha256;
  make_rig({});
  SessionConditions conditions{};
  conditions.seed = 7;
  conditions.pacing = rig_->pacing();
  conditions.started_utc = rig_->clock().utc();
  conditions.device = rig_->capability();
  session_ = begin_session(*study_, protocol_, "p1", conditions, this_program());
  run();
  const AttemptRow again = attempts()[2];
  const Recording one = read_recording(folder_.path() / "study" / again.recording->path);
  EXPECT_FALSE(one.time_ns.empty());
  EXPECT_NE(first, again.recording->sha256);  // another session number stands in the header …
  Study& study = *study_;
  const auto sessions = study.sessions();
  const AttemptRow before = study.attempts(sessions[0].id)[2];
  const Recording other = read_recording(folder_.path() / "study" / before.recording->path);
  EXPECT_EQ(one.columns, other.columns);  // … but every value is the same
}

}  // namespace
}  // namespace asperity

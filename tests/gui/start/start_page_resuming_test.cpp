// The page before a session that resumes another, and sessions of virtual participants.

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>

#include <QtCore/QTimer>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QSpinBox>
#include <gtest/gtest.h>

#include "app/gui/look/controls.h"
#include "app/gui/start/start_page.h"
#include "app/tasks/protocol_files.h"
#include "renderers/built_in_models.h"
#include "results_schema/study.h"
#include "tests/gui/start/the_start_page.h"
#include "tests/gui/support/screenshot.h"
#include "tests/gui/support/widgets.h"
#include "tests/support/marked_translation.h"

namespace asperity {
namespace {

/// A session of P001 that was stopped long ago, with a masking noise that was measured elsewhere.
void store_old_session(const std::filesystem::path& folder, const std::filesystem::path& file) {
  const Protocol protocol = load_protocol(file, built_in_models(), folder);
  Study study = Study::open(folder, Access::read_write);
  study.add_participant({.label = "P001", .created_utc = "2026-01-01T00:00:00.000Z"});
  const OpenSession session = begin_session(study, protocol, "P001",
                                            {.mode = SessionMode::pilot,
                                             .seed = 5,
                                             .pacing = "real_time",
                                             .scheduling = "none",
                                             .started_utc = "2026-01-01T00:00:00.000Z",
                                             .clock_zero_ns = 1},
                                            this_program());
  study.add_event(session.row.id, {.time_ns = 2, .kind = "session_began"});
  study.add_event(session.row.id,
                  {.time_ns = 3, .kind = "masking_noise", .data_json = R"({"kind": "pink", "heard":
                   false, "measured_dBA": 64.5, "verified_by": "M. Wu"})"});
  study.end_session(session.row.id, SessionState::stopped, "2026-01-01T00:10:00.000Z");
}

TEST_F(TheStartPage, OffersTheLanguagesOfTheProtocolAndKeepsThatOfAParticipant) {
  page->show();
  choose(protocol);
  EXPECT_FALSE(is_shown("languages")) << "there is only one";
  const std::filesystem::path german = folder / "protocols" / "small.de.json";
  write_file(german, marked_translation(protocol_with_questions(), "DE"), Overwrite::refuse);
  page->check_again();
  ASSERT_TRUE(wait_for_study());
  ASSERT_TRUE(is_shown("languages"));
  EXPECT_EQ(find<QComboBox>("protocols").count(), 1);
  EXPECT_EQ(find<QComboBox>("languages").currentText(), "English");
  EXPECT_EQ(page->order().inputs.protocol, protocol);
  pick("languages", "Deutsch");
  ASSERT_TRUE(wait_for_checks());
  EXPECT_EQ(page->order().inputs.protocol, german);
  EXPECT_EQ(find<QComboBox>("protocols").currentIndex(), 0);
  EXPECT_TRUE(find<QLabel>("protocol_text").text().contains("DE A few short trials"));
  EXPECT_FALSE(has_reason("changed since it was chosen")) << shown_reason();
  take_screenshot(*page, "start-page-language");

  store_old_session(folder, protocol);
  page->set_mode(SessionMode::pilot);
  choose(german, "P001");
  EXPECT_TRUE(eventually([this] { return page->order().inputs.protocol == protocol; }));
  ASSERT_TRUE(wait_for_study());
  EXPECT_FALSE(find<QComboBox>("languages").isEnabled());
  EXPECT_FALSE(has_reason("in the language")) << shown_reason();

  page->forget_person();
  EXPECT_TRUE(eventually([this, &german] { return page->order().inputs.protocol == german; }))
      << "a new participant has what the experimenter chose";
}

TEST_F(TheStartPage, AsksForAReasonToResumeWhatIsOlderThanTheProtocolHasIt) {
  std::string text = protocol_with_questions();
  text.insert(text.find("\"flow\""), R"("resume": {"maximum_age_hours": 24}, )");
  write_protocol(text);
  store_old_session(folder, protocol);
  page->show();
  choose(protocol, "P001");
  EXPECT_FALSE(is_shown("late_reason"));
  click("resume");
  ASSERT_TRUE(is_shown("late_reason"));
  ASSERT_TRUE(wait_for_checks());
  EXPECT_TRUE(has_reason("The session last ran")) << shown_reason();
  EXPECT_FALSE(can_start());
  take_screenshot(*page, "start-page-late");
  type("late_reason", "was ill");
  ASSERT_TRUE(wait_for_checks());
  EXPECT_TRUE(can_start()) << shown_reason();
  EXPECT_EQ(page->order().inputs.late_reason, "was ill");
}

TEST_F(TheStartPage, KeepsTheNoiseThatWasMeasuredBeforeTheInterruption) {
  std::string text = protocol_with_questions();
  text.insert(text.find("\"flow\""),
              R"("environment": {"masking_noise": {"kind": "pink", "level_dBA": 65}}, )");
  write_protocol(text);
  store_old_session(folder, protocol);
  page->show();
  choose(protocol, "P001");
  EXPECT_FALSE(page->order().noise.measured_dBA);
  click("resume");
  EXPECT_EQ(page->order().noise.measured_dBA, 64.5);
  EXPECT_EQ(page->order().noise.verified_by, "M. Wu");
}

TEST_F(TheStartPage, OffersToGoOnWithAnUnfinishedSession) {
  run_unfinished("virtual0001");
  page->show();
  choose(protocol, "virtual0001");
  EXPECT_EQ(find<QPushButton>("resume").text(), "Resume session 1 (trials completed: 1 of 3)");
  EXPECT_FALSE(page->order().inputs.resume);
  click("resume");
  EXPECT_TRUE(page->order().inputs.resume);
  EXPECT_EQ(page->order().inputs.mode, SessionMode::simulate);
  EXPECT_FALSE(find<QPushButton>("mode_run").isEnabled());
  EXPECT_TRUE(find<QLabel>("unfinished").text().contains("trials completed and stored: 1 of 3"));
  ASSERT_TRUE(wait_for_checks());
  EXPECT_TRUE(can_start()) << shown_reason();
  EXPECT_EQ(find<QPushButton>("start").text(), "Resume session 1");

  SessionRunner runner;
  QSignalSpy ended(&runner, &SessionRunner::ended);
  runner.start(page->order());
  ASSERT_TRUE(eventually([&] { return !runner.is_running(); }));
  ASSERT_EQ(ended.size(), 1);
  EXPECT_EQ(ended.first().first().value<SessionEnd>().attempts, 2);
}

TEST_F(TheStartPage, KeepsTheHandThatSomebodyChose) {
  page->show();
  choose(protocol);
  click("left_hand");
  click("mode_pilot");
  type("question_age", "31");
  pick("question_hand_used", "right");
  announce_change();
  EXPECT_TRUE(page->order().inputs.mirrored) << "it was chosen after all that is suggested";
  type("participant_label", "P777");
  EXPECT_FALSE(page->order().inputs.mirrored) << "the hand of another participant is suggested";
}

// A session runs then, as likely as not, and the checklist would run a second servo loop beside it.
TEST_F(TheStartPage, LooksAtNothingWhileItIsHidden) {
  const auto looks_soon = [this] {
    const QList<QTimer*> timers =
        page->findChildren<QTimer*>(QString(), Qt::FindDirectChildrenOnly);
    return std::any_of(timers.begin(), timers.end(), [](QTimer* one) { return one->isActive(); });
  };
  page->show();
  choose(protocol);
  ASSERT_TRUE(wait_for_checks());
  page->hide();
  const QString suggested = find<QLineEdit>("participant_label").text();
  {
    Study other = Study::open(folder, Access::read_write);
    ParticipantRow person{};
    person.label = suggested.toStdString();
    person.created_utc = "2026-03-02T08:00:00Z";
    other.add_participant(person);
  }
  announce_change();
  EXPECT_FALSE(looks_soon());
  EXPECT_EQ(find<QLineEdit>("participant_label").text(), suggested);
  page->show();
  ASSERT_TRUE(wait_for_checks());
  EXPECT_NE(find<QLineEdit>("participant_label").text(), suggested);
}

TEST_F(TheStartPage, ContinuesAtOnceWhenItIsToldTo) {
  run_unfinished("virtual0001");
  choose(protocol, "virtual0001", std::int64_t{1});
  EXPECT_TRUE(page->order().inputs.resume);
  choose(protocol);
  EXPECT_FALSE(page->order().inputs.resume);
  EXPECT_TRUE(find<QPushButton>("mode_run").isEnabled());
}

TEST_F(TheStartPage, OffersAnotherPersonTheirOwnUnfinishedSession) {
  run_unfinished("virtual0001");
  run_unfinished("virtual0002");
  choose(protocol, "virtual0001", std::int64_t{1});
  EXPECT_EQ(page->order().inputs.resumed_session, 1);
  find<QComboBox>("participants").setCurrentText("virtual0002");
  EXPECT_FALSE(page->order().inputs.resume);
  EXPECT_FALSE(find<QPushButton>("resume").isHidden());
  click("resume");
  EXPECT_EQ(page->order().inputs.resumed_session, 2);
}

// Pages are made anew with the theme and the language.
TEST_F(TheStartPage, ContinuesWithWhatWasFilledInWhenItIsMadeAnew) {
  page->show();
  choose(protocol);
  click("mode_pilot");
  type("participant_label", "P044");
  fill_in();
  click("left_hand");
  const auto make_anew = [this] {
    page.reset();
    page = std::make_unique<StartPage>(*study);
    page->show();
  };
  make_anew();
  make_anew();  // at once: nothing has been read in between
  ASSERT_TRUE(wait_for_checks());
  EXPECT_TRUE(can_start()) << shown_reason();
  const SessionOrder order = page->order();
  EXPECT_EQ(order.inputs.protocol, protocol);
  EXPECT_EQ(order.inputs.participant, "P044");
  EXPECT_EQ(order.inputs.mode, SessionMode::pilot);
  EXPECT_TRUE(order.inputs.mirrored);
  EXPECT_TRUE(order.inputs.consent);
  EXPECT_EQ(order.consent_seen_by, "MW");
  ASSERT_TRUE(order.inputs.new_person);
  EXPECT_EQ(order.inputs.new_person->age_years, 31.0);
  EXPECT_EQ(order.inputs.new_person->answers_json, R"({"hand_used":"right"})");
}

TEST_F(TheStartPage, ContinuesWithTheSameSessionWhenItIsMadeAnew) {
  run_unfinished("virtual0001");
  choose(protocol, "virtual0001", std::int64_t{1});
  page.reset();
  page = std::make_unique<StartPage>(*study);
  page->show();
  ASSERT_TRUE(wait_for_study());
  EXPECT_EQ(page->order().inputs.resumed_session, 1);
  EXPECT_EQ(page->order().inputs.participant, "virtual0001");
  EXPECT_EQ(find<QPushButton>("start").text(), "Resume session 1");
}

TEST_F(TheStartPage, RunsOneVirtualParticipantFromEndToEnd) {
  page->show();
  choose(protocol);
  click("mode_simulate");
  ASSERT_TRUE(wait_for_checks());
  SessionRunner runner;
  QSignalSpy ended(&runner, &SessionRunner::ended);
  QObject::connect(page.get(), &StartPage::start_wanted, &runner,
                   [&runner](const SessionOrder& order) { runner.start(order); });
  click("start");
  ASSERT_TRUE(eventually([&] { return !runner.is_running(); }));
  ASSERT_EQ(ended.size(), 1);
  EXPECT_EQ(ended.first().first().value<SessionEnd>().state, SessionState::completed);
  announce_change();
  EXPECT_EQ(page->order().inputs.participant, "virtual0002");
}

TEST_F(TheStartPage, WantsSeveralVirtualParticipantsToBeSimulated) {
  page->show();
  choose(protocol);
  click("mode_simulate");
  find<QSpinBox>("virtual_participants").setValue(3);
  ASSERT_TRUE(wait_for_checks());
  EXPECT_EQ(find<QPushButton>("start").text(), "Simulate 3 participants");
  QSignalSpy session(page.get(), &StartPage::start_wanted);
  std::vector<SimulationInputs> wanted{};
  QObject::connect(page.get(), &StartPage::simulation_wanted, page.get(),
                   [&wanted](const SimulationInputs& inputs) { wanted.push_back(inputs); });
  click("start");
  click("start");
  EXPECT_EQ(session.size(), 0);
  ASSERT_EQ(wanted.size(), 2U);
  EXPECT_EQ(wanted[0].participants, 3);
  EXPECT_EQ(wanted[0].protocols, std::vector{protocol});
  EXPECT_NE(wanted[0].seed, wanted[1].seed);
  page->set_simulating(true);
  EXPECT_FALSE(find<QPushButton>("start").isEnabled());
  EXPECT_NE(shown_reason().find("are being simulated"), std::string::npos);
  page->set_simulating(false);
  EXPECT_TRUE(find<QPushButton>("start").isEnabled());
}

}  // namespace
}  // namespace asperity

// The page before a session: what keeps it from starting, and what is ordered when it starts.

#include "app/gui/start/start_page.h"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include <QtCore/QSettings>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QProgressBar>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QScrollBar>
#include <QtWidgets/QSpinBox>
#include <gtest/gtest.h>

#include "app/gui/look/controls.h"
#include "app/gui/start/participant_card.h"
#include "app/tasks/check_protocol.h"
#include "app/tasks/new_study.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/hashes/sha256.h"
#include "results_schema/study.h"
#include "tests/app/punctual_trial.h"
#include "tests/gui/start/the_start_page.h"
#include "tests/gui/support/gated_examination.h"
#include "tests/gui/support/screenshot.h"
#include "tests/gui/support/widgets.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

TEST_F(TheStartPage, StartsAFilledInRunWithEverythingThatWasSaid) {
  page->show();
  choose(protocol);
  fill_in();
  ASSERT_TRUE(wait_for_checks());
  EXPECT_EQ(page->reasons(), std::vector<QString>{});
  EXPECT_TRUE(can_start()) << shown_reason();
  QSignalSpy wanted(page.get(), &StartPage::start_wanted);
  click("start");
  ASSERT_EQ(wanted.size(), 1);
  const auto order = wanted.first().first().value<SessionOrder>();
  EXPECT_EQ(order.inputs.protocol, protocol);
  EXPECT_EQ(order.inputs.study, folder);
  EXPECT_EQ(order.inputs.participant, "sub001");
  EXPECT_EQ(order.inputs.mode, SessionMode::run);
  EXPECT_FALSE(order.inputs.is_virtual);
  EXPECT_FALSE(order.inputs.resume);
  EXPECT_EQ(order.inputs.pacing, RunPacing::real_time);
  EXPECT_TRUE(order.inputs.consent);
  EXPECT_EQ(order.consent_seen_by, "MW");
  ASSERT_TRUE(order.inputs.new_person);
  EXPECT_EQ(order.inputs.new_person->age_years, 31.0);
  EXPECT_EQ(order.inputs.new_person->answers_json, R"({"hand_used":"right"})");
  EXPECT_EQ(order.protocol_sha256, sha256_of(protocol_with_questions()));
  EXPECT_FALSE(can_start());  // a second click starts nothing
}

TEST_F(TheStartPage, RefusesToStartWithoutConsentAndSaysSo) {
  page->show();
  choose(protocol);
  fill_in();
  find<QCheckBox>("consent_given").setChecked(false);
  ASSERT_TRUE(wait_for_checks());
  EXPECT_FALSE(can_start());
  EXPECT_NE(shown_reason().find("has not agreed"), std::string::npos) << shown_reason();
  find<QCheckBox>("consent_given").setChecked(true);
  EXPECT_TRUE(can_start()) << shown_reason();
  find<QLineEdit>("consent_seen_by").clear();
  EXPECT_FALSE(can_start());
  EXPECT_NE(shown_reason().find("witness of the participant's consent"), std::string::npos)
      << shown_reason();
}

TEST_F(TheStartPage, RefusesToStartWhereTheLoopIsTooSlow) {
  study->set_device_trial([](const auto&... inputs) {
    TriedDevice tried = punctual_trial(inputs...);
    tried.quality.period_mean_s *= 2.0;
    return tried;
  });
  page->show();
  choose(protocol);
  fill_in();
  ASSERT_TRUE(wait_for_checks());
  EXPECT_FALSE(can_start());
  EXPECT_TRUE(find<QLabel>("check_rate").text().contains("too slow or too busy"))
      << find<QLabel>("check_rate").text().toStdString();
}

TEST_F(TheStartPage, CancelsTheChecksAndRunsThemAgainWhenAsked) {
  std::atomic<bool> goes_on = false;
  study->set_device_trial([&goes_on](const auto&... inputs) {
    while (!goes_on) std::this_thread::yield();
    return punctual_trial(inputs...);
  });
  page->show();
  choose(protocol);
  fill_in();
  auto& cancel = find<QPushButton>("check_cancel");
  ASSERT_TRUE(eventually([&] { return cancel.isVisible(); }));
  EXPECT_TRUE(find<QProgressBar>("check_progress").isVisible());
  cancel.click();
  EXPECT_FALSE(cancel.isEnabled());
  goes_on = true;
  ASSERT_TRUE(eventually([&] { return !cancel.isVisible(); }));
  EXPECT_FALSE(can_start());
  EXPECT_TRUE(has_reason("The checks were cancelled"));
  find<QPushButton>("check_again").click();
  ASSERT_TRUE(wait_for_checks());
  EXPECT_TRUE(can_start());
}

TEST_F(TheStartPage, AsksAnewForConsentWhenSomebodyElseTakesPart) {
  choose(protocol);
  fill_in();
  EXPECT_TRUE(find<QCheckBox>("consent_given").isChecked());
  type("participant_label", "P007");
  EXPECT_FALSE(find<QCheckBox>("consent_given").isChecked());
}

TEST_F(TheStartPage, NamesEveryRequiredAnswerThatIsMissingOrNotPossible) {
  page->show();
  choose(protocol);
  EXPECT_TRUE(has_reason("\"How old are you?\" has not been answered; enter an answer."));
  EXPECT_TRUE(has_reason("\"Which hand?\" has not been answered; enter an answer."));
  EXPECT_FALSE(has_reason("What do you like?"));
  fill_in();
  EXPECT_FALSE(has_reason("How old are you?"));
  type("question_age", "12");
  EXPECT_TRUE(has_reason("must be 18 or more"));
  type("question_age", "old");
  EXPECT_TRUE(has_reason("must be a number"));
  ASSERT_TRUE(wait_for_checks());
  EXPECT_FALSE(can_start());
}

TEST_F(TheStartPage, RefusesLabelsThatAreEmptyImpossibleOrTaken) {
  Study::open(folder, Access::read_write).add_participant({.label = "P001"});
  announce_change();
  choose(protocol);
  EXPECT_EQ(find<QLineEdit>("participant_label").text(), "P002");  // the study's own pattern
  EXPECT_FALSE(has_reason("label"));
  type("participant_label", "");
  EXPECT_TRUE(has_reason("has no label"));
  type("participant_label", "not a label");
  EXPECT_TRUE(has_reason("1 to 32 letters and digits"));
  type("participant_label", "P001");
  EXPECT_TRUE(has_reason("P001 is already in the study"));
}

TEST_F(TheStartPage, LeavesALabelAloneThatSomebodyClearsToTypeAnother) {
  page->show();
  choose(protocol);
  auto& label = find<QLineEdit>("participant_label");
  EXPECT_EQ(label.text(), "sub001");
  label.clear();
  EXPECT_EQ(label.text(), "");
  QTest::keyClicks(&label, "P044");
  announce_change();
  EXPECT_EQ(label.text(), "P044");
}

TEST_F(TheStartPage, WaitsForTheChecklistAndTellsWhatItFound) {
  const StudyLock elsewhere(folder, Study::session_lock_name("sub001"));
  page->show();
  choose(protocol);
  fill_in();
  EXPECT_TRUE(has_reason("Running the checks…"));
  EXPECT_FALSE(can_start());
  ASSERT_TRUE(wait_for_checks());
  EXPECT_FALSE(can_start());
  EXPECT_TRUE(has_reason("A session of sub001 is running in process"));
  EXPECT_NE(find<QLabel>("check_participant").text().indexOf("Wait until it has ended"), -1);
}

TEST_F(TheStartPage, HasALineForEverythingThatIsLookedAt) {
  page->show();
  choose(protocol);
  fill_in();
  ASSERT_TRUE(wait_for_checks());
  for (const char* line : {"check_protocol", "check_participant", "check_study", "check_disk",
                           "check_stimuli", "check_device", "check_calibration", "check_force_zero",
                           "check_rate", "check_screens", "check_masking_noise"}) {
    EXPECT_TRUE(eventually([&] { return is_shown(line); })) << line;
  }
  EXPECT_TRUE(find<QLabel>("check_force_zero").text().contains("Exactly 0 N"));
}

TEST_F(TheStartPage, ShowsTheWarningsAboutTheStimuliAndDoesNotWaitForThem) {
  const auto gate = std::make_shared<GatedExamination>();
  study->examiner().set_examine(examine_through(gate));
  page->show();
  choose(protocol);
  fill_in();
  ASSERT_TRUE(wait_for_checks());
  EXPECT_TRUE(can_start()) << shown_reason();
  ASSERT_TRUE(eventually([&] { return gate->running == 1; }));
  EXPECT_TRUE(is_shown("note_of_checks"));
  EXPECT_EQ(find<QLabel>("note_of_checks").text(),
            "The stimuli are being examined; the session does not wait for this.");
  const auto line = [this] { return page->findChild<QLabel*>("check_stimulus_warnings"); };
  EXPECT_EQ(line(), nullptr);
  gate->is_open = true;
  ASSERT_TRUE(eventually([&] { return line() != nullptr; }));
  EXPECT_TRUE(line()->text().contains("the gate is open.")) << line()->text().toStdString();
  EXPECT_FALSE(is_shown("note_of_checks"));
  EXPECT_TRUE(eventually([this] { return is_shown("check_rate"); })) << "the other lines stay";
  EXPECT_TRUE(can_start());
}

// The checks time the servo loop.
TEST_F(TheStartPage, ExaminesNothingWhileTheChecksRun) {
  const auto gate = std::make_shared<GatedExamination>();
  study->examiner().set_examine(examine_through(gate));
  std::atomic<bool> goes_on = false;
  std::atomic<bool> is_tried = false;
  study->set_device_trial([&](const auto&... inputs) {
    is_tried = true;
    while (!goes_on) std::this_thread::yield();
    return punctual_trial(inputs...);
  });
  page->show();
  choose(protocol);
  fill_in();
  ASSERT_TRUE(eventually([&] { return is_tried.load(); }));
  EXPECT_EQ(gate->begun, 0);
  goes_on = true;
  ASSERT_TRUE(eventually([&] { return gate->running == 1; }));
  const int begun = gate->begun;
  find<QPushButton>("check_again").click();
  EXPECT_TRUE(eventually([&] { return gate->stopped == begun; }));
  ASSERT_TRUE(eventually([&] { return gate->has_begun(begun + 1); }));
  page->hide();
  EXPECT_TRUE(eventually([&] { return gate->has_stopped(begun + 1); }));
}

TEST_F(TheStartPage, DropsTheChecksOfAnEarlierChoice) {
  std::atomic<bool> goes_on = false;
  std::atomic<int> tried = 0;
  study->set_device_trial([&](const auto&... inputs) {
    ++tried;
    while (!goes_on) std::this_thread::yield();
    return punctual_trial(inputs...);
  });
  page->show();
  choose(protocol);
  fill_in();
  ASSERT_TRUE(eventually([&] { return tried == 1; }));
  goes_on = true;
  // Each change delays the next checks, so that those of the earlier choice end in between.
  for (int change = 0; change < 20; ++change) {
    type("participant_label", QString("P%1").arg(100 + change));
    QTest::qWait(20);
    EXPECT_TRUE(has_reason("Running the checks…")) << "after change " << change;
  }
  ASSERT_TRUE(wait_for_checks());
  EXPECT_EQ(tried, 2);
}

TEST_F(TheStartPage, SaysThatAProtocolIsNotChosenOrNotValid) {
  write_file(folder / "protocols" / "broken.json", "{}", Overwrite::refuse);
  page->show();  // of two protocols none is the one that is meant
  ASSERT_TRUE(wait_for_study());
  EXPECT_EQ(page->reasons(), std::vector<QString>{"No protocol is chosen; choose one."});
  choose(folder / "protocols" / "broken.json");
  EXPECT_EQ(page->reasons(),
            std::vector<QString>{"The protocol is not valid; correct it, or choose another one."});
  EXPECT_TRUE(find<QLabel>("protocol_state").text().contains("not valid"));
  EXPECT_FALSE(can_start());
}

TEST_F(TheStartPage, RefusesAProtocolThatChangedAndReadsItAnewWhenAsked) {
  page->show();
  page->set_mode(SessionMode::simulate);
  choose(protocol);
  ASSERT_TRUE(wait_for_checks());
  EXPECT_TRUE(can_start()) << shown_reason();
  write_protocol(protocol_with_questions() + "\n");
  announce_change();  // looks again, at what was chosen
  EXPECT_FALSE(can_start());
  ASSERT_TRUE(wait_for_checks());
  EXPECT_FALSE(can_start());
  EXPECT_TRUE(has_reason("The file has changed since it was chosen"));
  click("check_again");
  ASSERT_TRUE(wait_for_checks());
  EXPECT_TRUE(can_start()) << shown_reason();
  EXPECT_EQ(page->order().protocol_sha256, sha256_of(protocol_with_questions() + "\n"));
}

// A large study takes a while to read: nobody waits for it, and nothing is started meanwhile.
TEST_F(TheStartPage, ReadsTheStudyBesideTheWindowAndStartsNothingMeanwhile) {
  page->show();
  page->choose(protocol, std::nullopt, {});
  EXPECT_EQ(page->reasons(), std::vector<QString>{"The study is being read."});
  EXPECT_FALSE(find<QLineEdit>("participant_label").isEnabled());
  ASSERT_TRUE(wait_for_study());
  EXPECT_TRUE(find<QLineEdit>("participant_label").isEnabled());
  click("mode_simulate");
  ASSERT_TRUE(wait_for_checks());
  ASSERT_TRUE(can_start()) << shown_reason();

  QSignalSpy wanted(page.get(), &StartPage::start_wanted);
  study->announce_change();
  EXPECT_NE(shown_reason().find("The study is being read."), std::string::npos);
  click("start");
  EXPECT_EQ(wanted.size(), 0);
  ASSERT_TRUE(wait_for_checks());
  click("start");
  EXPECT_EQ(wanted.size(), 1);
}

TEST_F(TheStartPage, ShowsTheLastOfSeveralChoicesThatAreMadeAtOnce) {
  const std::filesystem::path other = folder / "protocols" / "other.json";
  std::string text = protocol_with_questions();
  text.replace(text.find("\"small\""), 7, "\"other\"");
  write_file(other, text, Overwrite::refuse);
  page->show();
  page->choose(other, std::nullopt, {});
  page->choose(protocol, "P044", {});
  page->choose(other, "P045", {});
  ASSERT_TRUE(wait_for_study());
  EXPECT_TRUE(find<QComboBox>("protocols").currentText().endsWith(" (other)"));
  EXPECT_EQ(find<QLineEdit>("participant_label").text(), "P045");
  EXPECT_EQ(page->order().inputs.protocol, other);
  EXPECT_EQ(page->order().protocol_sha256, sha256_of(text));
}

TEST_F(TheStartPage, SaysThatAStudyCannotBeReadAndReadsItWhenAskedAgain) {
  page->show();
  const std::filesystem::path store = folder / "study.sqlite";
  const std::string bytes = read_file(store);
  write_file(store, "no study", Overwrite::allow);
  page->choose(protocol, std::nullopt, {});
  auto* banner = page->findChild<Banner*>();
  ASSERT_TRUE(eventually([&] { return banner->isVisible(); }));
  EXPECT_TRUE(banner->text().startsWith("The study could not be read: "));
  EXPECT_EQ(page->reasons(),
            std::vector<QString>{"The study has not been read; press “Try again”."});
  write_file(store, bytes, Overwrite::allow);
  for (auto* button : banner->findChildren<QPushButton*>()) {
    if (button->text() == "Try again") QTest::mouseClick(button, Qt::LeftButton);
  }
  ASSERT_TRUE(wait_for_study());
  EXPECT_EQ(find<QLineEdit>("participant_label").text(), "sub001");
}

TEST_F(TheStartPage, NeedsNeitherConsentNorAnswersForASimulation) {
  page->show();
  choose(protocol);
  click("mode_simulate");
  EXPECT_FALSE(is_shown("consent_statement"));
  EXPECT_FALSE(is_shown("question_age"));
  EXPECT_FALSE(is_shown("participant_screen"));
  ASSERT_TRUE(wait_for_checks());
  EXPECT_TRUE(can_start()) << shown_reason();
  const SessionOrder order = page->order();
  EXPECT_TRUE(order.inputs.is_virtual);
  EXPECT_EQ(order.inputs.participant, "virtual0001");
  EXPECT_EQ(order.inputs.pacing, RunPacing::stepped);
  EXPECT_FALSE(order.inputs.new_person);
  EXPECT_FALSE(order.inputs.consent);
  click("speed_real_time");
  EXPECT_EQ(page->order().inputs.pacing, RunPacing::real_time);
  EXPECT_FALSE(find<QSpinBox>("virtual_participants").isEnabled());
  EXPECT_TRUE(find<QLabel>("simulation_text")
                  .text()
                  .contains("only one virtual participant can be simulated at a time"));
}

TEST_F(TheStartPage, ShowsTheBandOfTheModeAtOnce) {
  page->show();
  choose(protocol);
  auto* band = page->findChild<ModeBand*>();
  ASSERT_NE(band, nullptr);
  EXPECT_FALSE(band->isVisible());
  click("mode_pilot");
  EXPECT_TRUE(band->isVisible());
  EXPECT_EQ(band->text(), "PILOT: not study data");
  EXPECT_TRUE(is_shown("consent_statement"));  // a person is a person
  EXPECT_EQ(page->order().inputs.mode, SessionMode::pilot);
  click("mode_simulate");
  EXPECT_EQ(band->text(), "SIMULATED: no human participant");
}

TEST_F(TheStartPage, MirrorsTheLayoutForALeftHandUnlessItIsChosenOtherwise) {
  choose(protocol);
  EXPECT_FALSE(page->order().inputs.mirrored);
  pick("question_hand_used", "left");
  EXPECT_TRUE(page->order().inputs.mirrored);
  click("right_hand");
  EXPECT_FALSE(page->order().inputs.mirrored);
  type("question_hobby", "chess");  // what was chosen stays
  EXPECT_FALSE(page->order().inputs.mirrored);

  Study::open(folder, Access::read_write).add_participant({.label = "P009", .handedness = "left"});
  announce_change();
  choose(protocol, "P009");
  EXPECT_TRUE(page->order().inputs.mirrored);
}

TEST_F(TheStartPage, ComesInTheOrderInWhichASessionIsPrepared) {
  page->show();
  choose(protocol);
  QTest::qWait(10);
  const std::vector<const char*> order{
      "mode_run",      "protocols", "participant_label", "question_age",       "session_text",
      "consent_given", "device",    "right_hand",        "participant_screen", "start"};
  int last = -1;
  for (const char* name : order) {
    const int y = find<QWidget>(name).mapTo(page.get(), QPoint(0, 0)).y();
    if (std::string_view(name) != "start") {
      EXPECT_GT(y, last) << name;
    }
    last = y;
  }
}

TEST_F(TheStartPage, ShowsTheChoiceOfParticipantsNextToItsHeading) {
  Study::open(folder, Access::read_write).add_participant({.label = "P009"});
  page->show();
  choose(protocol);
  QTest::qWait(10);
  const auto place_of = [this](const QWidget& widget) {
    return QRect(widget.mapTo(page.get(), QPoint(0, 0)), widget.size());
  };
  const QRect newcomers = place_of(find<QPushButton>("new_participant"));
  const QRect known = place_of(find<QPushButton>("known_participant"));
  EXPECT_EQ(newcomers.top(), known.top());
  EXPECT_GE(known.width(), find<QPushButton>("known_participant").sizeHint().width());
  for (const auto* label : page->findChild<ParticipantCard*>()->findChildren<QLabel*>()) {
    if (!label->isVisible()) continue;
    EXPECT_FALSE(place_of(*label).intersects(newcomers)) << label->text().toStdString();
  }
}

TEST_F(TheStartPage, IsFilledInByTheKeyboardAlone) {
  page->show();
  page->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(page.get(), kPatience_ms));
  choose(protocol);
  ASSERT_TRUE(eventually([this] { return find<QWidget>("question_age").isVisible(); }));
  find<QComboBox>("protocols").setFocus();
  // Every control comes by Tab, from the protocol to the last one, and round again.
  QStringList reached{};
  for (int press = 0; press < 60; ++press) {
    const QWidget* focus = QApplication::focusWidget();
    ASSERT_NE(focus, nullptr);
    if (reached.contains(focus->objectName()) && focus->objectName() == "protocols") break;
    reached << focus->objectName();
    if (focus->objectName() == "question_age") QTest::keyClicks(QApplication::focusWidget(), "31");
    if (focus->objectName() == "question_hand_used") {
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_Down);
    }
    if (focus->objectName() == "consent_given") {
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
    }
    if (focus->objectName() == "consent_seen_by")
      QTest::keyClicks(QApplication::focusWidget(), "MW");
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
  }
  for (const char* name : {"participant_label", "question_age", "question_hand_used", "mode_run",
                           "consent_given", "consent_seen_by", "device", "right_hand",
                           "participant_screen", "own_keyboard", "check_again"}) {
    EXPECT_TRUE(reached.contains(name)) << name << " is not reached by Tab";
  }
  const auto label = reached.indexOf("participant_label");
  EXPECT_EQ(reached.value(label + 1), "question_age") << "not in the order in which they stand";
  EXPECT_EQ(reached.value(label + 2), "question_hand_used");
  ASSERT_TRUE(wait_for_checks());
  ASSERT_TRUE(can_start()) << shown_reason();
  QSignalSpy wanted(page.get(), &StartPage::start_wanted);
  find<QPushButton>("start").setFocus();
  QTest::keyClick(&find<QPushButton>("start"), Qt::Key_Space);
  EXPECT_EQ(wanted.size(), 1);
}

TEST_F(TheStartPage, KeepsStartInSightAndNeverScrollsSideways) {
  page->show();
  choose(protocol);
  page->resize(1048, 620);
  QTest::qWait(10);
  for (auto* area : page->findChildren<QScrollArea*>()) {
    EXPECT_LE(area->widget()->minimumSizeHint().width(), area->viewport()->width());
  }
  const QPoint corner =
      find<QPushButton>("start").mapTo(page.get(), find<QPushButton>("start").rect().bottomRight());
  EXPECT_TRUE(page->rect().contains(corner));
}

TEST_F(TheStartPage, HasTheModeInSightAndMovesNothingWhenItIsChosen) {
  page->show();
  choose(protocol);
  page->resize(1048, 620);
  auto* area = page->findChild<QScrollArea*>("start_form");
  ASSERT_NE(area, nullptr);
  ASSERT_FALSE(area->isAncestorOf(&find<QPushButton>("mode_run")));
  const auto places = [this] {
    QString text{};
    for (const char* name : {"mode_run", "mode_pilot", "mode_simulate", "mode_text", "protocols",
                             "check_again", "start_footer"}) {
      const auto& widget = find<QWidget>(name);
      const QPoint place = widget.mapTo(page.get(), QPoint(0, 0));
      EXPECT_TRUE(page->rect().contains(place)) << name;
      text += QString("%1 at %2, %3; ").arg(name).arg(place.x()).arg(place.y());
    }
    return text.toStdString();
  };
  QTest::qWait(10);
  // From a run to a pilot nothing is asked otherwise: what is looked at stays where it is.
  area->verticalScrollBar()->setValue(area->verticalScrollBar()->maximum() / 2);
  const int value = area->verticalScrollBar()->value();
  ASSERT_GT(value, 0);
  click("mode_pilot");
  QTest::qWait(10);
  EXPECT_EQ(area->verticalScrollBar()->value(), value);
  area->verticalScrollBar()->setValue(0);
  click("mode_run");
  const std::string before = places();
  for (const char* mode : {"mode_pilot", "mode_simulate", "mode_run"}) {
    click(mode);
    QTest::qWait(10);
    EXPECT_EQ(places(), before) << mode;
  }
}

/// The protocol with two groups.
std::string protocol_with_groups(const std::string& assigned) {
  std::string text = protocol_with_questions();
  insert_before(text, "\"factors\"",
                R"("groups": {"factor": "training", "assigned": ")" + assigned + R"("}, )");
  text.insert(text.find("\"factors\": {") + 12,
              R"("training": {"levels": ["haptic", "visual"]}, )");
  return text;
}

TEST_F(TheStartPage, LetsTheExperimenterChooseTheGroupWhereTheProtocolSaysSo) {
  write_protocol(protocol_with_groups("by_experimenter"));
  page->show();
  choose(protocol);
  fill_in();
  ASSERT_TRUE(wait_for_checks());
  EXPECT_TRUE(is_shown("group"));
  EXPECT_TRUE(has_reason("No group is chosen; choose one."));
  EXPECT_FALSE(can_start());
  EXPECT_EQ(page->order().inputs.group, std::nullopt);
  pick("group", "visual");
  EXPECT_FALSE(has_reason("No group is chosen; choose one."));
  EXPECT_TRUE(can_start()) << shown_reason();
  EXPECT_EQ(page->order().inputs.group, "visual");
  type("participant_label", "sub777");
  EXPECT_TRUE(has_reason("No group is chosen; choose one.")) << "it was another participant's";
  page->set_mode(SessionMode::simulate);
  EXPECT_TRUE(is_shown("group")) << "of one virtual participant";
  find<QSpinBox>("virtual_participants").setValue(4);
  EXPECT_FALSE(is_shown("group")) << "of several the program assigns the groups in turn";
}

TEST_F(TheStartPage, KeepsTheGroupOfAParticipantAndTellsNoneThatTheProgramAssigns) {
  write_protocol(protocol_with_groups("balanced"));
  page->show();
  choose(protocol);
  EXPECT_FALSE(is_shown("group"));
  const auto session_text = [this] { return find<QLabel>("session_text").text().toStdString(); };
  EXPECT_NE(session_text().find("The program assigns the group."), std::string::npos)
      << session_text();
  const RunInputs inputs{.protocol = protocol,
                         .study = folder,
                         .participant = "virtual0001",
                         .seed = 3,
                         .mode = SessionMode::simulate,
                         .is_virtual = true,
                         .pacing = RunPacing::stepped};
  ASSERT_EQ(run_session(inputs, built_in_models(), nullptr, {}, {}).state, SessionState::completed);
  announce_change();
  page->set_mode(SessionMode::simulate);
  choose(protocol, "virtual0001");
  EXPECT_NE(session_text().find("Group haptic, as before."), std::string::npos) << session_text();
  EXPECT_EQ(page->order().inputs.group, std::nullopt);
}

/// Pictures of the demonstration study, as an experimenter sees them.
TEST(StartPagePictures, ShowEveryMode) {
  if (qEnvironmentVariableIsEmpty("ASPERITY_SCREENSHOTS")) GTEST_SKIP() << "no folder for pictures";
  TemporaryFolder temporary;
  const std::filesystem::path folder = temporary.path() / "Rough surfaces 2026";
  new_demo_study(folder, [](double) {});
  {
    Study stored = Study::open(folder, Access::read_write);
    for (const char* label : {"P011", "P012"}) {
      stored.add_participant({.label = label, .age_years = 28, .sex = "F", .handedness = "right"});
    }
  }
  std::stop_source stop;
  run_session({.protocol = folder / "protocols" / "chapter_selection.json",
               .study = folder,
               .participant = "virtual0001",
               .is_virtual = true,
               .pacing = RunPacing::stepped},
              built_in_models(), nullptr, stop.get_token(),
              [&stop](const AttemptDone&) { stop.request_stop(); });
  OpenStudy study(folder);
  for (const auto theme_choice : {ThemeChoice::light, ThemeChoice::dark}) {
    apply_theme(*qApp, theme_choice);
    const QString suffix = theme_choice == ThemeChoice::dark ? "-dark" : "";
    StartPage page(study);
    page.show();
    page.choose(folder / "protocols" / "chapter_recognition.json", std::nullopt, {});
    const auto settle = [&page] {
      EXPECT_TRUE(eventually([&page] {
        const auto reasons = page.reasons();
        return page.is_read() &&
               std::none_of(reasons.begin(), reasons.end(), [](const QString& reason) {
                 return reason.contains("Running the checks");
               });
      }));
    };
    settle();
    take_screenshot(page, "start-page" + suffix);
    page.set_mode(SessionMode::pilot);
    settle();
    auto* area = page.findChild<QScrollArea*>("start_form");
    area->ensureVisible(0, area->widget()->sizeHint().height());
    take_screenshot(page, "start-page-pilot" + suffix);
    page.set_mode(SessionMode::simulate);
    settle();
    take_screenshot(page, "start-page-simulate" + suffix);
    page.choose(folder / "protocols" / "chapter_selection.json", "virtual0001", std::int64_t{1});
    settle();
    take_screenshot(page, "start-page-go-on" + suffix);
  }
  apply_theme(*qApp, ThemeChoice::light);
}

/// A discrimination whose levels a program states.
constexpr const char* kStatedLevels = R"({
  "format": "asperity.protocol/1", "kind": "discrimination", "design": "improved", "name": "stated",
  "version": "1.0.0", "title": "Stated levels", "device": {"input_only": true},
  "consent": {"version": "1.0", "statement": "I take part of my own free will."},
  "stimuli": {"grating": {"model": "sinusoid", "parameters": {"amplitude_m": 5e-5, "wavelength_m": 0.0025}}},
  "explorations": {"short": {"minimum_contact_s": 0.1, "maximum_contact_s": 2}},
  "blocks": {"main": {
    "exploration": "short", "positions": "balanced",
    "vary": {"parameter": "amplitude_m", "of": "comparison", "relative_to": "standard",
             "levels_percent": {"lowest": 5, "highest": 100, "step": 5}},
    "procedure": {"method": "external", "stop": {"trials": 4}},
    "presented": [{"role": "standard", "stimulus": "grating"}, {"role": "comparison", "stimulus": "grating"}],
    "question": {"name": "rougher", "prompt": "Which is rougher?", "judgement": "performance"}}},
  "flow": [{"run": "main"}]})";

TEST_F(TheStartPage, NeedsAProgramWhereTheProtocolTakesItsLevelsFromOne) {
  page->show();
  choose(protocol);
  EXPECT_FALSE(is_shown("external_program"));
  EXPECT_FALSE(page->order().inputs.level_program);
  write_protocol(kStatedLevels);
  choose(protocol);
  ASSERT_TRUE(wait_for_checks());
  EXPECT_TRUE(is_shown("external_program"));
  EXPECT_TRUE(has_reason("No external program is chosen"));
  EXPECT_FALSE(can_start());
  type("external_program", "/nowhere/levels");
  EXPECT_TRUE(has_reason("/nowhere/levels does not exist"));
  EXPECT_FALSE(can_start());
  type("external_program", "/usr/bin/env");
  type("external_program_arguments", R"(python3 "my levels.py")");
  EXPECT_FALSE(has_reason("external program"));
  const std::optional<ExternalProgram> program = page->order().inputs.level_program;
  ASSERT_TRUE(program);
  EXPECT_EQ(program->file, "/usr/bin/env");
  EXPECT_EQ(program->arguments, (std::vector<std::string>{"python3", "my levels.py"}));
  // A page that is made anew has it; another run of Asperity does not.
  page.reset();
  page = std::make_unique<StartPage>(*study);
  page->resize(1146, 768);
  page->show();
  ASSERT_TRUE(wait_for_checks());
  ASSERT_TRUE(page->order().inputs.level_program);
  EXPECT_EQ(page->order().inputs.level_program->arguments, program->arguments);
  for (const QString& key : QSettings().allKeys()) {
    EXPECT_FALSE(QSettings().value(key).toString().contains("/usr/bin/env")) << key.toStdString();
  }
}

}  // namespace
}  // namespace asperity

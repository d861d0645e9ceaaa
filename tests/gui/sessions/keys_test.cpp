// Every key of a session, in a running one, and what each leaves in the store.

#include <algorithm>
#include <chrono>

#include <QtGui/QKeyEvent>
#include <QtWidgets/QApplication>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QDialog>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMenuBar>
#include <QtWidgets/QPushButton>

#include "app/gui/participant/participant_window.h"
#include "app/gui/session/reason_form.h"
#include "tests/gui/sessions/session_room.h"

namespace asperity {
namespace {

using Outcomes = std::vector<std::string>;

class SessionKeysAtWork : public SessionRoom {
 protected:
  /// A ready-made reason of a form, and its button.
  void give_reason(QWidget& in, const QString& reason) {
    auto& form = child<ReasonForm>(in, "reason_form");
    wait_for("the question for a reason", [&] { return form.isVisible(); });
    for (QPushButton* button : form.findChildren<QPushButton*>()) {
      if (button->text() != reason || !button->isVisible()) continue;
      click(*button);
      click(form, "reason_given");
      return;
    }
    throw std::runtime_error("no reason " + reason.toStdString());
  }
  SessionRequests::Pending pending() { return runner().requests().pending(); }
  std::vector<std::string> texts(const std::string& kind) {
    std::vector<std::string> texts{};
    for (const EventRow& event : stored_events(kind)) texts.push_back(event.text);
    return texts;
  }
};

TEST_F(SessionKeysAtWork, PauseBetweenTrialsResumeRepeatNoteAndStopAfterTheBlock) {
  make_study();
  add_protocol(
      {.blocks = 2, .minimum_contact_s = 1.0, .flow = R"({"run": "main"}, {"run": "second"})"});
  open();
  start("small");

  wait_for("contact", [&] { return is_in(SessionPhase::contact, 1); });
  key(Qt::Key_Escape);
  EXPECT_TRUE(pending().pause);
  take_part(chooses_a(), [&] { return is_in(SessionPhase::paused); });
  EXPECT_EQ(stored_outcomes(), Outcomes{"1/1 answered"});  // the trial was not cut short
  key(Qt::Key_F5);
  wait_for("the next trial", [&] { return is_in(SessionPhase::contact, 2); });

  key(Qt::Key_F2);
  auto& note = child<QLineEdit>(experimenter(), "note");
  EXPECT_EQ(QApplication::focusWidget(), &note);
  QTest::keyClicks(&note, "hm 12");
  key(Qt::Key_Return);
  key(Qt::Key_F6);
  EXPECT_TRUE(pending().pause);
  key(Qt::Key_F5);
  EXPECT_FALSE(pending().pause);
  key(Qt::Key_R, Qt::ControlModifier);
  give_reason(experimenter(), "Wrong key pressed");
  EXPECT_TRUE(pending().repeat_last);
  key(Qt::Key_F7);
  EXPECT_EQ(pending().stop, StopAfter::trial);
  key(Qt::Key_F7);
  EXPECT_FALSE(pending().stop);
  key(Qt::Key_F8);
  EXPECT_EQ(pending().stop, StopAfter::block);
  take_part(chooses_a());

  EXPECT_EQ(stored_outcomes(),
            (Outcomes{"1/1 answered", "2/1 answered, not valid", "2/2 answered"}));
  EXPECT_EQ(stored_session().state, SessionState::stopped);
  EXPECT_EQ(texts("paused").size(), 1U);
  EXPECT_EQ(texts("resumed").size(), 1U);
  EXPECT_EQ(texts("note"), Outcomes{"hm 12"});
  EXPECT_EQ(texts("trial_repeated"), Outcomes{"Wrong key pressed"});
  EXPECT_EQ(texts("session_stopped"), Outcomes{"on request, after the block"});
  const std::vector<std::string> phases = texts("phase");
  // Until the pause: two surfaces are felt, the question is asked.
  const std::vector<std::string> first(phases.begin(),
                                       std::find(phases.begin(), phases.end(), "paused"));
  EXPECT_EQ(first,
            (Outcomes{"ready", "iti", "fore", "contact", "fore", "contact", "response", "iti"}));
  EXPECT_EQ(phases.back(), "ended");
}

TEST_F(SessionKeysAtWork, StopAfterTheTrialThenAbortWithAReason) {
  make_study();
  add_protocol({});
  open();
  start("small");
  wait_for("contact", [&] { return is_in(SessionPhase::contact, 1); });
  key(Qt::Key_F7);
  take_part(chooses_a());
  EXPECT_EQ(stored_outcomes(), Outcomes{"1/1 answered"});
  EXPECT_EQ(stored_session().state, SessionState::stopped);
  EXPECT_EQ(texts("session_stopped"), Outcomes{"on request, after the trial"});
  click(experimenter(), "see_trials");
  wait_for("the trials of the session", [&] { return window->shown_page() == "trials"; });
  // The page before a session knows nothing any more of who was here.
  EXPECT_FALSE(child<QCheckBox>(*window, "consent_given").isChecked());
  window->show_page("sessions");

  click_row(*window, "sessions_table", "small");
  click(*window, "sessions_resume");
  press_start();
  wait_for("contact", [&] { return is_in(SessionPhase::contact, 2); });
  key(Qt::Key_Q, Qt::ControlModifier | Qt::ShiftModifier);
  give_reason(child<QDialog>(experimenter(), "abort_dialog"), "The participant is unwell");
  wait_for_end();
  EXPECT_EQ(stored_outcomes(), (Outcomes{"1/1 answered", "2/1 aborted, not valid"}));
  EXPECT_EQ(stored_attempts().back().invalid_reason.value().text, "The participant is unwell");
  EXPECT_EQ(stored_session().state, SessionState::stopped);
}

TEST_F(SessionKeysAtWork, DigitsLettersSpaceAndReturnAnswerAndNothingElseDoesAnything) {
  make_study();
  add_protocol({.trials = 1,
                .question = R"(, "allow_cannot_tell": true)",
                .flow = R"({"run": "main"}, {"screen": "Thank you."})"});
  open();
  start("small");
  int questions = 0;
  take_part([&](const Scene& scene) {
    if (++questions == 1) {
      wait_until_feeling_again_counts();
      key(Qt::Key_Space);
      return;
    }
    ASSERT_EQ(scene.choices.size(), 3U);
    const auto wait_until_chosen = [&](std::size_t option) {
      wait_for("a choice", [&] { return view().scene().choices.at(option).chosen; });
    };
    for (const Qt::Key nothing : {Qt::Key_Z, Qt::Key_9, Qt::Key_Backspace, Qt::Key_Left,
                                  Qt::Key_Minus, Qt::Key_Delete, Qt::Key_F3}) {
      key(nothing);
    }
    key(Qt::Key_2);
    wait_until_chosen(1);
    QKeyEvent repeated(QEvent::KeyPress, Qt::Key_A, {}, "a", true);
    QApplication::sendEvent(&experimenter(), &repeated);
    key(Qt::Key_0);
    wait_until_chosen(2);
    key(Qt::Key_A);
    wait_until_chosen(0);
    key(Qt::Key_Return);
  });
  EXPECT_EQ(questions, 2);
  const std::vector<AttemptRow> attempts = stored_attempts();
  ASSERT_EQ(attempts.size(), 1U);
  EXPECT_EQ(attempts[0].responses.at(0).answer, attempts[0].presentations.at(0).model);
  // The last one goes on from the thanks, and the session ends before it is let go.
  EXPECT_EQ(texts("input"),
            (Outcomes{"next", "option 2", "option 3", "option 1", "confirm", "confirm"}));
  std::vector<std::string> released = texts("input_released");
  released.resize(5);
  EXPECT_EQ(released, (Outcomes{"Space", "2", "0", "a", "Return"}));
  for (const EventRow& let_go : stored_events("input_released")) {
    EXPECT_NE(let_go.data_json.find("held_s"), std::string::npos) << let_go.data_json;
  }
}

TEST_F(SessionKeysAtWork, AnswersTooEarlyAreRefusedWithACue) {
  make_study();
  add_protocol({.trials = 1, .minimum_contact_s = 0.6});
  open();
  start("small");
  wait_for("contact", [&] { return is_in(SessionPhase::contact, 1); });
  wait_for("the surface in the window", [&] { return view().scene().kind == Scene::Kind::feel; });
  wait_for("it to be perceived", [&] { return can_be_perceived(); });
  key(Qt::Key_A);
  wait_for("the tone", [&] { return sound.count(Cue::refused) == 1; });
  wait_for("the words in the window", [&] {
    view().grab();
    return view().drawn_texts().contains("Please feel surface B first.");
  });
  key(Qt::Key_1);
  wait_for("the tone again", [&] { return sound.count(Cue::refused) == 2; });
  bool refused_at_the_question = false;
  take_part([&](const Scene&) {
    if (!refused_at_the_question) {
      key(Qt::Key_Return);
      wait_for("the third tone", [&] { return sound.count(Cue::refused) == 3; });
      refused_at_the_question = true;
    }
    choose(Qt::Key_B);
  });
  EXPECT_EQ(texts("refused"), (Outcomes{"Please feel surface B first.",
                                        "Please feel surface B first.", "Please choose first."}));
  const std::vector<AttemptRow> attempts = stored_attempts();
  ASSERT_EQ(attempts.size(), 1U);
  ASSERT_EQ(attempts[0].responses.size(), 1U);
  EXPECT_EQ(attempts[0].responses[0].answer, attempts[0].presentations.at(1).model);
  const auto asked = std::find_if(attempts[0].events.begin(), attempts[0].events.end(),
                                  [](const EventRow& event) { return event.text == "response"; });
  ASSERT_NE(asked, attempts[0].events.end());
  EXPECT_GT(attempts[0].responses[0].time_ns, asked->time_ns);
}

TEST_F(SessionKeysAtWork, KeysInANoteAnswerTheTrialWhileAResponseIsOpen) {
  make_study();
  add_protocol({.minimum_contact_s = 1.0});
  open();
  start("small");
  auto& note = child<QLineEdit>(experimenter(), "note");
  int questions = 0;
  const auto answer = [&](const Scene&) {
    wait_for("greyed text fields", [&] { return !note.isEnabled(); });
    if (++questions == 1) {
      EXPECT_EQ(note.text(), "b2");
      QTest::keyClick(&note, Qt::Key_B);  // to the field itself
      wait_for("a choice", [&] { return view().scene().choices.at(1).chosen; });
      QTest::keyClick(&note, Qt::Key_Backspace);
      QTest::keyClick(&note, Qt::Key_Return);
    } else {
      choose(Qt::Key_A);  // to whatever has the focus
    }
  };
  wait_for("contact", [&] { return is_in(SessionPhase::contact, 1); });
  key(Qt::Key_F2);
  key(Qt::Key_B);
  key(Qt::Key_2);
  EXPECT_EQ(note.text(), "b2");
  take_part(answer, [&] { return is_in(SessionPhase::contact, 2); });
  EXPECT_EQ(note.text(), "b2");
  click(note);
  key(Qt::Key_C);
  key(Qt::Key_Return);
  take_part(answer);
  EXPECT_EQ(texts("note"), Outcomes{"b2c"});
  EXPECT_EQ(texts("input"), (Outcomes{"option 2", "confirm", "option 1", "confirm"}));
  const std::vector<AttemptRow> attempts = stored_attempts();
  ASSERT_EQ(attempts.size(), 2U);
  EXPECT_EQ(attempts[0].responses.at(0).answer, attempts[0].presentations.at(1).model);
  EXPECT_EQ(attempts[1].responses.at(0).answer, attempts[1].presentations.at(0).model);
}

TEST_F(SessionKeysAtWork, AQuestionIsLeftOutByWhoeverSitsAtTheSessionNotByWorkElsewhere) {
  make_study();
  add_protocol({.trials = 1, .flow = R"({"run": "main"}, {"ask": ["remarks"]})"});
  open();
  start("small");
  take_part(chooses_a(), [&] { return view().scene().kind == Scene::Kind::form; });
  wait_for("the question to be perceived", [&] { return can_be_perceived(); });
  int answers = 0;
  QObject::connect(desk->participant_window(), &ParticipantWindow::acted, window.get(),
                   [&answers] { ++answers; });
  window->raise();
  window->activateWindow();
  wait_for("the study's window", [&] { return window->isActiveWindow(); });
  QMenu* menu = window->menuBar()->actions().first()->menu();
  ASSERT_NE(menu, nullptr);
  bool is_chosen = false;
  menu->addAction("Chosen", [&is_chosen] { is_chosen = true; });
  menu->popup(window->mapToGlobal(QPoint(5, 5)));
  wait_for("the menu", [&] { return QApplication::activePopupWidget() == menu; });
  QTest::keyClick(menu, Qt::Key_Up);  // the last one
  QTest::keyClick(menu, Qt::Key_Return);
  EXPECT_TRUE(is_chosen);
  QTest::keyClick(window.get(), Qt::Key_Return);
  EXPECT_EQ(answers, 0);
  experimenter().activateWindow();
  wait_for("the session's window", [&] { return experimenter().isActiveWindow(); });
  QTest::keyClick(&experimenter(), Qt::Key_Return);
  EXPECT_EQ(answers, 1);
  wait_for_end();
  EXPECT_EQ(stored_session().state, SessionState::completed);
}

std::int64_t steady_ms() {
  return std::chrono::duration_cast<std::chrono::milliseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

TEST_F(SessionKeysAtWork, AnswersAreTimedByTheStampOfTheKeyNotByItsHandling) {
  make_study();
  add_protocol({.trials = 1});
  open();
  start("small");
  // As under a window system: its clock is the machine's here, and some events were heard before.
  view().event_clock() = EventClock(EventClock::Stamps::of_window_system);
  const auto press = [&](Qt::Key key, const QString& text, std::int64_t stamp_ms) {
    QKeyEvent event(QEvent::KeyPress, key, {}, text);
    event.setTimestamp(static_cast<quint64>(stamp_ms));
    QApplication::sendEvent(&experimenter(), &event);
  };
  constexpr std::int64_t kLate_ms = 250;
  std::int64_t stamp_ns = 0;
  std::int64_t handled_ns = 0;
  take_part([&](const Scene&) {
    press(Qt::Key_A, "a", steady_ms());
    wait_for("a choice", [&] { return view().scene().can_confirm; });
    const std::int64_t asked_ms = steady_ms();
    wait_for("time to go by", [&] { return steady_ms() > asked_ms + kLate_ms; });
    const std::int64_t pressed_ms = steady_ms() - kLate_ms;
    const std::int64_t ahead_ns = monitor().facts()->clock_ahead_ns;
    press(Qt::Key_Return, "\r", pressed_ms);
    stamp_ns = pressed_ms * 1'000'000 + ahead_ns;
    handled_ns = steady_ms() * 1'000'000 + ahead_ns;
  });
  const std::vector<AttemptRow> attempts = stored_attempts();
  ASSERT_EQ(attempts.size(), 1U);
  const ResponseRow& response = attempts[0].responses.at(0);
  EXPECT_GE(response.time_ns, stamp_ns - 1'000'000);
  EXPECT_LE(response.time_ns, handled_ns - (kLate_ms - 50) * 1'000'000);
  const auto asked = std::find_if(attempts[0].events.begin(), attempts[0].events.end(),
                                  [](const EventRow& event) { return event.text == "response"; });
  ASSERT_NE(asked, attempts[0].events.end());
  // The cue follows the change of phase by less than the question takes to be heard.
  EXPECT_LE(1e9 * response.from_cue_s.value_or(0.0),
            static_cast<double>(response.time_ns - asked->time_ns));
  EXPECT_GT(response.from_cue_s.value_or(0.0), 0.0);
  EXPECT_GT(response.from_contact_s.value_or(0.0), response.from_cue_s.value_or(0.0));
}

}  // namespace
}  // namespace asperity

// Notes, phrases and reasons that an experimenter enters during a session.

#include <algorithm>

#include <QtGui/QFontMetrics>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <gtest/gtest.h>

#include "app/gui/base/settings.h"
#include "app/gui/look/controls.h"
#include "tests/gui/session/filled_monitor.h"
#include "tests/gui/session/session_window_text.h"
#include "tests/gui/support/widgets.h"

namespace asperity {
namespace {

TEST(SessionWindow, GreysTheNoteWhileKeysAnswerTheTrialAndSaysSo) {
  FilledMonitor session{};
  session.answer_up_to(16);
  const auto window = session.window();
  auto& note = child<QLineEdit>(*window, "note");
  note.setFocus();
  ASSERT_TRUE(note.hasFocus());
  note.setText("half");
  session.open_response(true);
  window->refresh();
  EXPECT_FALSE(note.isEnabled());
  EXPECT_EQ(note.text(), "half");
  EXPECT_EQ(child<QLabel>(*window, "note_locked").text(), "Keys reserved for the response");
  const QWidget* focus = QApplication::focusWidget();
  EXPECT_EQ(qobject_cast<const QPushButton*>(focus), nullptr)
      << "the participant's Space would press it";

  auto& phrase = child<QPushButton>(*window, "phrase");
  QTest::mouseClick(&phrase, Qt::LeftButton);
  EXPECT_FALSE(phrase.hasFocus());
  EXPECT_EQ(kinds(session.requests.take_remarks()), std::vector<std::string>{"note"});

  session.open_response(false);
  window->refresh();
  EXPECT_TRUE(note.isEnabled());
  EXPECT_FALSE(note.hasFocus());
}

TEST(SessionWindow, LeavesTheNoteOpenToWhoHasAKeyboardOfTheirOwn) {
  FilledMonitor session{};
  session.answer_up_to(16);
  const auto window = session.window();
  window->set_own_keyboard(true);
  session.open_response(true);
  window->refresh();
  EXPECT_TRUE(child<QLineEdit>(*window, "note").isEnabled());
}

TEST(SessionWindow, KeepsPhrasesOfOnesOwnForLaterSessions) {
  remember_note_phrases({});
  const auto phrases_of = [](const SessionWindow& window) {
    QStringList phrases{};
    for (const QPushButton* button : window.findChildren<QPushButton*>("phrase")) {
      phrases += button->property("phrase").toString();
    }
    return phrases;
  };
  FilledMonitor session{};
  session.answer_up_to(2);
  {
    const auto window = session.window();
    EXPECT_FALSE(phrases_of(*window).contains("Glove worn"));
    auto& keep = child<QPushButton>(*window, "keep_phrase");
    EXPECT_FALSE(keep.isVisible());
    child<QLineEdit>(*window, "note").setText("Glove worn");
    QTest::mouseClick(&keep, Qt::LeftButton);
    EXPECT_TRUE(kinds(session.requests.take_remarks()).empty()) << "kept, not noted";
  }
  const auto window = session.window();
  session.open_response(true);  // by mouse alone
  window->refresh();
  QPushButton* own = nullptr;
  for (QPushButton* button : window->findChildren<QPushButton*>("phrase")) {
    if (button->property("phrase") == "Glove worn") own = button;
  }
  ASSERT_NE(own, nullptr);
  QTest::mouseClick(own, Qt::LeftButton);
  const auto remarks = session.requests.take_remarks();
  ASSERT_EQ(kinds(remarks), std::vector<std::string>{"note"});
  EXPECT_EQ(remarks.front().text, "Glove worn");

  ASSERT_EQ(own->actions().size(), 1);
  own->actions().front()->trigger();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  EXPECT_FALSE(phrases_of(*window).contains("Glove worn"));
  EXPECT_TRUE(note_phrases().empty());
}

TEST(SessionWindow, ShowsItsPhrasesWholeAndLeavesSomeOutWhereThereIsNoRoom) {
  remember_note_phrases({"one", "two", "a phrase that is longer than any button"});
  FilledMonitor session{};
  session.answer_up_to(2);
  const auto window = session.window();
  const auto buttons = window->findChildren<QPushButton*>("phrase");
  ASSERT_EQ(buttons.size(), 12);
  for (const QPushButton* button : buttons) {
    EXPECT_LE(button->fontMetrics().horizontalAdvance(button->text()), button->width() - 10)
        << button->text().toStdString();
    EXPECT_TRUE(button->isVisible()) << button->text().toStdString();
  }
  window->resize(1366, window->minimumSizeHint().height());
  QCoreApplication::processEvents();
  EXPECT_TRUE(buttons.front()->isVisible()) << "one's own stay";
  EXPECT_FALSE(buttons.back()->isVisible());
  remember_note_phrases({});
}

TEST(SessionWindow, LetsTheOldestPhraseOfOnesOwnGo) {
  remember_note_phrases({"one", "two", "three"});
  FilledMonitor session{};
  const auto window = session.window();
  child<QLineEdit>(*window, "note").setText("four");
  child<QPushButton>(*window, "keep_phrase").click();
  EXPECT_EQ(note_phrases(), (QStringList{"two", "three", "four"}));
  remember_note_phrases({});
}

TEST(SessionWindow, AsksWhyATrialIsSkippedAndTakesAReasonByMouse) {
  FilledMonitor session{};
  session.answer_up_to(16);
  session.open_response(true);
  const auto window = session.window();
  child<QPushButton>(*window, "skip").click();
  EXPECT_FALSE(child<QLineEdit>(*window, "reason").isEnabled());
  const auto buttons = window->findChild<QWidget*>("reason_form")->findChildren<QPushButton*>();
  const auto ready = std::find_if(buttons.begin(), buttons.end(), [](const QPushButton* button) {
    return button->text() == "Technical problem";
  });
  ASSERT_NE(ready, buttons.end());
  QTest::mouseClick(*ready, Qt::LeftButton);
  child<QPushButton>(*window, "reason_given").click();
  const std::optional<Phrase> chosen = session.requests.take_skip();
  ASSERT_TRUE(chosen);
  EXPECT_STREQ(chosen->code(), "technical_problem");
}

TEST(SessionWindow, BringsTheNotesForwardWhereSomebodyIsToTypeOne) {
  FilledMonitor session{};
  session.answer_up_to(16);
  const auto window = session.window();
  window->resize(683, 700);
  ASSERT_FALSE(child<QLineEdit>(*window, "note").isVisible());
  QTest::keyClick(window.get(), Qt::Key_F2);
  EXPECT_TRUE(child<QLineEdit>(*window, "note").hasFocus());
}

}  // namespace
}  // namespace asperity

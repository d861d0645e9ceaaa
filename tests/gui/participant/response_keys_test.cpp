// Keys of a response while notes, menus, questions and dialogs of the experimenter are open.

#include "app/gui/participant/response_keys.h"

#include <algorithm>

#include <QtGui/QShortcut>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialog>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QMenu>
#include <QtWidgets/QPlainTextEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QToolTip>
#include <gtest/gtest.h>

#include "app/gui/participant/participant_window.h"
#include "tests/gui/participant/scenes.h"
#include "tests/gui/support/widgets.h"
#include "tests/support/questions.h"

namespace asperity {
namespace {

using Kind = ParticipantInput::Kind;

/// The participant's window, and an experimenter's with a note in it that has the focus.
struct Desk {
  scenes::PictureFolder pictures{};
  SessionMonitor monitor{};
  ParticipantWindow window{monitor, pictures.path()};
  std::vector<ParticipantInput> inputs{};
  std::vector<ParticipantInput> releases{};
  std::vector<std::pair<QString, QString>> remarks{};
  QWidget experimenter{};
  QLineEdit* note = new QLineEdit(&experimenter);
  QPlainTextEdit* long_note = new QPlainTextEdit(&experimenter);
  QPushButton* button = new QPushButton("Pause", &experimenter);
  int pressed = 0;

  Desk() {
    QObject::connect(&window, &ParticipantWindow::acted, [this](const ParticipantInput& input) {
      (input.kind == Kind::released ? releases : inputs).push_back(input);
    });
    QObject::connect(
        &window, &ParticipantWindow::remarked,
        [this](const QString& kind, const QString& text) { remarks.emplace_back(kind, text); });
    QObject::connect(button, &QPushButton::clicked, [this] { ++pressed; });
    auto* layout = new QVBoxLayout(&experimenter);
    layout->addWidget(note);
    layout->addWidget(long_note);
    layout->addWidget(button);
    window.resize(800, 600);
    window.show();
    experimenter.show();
    focus(note);
  }
  explicit Desk(const ParticipantScene& scene) : Desk() { show(scene); }
  void show(const ParticipantScene& scene) {
    monitor.show(scene);
    const std::shared_ptr<const ParticipantScene> shown = monitor.snapshot().scene;
    ASSERT_TRUE(eventually([&] { return &window.view().scene() == shown.get(); }));
  }
  void focus(QWidget* widget) {
    widget->window()->activateWindow();
    widget->setFocus();
    ASSERT_TRUE(eventually([&] { return QApplication::focusWidget() == widget; }));
  }
  /// As the keyboard does it: to whoever has the focus.
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(QApplication::focusWidget(), key, modifiers);
  }
};

TEST(ResponseKeys, AnswersFromAFocusedNoteAndLeavesTheNoteUnchanged) {
  Desk desk{};
  desk.note->setText("began 10:04");
  desk.show(scenes::recognition(6));
  desk.key(Qt::Key_3);
  desk.key(Qt::Key_Space);
  desk.key(Qt::Key_Return);
  ASSERT_EQ(desk.inputs.size(), 3U);
  EXPECT_EQ(desk.inputs[0].kind, Kind::option);
  EXPECT_EQ(desk.inputs[0].number, 3);
  EXPECT_EQ(desk.inputs[1].kind, Kind::next);
  EXPECT_EQ(desk.inputs[2].kind, Kind::confirm);
  EXPECT_EQ(desk.note->text(), "began 10:04");
  desk.focus(desk.long_note);
  desk.key(Qt::Key_5);
  EXPECT_EQ(desk.inputs.size(), 4U);
  EXPECT_EQ(desk.long_note->toPlainText(), "");
}

TEST(ResponseKeys, LetsNothingElseBeTypedWhileAResponseIsOpen) {
  Desk desk{};
  desk.note->setText("note");
  desk.show(scenes::recognition(6));
  desk.key(Qt::Key_9);  // there are six
  desk.key(Qt::Key_Q);
  desk.key(Qt::Key_Backspace);
  EXPECT_TRUE(desk.inputs.empty());
  EXPECT_EQ(desk.note->text(), "note");
}

TEST(ResponseKeys, PressesNoButtonOfTheExperimenterWhileAResponseIsOpen) {
  Desk desk(scenes::recognition(6));
  desk.focus(desk.button);
  desk.key(Qt::Key_Space);
  EXPECT_EQ(desk.pressed, 0);
  ASSERT_EQ(desk.inputs.size(), 1U);
  EXPECT_EQ(desk.inputs[0].kind, Kind::next);
}

TEST(ResponseKeys, LeavesTheNoteItsKeysOutsideResponses) {
  Desk desk{};
  int returns = 0;
  QObject::connect(desk.note, &QLineEdit::returnPressed, [&] { ++returns; });
  desk.show(scenes::to_read());
  QTest::keyClicks(desk.note, "slow 1");
  desk.key(Qt::Key_Return);
  EXPECT_EQ(desk.note->text(), "slow 1");
  EXPECT_EQ(returns, 1);
  EXPECT_TRUE(desk.inputs.empty());
}

TEST(ResponseKeys, ContinuesFromTheExperimentersWindowWhenNoTextFieldHasTheFocus) {
  Desk desk(scenes::to_read());
  desk.focus(desk.button);
  desk.key(Qt::Key_Return);
  ASSERT_EQ(desk.inputs.size(), 1U);
  EXPECT_EQ(desk.inputs[0].kind, Kind::confirm);
  desk.show(scenes::form_text());
  QTest::keyClicks(desk.button, "rough");
  desk.key(Qt::Key_Return);
  ASSERT_EQ(desk.inputs.size(), 2U);
  EXPECT_EQ(desk.inputs[1].text, "rough");
  EXPECT_EQ(desk.pressed, 0);
}

TEST(ResponseKeys, FollowsTheKeyboardToTheWindowThatAsksForAText) {
  Desk desk(scenes::form_text());
  ASSERT_TRUE(eventually([&] { return QApplication::activeWindow() == &desk.window; }));
  QTest::keyClicks(QApplication::focusWidget(), "smooth");
  desk.key(Qt::Key_Return);
  ASSERT_EQ(desk.inputs.size(), 1U);
  EXPECT_EQ(desk.inputs[0].text, "smooth");
  EXPECT_EQ(desk.note->text(), "");
}

TEST(ResponseKeys, LeavesEverythingToTheExperimenterBetweenScenesThatWait) {
  Desk desk(ParticipantScene{});
  desk.focus(desk.button);
  desk.key(Qt::Key_Space);
  EXPECT_EQ(desk.pressed, 1);
  EXPECT_TRUE(desk.inputs.empty());
}

TEST(ResponseKeys, LetsTheExperimentersKeysPass) {
  Desk desk{};
  int stops = 0;
  int notes = 0;
  int pauses = 0;
  QShortcut stop(QKeySequence(Qt::Key_F7), &desk.experimenter, [&] { ++stops; });
  QShortcut repeat(QKeySequence(Qt::CTRL | Qt::Key_1), &desk.experimenter, [&] { ++notes; });
  QShortcut pause(QKeySequence(Qt::Key_Escape), &desk.experimenter, [&] { ++pauses; });
  desk.show(scenes::recognition(6));
  desk.key(Qt::Key_F7);
  desk.key(Qt::Key_1, Qt::ControlModifier);
  desk.key(Qt::Key_Escape);
  EXPECT_EQ(stops, 1);
  EXPECT_EQ(notes, 1);
  EXPECT_EQ(pauses, 1);
  EXPECT_TRUE(desk.inputs.empty());
}

TEST(ResponseKeys, IsNotRobbedByAShortcut) {
  Desk desk{};
  int robbed = 0;
  QShortcut space(QKeySequence(Qt::Key_Space), &desk.experimenter, [&] { ++robbed; });
  desk.show(scenes::recognition(6));
  desk.focus(desk.button);
  desk.key(Qt::Key_Space);
  EXPECT_EQ(robbed, 0);
  EXPECT_EQ(desk.inputs.size(), 1U);
}

/// A question to the experimenter that is open over their window.
struct OpenQuestion {
  QDialog dialog;
  QLineEdit* field = new QLineEdit(&dialog);
  QPushButton* give = new QPushButton("Give", &dialog);
  int given = 0;

  explicit OpenQuestion(Desk& desk) : dialog(&desk.experimenter) {
    auto* layout = new QVBoxLayout(&dialog);
    layout->addWidget(field);
    layout->addWidget(give);
    give->setDefault(true);
    QObject::connect(give, &QPushButton::clicked, [this] { ++given; });
    dialog.open();
    desk.focus(field);
  }
};

// The clock of a trial runs; a question to the experimenter can wait.
TEST(ResponseKeys, AnswersATrialThroughAModalQuestionThatTheMouseStillAnswers) {
  Desk desk(scenes::recognition(6));
  OpenQuestion question(desk);
  ASSERT_EQ(QApplication::activeModalWidget(), &question.dialog);
  desk.key(Qt::Key_3);
  desk.key(Qt::Key_X);
  desk.key(Qt::Key_Space);
  desk.key(Qt::Key_Return);
  ASSERT_EQ(desk.inputs.size(), 3U);
  EXPECT_EQ(desk.inputs[0].number, 3);
  EXPECT_EQ(desk.inputs[2].kind, Kind::confirm);
  EXPECT_EQ(question.field->text(), "");
  EXPECT_EQ(question.given, 0);
  QTest::mouseClick(question.give, Qt::LeftButton);
  EXPECT_EQ(question.given, 1);
  desk.key(Qt::Key_Escape);
  EXPECT_FALSE(question.dialog.isVisible());
  EXPECT_EQ(desk.inputs.size(), 3U);
}

TEST(ResponseKeys, LeavesAQuestionToTheExperimenterItsKeysWhileNoResponseIsOpen) {
  Desk desk(scenes::to_read());
  OpenQuestion question(desk);
  QTest::keyClicks(question.field, "12 min late");
  EXPECT_EQ(question.field->text(), "12 min late");
  desk.focus(question.give);
  desk.key(Qt::Key_Return);
  EXPECT_EQ(question.given, 1);
  EXPECT_TRUE(desk.inputs.empty());
}

TEST(ResponseKeys, AnswersATrialThroughAnOpenMenu) {
  Desk desk(scenes::recognition(6));
  QMenu menu(&desk.experimenter);
  int chosen = 0;
  menu.addAction("&3 of them", [&] { ++chosen; });
  menu.popup(desk.experimenter.mapToGlobal(QPoint(5, 5)));
  ASSERT_TRUE(eventually([&] { return QApplication::activePopupWidget() == &menu; }));
  QTest::keyClick(&menu, Qt::Key_3);
  QTest::keyClick(&menu, Qt::Key_Return);
  EXPECT_EQ(chosen, 0);
  ASSERT_EQ(desk.inputs.size(), 2U);
  EXPECT_EQ(desk.inputs[0].number, 3);
  QTest::keyClick(&menu, Qt::Key_Escape);
  EXPECT_FALSE(menu.isVisible());
}

/// A window of the program that has nothing to do with the session, with a menu and a list of choices.
struct UnrelatedWindow {
  QWidget window{};
  QPushButton* table = new QPushButton("A row", &window);
  QComboBox* choice = new QComboBox(&window);
  QMenu menu{&window};
  QStringList chosen{};

  UnrelatedWindow() {
    auto* layout = new QVBoxLayout(&window);
    layout->addWidget(table);
    layout->addWidget(choice);
    choice->addItems({"one", "two"});
    for (const QString text : {"First", "Second"}) {
      menu.addAction(text, [this, text] { chosen += text; });
    }
    window.show();
  }
  void open_menu() {
    menu.popup(window.mapToGlobal(QPoint(5, 5)));
    ASSERT_TRUE(eventually([&] { return QApplication::activePopupWidget() == &menu; }));
  }
};

ParticipantScene optional_text() {
  ParticipantScene scene = scenes::form_text();
  scene.optional = true;
  return scene;
}

TEST(ResponseKeys, LeavesAMenuItsKeysWhileNoResponseIsOpen) {
  Desk desk{};
  UnrelatedWindow other{};
  int opened = 0;
  for (const ParticipantScene& scene : {optional_text(), scenes::to_read(), scenes::feel(3)}) {
    desk.show(scene);
    other.window.activateWindow();
    other.open_menu();
    QTest::keyClick(&other.menu, Qt::Key_Down);
    QTest::keyClick(&other.menu, Qt::Key_Return);
    EXPECT_EQ(other.chosen.size(), ++opened);
    EXPECT_FALSE(other.menu.isVisible());
  }
  EXPECT_TRUE(desk.inputs.empty());
}

TEST(ResponseKeys, LeavesTheListOfAChoiceItsKeysWhileNoResponseIsOpen) {
  Desk desk{};
  UnrelatedWindow other{};
  desk.show(optional_text());
  desk.focus(other.choice);
  other.choice->showPopup();
  QWidget* list = nullptr;
  ASSERT_TRUE(eventually([&] { return (list = QApplication::activePopupWidget()) != nullptr; }));
  QWidget* has_keys = list->focusWidget() != nullptr ? list->focusWidget() : list;
  QTest::keyClick(has_keys, Qt::Key_Down);
  QTest::keyClick(has_keys, Qt::Key_Return);
  EXPECT_EQ(other.choice->currentText(), "two");
  EXPECT_TRUE(desk.inputs.empty());
}

TEST(ResponseKeys, LeavesADialogThatHoldsUpNothingItsKeysWhileNoResponseIsOpen) {
  Desk desk(scenes::to_read());
  QDialog dialog(&desk.experimenter);
  QPushButton give("Give", &dialog);
  int given = 0;
  QObject::connect(&give, &QPushButton::clicked, [&] { ++given; });
  give.setDefault(true);
  dialog.show();
  desk.focus(&give);
  ASSERT_EQ(QApplication::activeModalWidget(), nullptr);
  desk.key(Qt::Key_Return);
  EXPECT_EQ(given, 1);
  EXPECT_TRUE(desk.inputs.empty());
  desk.show(scenes::recognition(6));
  desk.key(Qt::Key_3);
  desk.key(Qt::Key_Return);
  EXPECT_EQ(given, 1) << "the clock of a trial runs";
  EXPECT_EQ(desk.inputs.size(), 2U);
}

TEST(ResponseKeys, LeavesAQuestionOutOnlyFromTheWindowsOfTheSession) {
  Desk desk{};
  UnrelatedWindow other{};
  desk.window.keys().set_session_window(&desk.experimenter);
  ParticipantScene number = optional_text();
  number.form = NumberForm{};
  ParticipantScene choice = optional_text();
  choice.form = ChoiceForm{};
  choice.choices = {{.key = "1", .text = "good"}, {.key = "2", .text = "tired"}};
  std::size_t left_out = 0;
  for (const ParticipantScene& scene : {optional_text(), number, choice}) {
    desk.show(scene);
    desk.focus(other.table);
    desk.key(Qt::Key_Return);
    desk.key(Qt::Key_Enter);
    EXPECT_EQ(desk.inputs.size(), left_out) << "another window";
    desk.focus(desk.button);
    desk.key(Qt::Key_Return);
    EXPECT_EQ(desk.inputs.size(), ++left_out) << "the experimenter's";
    desk.show(ParticipantScene{});
    desk.show(scene);
    desk.focus(&desk.window.view());
    desk.key(Qt::Key_Return);
    EXPECT_EQ(desk.inputs.size(), ++left_out) << "the participant's";
    desk.show(ParticipantScene{});
  }
  for (const ParticipantInput& input : desk.inputs) EXPECT_EQ(input.text, "");
}

TEST(ResponseKeys, AnswersAQuestionThatMayBeLeftOutFromAnyWindowOnceSomethingIsTyped) {
  Desk desk{};
  UnrelatedWindow other{};
  desk.window.keys().set_session_window(&desk.experimenter);
  desk.show(optional_text());
  desk.focus(other.table);
  QTest::keyClicks(other.table, "icy");
  desk.key(Qt::Key_Return);
  ASSERT_EQ(desk.inputs.size(), 1U);
  EXPECT_EQ(desk.inputs[0].text, "icy");
}

TEST(ResponseKeys, HaveKeysAndClicksRefusedBetweenTwoSurfaces) {
  Desk desk{};
  ParticipantScene between = scenes::feel(3);
  between.kind = ParticipantScene::Kind::blank;
  between.text.clear();
  between.text_message = {};
  desk.show(between);
  desk.focus(desk.button);
  desk.key(Qt::Key_1);
  desk.key(Qt::Key_A);
  desk.key(Qt::Key_Space);
  EXPECT_EQ(desk.pressed, 0);
  QTest::mouseClick(&desk.window.view(), Qt::LeftButton, {}, QPoint(400, 300));
  ASSERT_EQ(desk.inputs.size(), 4U);
  EXPECT_EQ(desk.inputs[0].kind, Kind::option);
  EXPECT_EQ(desk.inputs[1].kind, Kind::surface);
  EXPECT_EQ(desk.inputs[2].kind, Kind::next);
  EXPECT_EQ(desk.inputs[3].kind, Kind::click);
  EXPECT_EQ(desk.inputs[3].source, "mouse");
  EXPECT_TRUE(desk.window.view().items().empty()) << "nothing is seen";
  between.cue = "Please feel surface B first.";
  between.cue_number = 1;
  desk.show(between);
  const auto items = desk.window.view().items();
  ASSERT_EQ(items.size(), 1U) << "but the refusal";
  EXPECT_EQ(items[0].kind, ParticipantItem::Kind::cue);
}

TEST(ResponseKeys, AnswersATrialWhileAMouseButtonIsHeld) {
  Desk desk(scenes::recognition(6));
  QTest::mousePress(desk.button, Qt::LeftButton);
  desk.key(Qt::Key_3);
  desk.key(Qt::Key_Space);
  ASSERT_EQ(desk.inputs.size(), 2U);
  EXPECT_EQ(desk.inputs[0].number, 3);
  EXPECT_EQ(desk.pressed, 0);
  QTest::mouseRelease(desk.button, Qt::LeftButton);
  EXPECT_EQ(desk.pressed, 1);
  // Nor does one that is held on a picture: two answers, as they were given.
  const auto items = desk.window.view().items();
  const auto picture = std::find_if(items.begin(), items.end(), [](const ParticipantItem& item) {
    return item.kind == ParticipantItem::Kind::picture && item.key == "5";
  });
  ASSERT_NE(picture, items.end());
  const QPoint place = picture->rect.center().toPoint();
  QTest::mousePress(&desk.window.view(), Qt::LeftButton, {}, place);
  desk.key(Qt::Key_2);
  QTest::mouseRelease(&desk.window.view(), Qt::LeftButton, {}, place);
  ASSERT_EQ(desk.inputs.size(), 4U);
  EXPECT_EQ(desk.inputs[2].number, 2);
  EXPECT_EQ(desk.inputs[3].number, 5);
}

TEST(ResponseKeys, GreysTheTextFieldsOfEveryWindowWhileAResponseIsOpenAndSaysWhy) {
  Desk desk{};
  const auto ground = [](QWidget& field) {
    return field.grab().toImage().pixelColor(field.width() - 6, field.height() / 2).name();
  };
  const QString usual = ground(*desk.note);
  desk.show(scenes::recognition(6));
  EXPECT_NE(ground(*desk.note), usual);
  EXPECT_EQ(ground(*desk.note), ground(*desk.long_note));
  QDialog opened_meanwhile(&desk.experimenter);
  QLineEdit field(&opened_meanwhile);
  opened_meanwhile.show();
  EXPECT_EQ(ground(field), ground(*desk.note));
  EXPECT_EQ(QToolTip::text(), "");
  desk.key(Qt::Key_Q);
  EXPECT_EQ(QToolTip::text(), "Keys reserved for the response");
  desk.show(ParticipantScene{});
  EXPECT_EQ(ground(*desk.note), usual);
  EXPECT_EQ(ground(field), usual);
  QToolTip::hideText();
  desk.window.keys().set_own_keyboard(true);
  desk.show(scenes::recognition(6));
  EXPECT_EQ(ground(*desk.note), usual);
}

TEST(ResponseKeys, HasQtsOwnDialogsStandInForThoseOfTheDesktop) {
  EXPECT_FALSE(QCoreApplication::testAttribute(Qt::AA_DontUseNativeDialogs));
  {
    const Desk desk{};
    EXPECT_TRUE(QCoreApplication::testAttribute(Qt::AA_DontUseNativeDialogs));
  }
  EXPECT_FALSE(QCoreApplication::testAttribute(Qt::AA_DontUseNativeDialogs));
}

TEST(ResponseKeys, TakesOnlyTheParticipantsWindowWithAKeyboardOfTheirOwn) {
  Desk desk{};
  desk.window.keys().set_own_keyboard(true);
  desk.show(scenes::recognition(6));
  desk.key(Qt::Key_3);
  EXPECT_EQ(desk.note->text(), "3");
  EXPECT_TRUE(desk.inputs.empty());
  desk.focus(&desk.window.view());
  desk.key(Qt::Key_3);
  EXPECT_EQ(desk.inputs.size(), 1U);
}

TEST(ResponseKeys, TakesWhatAnInputMethodWouldWriteForAKey) {
  Desk desk(scenes::recognition(6));
  QInputMethodEvent written{};
  written.setCommitString("4");
  QApplication::sendEvent(desk.note, &written);
  EXPECT_EQ(desk.note->text(), "");
  ASSERT_EQ(desk.inputs.size(), 1U);
  EXPECT_EQ(desk.inputs[0].number, 4);
}

TEST(ResponseKeys, TellsHowLongAKeyWasHeld) {
  Desk desk(scenes::recognition(6));
  desk.window.view().event_clock() = EventClock(EventClock::Stamps::of_window_system);
  const auto send = [&desk](QEvent::Type type, std::uint64_t stamp_ms, bool repeat) {
    QKeyEvent event(type, Qt::Key_2, Qt::NoModifier, "2", repeat);
    event.setTimestamp(stamp_ms);
    QApplication::sendEvent(desk.note, &event);
  };
  send(QEvent::KeyPress, 9000, false);
  send(QEvent::KeyRelease, 9300, true);
  send(QEvent::KeyPress, 9300, true);
  send(QEvent::KeyRelease, 9400, false);
  ASSERT_EQ(desk.inputs.size(), 1U);
  ASSERT_EQ(desk.releases.size(), 1U);
  EXPECT_EQ(desk.releases[0].text, "2");
  EXPECT_EQ(desk.releases[0].time_ns, desk.inputs[0].time_ns);
  // The stamps ran ahead of the real time here; the hearing bounds what they may say.
  EXPECT_GE(desk.releases[0].held_s, 0.0);
  EXPECT_LE(desk.releases[0].held_s, 0.4);
}

TEST(ResponseKeys, RemarksWhoHasTheKeyboard) {
  Desk desk{};
  desk.remarks.clear();
  desk.focus(desk.button);
  desk.focus(&desk.window.view());
  desk.focus(desk.note);
  ASSERT_GE(desk.remarks.size(), 3U);
  std::vector<QString> texts{};
  for (const auto& [kind, text] : desk.remarks) {
    EXPECT_EQ(kind, "focus_changed");
    if (text != "another program") texts.push_back(text);
  }
  EXPECT_EQ(texts,
            (std::vector<QString>{"experimenter", "participant", "experimenter, text field"}));
}

}  // namespace
}  // namespace asperity

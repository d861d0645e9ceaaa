// Who may see and hear what: a session without eyes, and one in which nobody knows what is felt.

#include <algorithm>
#include <set>

#include <QtCore/QAbstractItemModel>
#include <QtCore/QRegularExpression>
#include <QtWidgets/QAbstractItemView>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QPushButton>
#include <qcustomplot.h>

#include "app/gui/session/reason_form.h"
#include "tests/gui/sessions/session_room.h"

namespace asperity {
namespace {

class Blindfold : public SessionRoom {};

TEST_F(Blindfold, GoesThroughASessionByTonesAndDeviceButtonsAlone) {
  make_study();
  add_protocol({.head = R"(, "environment": {"vision": "blindfold",
                           "masking_noise": {"kind": "pink", "level_dBA": 60}})",
                .question = R"(, "allow_revisit": false)",
                .flow = R"({"screen": "Welcome."}, {"run": "main"}, {"screen": "Thank you."})"});
  open();
  start("small");
  // Not before the tone can have been heard, nor so soon after the last press that it is one with it.
  std::int64_t pressed_ns = 0;
  const auto press = [&](int button) {
    wait_for("the moment to press", [&] {
      return can_be_perceived() && monitor().snapshot().now_ns - pressed_ns > 50'000'000;
    });
    runner().requests().press_button(button);
    runner().requests().release_button(button);
    pressed_ns = monitor().snapshot().now_ns;
  };
  // The welcome can be read: the mask is not on yet. From then on only tones say what to do.
  wait_for("the welcome", [&] { return monitor().snapshot().scene->can_confirm; });
  press(1);
  std::size_t heard = 0;
  int options = 0;
  int questions = 0;
  bool is_thanked = false;
  wait_for("the end", [&] {
    const std::vector<std::string> tones = sound.cues();
    for (; heard < tones.size(); ++heard) {
      const std::string& tone = tones[heard];
      if (tone == "mask_on" || tone == "mask_off") press(2);
      if (tone == "question") {
        ++questions;
        options = 0;
        press(1);
      }
      if (tone.starts_with("option")) {
        ++options;
        // The first time the second surface, the second time the first.
        press(questions == 1 && options == 1 ? 1 : 2);
      }
    }
    // What follows the mask can be read again. One press ends the session, a moment later.
    const std::shared_ptr<const Scene> scene = monitor().snapshot().scene;
    if (!is_thanked && scene->text == "Thank you." && scene->can_confirm) {
      is_thanked = true;
      press(1);
    }
    return !desk->is_running();
  });
  EXPECT_EQ(sound.cues(),
            (std::vector<std::string>{"mask_on", "surface 1", "next", "surface 2", "next",
                                      "question", "option 1", "option 2", "accepted",  // trial 1
                                      "surface 1", "next", "surface 2", "next", "question",
                                      "option 1", "accepted", "mask_off", "finished"}));
  EXPECT_EQ(stored_session().state, SessionState::completed);
  const std::vector<AttemptRow> attempts = stored_attempts();
  ASSERT_EQ(attempts.size(), 2U);
  EXPECT_EQ(attempts[0].responses.at(0).answer, attempts[0].presentations.at(1).model);
  EXPECT_EQ(attempts[1].responses.at(0).answer, attempts[1].presentations.at(0).model);
  for (const AttemptRow& attempt : attempts) {
    EXPECT_EQ(attempt.responses.at(0).source, "device_button");
    EXPECT_GT(attempt.responses.at(0).from_cue_s.value_or(0.0), 0.0);
  }
  for (const EventRow& input : stored_events("input")) {
    EXPECT_TRUE(input.text.starts_with("device button")) << input.text;
  }
  EXPECT_EQ(stored_events("mask_on").size(), 1U);
  EXPECT_EQ(stored_events("mask_off").size(), 1U);
}

TEST_F(Blindfold, TheExperimenterTypesWhatIsSpokenAndSeesItInTheMirror) {
  make_study();
  add_protocol({.trials = 1,
                .head = R"(, "environment": {"vision": "blindfold"})",
                .flow = R"({"run": "main"}, {"ask": ["age", "remarks"]})"});
  open();
  start("small");
  auto& mirror = child<ParticipantView>(experimenter(), "participant_mirror");
  const auto mirrored = [&](const QString& text) {
    wait_for("the mirror of " + text.toStdString(), [&] {
      mirror.grab();
      return mirror.drawn_texts().contains(text);
    });
  };
  /// As somebody does who works at their own window and looks at nothing else.
  const auto in_my_window = [&] {
    experimenter().activateWindow();
    wait_for("the keyboard", [&] { return experimenter().isActiveWindow(); });
  };
  const auto asked = [&](Scene::Kind kind, const char* question) {
    wait_for(question, [&] {
      const Scene& scene = view().scene();
      const bool is_it =
          scene.kind == kind && (kind != Scene::Kind::form || scene.question == question);
      return is_it && can_be_perceived();
    });
  };
  asked(Scene::Kind::mask_on, "the mask");
  in_my_window();
  key(Qt::Key_Return);
  asked(Scene::Kind::question, "the question");
  in_my_window();
  key(Qt::Key_B);  // as it was said
  wait_for("the choice", [&] { return view().scene().choices.at(1).chosen; });
  key(Qt::Key_Return);
  asked(Scene::Kind::mask_off, "the mask again");
  in_my_window();
  key(Qt::Key_Return);
  asked(Scene::Kind::form, "age");
  in_my_window();
  key(Qt::Key_4);
  key(Qt::Key_2);
  mirrored("42");
  key(Qt::Key_Return);
  asked(Scene::Kind::form, "remarks");
  // The field for it has the keyboard by itself, wherever its window is; a click takes it away, and
  // still what is typed arrives.
  key(Qt::Key_I);
  in_my_window();
  child<QPushButton>(experimenter(), "pause").setFocus();
  key(Qt::Key_C);
  key(Qt::Key_Y);
  mirrored("icy");
  key(Qt::Key_Return);
  wait_for_end();
  const std::vector<AttemptRow> attempts = stored_attempts();
  ASSERT_EQ(attempts.size(), 1U);
  EXPECT_EQ(attempts[0].responses.at(0).answer, attempts[0].presentations.at(1).model);
  const auto answers =
      Study::open(folder(), Access::read_only).session_answers(stored_session().id);
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(answers[0].answer, "42");
  EXPECT_EQ(answers[1].answer, "icy");
  // What is said in confidence stands in no list of keys.
  for (const EventRow& event : stored_events("input_released")) {
    EXPECT_NE(event.text, "4");
    EXPECT_NE(event.text, "c");
  }
}

class MaskingNoiseLost : public SessionRoom {};

TEST_F(MaskingNoiseLost, KeepsASessionFromItsFirstTrialUntilTheNoiseIsHeard) {
  make_study();
  add_protocol({.trials = 1, .head = R"(, "environment": {"vision": "hand_occluded",
                           "masking_noise": {"kind": "pink", "level_dBA": 60}})"});
  open();
  sound.is_running = false;  // the card does not open
  start("small");
  wait_for("the pause", [&] { return is_in(SessionPhase::paused); });
  EXPECT_FALSE(sound_is_made_by_a_window);  // it could have waited for the card
  const std::optional<SessionTrouble> trouble = monitor().snapshot().trouble;
  ASSERT_TRUE(trouble);
  const std::string what = trouble->what.english();
  EXPECT_NE(what.find("masking noise"), std::string::npos) << what;
  sound.is_running = true;
  // The session pauses as it begins: the window does nothing for it before it knows of it.
  auto& resume = child<QPushButton>(experimenter(), "pause");
  wait_for("the way to resume",
           [&] { return resume.isEnabled() && resume.text() == "Resume\nF5"; });
  key(Qt::Key_F5);
  take_part(chooses_a());
  EXPECT_EQ(stored_session().state, SessionState::completed);
  EXPECT_EQ(stored_outcomes(), std::vector<std::string>{"1/1 answered"});
}

class DoubleBlind : public SessionRoom {
 protected:
  /// Every text of a window and of all in it, seen or not, that holds a name.
  static QStringList leaks(QWidget& top) {
    QStringList texts{};
    QList<QWidget*> widgets = top.findChildren<QWidget*>();
    widgets << &top;
    for (QWidget* widget : widgets) {
      for (const char* property :
           {"text", "title", "windowTitle", "toolTip", "statusTip", "whatsThis", "accessibleName",
            "accessibleDescription", "placeholderText"}) {
        texts << widget->property(property).toString();
      }
      if (auto* view = qobject_cast<ParticipantView*>(widget)) texts << view->drawn_texts();
      if (auto* items = qobject_cast<QAbstractItemView*>(widget)) add_cells(*items, texts);
      if (auto* plot = qobject_cast<QCustomPlot*>(widget)) add_words(*plot, texts);
    }
    static const QRegularExpression kNames("slate|cork|linen|height.?map|stochastic",
                                           QRegularExpression::CaseInsensitiveOption);
    return texts.filter(kNames);
  }

 private:
  static void add_cells(const QAbstractItemView& view, QStringList& texts) {
    const QAbstractItemModel* model = view.model();
    if (model == nullptr) return;
    for (int row = 0; row < model->rowCount(); ++row) {
      for (int column = 0; column < model->columnCount(); ++column) {
        for (const int role : {Qt::DisplayRole, Qt::ToolTipRole, Qt::AccessibleTextRole}) {
          texts << model->index(row, column).data(role).toString();
        }
      }
    }
  }
  static void add_words(QCustomPlot& plot, QStringList& texts) {
    for (int i = 0; i < plot.graphCount(); ++i) texts << plot.graph(i)->name();
    for (int i = 0; i < plot.itemCount(); ++i) {
      if (auto* words = qobject_cast<QCPItemText*>(plot.item(i))) texts << words->text();
    }
    for (QCPAxis* axis : {plot.xAxis, plot.yAxis, plot.xAxis2, plot.yAxis2}) texts << axis->label();
  }
};

TEST_F(DoubleBlind, NoNameIsSeenInAnyPhaseOfARunUntilAReasonIsGiven) {
  make_study();
  add_protocol({.kind = "recognition",
                .flow = R"({"screen": "Welcome."}, {"run": "main"}, {"ask": ["comfort"]},
                           {"break": {"minimum_s": 0, "text": "Rest."}}, {"screen": "Thanks."})"});
  open();
  start_by_mouse("small", "mode_run");
  std::set<std::string> phases{};
  QStringList found{};
  const auto look = [&] {
    const SessionPhase phase = monitor().snapshot().phase;
    phases.insert(text_of(phase));
    found << leaks(experimenter());
    if (desk->participant_window() != nullptr) found << leaks(*desk->participant_window());
    return false;
  };
  const auto answer = [&](const Scene&) {
    wait_for("the pictures", [&] {
      view().grab();
      return view().pictures_are_there();
    });
    look();
    choose(Qt::Key_1);
  };
  const auto look_and_stroke = [&] {
    stroke_by_mouse();
    return look();
  };
  take_part(answer, [&] { return look_and_stroke() || is_in(SessionPhase::contact, 2); });
  key(Qt::Key_F6);
  take_part(answer, [&] { return look_and_stroke() || is_in(SessionPhase::paused); });
  look();
  EXPECT_TRUE(found.isEmpty()) << found.first().toStdString();

  click(experimenter(), "unblind");
  auto& form = child<ReasonForm>(experimenter(), "reason_form");
  wait_for("the question", [&] { return form.isVisible(); });
  EXPECT_TRUE(experimenter().is_blind());
  // The participant's window may still be asking for the keyboard that the pause took from it.
  wait_for("the keyboard", [&] {
    auto& reason = child<QLineEdit>(form, "reason");
    if (reason.hasFocus()) return true;
    experimenter().activateWindow();
    reason.setFocus();
    return false;
  });
  QTest::keyClicks(&child<QLineEdit>(form, "reason"), "the hand is hot");
  click(form, "reason_given");
  EXPECT_FALSE(experimenter().is_blind());
  EXPECT_FALSE(leaks(experimenter()).isEmpty());  // and this test would have seen a name
  click(experimenter(), "unblind");
  EXPECT_TRUE(experimenter().is_blind());
  EXPECT_EQ(leaks(experimenter()).join('|').toStdString(), "");
  key(Qt::Key_F5);
  take_part(answer, [&] {
    if (desk->is_running()) stroke_by_mouse();
    return look() || !desk->is_running();
  });
  wait_for("the summary", [&] { return child<QWidget>(experimenter(), "see_table").isVisible(); });
  look();
  EXPECT_TRUE(found.isEmpty()) << found.first().toStdString();
  const std::vector<EventRow> unblinded = stored_events("unblinded");
  ASSERT_EQ(unblinded.size(), 1U);
  EXPECT_EQ(unblinded[0].text, "the hand is hot");
  EXPECT_EQ(stored_events("blinded_again").size(), 1U);
  for (const char* phase :
       {"ready", "fore", "contact", "response", "paused", "questions", "rest", "ended"}) {
    EXPECT_TRUE(phases.contains(phase)) << phase;
  }
}

class NewUser : public SessionRoom {};

TEST_F(NewUser, ComesFromTheWelcomePageToASimulatedSessionsTableInUnderTenClicks) {
  const std::filesystem::path demo = small_demo_study();
  std::filesystem::create_directories(home() / "Asperity");
  std::filesystem::rename(demo, home() / "Asperity" / "demo");
  make_windows();
  click(*window, "welcome_demo");
  wait_for("the study", [&] { return window->study() != nullptr; });
  click_row(*window, "protocols_table", "chapter_recognition");
  click(*window, "protocol_start");
  click(*window, "mode_simulate");
  press_start();
  wait_for_end();
  click(experimenter(), "see_table");
  wait_for("the analysis", [&] { return window->shown_page() == "analysis"; });
  auto& outcomes = child<QListWidget>(*window, "outcomes");
  wait_for("the table", [&] { return outcomes.count() == 1 && outcomes.isVisible(); });
  EXPECT_LT(clicks, 10);
  EXPECT_FALSE(window->page("analysis")->findChildren<QTableView*>().isEmpty());
  RecordProperty("clicks", clicks);
}

}  // namespace
}  // namespace asperity

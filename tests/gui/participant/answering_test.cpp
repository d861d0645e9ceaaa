// The participant's view and the rules behind it, together: what is pressed is what is answered.

#include <future>
#include <thread>

#include <QtTest/QTest>
#include <gtest/gtest.h>

#include "app/gui/participant/participant_window.h"
#include "app/session/respondents/person_at_window.h"
#include "protocols/file/library_protocols.h"
#include "protocols/file/protocol_reader.h"
#include "renderers/built_in_models.h"
#include "renderers/force/force_model.h"
#include "tests/gui/participant/scenes.h"
#include "tests/gui/support/widgets.h"
#include "tests/support/questions.h"
#include "tests/support/replies.h"

namespace asperity {
namespace {

using Item = ParticipantItem;

Trial first_trial(std::string_view name) {
  std::vector<ModelDeclaration> models{};
  const ModelRegistry registry = built_in_models();
  for (const ForceModel& model : registry.models()) models.push_back(model.declaration);
  for (const LibraryProtocol& each : library_protocols()) {
    if (each.name != name) continue;
    return make_plan(read_protocol(each.text, std::string(name), models), {1, 0}).trials.front();
  }
  ADD_FAILURE() << "no library protocol " << name;
  return {};
}

/// A person at the real window; a thread stands in for the conductor's.
struct Room {
  SessionMonitor monitor{};
  PersonAtWindow person{monitor, nullptr};
  ParticipantWindow window{monitor, "nowhere"};

  Room() {
    QObject::connect(&window, &ParticipantWindow::acted,
                     [this](const ParticipantInput& input) { person.post(input); });
    window.resize(1366, 768);
    window.show();
  }
  ParticipantView& view() { return window.view(); }
  template <class Result>
  std::future<Result> on_thread(std::function<Result()> work) {
    return std::async(std::launch::async, std::move(work));
  }
  /// Gives up after a while, so that a test that has failed ends.
  static Wait wait() {
    return [left_s = 1e-3 * kPatience_ms](double seconds) mutable {
      left_s -= seconds;
      if (left_s < 0.0) throw RespondentGone("nobody answered");
      std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    };
  }
  /// All surfaces of the trial have been felt.
  void feel(const Trial& trial) {
    person.begin_attempt(trial.ordinal, 1);
    for (const PlannedPresentation& surface : trial.presentations) {
      person.announce(trial, surface);
      person.wants_next(true);
    }
  }
  bool sees(const std::function<bool(const ParticipantScene&)>& what) {
    return eventually([&] { return what(view().scene()); });
  }
  bool sees_question() {
    return sees([](const ParticipantScene& scene) {
      return scene.kind == ParticipantScene::Kind::question;
    });
  }
  void key(Qt::Key key) { QTest::keyClick(&view(), key); }
  QPoint place_of(Item::Kind kind, const QString& key) {
    for (const Item& item : view().items()) {
      if (item.kind == kind && item.key == key) return item.rect.center().toPoint();
    }
    ADD_FAILURE() << "nothing has the key " << key.toStdString();
    return {};
  }
};

TEST(Answering, RecognisesByKeysAfterARefusalAndAChange) {
  const Trial trial = first_trial("chapter_recognition");
  Room room{};
  auto reply = room.on_thread<Reply>([&] {
    room.feel(trial);
    return room.person.ask(trial, trial.questions, {}, {}, Room::wait());
  });
  ASSERT_TRUE(room.sees_question());
  room.key(Qt::Key_Return);
  ASSERT_TRUE(room.sees([](const ParticipantScene& scene) { return !scene.cue.empty(); }));
  room.view().grab();
  EXPECT_TRUE(room.view().drawn_texts().contains("Please choose first."));
  room.key(Qt::Key_3);
  ASSERT_TRUE(room.sees([](const ParticipantScene& scene) { return scene.choices[2].chosen; }));
  room.key(Qt::Key_5);
  ASSERT_TRUE(room.sees([](const ParticipantScene& scene) { return scene.choices[4].chosen; }));
  room.key(Qt::Key_Return);
  EXPECT_EQ(options_of(reply.get()), std::vector<std::size_t>{4});
}

TEST(Answering, MatchesByMouseAlone) {
  const Trial trial = first_trial("photo_matching");
  Room room{};
  auto reply = room.on_thread<Reply>([&] {
    room.feel(trial);
    return room.person.ask(trial, trial.questions, {}, {}, Room::wait());
  });
  ASSERT_TRUE(room.sees_question());
  const auto click = [&](Item::Kind kind, const QString& key) {
    QTest::mouseClick(&room.view(), Qt::LeftButton, {}, room.place_of(kind, key));
  };
  const auto given = [&](std::size_t picture, const char* surface) {
    return room.sees([=](const ParticipantScene& scene) {
      return scene.choices[picture].assigned_to == surface;
    });
  };
  click(Item::Kind::chip, "B");
  click(Item::Kind::picture, "1");
  ASSERT_TRUE(given(0, "B"));
  const QPoint from = room.place_of(Item::Kind::chip, "C");
  const QPoint onto = room.place_of(Item::Kind::picture, "2");
  QTest::mousePress(&room.view(), Qt::LeftButton, {}, from);
  QTest::mouseMove(&room.view(), (from + onto) / 2);
  QTest::mouseMove(&room.view(), onto);
  QTest::mouseRelease(&room.view(), Qt::LeftButton, {}, onto);
  ASSERT_TRUE(given(1, "C"));
  click(Item::Kind::picture, "3");
  ASSERT_TRUE(given(2, "A"));
  click(Item::Kind::control, "Return");
  EXPECT_EQ(options_of(reply.get()), (std::vector<std::size_t>{2, 0, 1}));
}

TEST(Answering, FeelsTheNextSurfaceAgainBySpace) {
  const Trial trial = first_trial("chapter_selection");
  Room room{};
  auto reply = room.on_thread<Reply>([&] {
    room.feel(trial);
    return room.person.ask(trial, trial.questions, {}, {}, Room::wait());
  });
  ASSERT_TRUE(room.sees_question());
  room.key(Qt::Key_Space);
  EXPECT_EQ(felt_again(reply.get()), 1);
}

TEST(Answering, RefusesAnAnswerBeforeAllWasFelt) {
  const Trial trial = first_trial("chapter_selection");
  Room room{};
  room.person.begin_attempt(1, 1);
  room.person.announce(trial, trial.presentations.front());
  ASSERT_TRUE(room.sees(
      [](const ParticipantScene& scene) { return scene.kind == ParticipantScene::Kind::feel; }));
  room.key(Qt::Key_2);
  EXPECT_FALSE(room.person.wants_next(true));
  ASSERT_TRUE(room.sees([](const ParticipantScene& scene) { return !scene.cue.empty(); }));
  room.view().grab();
  EXPECT_TRUE(room.view().drawn_texts().contains("Please feel surface B first."));
  room.key(Qt::Key_Space);
  EXPECT_TRUE(room.person.wants_next(true));
}

TEST(Answering, AsksAgainForANumberThatIsOutOfRange) {
  Question question{};
  question.name = "age";
  question.prompt = "How old are you, in years?";
  question.form = NumberForm{.minimum = 18.0};
  Room room{};
  auto answer = room.on_thread<std::optional<Answer>>(
      [&] { return room.person.answer(question, Room::wait()); });
  ASSERT_TRUE(room.sees(
      [](const ParticipantScene& scene) { return scene.kind == ParticipantScene::Kind::form; }));
  room.key(Qt::Key_7);
  room.key(Qt::Key_Return);
  ASSERT_TRUE(room.sees([](const ParticipantScene& scene) { return !scene.cue.empty(); }));
  room.view().grab();
  EXPECT_TRUE(room.view().drawn_texts().contains("Please enter a number of at least 18."));
  room.key(Qt::Key_0);
  room.key(Qt::Key_Return);
  EXPECT_EQ(stored(question, answer.get()), FormAnswer{"70"});
}

// A hand that holds the device reads with its button.
TEST(Answering, ReadsALongTextByAButtonOfTheDeviceAlone) {
  Room room{};
  QObject::connect(&room.view(), &ParticipantView::more_to_read,
                   [&](bool more) { room.person.set_more_to_read(more); });
  auto done = room.on_thread<bool>([&] {
    room.person.read(scenes::sentences(25), 0.0, Room::wait());
    return true;
  });
  const auto is_on = [&](const QString& page) {
    return eventually([&] {
      room.view().grab();
      return room.view().drawn_texts().contains(page);
    });
  };
  const auto press = [&] {
    room.person.post({.kind = ParticipantInput::Kind::device_button,
                      .number = 1,
                      .time_ns = room.view().time_of_ns(0),
                      .source = "device_button"});
  };
  ASSERT_TRUE(is_on("Page 1 of 3"));
  press();
  ASSERT_TRUE(is_on("Page 2 of 3"));
  press();
  ASSERT_TRUE(is_on("Page 3 of 3"));
  EXPECT_NE(done.wait_for(std::chrono::seconds(0)), std::future_status::ready);
  press();
  EXPECT_TRUE(done.get());
}

}  // namespace
}  // namespace asperity

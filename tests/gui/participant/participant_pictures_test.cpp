// Pictures of the participant's window for people to look at, with the demonstration's photographs.

#include <filesystem>
#include <vector>

#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>
#include <gtest/gtest.h>

#include "app/gui/participant/participant_window.h"
#include "app/tasks/new_study.h"
#include "renderers/servo/servo_thread.h"
#include "tests/gui/participant/scenes.h"
#include "tests/gui/support/screenshot.h"
#include "tests/gui/support/widgets.h"

namespace asperity {
namespace {

TEST(ParticipantPictures, AreTakenOfEveryScene) {
  if (qEnvironmentVariableIsEmpty("ASPERITY_SCREENSHOTS")) {
    GTEST_SKIP() << "ASPERITY_SCREENSHOTS names no folder";
  }
  QTemporaryDir folder{};
  const std::filesystem::path study = folder.filePath("demo").toStdString();
  new_demo_study(study, [](double) {});
  std::vector<std::string> photographs{};
  for (const auto& file : std::filesystem::directory_iterator(study / "stimuli")) {
    const std::string name = file.path().filename().string();
    if (name.find("_photo") != std::string::npos) photographs.push_back("stimuli/" + name);
  }
  ASSERT_FALSE(photographs.empty());
  std::sort(photographs.begin(), photographs.end());
  const auto real = [&](std::optional<std::string>& picture) {
    if (!picture) return;
    const auto number = static_cast<std::size_t>(std::stoi(picture->substr(9)));
    picture = photographs[number % photographs.size()];
  };

  SessionMonitor monitor{};
  ParticipantWindow window(monitor, study);
  std::uint64_t cues = 0;
  auto everything = scenes::all();
  for (auto& more : scenes::demanding()) everything.push_back(std::move(more));
  for (auto [name, scene] : everything) {
    for (ParticipantScene::Choice& choice : scene.choices) real(choice.picture);
    real(scene.standard_picture);
    if (name == "rest") scene.rest_until_ns = monotonic_now_ns() + 83'000'000'000;
    for (const auto& [size, size_name] : {std::pair{QSize(1366, 768), "1366"},
                                          {QSize(1920, 1080), "1920"},
                                          {QSize(683, 700), "half"}}) {
      if (!scene.cue.empty()) scene.cue_number = ++cues;
      monitor.show(scene);
      const auto shown = monitor.snapshot().scene;
      ASSERT_TRUE(eventually([&] { return &window.view().scene() == shown.get(); }));
      window.resize(size);
      window.show();
      ASSERT_TRUE(eventually([&] {
        window.grab();
        return window.view().pictures_are_there();
      }));
      take_screenshot(window, QString("participant-%1-%2").arg(name.c_str(), size_name), size);
    }
  }
  // A pilot with a left-handed participant.
  SessionMonitor left_handed{};
  SessionFacts facts{};
  facts.mirrored = true;
  facts.row.mode = SessionMode::pilot;
  left_handed.set_facts(facts);
  ParticipantScene matched = scenes::matching(4);
  for (ParticipantScene::Choice& choice : matched.choices) real(choice.picture);
  matched.choices[2].assigned_to = "A";
  matched.can_switch = true;
  left_handed.show(matched);
  ParticipantWindow mirrored(left_handed, study);
  mirrored.resize(1366, 768);
  mirrored.show();
  ASSERT_TRUE(eventually([&] {
    mirrored.grab();
    return mirrored.view().pictures_are_there();
  }));
  QTest::keyClick(&mirrored.view(), Qt::Key_D);
  take_screenshot(mirrored, "participant-matching-left-handed", {1366, 768});
}

}  // namespace
}  // namespace asperity

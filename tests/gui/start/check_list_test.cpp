// The checklist as it is shown: in the language of the windows, all of it.

#include "app/gui/start/check_list.h"

#include <filesystem>
#include <fstream>
#include <functional>

#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QScrollArea>
#include <gtest/gtest.h>

#include "app/gui/base/settings.h"
#include "app/gui/look/words.h"
#include "app/tasks/checks/disk_check.h"
#include "app/tasks/checks/session_checks.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/study.h"
#include "tests/app/small_study.h"
#include "tests/gui/support/widgets.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

class TheCheckList : public testing::Test {
 protected:
  void SetUp() override {
    make_small_study(study);
    write_protocol(small_protocol());
    inputs.study = study;
    inputs.protocol = study / "protocols" / "small.json";
    inputs.participant = "P001";
    inputs.screens = 2;
    inputs.pacing = RunPacing::stepped;
    apply_language("de");
  }
  ~TheCheckList() override { apply_language("en"); }

  void write_protocol(const std::string& text) const {
    std::filesystem::create_directories(study / "protocols");
    write_file(study / "protocols" / "small.json", text, Overwrite::allow);
  }
  void put_into_protocol(const std::string& more) const {
    std::string text = small_protocol();
    text.insert(text.find("\"textures\""), more);
    write_protocol(text);
  }

  /// Goes through the list with these inputs, shows it, and holds each line to German.
  void expect_german(const std::string& situation,
                     const std::function<void(CheckInputs&)>& change) {
    CheckInputs changed = inputs;
    change(changed);
    const std::vector<SessionCheck> checks = check_session(changed, models, {});
    list.set_checks(checks);
    for (const SessionCheck& check : checks) {
      const auto* line = list.findChild<QLabel*>("check_" + QString::fromStdString(check.id));
      ASSERT_NE(line, nullptr) << check.id;
      for (const Phrase& part : {check.title, check.text, check.remedy}) {
        if (part.empty()) continue;
        const QString english = QString::fromStdString(part.english());
        const QString shown = words_of(part);
        EXPECT_NE(shown, english) << situation;
        EXPECT_TRUE(line->text().contains(shown.toHtmlEscaped())) << line->text().toStdString();
        EXPECT_FALSE(line->text().contains(english.toHtmlEscaped())) << line->text().toStdString();
      }
    }
  }

  TemporaryFolder folder{};
  std::filesystem::path study = folder.path() / "study";
  ModelRegistry models = built_in_models();
  CheckInputs inputs{};
  CheckList list{};
};

TEST_F(TheCheckList, SaysInGermanWhatIsFineAndWhatIsNot) {
  expect_german("a run", [](CheckInputs&) {});
  expect_german("a pilot on one screen", [](CheckInputs& in) {
    in.mode = SessionMode::pilot;
    in.screens = 1;
  });
  expect_german("in real time", [](CheckInputs& in) { in.pacing = RunPacing::real_time; });
  expect_german("nobody", [](CheckInputs& in) { in.participant = ""; });
  expect_german("a label with a blank", [](CheckInputs& in) { in.participant = "P 1"; });
  expect_german("a virtual label", [](CheckInputs& in) { in.participant = "virtual0001"; });
  expect_german("nothing to resume", [](CheckInputs& in) { in.resume = true; });
  expect_german("another text than was shown",
                [](CheckInputs& in) { in.protocol_sha256 = std::string(64, '0'); });
  expect_german("a simulation", [](CheckInputs& in) {
    in.mode = SessionMode::simulate;
    in.participant = "virtual0001";
  });
  const StudyLock elsewhere(study, Study::session_lock_name("P001"));
  expect_german("a session elsewhere", [](CheckInputs&) {});
}

TEST_F(TheCheckList, ShowsFirstWhatKeepsTheSessionFromStarting) {
  const auto check = [](const char* id, SessionCheck::State state) {
    SessionCheck made{};
    made.id = id;
    made.state = state;
    return made;
  };
  constexpr auto kFine = SessionCheck::State::fine;
  constexpr auto kLook = SessionCheck::State::look;
  constexpr auto kStop = SessionCheck::State::stop;
  list.set_checks({check("study", kFine), check("screens", kLook), check("rate", kFine),
                   check("device", kStop), check("memory", kLook), check("consent", kStop)});
  QStringList shown{};
  for (const QLabel* line : list.findChildren<QLabel*>()) {
    if (line->objectName().startsWith("check_")) shown << line->objectName().mid(6);
  }
  EXPECT_EQ(shown.join(' ').toStdString(), "summary device consent screens memory study rate");
}

TEST_F(TheCheckList, HasNoScrollBarWhileItHasNoLines) {
  list.resize(320, 200);
  list.show();
  const auto& area = *list.findChild<QScrollArea*>();
  EXPECT_FALSE(area.isVisible());
  std::vector<SessionCheck> many(40);
  for (SessionCheck& check : many) check.text = "Something was found.";
  list.set_checks(many);
  EXPECT_TRUE(area.isVisible());
  list.set_running(true);
  EXPECT_FALSE(area.isVisible());
  EXPECT_TRUE(child<QPushButton>(list, "check_cancel").isVisible());
  list.set_running(false);
  EXPECT_FALSE(child<QPushButton>(list, "check_cancel").isVisible());
}

TEST_F(TheCheckList, SaysInGermanWhatTheProtocolAsksForInVain) {
  put_into_protocol(R"("device": {"force_limit_N": 12}, )");
  expect_german("a strong device", [](CheckInputs&) {});
  put_into_protocol(R"("environment": {"masking_noise": {"kind": "pink", "level_dBA": 65}}, )");
  expect_german("no sound", [](CheckInputs&) {});
  expect_german("not measured", [](CheckInputs& in) { in.sound_card = true; });
  expect_german("measured by nobody", [](CheckInputs& in) {
    in.sound_card = true;
    in.noise.measured_dBA = 65.0;
  });
  const auto measured = [](double level_dBA) {
    return [level_dBA](CheckInputs& in) {
      in.sound_card = true;
      in.noise.measured_dBA = level_dBA;
      in.noise.verified_by = "MW";
    };
  };
  expect_german("from elsewhere", [&measured](CheckInputs& in) {
    measured(65.0)(in);
    in.sound_card = false;
  });
  expect_german("too loud", measured(70.0));
  expect_german("as declared", measured(65.0));
  std::string blindfold = small_protocol();
  blindfold.insert(blindfold.find("\"textures\""), R"("environment": {"vision": "blindfold"}, )");
  blindfold.replace(blindfold.find("photograph"), 10, "memory");
  write_protocol(blindfold);
  expect_german("no cues", [](CheckInputs&) {});
}

TEST_F(TheCheckList, SaysInGermanWhatASessionHasToGoOnWith) {
  inputs.participant = "virtual0001";
  inputs.mode = SessionMode::simulate;
  std::stop_source stop;
  stop.request_stop();
  run_session({.protocol = inputs.protocol,
               .study = study,
               .participant = inputs.participant,
               .mode = SessionMode::simulate,
               .is_virtual = true,
               .pacing = RunPacing::stepped},
              models, nullptr, stop.get_token(), {});
  expect_german("known", [](CheckInputs&) {});
  expect_german("known as virtual", [](CheckInputs& in) { in.mode = SessionMode::pilot; });
  expect_german("going on", [](CheckInputs& in) { in.resume = true; });
  std::ofstream(study / "stimuli" / "grain_photo.png", std::ios::app) << ' ';
  expect_german("with another file", [](CheckInputs& in) { in.resume = true; });
}

TEST_F(TheCheckList, SaysInGermanHowMuchRoomThereIs) {
  for (const double free_bytes : {1e8, 3e9, 1e12}) {
    const SessionCheck check = disk_check({.wanted_bytes = 2e9, .free_bytes = free_bytes});
    EXPECT_NE(words_of(check.text), QString::fromStdString(check.text.english()));
    if (check.remedy.empty()) continue;
    EXPECT_NE(words_of(check.remedy), QString::fromStdString(check.remedy.english()));
  }
}

}  // namespace
}  // namespace asperity

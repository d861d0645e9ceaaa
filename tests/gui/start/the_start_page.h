// The page before a session, in a study with a small protocol and questions about the participant.

#pragma once

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <vector>

#include <QtCore/QSettings>
#include <QtTest/QTest>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <gtest/gtest.h>

#include "app/gui/start/start_page.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/study.h"
#include "tests/app/punctual_trial.h"
#include "tests/app/small_study.h"
#include "tests/gui/support/widgets.h"
#include "tests/support/patient_servo.h"
#include "tests/support/temporary_folder.h"

namespace asperity {

inline void insert_before(std::string& text, const std::string& place, const std::string& added) {
  text.insert(text.find(place), added);
}

/// The small protocol with questions about the participant and no screens.
inline std::string protocol_with_questions() {
  std::string text = small_protocol();
  insert_before(text, "\"textures\"",
                R"("device": {"input_only": true}, "participants": {"planned": 4, "sessions": 2,
                    "questions": ["age", "hand_used", "hobby"]}, )");
  const std::string questions = "\"questions\": {\"remarks\"";
  text.replace(text.find(questions), questions.size(), R"("questions": {
    "age": {"prompt": "How old are you?", "form": "number", "minimum": 18, "maximum": 120},
    "hand_used": {"prompt": "Which hand?", "form": "choice", "options": ["right", "left"]},
    "hobby": {"prompt": "What do you like?", "form": "text", "optional": true},
    "remarks")");
  text.replace(text.find("\"flow\""), std::string::npos, R"("flow": [{"run": "main"}]})");
  return text;
}

class TheStartPage : public testing::Test {
 protected:
  void SetUp() override {
    QSettings().clear();
    make_small_study(folder);
    write_protocol(protocol_with_questions());
    study = std::make_unique<OpenStudy>(folder);
    study->set_device_trial(punctual_trial);
    study->set_servo(patient_servo());
    page = std::make_unique<StartPage>(*study);
    page->resize(1146, 768);
  }

  void write_protocol(const std::string& text) const {
    std::filesystem::create_directories(folder / "protocols");
    write_file(protocol, text, Overwrite::allow);
  }

  template <class Widget>
  Widget& find(const char* name) const {
    return child<Widget>(*page, name);
  }
  void click(const char* name) const {
    QTest::mouseClick(&find<QPushButton>(name), Qt::LeftButton);
  }
  void type(const char* name, const QString& text) const {
    auto& field = find<QLineEdit>(name);
    field.clear();
    QTest::keyClicks(&field, text);
  }
  void pick(const char* name, const QString& text) const {
    auto& box = find<QComboBox>(name);
    box.setCurrentIndex(box.findText(text));
  }
  bool is_shown(const char* name) const { return find<QWidget>(name).isVisibleTo(page.get()); }

  bool has_reason(const QString& part) const {
    const std::vector<QString> reasons = page->reasons();
    return std::any_of(reasons.begin(), reasons.end(),
                       [&part](const QString& reason) { return reason.contains(part); });
  }
  std::string shown_reason() const { return find<QLabel>("start_reason").text().toStdString(); }
  bool can_start() const { return find<QPushButton>("start").isEnabled(); }
  /// Until the study has been read.
  bool wait_for_study() const {
    return eventually([this] { return page->is_read(); });
  }
  /// Until the checklist is up to date as well.
  bool wait_for_checks() const {
    return eventually([this] { return page->is_read() && !has_reason("Running the checks"); });
  }
  void choose(const std::filesystem::path& file, const std::optional<std::string>& participant = {},
              std::optional<std::int64_t> session = {}) const {
    page->choose(file, participant, session);
    if (!wait_for_study()) throw std::runtime_error("the study is not read");
    // Study data of human participants do not come from the simulated device, which a virtual hand holds.
    auto& devices = find<QComboBox>("device");
    if (const int mouse = devices.findData("mouse"); mouse >= 0) devices.setCurrentIndex(mouse);
  }
  void announce_change() const {
    study->announce_change();
    if (page->isVisible() && !wait_for_study()) throw std::runtime_error("the study is not read");
  }

  /// Everything that is required of a participant in a run.
  void fill_in() const {
    type("question_age", "31");
    pick("question_hand_used", "right");
    QTest::mouseClick(&find<QCheckBox>("consent_given"), Qt::LeftButton, {}, QPoint(8, 8));
    type("consent_seen_by", "MW");
  }

  void run_unfinished(const std::string& participant) {
    std::stop_source stop;
    const RunInputs inputs{.protocol = protocol,
                           .study = folder,
                           .participant = participant,
                           .seed = 3,
                           .mode = SessionMode::simulate,
                           .is_virtual = true,
                           .pacing = RunPacing::stepped};
    const ModelRegistry models = built_in_models();
    const SessionEnd end = run_session(inputs, models, nullptr, stop.get_token(),
                                       [&stop](const AttemptDone&) { stop.request_stop(); });
    ASSERT_EQ(end.state, SessionState::stopped);
    study->announce_change();
  }

  TemporaryFolder temporary{};
  std::filesystem::path folder = temporary.path() / "study";
  std::filesystem::path protocol = folder / "protocols" / "small.json";
  std::unique_ptr<OpenStudy> study{};
  std::unique_ptr<StartPage> page{};
};

}  // namespace asperity

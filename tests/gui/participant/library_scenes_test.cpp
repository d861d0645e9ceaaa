// What participants of the library's protocols read, word for word, from the real view.

#include <set>

#include <QtCore/QRegularExpression>
#include <QtTest/QTest>
#include <gtest/gtest.h>

#include "app/gui/participant/participant_view.h"
#include "protocols/file/library_protocols.h"
#include "protocols/file/protocol_reader.h"
#include "renderers/built_in_models.h"
#include "renderers/force/force_model.h"
#include "tests/gui/support/widgets.h"

namespace asperity {
namespace {

/// Every scene that a session of this protocol can show, those that look the same once.
std::vector<ParticipantScene> scenes_of(const Protocol& protocol, const Plan& plan) {
  std::vector<ParticipantScene> scenes{};
  std::set<std::string> breaks{};
  for (const PlanStep& step : plan.steps) {
    if (const auto* screen = std::get_if<Protocol::Screen>(&step)) {
      scenes.push_back(scene_to_read(screen->text));
    } else if (const auto* pause = std::get_if<Protocol::Break>(&step)) {
      if (!breaks.insert(pause->text).second) continue;
      ParticipantScene scene{};
      scene.kind = ParticipantScene::Kind::rest;
      scene.text = pause->text;
      scenes.push_back(scene);
    }
  }
  for (const auto& [name, question] : protocol.questions) scenes.push_back(scene_of_form(question));
  // The questions of a block differ in what is felt, which is not shown: two of each will do.
  std::map<std::string, int> shown{};
  for (const Trial& trial : plan.trials) {
    if (++shown[trial.block] > 2) continue;
    std::vector<int> felt{};
    for (const PlannedPresentation& surface : trial.presentations) {
      scenes.push_back(scene_of_surface(trial, felt, surface.position));
      felt.push_back(surface.position);
    }
    scenes.push_back(scene_of_question(trial, trial.questions, felt));
  }
  scenes.push_back(scene_of_mask(true));
  scenes.push_back(scene_of_mask(false));
  for (const auto kind : {ParticipantScene::Kind::paused, ParticipantScene::Kind::ended}) {
    ParticipantScene scene{};
    scene.kind = kind;
    scenes.push_back(scene);
  }
  return scenes;
}

/// Names of textures, models and stimuli, and of the pictures' files.
std::set<QString> names_in(const Protocol& protocol, const Plan& plan) {
  std::set<QString> names{};
  for (const auto& [name, texture] : protocol.textures) names.insert(QString::fromStdString(name));
  for (const auto& [name, stimulus] : protocol.stimuli) names.insert(QString::fromStdString(name));
  for (const Trial& trial : plan.trials) {
    for (const PlannedPresentation& surface : trial.presentations) {
      names.insert(QString::fromStdString(surface.item));
      names.insert(QString::fromStdString(surface.stimulus.model));
    }
    for (const Option& option : trial.questions.front().options) {
      if (option.picture) names.insert(QString::fromStdString(*option.picture));
    }
  }
  names.erase(QString());
  return names;
}

class LibraryScenes : public testing::TestWithParam<LibraryProtocol> {};

TEST_P(LibraryScenes, SayNoNameAndFitBothSizes) {
  std::vector<ModelDeclaration> models{};
  const ModelRegistry registry = built_in_models();
  for (const ForceModel& model : registry.models()) models.push_back(model.declaration);
  const Protocol protocol = read_protocol(GetParam().text, std::string(GetParam().name), models);
  const Plan plan = make_plan(protocol, {1, 0});
  const std::set<QString> names = names_in(protocol, plan);
  ASSERT_FALSE(names.empty());

  SessionMonitor monitor{};
  ParticipantView view(monitor, "nowhere", ParticipantView::Role::participant);
  for (const ParticipantScene& scene : scenes_of(protocol, plan)) {
    monitor.show(scene);
    const auto shown = monitor.snapshot().scene;
    view.show();
    ASSERT_TRUE(eventually([&] { return &view.scene() == shown.get(); }));
    for (const QSize size : {QSize(1366, 768), QSize(1920, 1080)}) {
      view.resize(size);
      view.grab();
      for (const ParticipantItem& item : view.items()) {
        EXPECT_TRUE(QRectF(view.rect()).contains(item.rect)) << item.text.toStdString();
        EXPECT_TRUE(item.text.isEmpty() || item.size_px >= 32) << item.text.toStdString();
      }
      for (const QString& text : view.drawn_texts()) {
        for (const QString& name : names) {
          // As a word: "a wooden table" is no name.
          const QRegularExpression word("\\b" + QRegularExpression::escape(name) + "\\b",
                                        QRegularExpression::CaseInsensitiveOption);
          EXPECT_FALSE(text.contains(word))
              << '"' << text.toStdString() << "\" names " << name.toStdString();
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Protocols, LibraryScenes,
                         testing::ValuesIn(library_protocols().begin(), library_protocols().end()),
                         [](const auto& each) { return std::string(each.param.name); });
INSTANTIATE_TEST_SUITE_P(InGerman, LibraryScenes,
                         testing::ValuesIn(library_protocols("de").begin(),
                                           library_protocols("de").end()),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace asperity

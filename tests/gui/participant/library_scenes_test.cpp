// What participants of the library's protocols read, word for word, from the real view.

#include <set>
#include <string>
#include <utility>
#include <vector>

#include <QtCore/QRegularExpression>
#include <gtest/gtest.h>

#include "app/gui/participant/participant_view.h"
#include "protocols/file/library_protocols.h"
#include "protocols/file/protocol_reader.h"
#include "renderers/built_in_models.h"
#include "renderers/force/force_model.h"
#include "tests/protocols/protocol_files.h"

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

/// Names of textures, models and stimuli, and of the pictures' files, as words: "a wooden table" is no name.
QRegularExpression names_in(const Protocol& protocol, const Plan& plan) {
  std::set<std::string> names{};
  for (const auto& [name, texture] : protocol.textures) names.insert(name);
  for (const auto& [name, stimulus] : protocol.stimuli) names.insert(name);
  for (const Trial& trial : plan.trials) {
    for (const PlannedPresentation& surface : trial.presentations) {
      names.insert(surface.item);
      names.insert(surface.stimulus.model);
    }
    for (const Option& option : trial.questions.front().options) {
      if (option.picture) names.insert(*option.picture);
    }
  }
  names.erase("");
  EXPECT_FALSE(names.empty());
  QStringList any{};
  for (const std::string& name : names) {
    any.append(QRegularExpression::escape(QString::fromStdString(name)));
  }
  return QRegularExpression("\\b(" + any.join('|') + ")\\b",
                            QRegularExpression::CaseInsensitiveOption);
}

void expect_to_fit(const ParticipantView& view) {
  for (const ParticipantItem& item : view.items()) {
    EXPECT_TRUE(QRectF(view.rect()).contains(item.rect)) << item.text.toStdString();
    EXPECT_TRUE(item.text.isEmpty() || item.size_px >= 32) << item.text.toStdString();
  }
}

using NameAndLanguage = std::pair<std::string, std::string>;
class LibraryScenes : public testing::TestWithParam<NameAndLanguage> {};

TEST_P(LibraryScenes, SayNoNameAndFitBothSizes) {
  std::vector<ModelDeclaration> models{};
  const ModelRegistry registry = built_in_models();
  for (const ForceModel& model : registry.models()) models.push_back(model.declaration);
  const auto& [name, language] = GetParam();
  const std::string source =
      language.empty() ? test::library_text(name) : test::library_text(name, language);
  const Protocol protocol = read_protocol(source, name, models);
  const Plan plan = make_plan(protocol, {1, 0});
  const QRegularExpression names = names_in(protocol, plan);

  SessionMonitor monitor{};
  qsizetype texts = 0;
  for (const ParticipantScene& scene : scenes_of(protocol, plan)) {
    monitor.show(scene);
    // A new view has the scene at once.
    ParticipantView view(monitor, "nowhere", ParticipantView::Role::participant);
    ASSERT_EQ(&view.scene(), monitor.snapshot().scene.get());
    view.show();
    view.resize(1920, 1080);
    expect_to_fit(view);
    view.resize(1366, 768);
    expect_to_fit(view);
    view.grab({0, 0, 1, 1});  // what it draws is noted, however little of it is looked at
    texts += view.drawn_texts().size();
    for (const QString& text : view.drawn_texts()) {
      EXPECT_FALSE(text.contains(names)) << '"' << text.toStdString() << "\" names "
                                         << names.match(text).captured(1).toStdString();
    }
  }
  EXPECT_GT(texts, 10);
}

/// The library's own texts with an empty language, then their translations.
std::vector<NameAndLanguage> library_in_all_languages() {
  std::vector<NameAndLanguage> all{};
  for (const LibraryProtocol& each : library_protocols()) {
    all.emplace_back(each.name, "");
    for (const LibraryTranslation& one : each.translations) {
      all.emplace_back(each.name, one.language);
    }
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Protocols, LibraryScenes, testing::ValuesIn(library_in_all_languages()),
                         [](const auto& each) {
                           return each.param.first + '_' + each.param.second;
                         });

}  // namespace
}  // namespace asperity

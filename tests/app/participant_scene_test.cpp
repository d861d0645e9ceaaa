// What participants are shown tells them nothing that they are not to know.

#include "app/session/respondents/participant_scene.h"

#include <set>

#include <gtest/gtest.h>

#include "protocols/file/library_protocols.h"
#include "protocols/file/protocol_reader.h"
#include "renderers/built_in_models.h"
#include "renderers/force/force_model.h"

namespace asperity {
namespace {

std::vector<ModelDeclaration> declarations() {
  std::vector<ModelDeclaration> models{};
  const ModelRegistry registry = built_in_models();
  for (const ForceModel& model : registry.models()) models.push_back(model.declaration);
  return models;
}

Protocol library_protocol(std::string_view name) {
  for (const LibraryProtocol& each : library_protocols()) {
    if (each.name == name) return read_protocol(each.text, std::string(name), declarations());
  }
  ADD_FAILURE() << "no library protocol " << name;
  return {};
}

std::vector<int> all_positions(const Trial& trial) {
  std::vector<int> positions{};
  for (const PlannedPresentation& planned : trial.presentations) {
    positions.push_back(planned.position);
  }
  return positions;
}

/// Every word that a window could show of a scene; pictures are files, and drawn, not named.
std::string scene_words(const ParticipantScene& scene) {
  std::string words = scene.text + '\n' + scene.cue + '\n' + scene.text_message.code + '\n';
  for (const ParticipantScene::Surface& surface : scene.surfaces) words += surface.code + '\n';
  for (const ParticipantScene::Choice& choice : scene.choices) {
    words += choice.key + '\n' + choice.text + '\n' + choice.assigned_to + '\n';
  }
  return words;
}

class Scenes : public testing::TestWithParam<LibraryProtocol> {};

TEST_P(Scenes, NameNoTextureModelOrFile) {
  const Protocol protocol = library_protocol(GetParam().name);
  std::set<std::string> names{};
  for (const auto& [name, texture] : protocol.textures) {
    names.insert(name);
    for (const auto& path : {texture.height_field, texture.picture, texture.true_height_field}) {
      if (path) names.insert(*path);
    }
  }
  for (const ModelDeclaration& model : declarations()) names.insert(model.id);
  for (const auto& [name, stimulus] : protocol.stimuli) names.insert(name + "_");
  int scenes = 0;
  for (const Trial& trial : make_plan(protocol, {1, 0}).trials) {
    std::vector<ParticipantScene> shown{};
    for (const int position : all_positions(trial)) {
      shown.push_back(scene_of_surface(trial, {}, position));
      shown.push_back(scene_of_lifting(trial, {}, position));
    }
    shown.push_back(scene_of_question(trial, trial.questions, all_positions(trial)));
    for (const ParticipantScene& scene : shown) {
      const std::string words = scene_words(scene);
      for (const std::string& name : names) {
        EXPECT_EQ(words.find(name), std::string::npos) << name << " in\n" << words;
      }
      ++scenes;
    }
  }
  EXPECT_GT(scenes, 0);
}

INSTANTIATE_TEST_SUITE_P(OfEveryLibraryProtocol, Scenes,
                         testing::ValuesIn(library_protocols().begin(), library_protocols().end()),
                         [](const auto& each) { return std::string(each.param.name); });

TEST(SceneOfQuestion, PutsDigitsOnPicturesAndLettersOnSurfaces) {
  const Trial matching = make_plan(library_protocol("chapter_matching"), {1, 0}).trials.front();
  const ParticipantScene pictures =
      scene_of_question(matching, matching.questions, all_positions(matching));
  ASSERT_EQ(pictures.choices.size(), 4U);
  EXPECT_EQ(pictures.choices[0].key, "1");
  EXPECT_EQ(pictures.choices[3].key, "4");
  EXPECT_TRUE(pictures.choices[0].picture);
  EXPECT_TRUE(pictures.is_answered_by<AssignmentForm>());
  EXPECT_EQ(pictures.assigning, std::optional<std::size_t>(0));
  EXPECT_TRUE(pictures.response_open);

  Trial selection = make_plan(library_protocol("chapter_selection"), {1, 0}).trials.front();
  selection.questions.front().options.push_back({"cannot_tell", "I cannot tell", std::nullopt});
  const ParticipantScene surfaces =
      scene_of_question(selection, selection.questions, all_positions(selection));
  ASSERT_EQ(surfaces.choices.size(), 4U);
  EXPECT_EQ(surfaces.choices[0].key, "A");
  EXPECT_EQ(surfaces.choices[2].key, "C");
  EXPECT_EQ(surfaces.choices[3].key, "0");
  EXPECT_EQ(surfaces.choices[3].text, "I cannot tell");
  EXPECT_EQ(surfaces.choices[3].message.what, ParticipantMessage::What::cannot_tell);
  EXPECT_TRUE(surfaces.standard_picture);
}

TEST(SceneOfQuestion, HidesPicturesUntilAllWasFeltWhereTheProtocolSaysSo) {
  const Trial trial = make_plan(library_protocol("chapter_matching"), {1, 0}).trials.front();
  ASSERT_TRUE(trial.pictures_after_feeling);
  EXPECT_TRUE(scene_of_surface(trial, {1, 2}, 3).choices.empty());
  EXPECT_TRUE(scene_of_question(trial, trial.questions, {1, 2, 3}).choices.empty());
  EXPECT_EQ(scene_of_question(trial, trial.questions, {1, 2, 3, 4}).choices.size(), 4U);

  Trial open = trial;
  open.pictures_after_feeling = false;
  EXPECT_EQ(scene_of_surface(open, {}, 1).choices.size(), 4U);
}

TEST(SceneOfSurface, SaysWhichSurfaceIsFeltNow) {
  const Trial trial = make_plan(library_protocol("chapter_selection"), {1, 0}).trials.front();
  const ParticipantScene scene = scene_of_surface(trial, {1}, 2);
  EXPECT_EQ(scene.kind, ParticipantScene::Kind::feel);
  EXPECT_EQ(scene.text, "Feel surface B now.");
  EXPECT_EQ(scene.text_message.what, ParticipantMessage::What::feel_surface);
  ASSERT_EQ(scene.surfaces.size(), 3U);
  EXPECT_TRUE(scene.surfaces[0].felt && !scene.surfaces[0].now);
  EXPECT_TRUE(!scene.surfaces[1].felt && scene.surfaces[1].now);
  EXPECT_FALSE(scene.response_open);
}

TEST(SceneOfSurface, SaysWhenItIsEnough) {
  const Trial trial = make_plan(library_protocol("chapter_selection"), {1, 0}).trials.front();
  const ParticipantScene scene = scene_of_lifting(trial, {1}, 2);
  EXPECT_EQ(scene.kind, ParticipantScene::Kind::feel);
  EXPECT_EQ(scene.text, "You have finished with surface B. Please lift the handle.");
  EXPECT_TRUE(scene.surfaces[1].now);
}

TEST(SceneOfFeedback, TellsTheRightAnswerOnlyToWhoWasWrong) {
  EXPECT_EQ(scene_of_feedback(true, "3").text, "Correct.");
  EXPECT_EQ(scene_of_feedback(false, "3").text, "Incorrect. The correct response is 3.");
  EXPECT_EQ(scene_of_feedback(false, "").text, "Incorrect.");
  EXPECT_EQ(scene_of_feedback(false, "3").text_message.what, ParticipantMessage::What::was_wrong);
}

}  // namespace
}  // namespace asperity
